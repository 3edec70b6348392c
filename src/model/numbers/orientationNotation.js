/**
 * The orientation of base or tool in the notation that a person likes. The document keeps roll, pitch, yaw or a quaternion,
 * whichever was typed; looking at it in another notation changes nothing. Notations that only call the kept numbers by other
 * names (FANUC W P R, KUKA A B C) show and set those very numbers; for the others they are computed.
 *
 * @import { PoseDoc, Units } from '../document.js'
 *
 * @typedef {'rpy' | 'wpr' | 'abc' | 'zyz' | 'quaternion'} Notation
 */
import { eulerAnglesOf, poseFromEulerAngles } from '../../kinematics/orientations/eulerAngles.js';
import { quaternionOf } from '../../kinematics/orientations/quaternion.js';
import { rollPitchYawOf } from '../../kinematics/orientation.js';
import { compilePose } from '../compile.js';
import { readAngle } from '../robot/convertConvention.js';
import { toKernel } from '../units.js';

/** @type {readonly Notation[]} */
export const NOTATIONS = ['rpy', 'wpr', 'abc', 'zyz', 'quaternion'];

const ORIGIN = [0, 0, 0];

/** Significant digits of a computed quaternion; the last one of a double is noise. */
const DIGITS = 15;

/**
 * @param {PoseDoc} pose
 * @param {Notation} notation
 * @param {Units} units
 * @returns {{ numbers: readonly number[], isKept: boolean }} angles in document units, or x y z w; whether they are the
 *   document's own numbers
 */
export function orientationOf({ rpy, quaternion }, notation, units) {
  const T = () => compilePose({ xyz: ORIGIN, ...(rpy && { rpy }), ...(quaternion && { quaternion }) }, units);
  const angles = (/** @type {Iterable<number>} */ radians) =>
    Array.from(radians, (value) => readAngle(value, units.angle));
  switch (notation) {
    case 'rpy':
    case 'wpr':
    case 'abc': {
      const numbers = quaternion ? angles(rollPitchYawOf(T())) : (rpy ?? ORIGIN);
      return { numbers: notation === 'abc' ? numbers.toReversed() : numbers, isKept: !quaternion };
    }
    case 'zyz':
      return { numbers: angles(eulerAnglesOf(T(), 'ZYZ').angles), isKept: false };
    case 'quaternion':
      if (quaternion) return { numbers: quaternion, isKept: true };
      return { numbers: Array.from(quaternionOf(T()), (value) => Number(value.toPrecision(DIGITS))), isKept: false };
    default:
      throw new TypeError(`Unknown notation: ${notation}`);
  }
}

/**
 * A pose turned as these numbers say.
 * @param {PoseDoc} pose
 * @param {Notation} notation
 * @param {readonly number[]} numbers  finite
 * @param {Units} units
 * @returns {PoseDoc} with roll, pitch, yaw, or with a quaternion if that was typed
 */
export function withOrientation({ xyz }, notation, numbers, units) {
  if (notation === 'quaternion') return { xyz, quaternion: numbers };
  if (notation === 'abc') return { xyz, rpy: numbers.toReversed() };
  if (notation !== 'zyz') return { xyz, rpy: numbers };
  const T = poseFromEulerAngles(
    ORIGIN,
    numbers.map((value) => toKernel('angle', value, units)),
    'ZYZ',
  );
  return { xyz, rpy: rollPitchYawOf(T).map((value) => readAngle(value, units.angle)) };
}
