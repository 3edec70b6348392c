/**
 * Solutions that are not isolated: postures from which the joints can move while the tool stands still.
 *
 * @import { Family } from '../candidates.js'
 * @import { Loop } from './loopClosure.js'
 */
import { closeLoopHolding, freeDirection } from './loopClosure.js';
import { wrapped } from './loopSolutions.js';

/** The last pivot over the first: above this nothing can move. */
const SINGULAR = 1e-6;

/** So far (radians, arm lengths) the joint that moves most is moved to see whether the others can follow. */
const TRY = 0.05;

/** Joints that move by less than this, while another moves by 1, stand still. */
const STILL = 1e-6;

const direction = new Float64Array(6);

/**
 * @param {Loop} loop
 * @param {Float64Array} q
 * @returns {number[] | null} the joints that move, or null if none can
 */
function movingJoints(loop, q) {
  if (freeDirection(loop, q, direction) > SINGULAR) return null;
  const most = direction.findIndex((value) => Math.abs(value) === 1);
  const moved = q.map((value, i) => value + TRY * direction[i]);
  if (!closeLoopHolding(loop, moved, most)) return null;
  return [0, 1, 2, 3, 4, 5].filter((i) => Math.abs(moved[i] - q[i]) > STILL);
}

/**
 * @param {Loop} loop
 * @param {Float64Array[]} found
 * @returns {{ isolated: Float64Array[], families: Family[] }}
 */
export function familiesAmong(loop, found) {
  /** @type {Float64Array[]} */
  const isolated = [];
  /** @type {Family[]} */
  const families = [];
  for (const q of found) {
    const joints = movingJoints(loop, q);
    if (!joints) isolated.push(q);
    else if (!families.some((family) => isSameFamily(loop, family, { q, joints }))) {
      families.push({ kind: 'other', q, joints });
    }
  }
  return { isolated, families };
}

/**
 * The same joints move, and the others stand where they stood. (Two families of which all joints move are taken for one.)
 * @param {Loop} loop
 * @param {Family} family
 * @param {{ q: Float64Array, joints: number[] }} other
 */
const isSameFamily = ({ slides }, family, { q, joints }) =>
  family.joints.join() === joints.join() &&
  family.q.every(
    (value, i) => joints.includes(i) || Math.abs(slides[i] ? value - q[i] : wrapped(value - q[i])) < STILL,
  );
