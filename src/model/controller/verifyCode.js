/**
 * Whether code does what the program does that it was written from: it is read again, run, and its moves are followed by the
 * arm; each is compared with the program's own, and looked at for what a controller might object to. Pure.
 *
 * @import { Doc } from '../document.js'
 * @import { CodeMove } from './codeMoves.js'
 * @import { MadeProgram } from './neutralProgram.js'
 * @import { Deed, FoundDeed, Where } from './deeds.js'
 * @import { CodeFinding } from './runCode.js'
 * @import { Deviation, MoveMargins } from './moveMargins.js'
 * @import { SystemValues } from '../code/codeFrames.js'
 * @import { RegisterSetting } from '../code/givenRegisters.js'
 * @import { CodeFile } from '../../karel/write/neutral.js'
 *
 * @typedef {object} CheckedMove
 * @property {string} file
 * @property {number} line
 * @property {number} step            of the program; −1: the way to where it begins
 * @property {'joint' | 'linear' | 'circular'} motion
 * @property {Deviation | null} deviation    at most, on the way and at its end, what a law costs that no controller has among it;
 *   null: there is no program to compare with
 * @property {Deviation} rounding     what the decimals of the language cost at most
 * @property {MoveMargins} margins
 * @property {string | null} configuration
 *
 * @typedef {object} Verification
 * @property {readonly CheckedMove[]} moves
 * @property {readonly CodeFinding[]} findings   in the order of their lines
 * @property {Deviation} deviation    the largest of all
 * @property {boolean} isCompared     with a program; else everything but the deviation is known
 * @property {boolean} matches        the same moves, each within its rounding or within 0.01 mm and 0.01°; and no error
 */
import { positionForCode, systemAtFirst } from '../code/codeFrames.js';
import { compilePosture, postureFromKernel } from '../compile.js';
import { atOnce } from '../inSlices.js';
import { compared, lostText } from './compareMoves.js';
import { pendantValues } from './controllerValues.js';
import { decimalsCost, mostOf } from './decimalsCost.js';
import { deedDifferences, deedsOf } from './deeds.js';
import { effectMoves } from './effectMoves.js';
import { controllerFrames } from './frameNumbers.js';
import { moveMargins } from './moveMargins.js';
import { runMoves } from './runCode.js';

/** Condition numbers past this are near a singularity: one over it. */
export const NEAR_SINGULAR = 0.02;

/** Moves after which half of what is to come is taken to be done, where nobody knows how many there are. */
const SOME = 20;

/**
 * @param {Doc} doc
 * @param {MadeProgram | null} made     null: nothing to compare with
 * @param {readonly CodeFile[]} files   the first is the one that is run
 * @param {readonly number[]} [start]   where the arm stands at first
 * @returns {Verification}
 */
export const verifyCode = (doc, made, files, start) => atOnce(verifyInSlices(doc, made, files, start));

/**
 * The same, move by move.
 * @param {Doc} doc
 * @param {MadeProgram | null} made
 * @param {readonly CodeFile[]} files
 * @param {readonly number[]} [start]
 * @param {readonly RegisterSetting[]} [given]   what registers hold at first
 * @returns {Generator<number, Verification>}
 */
