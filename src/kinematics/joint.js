/**
 * One row of a Denavit–Hartenberg table in metres and radians, checked.
 *
 * @typedef {'standard' | 'modified'} Convention
 *
 * @typedef {object} JointRow
 * @property {'revolute' | 'prismatic'} type
 * @property {number} a      link length, m
 * @property {number} alpha  link twist, rad
 * @property {number} d      link offset, m; the joint value adds to it if the joint slides
 * @property {number} theta  joint angle, rad; the joint value adds to it if the joint turns
 * @property {number} [lower]  limits of the joint value; missing means unlimited
 * @property {number} [upper]
 *
 * @typedef {Required<Readonly<JointRow>>} Joint
 */

/** A wrong value as a message shows it. @param {unknown} value */
export const show = (value) => (typeof value === 'string' ? `'${value}'` : String(value));

/**
 * Throws if the row is none.
 * @param {JointRow} row
 * @param {number} index  from 0, for the message
 * @returns {Joint}
 */
export function checkedJoint(row, index) {
  const name = `joint ${index + 1}`;
  if (row === null || typeof row !== 'object')
    throw new TypeError(`Expected ${name} to be an object, got ${show(row)}.`);
  const { type, a, alpha, d, theta, lower = -Infinity, upper = Infinity } = row;
  if (type !== 'revolute' && type !== 'prismatic') {
    throw new RangeError(`Expected ${name} to be 'revolute' or 'prismatic', got ${show(type)}.`);
  }
  for (const [field, value] of Object.entries({ a, alpha, d, theta })) {
    if (!Number.isFinite(value))
      throw new RangeError(`Expected ${name}'s ${field} to be a finite number, got ${show(value)}.`);
  }
  for (const [field, value] of Object.entries({ lower, upper })) {
    if (typeof value !== 'number' || Number.isNaN(value)) {
      throw new RangeError(`Expected ${name}'s ${field} limit to be a number, got ${show(value)}.`);
    }
  }
  if (lower > upper || lower === Infinity || upper === -Infinity) {
    throw new RangeError(`Expected ${name}'s lower limit to be at most its upper limit, got ${lower} and ${upper}.`);
  }
  return Object.freeze({ type, a, alpha, d, theta, lower, upper });
}
