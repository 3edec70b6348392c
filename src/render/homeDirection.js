/**
 * From where an arm is first seen: from front right, slightly above; but a planar arm, which moves in one plane only, so that
 * its plane is seen and not its edge.
 *
 * @import { Direction } from './viewpoint.js'
 * @import { Chain } from '../kinematics/chain.js'
 */
import { Vector3 } from 'three';
import { toRadians } from '../model/units.js';
import { DIRECTIONS, backwards } from './viewpoint.js';

/** So far from its normal the plane is seen: enough to read which link lies above which. */
const TILT = toRadians(38);

/** Cosines that are this near to 0 or 1 are those of right angles and of parallels. */
const NEAR = 1e-6;

/**
 * The normal of the plane in which every joint moves the arm, if there is one.
 * @param {Chain} chain
 * @param {Float64Array} frames  of the links, in any posture
 */
function planeNormal({ joints, convention }, frames) {
  const first = convention === 'standard' ? 0 : 1; // the frame whose z is the first joint's axis
  const axes = joints.map((_, i) => new Vector3().fromArray(frames, 16 * (first + i) + 8).normalize());
  const normal = axes.find((_, i) => joints[i].type === 'revolute');
  const isInPlane = (/** @type {Vector3} */ axis, /** @type {number} */ i) => {
    const cosine = Math.abs(axis.dot(/** @type {Vector3} */ (normal)));
    return joints[i].type === 'revolute' ? cosine > 1 - NEAR : cosine < NEAR;
  };
  return normal && axes.every(isInPlane) ? normal : null;
}

/**
 * @param {Chain} chain
 * @param {Float64Array} frames
 * @returns {Direction}
 */
export function homeDirection(chain, frames) {
  const usual = backwards(DIRECTIONS.home);
  const normal = planeNormal(chain, frames);
  if (!normal) return DIRECTIONS.home;
  const towards = normal.clone().multiplyScalar(normal.dot(usual) < 0 ? -1 : 1);
  if (towards.angleTo(usual) <= TILT) return DIRECTIONS.home;
  const across = usual.clone().projectOnPlane(towards).normalize();
  const { x, y, z } = towards.multiplyScalar(Math.cos(TILT)).addScaledVector(across, Math.sin(TILT));
  return { azimuth: Math.atan2(y, x), elevation: Math.asin(z) };
}