export function* verifyInSlices(doc, made, files, start = doc.posture, given = []) {
  const language = files[0].language === 'krl' ? 'krl' : 'fanuc';
  const frames = made?.frames ?? controllerFrames(doc, language === 'krl' ? 'kuka' : 'fanuc');
  /** @type {CodeFinding[]} */
  const findings = [];
  /** @type {CheckedMove[]} */
  const moves = [];
  const largest = { millimetres: 0, degrees: 0 };
  let /** @type {Float64Array} */ from = compilePosture(doc.robot, start);
  let isSame = true;
  /** @type {FoundDeed[]} */
  const deeds = [];
  /** What the decimals of the move before leave open of the posture. @type {readonly Float64Array[]} */
  let loose = [];
  /** And of where the tool is. */
  let before = { millimetres: 0, degrees: 0 };
  /** Frames that were said to be missing. @type {Set<string>} */
  const told = new Set();
  /** @type {string | null} */
  let letters = null;
  const posture = () => postureFromKernel(doc.robot, from);
  const arm = {
    joints: () => pendantValues(doc.robot, posture()),
    position: (/** @type {SystemValues} */ system, /** @type {boolean} */ isTp) =>
      positionForCode({ ...doc, posture: posture() }, system, isTp),
    system: language === 'fanuc' ? systemAtFirst(doc, frames) : {},
    given,
  };
  /** @param {Deed} deed @param {Where} where */
  const noteDeed = (deed, where) => void deeds.push({ deed, where, after: moves.length });
  for (const effect of runMoves(files, findings, arm, noteDeed)) {
    yield made ? Math.min(1, moves.length / made.moves.length) : 1 - 1 / (1 + moves.length / SOME);
    if (effect === null) continue;
    const file = typeof effect.file === 'string' ? effect.file : files[0].name;
    const find = (
      /** @type {CodeFinding['severity']} */ severity,
      /** @type {string} */ code,
      /** @type {string} */ message,
    ) => void findings.push({ severity, code, message, file, line: effect.line ?? 0 });
    const found = effectMoves(doc, frames, from, effect, made !== null);
    if ('message' in found) {
      find('error', 'impossible', `The arm cannot make this move: ${found.message.replace(/\.$/, '')}.`);
      isSame = false;
      break;
    }
    for (const frame of found.missing) {
      if (told.has(frame)) continue;
      told.add(frame);
      find('warning', 'unknown-frame', `The model has no ${frame}: taken as one that changes nothing.`);
    }
    for (const done of found.moves) {
      const wanted = made?.moves[moves.length];
      from = done.followed.end;
      const margins = moveMargins(doc, done);
      const T_base_user = wanted && frames.userPose(wanted.move.userFrame);
      const cost = T_base_user
        ? decimalsCost(doc.robot, wanted, { ...done, T_base_user }, loose)
        : { along: [{ millimetres: 0, degrees: 0 }], loose };
      loose = cost.loose;
      const rounding = mostOf([before, ...cost.along]);
      before = cost.along[cost.along.length - 1];
      const { step, deviation, against, limited } = made
        ? compared(done, wanted, cost.along, language)
        : { step: -1, deviation: null, against: [], limited: [] };
      moves.push({
        ...{ file, line: effect.line ?? 0, step, motion: done.motion },
        ...{ deviation, rounding, margins, configuration: done.configuration },
      });
      largest.millimetres = Math.max(largest.millimetres, deviation?.millimetres ?? 0);
      largest.degrees = Math.max(largest.degrees, deviation?.degrees ?? 0);
      for (const difference of against) {
        find('error', 'differs', `This is not as in the program: ${difference}.`);
        isSame = false;
      }
      for (const text of limited) find('warning', 'speed-limit', text);
      if (wanted?.lost) find('warning', 'lost-law', lostText(wanted.lost));
      for (const [code, message] of concerns(done, margins, letters)) find('warning', code, message);
      letters = done.configuration?.split(',')[0] ?? letters;
    }
  }
  if (made && isSame) {
    for (const { message, where } of deedDifferences(deeds, deedsOf(made.program.steps), moves))
      findings.push({
        severity: 'error',
        code: 'differs',
        message: `This is not as in the program: ${message}.`,
        ...where,
      });
  }
  if (made && moves.length !== made.moves.length)
    findings.push({
      severity: 'error',
      code: 'moves',
      message: `The code makes ${moves.length} moves, the program ${made.moves.length}.`,
      file: files[0].name,
      line: 0,
    });
  const order = files.map(({ name }) => name);
  const listed = saidOnce(findings).sort((a, b) => order.indexOf(a.file) - order.indexOf(b.file) || a.line - b.line);
  return {
    moves,
    findings: listed,
    deviation: largest,
    isCompared: made !== null,
    matches: isSame && !findings.some(({ severity }) => severity === 'error'),
  };
}

/** What a loop says again and again is said once. @param {readonly CodeFinding[]} findings @returns {CodeFinding[]} */
function saidOnce(findings) {
  /** @type {Map<string, { one: CodeFinding, times: number }>} */
  const told = new Map();
  for (const one of findings) {
    const key = JSON.stringify([one.file, one.line, one.message]);
    const known = told.get(key);
    if (known) known.times++;
    else told.set(key, { one, times: 1 });
  }
  return [...told.values()].map(({ one, times }) =>
    times === 1 ? one : { ...one, message: `${one.message} (${times} times)` },
  );
}

/** @param {CodeMove} done @param {MoveMargins} margins @param {string | null} before @returns {[string, string][]} */
function concerns({ motion, configuration, followed }, { limit, singularity, rate }, before) {
  /** @type {[string, string][]} */
  const list = [];
  if (limit && limit.room < 0) list.push(['limit', `Joint ${limit.joint + 1} is past its limit here.`]);
  if (singularity < NEAR_SINGULAR) list.push(['singular', 'The way passes near a singular posture.']);
  if (rate && rate.share > 1)
    list.push([
      'rate',
      `Joint ${rate.joint + 1} would have to ${followed.chain.joints[rate.joint].type === 'prismatic' ? 'slide' : 'turn'} at ${(100 * rate.share).toFixed(0)}% of its rate for this speed.`,
    ]);
  const letters = configuration?.split(',')[0] ?? null;
  if (motion === 'linear' && letters && before && letters !== before && !letters.startsWith('S'))
    list.push([
      'configuration-change',
      `The configuration changes from ${before} to ${letters}, which a line cannot do.`,
    ]);
  return list;
}
