/**
 * A move of code beside the program's own: how far apart their ways are, and what else the code does otherwise.
 *
 * @import { CodeMove } from './codeMoves.js'
 * @import { Lost } from './lostLaws.js'
 * @import { Deviation } from './moveMargins.js'
 * @import { MadeMove } from './neutralProgram.js'
 * @import { NeutralMove, NeutralTarget } from '../../karel/write/neutral.js'
 */
import { speedFor } from '../../karel/write/fanucMoves.js';
import { tcpPose } from '../../kinematics/forward.js';
import { poseDifference } from '../../kinematics/pose.js';
import { fromKernel } from '../units.js';
import { postureAlong } from './followMoves.js';

/** What code may differ by in any case: mm and degrees. */
const TOLERANCE = 0.01;

/** Speeds are written without decimals, and a controller's reals have 24 bits. */
const HALF = 0.5;
const SINGLE = 2 ** -23;

/** Shares of a way at which the two are compared. */
const SHARES = [0.25, 0.5, 0.75, 1];

const UNITS = /** @type {const} */ ({ length: 'mm', angle: 'deg' });
const SPEED_UNITS = /** @type {Readonly<Record<string, string>>} */ ({
  '%': '%',
  'mm/s': 'mm/sec',
  'deg/s': 'deg/sec',
});

/** For people: three digits, and no exponent. @param {number} value */
const short = (value) => (value < 1e-4 ? '0' : String(Number(value.toPrecision(3))));

/** A joint that is so far from where it should be (radians, metres) stands in another posture. */
const ANOTHER = 1e-2;

/** So many numbers a Cartesian position has in effects. */
const CARTESIAN = 10;

/** @param {CodeMove} done @param {MadeMove | undefined} wanted @param {Deviation} rounding @param {'fanuc' | 'krl'} language @returns {{ step: number, deviation: Deviation, against: string[], limited: string[] }} */
export function compared(done, wanted, rounding, language) {
  if (!wanted)
    return {
      ...{ step: -1, deviation: { millimetres: Infinity, degrees: Infinity }, limited: [] },
      against: ['a move that the program does not have'],
    };
  const deviation = deviationOf(done, wanted);
  const { lost, move } = wanted;
  return {
    step: move.step,
    deviation: {
      millimetres: Math.max(deviation.millimetres, lost?.deviation.millimetres ?? 0),
      degrees: Math.max(deviation.degrees, lost?.deviation.degrees ?? 0),
    },
    against: differences(done, wanted, deviation, rounding, language),
    limited: speedLimits(done, move, language),
  };
}

/** @param {Lost} lost */
export const lostText = ({ law, deviation: { millimetres, degrees } }) =>
  `The program goes by ${law} here, the code by the joints in proportion: the tool is up to ${millimetres.toFixed(2)} mm and ${degrees.toFixed(2)}° off the program's own way, and the controller rounds the corner in its own manner.`;

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
  else if (isFar) list.push(`${short(deviation.millimetres)} mm and ${short(deviation.degrees)} degrees away`);
  if (isOtherVia(done.via, move.via)) list.push('another point on the way');
  if (isComparable(done, move)) {
    if (!isSpeed(done, move.speed.value) && !isSpeed(done, allowed(move, language)))
      list.push(`a speed of ${done.speed.value} ${done.speed.unit}, not ${move.speed.value}`);
  } else if (language === 'fanuc') list.push(`a speed in ${done.speed.unit}, not in ${move.speed.unit}`);
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

/** Whether a move of code has a speed. @param {CodeMove} done @param {number} value */
const isSpeed = ({ speed }, value) => Math.abs(Number(speed.value) - value) <= HALF + value * SINGLE;

/** Whether a speed is in the program's unit, and can be compared: KRL turns with a speed of their own. @param {CodeMove} done @param {NeutralMove} move */
const isComparable = ({ speed }, move) => speed.value !== null && speed.unit === SPEED_UNITS[move.speed.unit];

/** What a controller takes of the speed that is asked for. @param {NeutralMove} move @param {'fanuc' | 'krl'} language */
const allowed = ({ speed }, language) =>
  language === 'fanuc'
    ? speedFor(speed).value
    : speed.unit === '%'
      ? Math.max(1, Math.round(speed.value))
      : speed.value;

/** @param {CodeMove} done @param {NeutralMove} move @param {'fanuc' | 'krl'} language @returns {string[]} */
function speedLimits(done, move, language) {
  const { speed } = move;
  const isOther = isComparable(done, move) && !isSpeed(done, speed.value);
  if (!isOther || !isSpeed(done, allowed(move, language))) return [];
  return [`The program asks for ${speed.value} ${speed.unit}; the controller takes ${allowed(move, language)}.`];
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
