/**
 * MOVE NEAR, AWAY, RELATIVE, ABOUT and AXIS of KAREL as moves to a place. No controller has confirmed what they mean: `ASSUMED` says
 * how they are taken here, and whoever writes or runs one is told.
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

/** @type {Readonly<Record<string, string>>} */
export const ASSUMED = {
  NEAR: 'Not verified: NEAR stops so far before the position, against its z axis.',
  AWAY: 'Not verified: AWAY draws the tool back against its own z axis.',
  RELATIVE:
    'Not verified: RELATIVE shifts the tool by a VECTOR along the axes of the user frame, or by a position in its own frame.',
  ABOUT: 'Not verified: ABOUT turns the tool about a vector in its own frame.',
  AXIS: 'Not verified: AXIS turns or shifts one joint as the pendant counts it.',
};

/** A Cartesian position as KAREL has it. */
const SLOTS = 10;

/** @param {Doc} doc @param {Float64Array} start @param {Effect} effect @param {SystemValues} system @returns {Effect | { message: string }} */
export function asPlainMove(doc, start, effect, system) {
  const { to, by, axis, position, isJoint } = effect;
  if (to === 'TO' || to === 'ALONG') return effect;
  const posture = postureFromKernel(doc.robot, start);
  if (to === 'AXIS') {
    const joints = pendantValues(doc.robot, posture);
    const value = joints[Number(axis) - 1];
    if (value === undefined) return { message: `Expected an axis from 1 to ${joints.length}, got ${String(axis)}.` };
    return { ...effect, to: 'TO', isJoint: true, position: joints.with(Number(axis) - 1, value + Number(by)) };
  }
  if (isJoint) return { message: `MOVE ${to} takes a Cartesian position here, got joint values.` };
  const here = wholePosition(to === 'NEAR' ? position : positionForCode({ ...doc, posture }, system, false));
  if (!here) return { ...effect, to: 'TO', position: undefined };
  const goal = goalFrom(here, effect);
  if ('message' in goal) return goal;
  return { ...effect, to: 'TO', isJoint: false, position: [...goal.slice(0, 6), ...here.slice(6)] };
}

/** @param {unknown} value @returns {number[] | null} null: a part of it was never set */
function wholePosition(value) {
  if (!Array.isArray(value) || !areNumbers(value.slice(0, 6), 6)) return null;
  return Array.from({ length: SLOTS }, (_, i) => Number(value[i] ?? 0));
}

/** @param {unknown} values @param {number} count @returns {values is number[]} */
const areNumbers = (values, count) =>
  Array.isArray(values) && values.length === count && values.every((one) => typeof one === 'number');

/** @param {number[]} here @param {Effect} effect @returns {readonly number[] | { message: string }} */
function goalFrom(here, { to, by, vector }) {
  if (to === 'ABOUT') {
    if (!areNumbers(vector, 3) || !(Math.hypot(...vector) > 0))
      return { message: 'MOVE ABOUT takes a vector that is not zero.' };
    return positionOf(compose(poseOf(here), poseFromAxisAngle([0, 0, 0], vector, radians(Number(by)))), 0);
  }
  if (to !== 'RELATIVE') return composed(here, [0, 0, -Number(by), 0, 0, 0, 0, 0, 0, 0]);
  if (areNumbers(by, 3)) return here.map((value, i) => value + (by[i] ?? 0));
  const offset = wholePosition(by);
  return offset ? composed(here, offset) : { message: 'MOVE RELATIVE takes a vector or a position that has been set.' };
}
