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
import { poseDifference } from '../../kinematics/pose.js';
import { fromKernel } from '../units.js';
import { mostOf } from './decimalsCost.js';
import { SHARES, toolOnWay } from './followMoves.js';

/** What code may differ by in any case: mm and degrees. */
const TOLERANCE = 0.01;

/** Speeds are written without decimals, and a controller's reals have 24 bits. */
const HALF = 0.5;
const SINGLE = 2 ** -23;

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

/** @param {CodeMove} done @param {MadeMove | undefined} wanted @param {readonly Deviation[]} costs  of decimals, at the shares @param {'fanuc' | 'krl'} language @returns {{ step: number, deviation: Deviation, against: string[], limited: string[] }} */
export function compared(done, wanted, costs, language) {
  if (!wanted)
    return {
      ...{ step: -1, deviation: { millimetres: Infinity, degrees: Infinity }, limited: [] },
      against: ['a move that the program does not have'],
    };
  const deviations = deviationsOf(done, wanted);
  const deviation = mostOf(deviations);
  const { lost, move } = wanted;
  return {
    step: move.step,
    deviation: {
      millimetres: Math.max(deviation.millimetres, lost?.deviation.millimetres ?? 0),
      degrees: Math.max(deviation.degrees, lost?.deviation.degrees ?? 0),
    },
    against: differences(done, wanted, deviations, costs, language),
    limited: speedLimits(done, move, language),
  };
}

/** @param {Lost} lost */
export const lostText = ({ law, deviation: { millimetres, degrees } }) =>
  `The program goes by ${law} here, the code by the joints in proportion: the tool is up to ${millimetres.toFixed(2)} mm and ${degrees.toFixed(2)}° off the program's own way, and the controller rounds the corner in its own manner.`;

/**
 * How far apart the two are where both have gone by the same shares of their ways. Joint values are where a controller goes, whatever
 * of them an arm with few joints is asked for.
 * @param {CodeMove} done
 * @param {MadeMove} wanted
 * @returns {Deviation[]}
 */
function deviationsOf({ followed, isJoint, T_base_said }, { followed: own }) {
  return SHARES.map((share) => {
    const T_base_code = share === 1 && isJoint ? T_base_said : toolOnWay(followed, share);
    const [x, y, z, a, b, c] = poseDifference(toolOnWay(own, share), T_base_code);
    return {
      millimetres: fromKernel('length', Math.hypot(x, y, z), UNITS),
      degrees: fromKernel('angle', Math.hypot(a, b, c), UNITS),
    };
  });
}

/** @param {CodeMove} done @param {MadeMove} wanted @param {readonly Deviation[]} deviations @param {readonly Deviation[]} costs @param {'fanuc' | 'krl'} language @returns {string[]} */
function differences(done, wanted, deviations, costs, language) {
  const { move, followed } = wanted;
  /** @type {string[]} */
  const list = [];
  if (done.motion !== move.motion) list.push(`a ${done.motion} move, not a ${move.motion} one`);
  if (done.userFrame !== move.userFrame) list.push(`user frame ${done.userFrame}, not ${move.userFrame}`);
  if (done.tool !== move.tool) list.push(`tool ${done.tool}, not ${move.tool}`);
  const isFar = deviations.some(
    ({ millimetres, degrees }, k) =>
      millimetres > Math.max(TOLERANCE, costs[k].millimetres) || degrees > Math.max(TOLERANCE, costs[k].degrees),
  );
  const { millimetres, degrees } = mostOf(deviations);
  const away = Math.max(...done.followed.end.map((value, i) => Math.abs(value - followed.end[i])));
  const end = deviations[deviations.length - 1];
  // The tool may be there with another posture.
  const isOther = done.motion === 'joint' && away > ANOTHER && end.millimetres < 1 && end.degrees < 1;
  if (isOther) list.push('another posture of the arm');
  else if (isFar) list.push(`${short(millimetres)} mm and ${short(degrees)} degrees away`);
  if (isOtherVia(done.via, move.via)) list.push('another point on the way');
  if (isComparable(done, move)) {
    if (!isSpeed(done, move.speed.value) && !isSpeed(done, allowed(move, language)))
      list.push(`a speed of ${done.speed.value} ${done.speed.unit}, not ${move.speed.value}`);
  } else if (language === 'fanuc') list.push(`a speed in ${done.speed.unit}, not in ${move.speed.unit}`);
  const acceleration = Math.max(1, Math.round(move.acceleration));
  if (done.acceleration !== null && Math.abs(done.acceleration - acceleration) > HALF)
    list.push(`an acceleration of ${done.acceleration}%, not ${acceleration}%`);
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
  const isPosition = found.length >= CARTESIAN;
  const numbers = isPosition ? wanted.position : wanted.joints;
  return numbers.some((value, i) => {
    const off = found[i] - value;
    const turns = isPosition && i < 3 ? 0 : 360 * Math.round(off / 360);
    return Math.abs(off - turns) > TOLERANCE;
  });
}
