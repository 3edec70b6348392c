/**
 * MOVE NEAR, AWAY, ABOUT and AXIS of KAREL as moves to a place: NEAR stops before a position, against the way its tool points, AWAY draws back
 * so from where the arm is, ABOUT turns the tool about a vector of its own frame, AXIS turns or shifts one joint. No controller has confirmed this;
 * what RELATIVE refers to is not published.
 *
 * @import { SystemValues } from './codeFrames.js'
 * @import { Doc } from '../document.js'
 * @import { Effect } from '../../karel/run/machine.js'
 */
import { composed, poseOf, positionOf, radians } from '../../karel/run/positions.js';
import { poseFromAxisAngle } from '../../kinematics/orientations/axisAngle.js';
import { compose } from '../../kinematics/pose.js';
import { postureFromKernel } from '../compile.js';
import { pendantValues } from '../controller/controllerValues.js';
import { positionForCode } from './codeFrames.js';

/** A Cartesian position as KAREL has it. */
const SLOTS = 10;

/** @param {Doc} doc @param {Float64Array} start @param {Effect} effect @param {SystemValues} system @returns {Effect | { message: string }} */
export function asPlainMove(doc, start, effect, system) {
  const { to, by, axis, position, isJoint, vector } = effect;
  if (to === 'TO' || to === 'ALONG') return effect;
  if (to === 'RELATIVE')
    return { message: `MOVE ${to} is not simulated here, since nothing published says in which frame it is meant.` };
  const posture = postureFromKernel(doc.robot, start);
  if (to === 'AXIS') {
    const joints = pendantValues(doc.robot, posture);
    const value = joints[Number(axis) - 1];
    if (value === undefined) return { message: `Expected an axis from 1 to ${joints.length}, got ${String(axis)}.` };
    return { ...effect, to: 'TO', isJoint: true, position: joints.with(Number(axis) - 1, value + Number(by)) };
  }
  if (isJoint) return { message: 'MOVE NEAR takes a Cartesian position here, got joint values.' };
  const here = to === 'AWAY' || to === 'ABOUT' ? positionForCode({ ...doc, posture }, system, false) : position;
  if (!Array.isArray(here) || here.slice(0, 6).some((one) => typeof one !== 'number'))
    return { ...effect, to: 'TO', position: undefined };
  const whole = Array.from({ length: SLOTS }, (_, i) => Number(here[i] ?? 0));
  const goal =
    to === 'ABOUT' ? turnedAbout(whole, vector, Number(by)) : composed(whole, [0, 0, -Number(by), 0, 0, 0, 0, 0, 0, 0]);
  if (!goal) return { message: 'MOVE ABOUT takes a vector that is not zero.' };
  return { ...effect, to: 'TO', isJoint: false, position: [...goal.slice(0, 6), ...whole.slice(6)] };
}

/** @param {readonly number[]} position @param {unknown} vector  as the tool has it @param {number} angle  degrees */
function turnedAbout(position, vector, angle) {
  const axis = Array.isArray(vector) ? vector.map(Number) : [];
  if (axis.length !== 3 || !(Math.hypot(...axis) > 0)) return null;
  return positionOf(compose(poseOf(position), poseFromAxisAngle([0, 0, 0], axis, radians(angle))), 0);
}
