/**
 * MOVE NEAR, AWAY and AXIS of KAREL as moves to a place: NEAR stops before a position, against the way its tool points, AWAY draws back so from
 * where the arm is, AXIS turns or shifts one joint. No controller has confirmed this; what RELATIVE and ABOUT refer to is not published.
 *
 * @import { SystemValues } from './codeFrames.js'
 * @import { Doc } from '../document.js'
 * @import { Effect } from '../../karel/run/machine.js'
 */
import { composed } from '../../karel/run/positions.js';
import { postureFromKernel } from '../compile.js';
import { pendantValues } from '../controller/controllerValues.js';
import { positionForCode } from './codeFrames.js';

/** A Cartesian position as KAREL has it. */
const SLOTS = 10;

/** @param {Doc} doc @param {Float64Array} start @param {Effect} effect @param {SystemValues} system @returns {Effect | { message: string }} */
export function asPlainMove(doc, start, effect, system) {
  const { to, by, axis, position, isJoint } = effect;
  if (to === 'TO' || to === 'ALONG') return effect;
  if (to === 'RELATIVE' || to === 'ABOUT')
    return { message: `MOVE ${to} is not simulated here, since nothing published says in which frame it is meant.` };
  const posture = postureFromKernel(doc.robot, start);
  if (to === 'AXIS') {
    const joints = pendantValues(doc.robot, posture);
    const value = joints[Number(axis) - 1];
    if (value === undefined) return { message: `Expected an axis from 1 to ${joints.length}, got ${String(axis)}.` };
    return { ...effect, to: 'TO', isJoint: true, position: joints.with(Number(axis) - 1, value + Number(by)) };
  }
  if (isJoint) return { message: 'MOVE NEAR takes a Cartesian position here, got joint values.' };
  const here = to === 'AWAY' ? positionForCode({ ...doc, posture }, system, false) : position;
  if (!Array.isArray(here) || here.slice(0, 6).some((one) => typeof one !== 'number'))
    return { ...effect, to: 'TO', position: undefined };
  const whole = Array.from({ length: SLOTS }, (_, i) => Number(here[i] ?? 0));
  const before = composed(whole, [0, 0, -Number(by), 0, 0, 0, 0, 0, 0, 0]);
  return { ...effect, to: 'TO', isJoint: false, position: [...before.slice(0, 6), ...whole.slice(6)] };
}
