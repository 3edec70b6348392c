/**
 * A serial Denavit–Hartenberg chain, checked once and frozen, in metres and radians. Everything else in this folder takes
 * one; nothing changes one.
 *
 * @import { Convention, Joint, JointRow } from './joint.js'
 * @import { Packed } from './packed.js'
 * @import { Pose } from './pose.js'
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
import { checkedJoint, show } from './joint.js';
import { pack } from './packed.js';
import { identity, requirePose } from './pose.js';
import { measureReach } from './reach.js';

/**
 * What a chain hands out as a copy: a typed array cannot be frozen, but a copy can be spoilt without harm. On a prototype,
 * since an object with getters of its own is looked up in as in a dictionary, at every use.
 */
class CheckedChain {
  #base;
  #tool;

  /** @param {Omit<Chain, 'base' | 'tool'>} found @param {Pose} base @param {Pose} tool */
  constructor({ convention, joints, dof, shoulder, reach, characteristicLength, packed }, base, tool) {
    this.convention = convention;
    this.joints = joints;
    this.dof = dof;
    this.shoulder = shoulder;
    this.reach = reach;
    this.characteristicLength = characteristicLength;
    this.packed = packed;
    this.#base = base;
    this.#tool = tool;
    Object.freeze(this);
  }

  get base() {
    return this.#base.slice();
  }

  get tool() {
    return this.#tool.slice();
  }
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
  const measures = measureReach(packed);
  return new CheckedChain({ convention, joints: ownJoints, dof: joints.length, ...measures, packed }, ownBase, ownTool);
}
