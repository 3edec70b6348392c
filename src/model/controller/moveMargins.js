/**
 * How much room a move of code leaves: to the joints' limits, to singular postures, to the joints' rates.
 *
 * @import { Doc } from '../document.js'
 * @import { CodeMove } from './codeMoves.js'
 *
 * @typedef {{ millimetres: number, degrees: number }} Deviation   of the tool: of its place, of its turn
 *
 * @typedef {object} MoveMargins
 * @property {{ joint: number, room: number } | null} limit   the joint that comes nearest to a limit, and how near: rad or m;
 *   below 0 past it; null where no joint has limits
 * @property {number} singularity    the least of one over the condition number: 0 at a singular posture, 1 at best
 * @property {{ joint: number, share: number } | null} rate   the joint that has to go at the largest share of its rate for the
 *   commanded speed of the tool; null where none is commanded, or the joints share the way
 */
import { dexterity } from '../../kinematics/dexterity.js';
import { pathMomentAt } from '../../motion/posturePath.js';
import { limitsOf } from '../program/motionLimits.js';
import { toKernel } from '../units.js';

const UNITS = /** @type {const} */ ({ length: 'mm', angle: 'deg' });
const SAMPLES = 8;

/** @param {Doc} doc @param {CodeMove} move @returns {MoveMargins} */
export function moveMargins({ robot }, { followed, speed, motion }) {
  const { chain, path, way } = followed;
  const { limits } = limitsOf(robot.joints, robot.units);
  /** @type {MoveMargins['limit']} */
  let limit = null;
  /** @type {MoveMargins['rate']} */
  let rate = null;
  let singularity = 1;
  const duration = durationOf(way, speed);
  for (let k = 0; k <= SAMPLES; k++) {
    const { posture, first } = pathMomentAt(path, k / SAMPLES);
    for (const [joint, { lower, upper }] of chain.joints.entries()) {
      const room = Math.min(posture[joint] - lower, upper - posture[joint]);
      if (Number.isFinite(room) && (limit === null || room < limit.room)) limit = { joint, room };
      if (motion === 'joint' || duration === null) continue;
      const share = Math.abs(first[joint]) / duration / limits.rates[joint];
      if (rate === null || share > rate.share) rate = { joint, share };
    }
    singularity = Math.min(singularity, 1 / dexterity(chain, posture).conditionNumber);
  }
  return { limit, singularity, rate };
}

/** How long a way takes at the commanded speed, without speeding up. @param {CodeMove['followed']['way']} way @param {CodeMove['speed']} speed */
function durationOf(way, { value, unit }) {
  if (!way || value === null || !(value > 0)) return null;
  if (unit === 'mm/sec') return way.length > 0 ? way.length / toKernel('length', value, UNITS) : null;
  if (unit === 'deg/sec') return way.turn > 0 ? way.turn / toKernel('angle', value, UNITS) : null;
  return unit === 'sec' ? value : null;
}
