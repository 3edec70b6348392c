/**
 * Whether code does what the program does that it was written from: it is read again, run, and its moves are followed by the
 * arm; each is compared with the program's own, and looked at for what a controller might object to. Pure.
 *
 * @import { Doc } from '../document.js'
 * @import { CodeMove } from './codeMoves.js'
 * @import { MadeMove, MadeProgram } from './neutralProgram.js'
 * @import { CodeFinding } from './runCode.js'
 * @import { Deviation, MoveMargins } from './moveMargins.js'
 * @import { CodeFile, NeutralTarget } from '../../karel/write/neutral.js'
 *
 * @typedef {object} CheckedMove
 * @property {string} file
 * @property {number} line
 * @property {number} step            of the program; −1: the way to where it begins
 * @property {'joint' | 'linear' | 'circular'} motion
 * @property {Deviation} deviation    at most, on the way and at its end
 * @property {Deviation} rounding     what the decimals of the language cost at most
 * @property {MoveMargins} margins
 * @property {string | null} configuration
 *
 * @typedef {object} Verification
 * @property {readonly CheckedMove[]} moves
 * @property {readonly CodeFinding[]} findings   in the order of their lines
 * @property {Deviation} deviation    the largest of all
 * @property {boolean} matches        the same moves, each within its rounding or within 0.01 mm and 0.01°
 */
import { tcpPose } from '../../kinematics/forward.js';
import { poseDifference } from '../../kinematics/pose.js';
import { compilePosture } from '../compile.js';
import { fromKernel } from '../units.js';
import { codeMove } from './codeMoves.js';
import { postureAlong } from './followMoves.js';
import { moveMargins, roundingOf } from './moveMargins.js';
import { runCode } from './runCode.js';

/** What code may differ by in any case: mm and degrees. */
export const TOLERANCE = 0.01;

/** Shares of a way at which the two are compared. */
const SHARES = [0.25, 0.5, 0.75, 1];

const UNITS = /** @type {const} */ ({ length: 'mm', angle: 'deg' });
const SPEED_UNITS = /** @type {Readonly<Record<string, string>>} */ ({
  '%': '%',
  'mm/s': 'mm/sec',
  'deg/s': 'deg/sec',
});

/** Condition numbers past this are near a singularity: one over it. */
const NEAR_SINGULAR = 0.02;

/** A joint that is so far from where it should be (radians, metres) stands in another posture. */
const ANOTHER = 1e-2;

/** So many numbers a Cartesian position has in effects. */
const CARTESIAN = 10;

/**
 * @param {Doc} doc
 * @param {MadeProgram} made
 * @param {readonly CodeFile[]} files   the first is the one that is run
 * @param {readonly number[]} [start]   where the arm stands at first
 * @returns {Verification}
 */
export function verifyCode(doc, made, files, start = doc.posture) {
  const { effects, findings, language } = runCode(files);
  /** @type {CheckedMove[]} */
  const moves = [];
  /** @type {Deviation} */
  const largest = { millimetres: 0, degrees: 0 };
  let /** @type {Float64Array} */ from = compilePosture(doc.robot, start);
  let isSame = effects.length === made.moves.length;
  /** @type {string | null} */
  let before = null;
  for (const [i, effect] of effects.entries()) {
    const file = typeof effect.file === 'string' ? effect.file : files[0].name;
    const find = (
      /** @type {CodeFinding['severity']} */ severity,
      /** @type {string} */ code,
      /** @type {string} */ message,
    ) => void findings.push({ severity, code, message, file, line: effect.line ?? 0 });
    const done = codeMove(doc, made.frames, from, effect);
    if ('message' in done) {
      find('error', 'impossible', `The arm cannot make this move: ${done.message}.`);
      isSame = false;
      break;
    }
    from = done.followed.end;
    const margins = moveMargins(doc, done);
    const wanted = made.moves[i];
    const deviation = wanted ? deviationOf(done, wanted) : { millimetres: Infinity, degrees: Infinity };
    const rounding = roundingOf(doc, done);
    moves.push({
      ...{ file, line: effect.line ?? 0, step: wanted?.move.step ?? -1, motion: done.motion },
      ...{ deviation, rounding, margins, configuration: done.configuration },
    });
    largest.millimetres = Math.max(largest.millimetres, deviation.millimetres);
    largest.degrees = Math.max(largest.degrees, deviation.degrees);
    for (const difference of wanted
      ? differences(done, wanted, deviation, rounding, language)
      : ['a move that the program does not have']) {
      find('error', 'differs', `This is not as in the program: ${difference}.`);
      isSame = false;
    }
    for (const [code, message] of concerns(done, margins, before)) find('warning', code, message);
    before = done.configuration?.split(',')[0] ?? before;
  }
  if (effects.length !== made.moves.length)
    findings.push({
      severity: 'error',
      code: 'moves',
      message: `The code makes ${effects.length} moves, the program ${made.moves.length}.`,
      file: files[0].name,
      line: 0,
    });
  const order = files.map(({ name }) => name);
  findings.sort((a, b) => order.indexOf(a.file) - order.indexOf(b.file) || a.line - b.line);
  return {
    moves,
    findings,
    deviation: largest,
    matches: isSame && !findings.some(({ severity }) => severity === 'error'),
  };
}

