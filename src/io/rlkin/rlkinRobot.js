/**
 * A chain of an rlkin file → a robot of ours. The file has standard Denavit–Hartenberg rows, so that its numbers are taken as
 * they are; only where a constant transform stands between two joints there is no such table yet, and one is found from the
 * axes, as for a URDF.
 *
 * @import { JointDoc, PoseDoc, RobotDoc } from '../../model/document.js'
 * @import { Issue } from '../../model/issues.js'
 * @import { UrdfJoint } from '../urdf/urdfRobot.js'
 * @import { RlkinFile, RlkinFrame, RlkinJoint, RlkinPose } from './rlkinTable.js'
 * @import { RlkinStep } from './rlkinChain.js'
 */
import { rollPitchYawOf } from '../../kinematics/orientation.js';
import { compose, identity, position } from '../../kinematics/pose.js';
import { compilePose } from '../../model/compile.js';
import { identityPose } from '../../model/document.js';
import { shownText } from '../../model/shownText.js';
import { convertAngle, toKernel } from '../../model/units.js';
import { constantOf } from '../armFrames.js';
import { armFrom } from '../urdf/urdfArm.js';
import { idsFor } from '../urdf/ids.js';
import { isJoint } from './rlkinChain.js';

const UNITS = /** @type {const} */ ({ length: 'm', angle: 'deg' });

/** Zero may be left out. @param {readonly (number | undefined)[] | undefined} values */
const three = (values) => [0, 1, 2].map((i) => values?.[i] ?? 0);

/** @param {RlkinPose} pose @returns {PoseDoc} */
const poseFrom = ({ translation, rotation }) => ({ xyz: three(translation), rpy: three(rotation) });

/** @param {PoseDoc} pose */
const isIdentity = ({ xyz, rpy = [] }) => [...xyz, ...rpy].every((value) => value === 0);

/** Several constant poses as one; a single one keeps its numbers. @param {readonly PoseDoc[]} poses @returns {PoseDoc} */
function joined(poses) {
  const telling = poses.filter((pose) => !isIdentity(pose));
  if (telling.length < 2) return telling[0] ?? identityPose();
  const T = telling.map((pose) => compilePose(pose, UNITS)).reduce((product, next) => compose(product, next));
  return { xyz: position(T), rpy: rollPitchYawOf(T).map((angle) => convertAngle(angle, 'rad', 'deg')) };
}

/** A row's constants, with the offset of the joint in that which moves. @param {RlkinJoint} joint */
const rowOf = ({ type, d, theta, a, alpha, offset = 0 }) => ({
  theta: type === 'revolute' ? theta + offset : theta,
  d: type === 'prismatic' ? d + offset : d,
  a,
  alpha,
});

/**
 * @param {readonly RlkinStep[]} path
 * @param {RlkinFile} file
 * @param {string} tip
 * @returns {{ robot: RobotDoc | null, issues: Issue[] }}
 */
export function rlkinRobot(path, { name = '', manufacturer, frames }, tip) {
  const world = /** @type {RlkinFrame} */ (frames.find(({ kind }) => kind === 'world')); // the table asks for one
  const info = manufacturer === undefined ? {} : { manufacturer };
  const first = path.findIndex(isJoint);
  const last = path.findLastIndex(isJoint);
  const between = path.slice(first, last + 1);
  if (!between.every(isJoint)) {
    const steps = stepsFrom(path, world);
    const arm = armFrom(steps, { name, source: `rlkin, ${world.id} to ${tip}` });
    if (!arm.robot) return { robot: null, issues: arm.issues };
    return { robot: { ...arm.robot, name, info: { ...arm.robot.info, ...info } }, issues: [] };
  }
  const ids = idsFor(
    between.map(({ id }) => id),
    'joint',
  );
  const robot = {
    name,
    info,
    units: UNITS,
    convention: /** @type {const} */ ('standard'),
    base: joined([world, ...path.slice(0, first)].map(poseFrom)),
    tool: joined(path.slice(last + 1).map(poseFrom)),
    joints: between.map((joint, i) => jointFrom(joint, ids[i])),
  };
  return { robot, issues: [] };
}

/** @param {RlkinJoint} joint @param {string} id @returns {JointDoc} */
function jointFrom(joint, id) {
  const { type, min, max, speed = 0, wraparound } = joint;
  const label = shownText(joint.id);
  return {
    id,
    ...(label !== id && { label }),
    type: type === 'revolute' && wraparound ? 'continuous' : type,
    ...rowOf(joint),
    ...(min !== undefined && { lower: min }),
    ...(max !== undefined && { upper: max }),
    ...(speed > 0 && { velocity: speed }),
    link: { kind: 'auto' },
    controller: { sign: 1, offset: 0, coupling: 0 },
  };
}

/**
 * The same chain as joints that move before their link: Rz(q) or Tz(q), then the constant part of the row.
 * @param {readonly RlkinStep[]} path
 * @param {RlkinFrame} world
 * @returns {UrdfJoint[]}
 */
function stepsFrom(path, world) {
  const still = { parent: '', child: '', axis: [0, 0, 1], limit: null, mimics: null, line: 0 };
  /** @param {string} name @param {Float64Array} T @returns {UrdfJoint} */
  const fixed = (name, T) => ({ ...still, name, type: 'fixed', T_parent_joint: T });
  return [
    fixed(world.id, compilePose(poseFrom(world), UNITS)),
    ...path.flatMap((step) => {
      if (!isJoint(step)) return [fixed(step.id, compilePose(poseFrom(step), UNITS))];
      const { id, type, wraparound } = step;
      const value = (/** @type {number} */ number) =>
        type === 'prismatic' ? number : toKernel('angle', number, UNITS);
      const { min = -Infinity, max = Infinity, speed = 0 } = step;
      /** @type {UrdfJoint} */
      const moving = {
        ...still,
        name: id,
        type: type === 'revolute' && wraparound ? 'continuous' : type,
        T_parent_joint: identity(),
        limit: { lower: value(min), upper: value(max), ...(speed > 0 && { velocity: value(speed) }) },
      };
      return [moving, fixed(id, constantOf(rowOf(step), { convention: 'standard', units: UNITS }))];
    }),
  ];
}
