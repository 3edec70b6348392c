/**
 * A chain of joints, as a URDF has them → a robot of ours: its joints' axes become a Denavit–Hartenberg table, what is left over goes to base and
 * tool, and the two are held against each other at many postures before anybody sees the table.
 *
 * @import { Pose } from '../../kinematics/pose.js'
 * @import { Issue } from '../../model/issues.js'
 * @import { JointDoc, PoseDoc, RobotDoc } from '../../model/document.js'
 * @import { Row } from './dhFromAxes.js'
 * @import { UrdfJoint } from './urdfRobot.js'
 *
 * @typedef {object} Snap   what treating nearly parallel axes as parallel would do
 * @property {number} after   the joint after whose axis the next is nearly parallel, from 1
 * @property {number} angle   between the two, degrees
 * @property {number} moves   by how much it moves the tool at the most, m, in the postures that were looked at
 */
import { tcpPose } from '../../kinematics/forward.js';
import { rollPitchYawOf } from '../../kinematics/orientation.js';
import { poseFromAxisAngle } from '../../kinematics/orientations/axisAngle.js';
import { compose, identity, position, translation } from '../../kinematics/pose.js';
import { createRandom } from '../../kinematics/random.js';
import { compileRobot } from '../../model/compile.js';
import { shownText } from '../../model/shownText.js';
import { convertAngle, toDegrees } from '../../model/units.js';
import { fileIssue } from '../fileIssues.js';
import { dhFromAxes } from './dhFromAxes.js';
import { idsFor } from './ids.js';
import { moves } from './urdfChain.js';

/** A table that differs from its URDF by more than this, in metres or radians, is refused. */
const EXACT = 1e-8;

/** Digits that rounding left, here or in the file, are taken off a table if that moves the tool by less (m, rad). */
const TIDY = 1e-9;

/** How many decimals are tried: of metres, of degrees. The first rounds what 1.570796 was meant to be. */
const TIDY_DIGITS = [
  { length: 9, angle: 6 },
  { length: 12, angle: 9 },
];

/** Postures at which table and URDF are compared. */
const POSTURES = 100;
const FARTHEST_SLIDE = 1; // m, of a slide without limits

const UNITS = /** @type {const} */ ({ length: 'm', angle: 'deg' });

const NO_LIMITS = { lower: -Infinity, upper: Infinity };

/** What a joint does at a value: about or along its axis. @param {UrdfJoint} joint @param {number} value */
const motion = ({ type, axis }, value) =>
  type === 'prismatic' ? translation(axis.map((part) => part * value)) : poseFromAxisAngle([0, 0, 0], axis, value);

/**
 * The tip seen from the base, by the URDF's own rule: origin, then motion, joint after joint.
 * @param {readonly UrdfJoint[]} path
 * @param {ArrayLike<number>} q  of the joints that move
 */
export function urdfPose(path, q) {
  let T = identity();
  let i = 0;
  for (const joint of path) {
    T = compose(T, joint.T_parent_joint);
    if (moves(joint)) T = compose(T, motion(joint, q[i++]));
    if (joint.T_joint_child) T = compose(T, joint.T_joint_child);
  }
  return T;
}

/** The axes at zero joint values, seen from the base. @param {readonly UrdfJoint[]} path */
function axesOf(path) {
  let T = identity();
  const axes = [];
  for (const joint of path) {
    T = compose(T, joint.T_parent_joint);
    if (moves(joint)) {
      const [x, y, z] = joint.axis;
      const direction = [0, 1, 2].map((k) => T[k] * x + T[4 + k] * y + T[8 + k] * z);
      axes.push({ point: position(T), direction, slides: joint.type === 'prismatic' });
    }
    if (joint.T_joint_child) T = compose(T, joint.T_joint_child);
  }
  return axes;
}

/** @param {readonly UrdfJoint[]} joints  that move @returns {Float64Array[]} */
function postures(joints) {
  const random = createRandom(1);
  return Array.from({ length: POSTURES }, () =>
    Float64Array.from(joints, ({ type, limit }) => {
      const reach = type === 'prismatic' ? FARTHEST_SLIDE : Math.PI;
      const { lower, upper } = type === 'continuous' || !limit ? NO_LIMITS : limit;
      const from = Number.isFinite(lower) ? lower : Math.min(upper, reach) - 2 * reach;
      const to = Number.isFinite(upper) ? upper : from + 2 * reach;
      return from + random() * (to - from);
    }),
  );
}

/** The largest difference of two poses' numbers. @param {ArrayLike<number>} A @param {ArrayLike<number>} B */
function apart(A, B) {
  let most = 0;
  for (let i = 0; i < 16; i++) most = Math.max(most, Math.abs(A[i] - B[i]));
  return most;
}

/**
 * @param {readonly UrdfJoint[]} path  2 to 6 of which move
 * @param {{ name: string, source: string, snap?: number }} given  snap: radians
 * @returns {{ robot: RobotDoc, issues: [], snaps: Snap[] } | { robot: null, issues: Issue[], snaps: Snap[] }}
 */
