/**
 * Joint values as code has them, next to a singular posture: where their decimals alone would put the arm into it, the last
 * decimal goes the other way. Out of a singular posture there may be no way on, and no side of it is told there.
 *
 * @import { RobotDoc } from '../document.js'
 * @import { Chain } from '../../kinematics/chain.js'
 */
import { DECIMALS, rounded } from '../../karel/write/neutral.js';
import { dexterity } from '../../kinematics/dexterity.js';
import { compilePosture } from '../compile.js';
import { sideOfLimits } from './insideLimits.js';
import { postureFromPendant } from './pendantNumbers.js';

/** Of the last decimal. */
const STEP = 10 ** -DECIMALS;
/** Degrees, mm: a value nearer than this to the one with decimals is that one, but for what solving or typing it cost. */
const SAME = 1e-6;

/**
 * @param {RobotDoc} robot
 * @param {Chain} chain
 * @param {Float64Array} q            the posture
 * @param {readonly number[]} values  the pendant's values of it
 */
export function valuesBeside(robot, chain, q, values) {
  const read = (/** @type {readonly number[]} */ numbers) => postureFromPendant(robot, numbers.map(Math.fround));
  const isSingular = (/** @type {ArrayLike<number>} */ posture) => {
    const { rank, freedoms } = dexterity(chain, posture);
    return rank < freedoms;
  };
  const written = values.map(rounded);
  if (!isSingular(compilePosture(robot, read(written))) || isSingular(q)) return [...values];
  for (const [i, value] of values.entries()) {
    if (Math.abs(value - written[i]) < SAME) continue;
    const other = written.with(i, rounded(written[i] + Math.sign(value - written[i]) * STEP));
    const posture = read(other);
    const isInside = posture.every((there, k) => sideOfLimits(robot, k, there) === 0);
    if (isInside && !isSingular(compilePosture(robot, posture))) return values.with(i, other[i]);
  }
  return [...values];
}
