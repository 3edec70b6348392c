/**
 * Joint values as a controller's teach pendant shows them: with its signs, offsets and coupled joints, in degrees and
 * millimetres.
 *
 * @import { JointDoc, RobotDoc, Units } from '../document.js'
 */
import { quantityOf } from '../document.js';
import { fromKernel, toKernel } from '../units.js';

/** @type {Units} */
const PENDANT_UNITS = { length: 'mm', angle: 'deg' };

/**
 * pendant value = sign · q + offset + coupling · (pendant value of the joint `coupledTo`), where q and the offset are in
 * the document's units and the coupling is between pendant values. FANUC measures J3 from the horizontal: J3 is coupled
 * to J2 by −1.
 * @param {RobotDoc} robot
 * @param {readonly number[]} q  in the document's units
 * @returns {number[]} degrees, or millimetres where a joint slides
 */
export function pendantValues({ joints, units }, q) {
  if (q.length !== joints.length) throw new RangeError(`Expected ${joints.length} joint values, got ${q.length}.`);
  /** @type {(number | 'being computed' | undefined)[]} */
  const found = joints.map(() => undefined);

  /** @param {number} index @returns {number} */
  function valueOf(index) {
    const known = found[index];
    if (typeof known === 'number') return known;
    const { id, controller } = joints[index];
    if (known) throw new RangeError(`Expected joints to be coupled without a cycle, got one through "${id}".`);
    found[index] = 'being computed';
    const own = inPendantUnits(joints[index], controller.sign * q[index] + controller.offset, units);
    const value = own + coupledPart(index);
    if (!Number.isFinite(value)) throw new RangeError(`Expected a number for joint "${id}", got ${value}.`);
    found[index] = value;
    return value;
  }

  /** @param {number} index */
  function coupledPart(index) {
    const { coupledTo, coupling } = joints[index].controller;
    if (coupledTo === undefined) return 0;
    const other = joints.findIndex(({ id }) => id === coupledTo);
    if (other >= 0) return coupling * valueOf(other);
    throw new RangeError(
      `Expected joint "${joints[index].id}" to be coupled to a joint of the arm, got "${coupledTo}".`,
    );
  }

  return joints.map((_, index) => valueOf(index));
}

/** A value that has the unit already is not touched: the trip through metres and radians costs digits. */
/** @param {JointDoc} joint @param {number} value @param {Units} units */
function inPendantUnits(joint, value, units) {
  const quantity = quantityOf(joint, 'home');
  if (units[quantity] === PENDANT_UNITS[quantity]) return value;
  return fromKernel(quantity, toKernel(quantity, value, units), PENDANT_UNITS);
}