export function armFrom(path, { name, source, snap = 0 }) {
  const joints = path.filter(moves);
  const samples = postures(joints);
  const truth = samples.map((q) => urdfPose(path, q));
  const table = tableFrom(path, snap);
  const build = (/** @type {Digits} */ digits) => robotFrom(joints, table, { name, source, digits });
  const error = (/** @type {RobotDoc} */ robot) => {
    const chain = compileRobot(robot);
    return Math.max(...samples.map((q, i) => apart(tcpPose(chain, q), truth[i])));
  };
  const exact = build(null);
  const off = error(exact);
  const snaps = table.nearlyParallel.map(({ after, angle }) => ({
    after,
    angle: toDegrees(angle),
    moves: snapError(path, Math.max(snap, angle * (1 + 1e-9)), samples, truth),
  }));
  if (snap === 0 && !(off <= EXACT)) {
    const message = `The table that was found differs from the file by ${off.toPrecision(2)} (metres or radians); expected ${EXACT} at most.`;
    return { robot: null, issues: [fileIssue('not-exact', message)], snaps };
  }
  const robot = TIDY_DIGITS.map(build).find((tidy) => error(tidy) <= off + TIDY) ?? exact;
  return { robot, issues: [], snaps };
}

/** @param {readonly UrdfJoint[]} path @param {number} snap */
const tableFrom = (path, snap) => dhFromAxes(axesOf(path), urdfPose(path, new Float64Array(path.length)), snap);

/**
 * @param {readonly UrdfJoint[]} path
 * @param {number} snap
 * @param {readonly Float64Array[]} samples
 * @param {readonly Pose[]} truth
 */
function snapError(path, snap, samples, truth) {
  const chain = compileRobot(
    robotFrom(path.filter(moves), tableFrom(path, snap), { name: '', source: '', digits: null }),
  );
  const distance = (/** @type {ArrayLike<number>} */ A, /** @type {ArrayLike<number>} */ B) =>
    Math.hypot(A[12] - B[12], A[13] - B[13], A[14] - B[14]);
  return Math.max(...samples.map((q, i) => distance(tcpPose(chain, q), truth[i])));
}

/** @typedef {{ length: number, angle: number } | null} Digits  decimals that are kept; null: all */

/** @param {number} value @param {number | undefined} decimals */
const rounded = (value, decimals) => (decimals === undefined ? value : Number(value.toFixed(decimals))) + 0; // no −0

/**
 * @param {readonly UrdfJoint[]} joints
 * @param {ReturnType<typeof dhFromAxes>} table
 * @param {{ name: string, source: string, digits: Digits }} given
 * @returns {RobotDoc}
 */
function robotFrom(joints, { T_base_frame0, rows, T_flange_tip }, { name, source, digits }) {
  const length = (/** @type {number} */ metres) => rounded(metres, digits?.length);
  const angle = (/** @type {number} */ radians) => rounded(convertAngle(radians, 'rad', 'deg'), digits?.angle);
  /** @param {ArrayLike<number>} T @returns {PoseDoc} */
  const pose = (T) => ({ xyz: position(T).map(length), rpy: rollPitchYawOf(T).map(angle) });
  const ids = idsFor(
    joints.map((joint) => joint.name),
    'joint',
  );
  return {
    name: shownText(name),
    info: { source },
    units: UNITS,
    convention: 'standard',
    base: pose(T_base_frame0),
    tool: pose(T_flange_tip),
    joints: joints.map((joint, i) => jointFrom(joint, rows[i], { id: ids[i], length, angle })),
  };
}

/**
 * @param {UrdfJoint} joint
 * @param {Row} row
 * @param {{ id: string, length: (metres: number) => number, angle: (radians: number) => number }} given
 * @returns {JointDoc}
 */
function jointFrom({ name, type, limit }, { theta, d, a, alpha }, { id, length, angle }) {
  const slides = type === 'prismatic';
  const value = (/** @type {number} */ number) => (slides ? number : convertAngle(number, 'rad', 'deg'));
  const { lower, upper } = limit && type !== 'continuous' ? limit : NO_LIMITS;
  const label = shownText(name);
  return {
    id,
    ...(label !== id && label !== '' && { label }),
    type: slides ? 'prismatic' : type === 'continuous' ? 'continuous' : 'revolute',
    theta: angle(theta),
    d: length(d),
    a: length(a),
    alpha: angle(alpha),
    ...(Number.isFinite(lower) && { lower: value(lower) }),
    ...(Number.isFinite(upper) && { upper: value(upper) }),
    ...(limit?.velocity !== undefined && { velocity: value(limit.velocity) }),
    ...(limit?.effort !== undefined && { effort: limit.effort }),
    link: { kind: 'auto' },
    controller: { sign: 1, offset: 0, coupling: 0 },
  };
}
