/**
 * A serial Denavit–Hartenberg chain, checked once and frozen, in metres and radians. Everything else in this folder takes
 * one; nothing changes one.
 *
 * @import { Packed } from './packed.js'
 * @import { Pose } from './pose.js'
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
 *
 * @typedef {object} ChainDescription
 * @property {Convention} convention
 * @property {ArrayLike<number>} [base]  frame 0 seen from the world; missing means the same
 * @property {ArrayLike<number>} [tool]  the TCP seen from the flange; missing means the same
 * @property {readonly JointRow[]} joints
 *
 * @typedef {object} Chain
 * @property {Convention} convention
 * @property {Pose} base   a fresh copy at each reading, as is `tool`
 * @property {Pose} tool
 * @property {readonly Joint[]} joints
 * @property {number} dof
 * @property {readonly [number, number, number]} shoulder  the point that `reach` is measured from (reach.js)
 * @property {number} reach  no posture within the limits puts the TCP farther from the shoulder; m, perhaps Infinity
 * @property {number} characteristicLength  m; an angle times this is worth as much as a displacement (reach.js)
 * @property {Packed} packed
 */
import { pack } from './packed.js';
import { identity, requirePose } from './pose.js';
import { measureReach } from './reach.js';

/** @param {unknown} value */
const show = (value) => (typeof value === 'string' ? `'${value}'` : String(value));

/** @param {JointRow} row @param {number} index @returns {Joint} */
function checkedJoint(row, index) {
  const name = `joint ${index + 1}`;
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

/**
 * Throws if the description is not of a chain: that is a caller's mistake; a person's has been turned into an issue before.
 * @param {ChainDescription} description
 * @returns {Readonly<Chain>}
 */
export function createChain({ convention, base = identity(), tool = identity(), joints }) {
  if (convention !== 'standard' && convention !== 'modified') {
    throw new RangeError(`Expected the convention to be 'standard' or 'modified', got ${show(convention)}.`);
  }
  if (!Array.isArray(joints)) throw new TypeError(`Expected the joints to be an array, got ${show(joints)}.`);
  if (joints.length === 0) throw new RangeError('Expected at least 1 joint, got 0.');
  const ownBase = Float64Array.from(requirePose(base, 'the base'));
  const ownTool = Float64Array.from(requirePose(tool, 'the tool'));
  const ownJoints = Object.freeze(joints.map(checkedJoint));
  const packed = pack(convention, ownJoints, ownBase, ownTool);
  return Object.freeze({
    convention,
    // A typed array cannot be frozen; a copy can be spoilt without harm.
    get base() {
      return ownBase.slice();
    },
    get tool() {
      return ownTool.slice();
    },
    joints: ownJoints,
    dof: ownJoints.length,
    ...measureReach(packed),
    packed,
  });
}