/** How far apart the two are at most, where both go by the same shares of their ways. @param {CodeMove} done @param {MadeMove} wanted @returns {Deviation} */
function deviationOf({ followed }, { followed: own }, shares = SHARES) {
  const worst = { millimetres: 0, degrees: 0 };
  for (const share of shares) {
    const T_base_code = tcpPose(followed.chain, postureAlong(followed.path, share));
    const T_base_own = tcpPose(own.chain, postureAlong(own.path, share));
    const [x, y, z, a, b, c] = poseDifference(T_base_own, T_base_code);
    worst.millimetres = Math.max(worst.millimetres, fromKernel('length', Math.hypot(x, y, z), UNITS));
    worst.degrees = Math.max(worst.degrees, fromKernel('angle', Math.hypot(a, b, c), UNITS));
  }
  return worst;
}

/** @param {CodeMove} done @param {MadeMove} wanted @param {Deviation} deviation @param {Deviation} rounding @param {'fanuc' | 'krl'} language @returns {string[]} */
function differences(done, wanted, deviation, rounding, language) {
  const { move, followed } = wanted;
  /** @type {string[]} */
  const list = [];
  if (done.motion !== move.motion) list.push(`a ${done.motion} move, not a ${move.motion} one`);
  if (done.userFrame !== move.userFrame) list.push(`user frame ${done.userFrame}, not ${move.userFrame}`);
  if (done.tool !== move.tool) list.push(`tool ${done.tool}, not ${move.tool}`);
  const isFar =
    deviation.millimetres > Math.max(TOLERANCE, rounding.millimetres) ||
    deviation.degrees > Math.max(TOLERANCE, rounding.degrees);
  const away = Math.max(...done.followed.end.map((value, i) => Math.abs(value - followed.end[i])));
  const end = deviationOf(done, wanted, [1]);
  // The tool may be there with another posture.
  const isOther = done.motion === 'joint' && away > ANOTHER && end.millimetres < 1 && end.degrees < 1;
  if (isOther) list.push('another posture of the arm');
  else if (isFar)
    list.push(`${deviation.millimetres.toPrecision(3)} mm and ${deviation.degrees.toPrecision(3)} degrees away`);
  if (isOtherVia(done.via, move.via)) list.push('another point on the way');
  const { speed } = move;
  const isSpeed = done.speed.unit === SPEED_UNITS[speed.unit] && done.speed.value !== null;
  if (
    isSpeed &&
    Math.abs(Number(done.speed.value) - speed.value) > Math.max(0.5, speed.value / 10 ** 3) &&
    speed.value >= 1
  )
    list.push(`a speed of ${done.speed.value} ${done.speed.unit}, not ${speed.value}`);
  const stops = done.ending.kind === 'FINE';
  if (stops !== (move.ending.kind === 'fine')) list.push(stops ? 'it stops at the end' : 'it does not stop at the end');
  else if (
    !stops &&
    move.ending.kind === 'percent' &&
    done.ending.kind === 'CNT' &&
    Math.abs(Number(done.ending.value) - move.ending.value) > 0.5
  )
    list.push(`a corner of ${done.ending.value}, not ${move.ending.value}`);
  else if (
    !stops &&
    language === 'krl' &&
    move.ending.kind === 'distance' &&
    Math.abs(Number(done.ending.value) - move.ending.value) > 1e-3
  )
    list.push(`a corner of ${done.ending.value} mm, not ${move.ending.value}`);
  return list;
}

/** Whether the numbers of the point that a circle passes are others; full turns aside. @param {readonly number[] | null} found @param {NeutralTarget | undefined} wanted */
function isOtherVia(found, wanted) {
  if (!found || !wanted) return false;
  const numbers = found.length < CARTESIAN ? wanted.joints : wanted.position;
  return numbers.some((value, i) => {
    const off = found[i] - value;
    return Math.abs(off) > TOLERANCE && Math.abs(off - 360 * Math.round(off / 360)) > TOLERANCE;
  });
}

/** @param {CodeMove} done @param {MoveMargins} margins @param {string | null} before @returns {[string, string][]} */
function concerns({ motion, configuration }, { limit, singularity, rate }, before) {
  /** @type {[string, string][]} */
  const list = [];
  if (limit && limit.room < 0) list.push(['limit', `Joint ${limit.joint + 1} is past its limit here.`]);
  if (singularity < NEAR_SINGULAR) list.push(['singular', 'The way passes near a singular posture.']);
  if (rate && rate.share > 1)
    list.push([
      'rate',
      `Joint ${rate.joint + 1} would have to turn at ${(100 * rate.share).toFixed(0)}% of its rate for this speed.`,
    ]);
  const letters = configuration?.split(',')[0] ?? null;
  if (motion === 'linear' && letters && before && letters !== before && !letters.startsWith('S'))
    list.push([
      'configuration-change',
      `The configuration changes from ${before} to ${letters}, which a line cannot do.`,
    ]);
  return list;
}
