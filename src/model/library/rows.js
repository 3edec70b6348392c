/**
 * How an arm of the library is written down: in millimetres and degrees, standard Denavit-Hartenberg, base and tool the
 * identity.
 *
 * @import { JointDoc, JointType, RobotDoc } from '../document.js'
 * @typedef {[theta: number, d: number, a: number, alpha: number, lower: number, upper: number, home: number]} Row
 */
import { identityPose } from '../document.js';

/**
 * @param {JointType} type
 * @param {Row} row
 * @returns {(index: number) => JointDoc}
 */
const joint =
  (type, [theta, d, a, alpha, lower, upper, home]) =>
  (index) => ({
    id: `joint_${index + 1}`,
    type,
    ...{ theta, d, a, alpha, lower, upper, home },
    link: { kind: 'auto' },
    controller: { sign: 1, offset: 0, coupling: 0 },
  });
export const turn = (/** @type {Row} */ ...row) => joint('revolute', row);
export const slide = (/** @type {Row} */ ...row) => joint('prismatic', row);

/**
 * A joint whose number on the controller's pendant has a part of another's in it.
 * @param {(index: number) => JointDoc} make
 * @param {string} coupledTo
 * @param {number} coupling
 * @returns {(index: number) => JointDoc}
 */
export const coupled = (make, coupledTo, coupling) => (index) => ({
  ...make(index),
  controller: { sign: 1, offset: 0, coupledTo, coupling },
});

/**
 * A joint that the controller counts from elsewhere, or the other way.
 * @param {(index: number) => JointDoc} make
 * @param {1 | -1} sign
 * @param {number} [offset]
 * @returns {(index: number) => JointDoc}
 */
export const counted =
  (make, sign, offset = 0) =>
  (index) => ({ ...make(index), controller: { sign, offset, coupling: 0 } });

/**
 * @param {string} name
 * @param {string | null} source  of its numbers
 * @param {((index: number) => JointDoc)[]} joints
 * @returns {RobotDoc}
 */
export const robot = (name, source, joints) => ({
  name,
  info: source === null ? {} : { source },
  units: { length: 'mm', angle: 'deg' },
  convention: 'standard',
  base: identityPose(),
  tool: identityPose(),
  joints: joints.map((make, index) => make(index)),
});
