/**
 * A pose that was computed → the numbers of a document.
 * @import { PoseDoc, Units } from '../document.js'
 */
import { rollPitchYawOf } from '../../kinematics/orientation.js';
import { readAngle } from '../robot/convertConvention.js';
import { fromKernel } from '../units.js';

/** Significant digits of a computed length; the last one of a double is noise. */
const DIGITS = 15;

/**
 * @param {Float64Array} T  column-major, metres
 * @param {Units} units
 * @returns {PoseDoc} with roll, pitch, yaw
 */
export const poseInUnits = (T, units) => ({
  xyz: [T[12], T[13], T[14]].map((value) => Number(fromKernel('length', value, units).toPrecision(DIGITS)) + 0),
  rpy: rollPitchYawOf(T).map((value) => readAngle(value, units.angle) + 0),
});
