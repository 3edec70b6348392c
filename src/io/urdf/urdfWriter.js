/**
 * A robot of ours → URDF 1.0: joints at the frames of armFrames.js, so that every axis is z and there are no helper joints. What URDF has no place for is left out, which urdfLosses.js tells.
 *
 * @import { Doc, JointDoc, Units } from '../../model/document.js'
 */
import { rollPitchYawOf } from '../../kinematics/orientation.js';
import { position } from '../../kinematics/pose.js';
import { isSliding, limitsOf, quantityOf } from '../../model/document.js';
import { toKernel } from '../../model/units.js';
import { armFrames } from '../armFrames.js';
import { bothLimits, PLACEHOLDERS } from '../placeholders.js';
import { idsFor } from './ids.js';

/** @param {number} value */
const number = (value) => String(value + 0); // no −0
/** @param {readonly number[]} values */
const numbers = (values) => values.map(number).join(' ');

/** @param {ArrayLike<number>} T */
const originOf = (T) => `<origin xyz="${numbers(position(T))}" rpy="${numbers(rollPitchYawOf(T))}"/>`;

/** @param {JointDoc} joint @param {Units} units */
function limitOf(joint, units) {
  const value = (/** @type {number} */ typed) => toKernel(quantityOf(joint, 'lower'), typed, units);
  const { effort = PLACEHOLDERS.effort, velocity } = joint;
  const rates = `effort="${number(effort)}" velocity="${number(velocity === undefined ? PLACEHOLDERS.velocity : value(velocity))}"`;
  if (urdfTypeOf(joint) === 'continuous') return `<limit ${rates}/>`;
  const { lower, upper } = bothLimits(joint, units);
  return `<limit lower="${number(lower)}" upper="${number(upper)}" ${rates}/>`;
}

/** As URDF calls it: a turn without any limit is continuous. @param {JointDoc} joint */
export function urdfTypeOf(joint) {
  if (isSliding(joint)) return 'prismatic';
  const { lower, upper } = limitsOf(joint);
  return lower === -Infinity && upper === Infinity ? 'continuous' : 'revolute';
}

/** @param {string} name */
const linkText = (name) => {
  const { mass, inertia } = PLACEHOLDERS;
  return `  <link name="${name}">
    <inertial>
      <origin xyz="0 0 0" rpy="0 0 0"/>
      <mass value="${mass}"/>
      <inertia ixx="${inertia}" ixy="0" ixz="0" iyy="${inertia}" iyz="0" izz="${inertia}"/>
    </inertial>
  </link>`;
};

/** @param {string} name @param {string} parent @param {string} child @param {ArrayLike<number>} T */
const fixedText = (name, parent, child, T) => `  <joint name="${name}" type="fixed">
    ${originOf(T)}
    <parent link="${parent}"/>
    <child link="${child}"/>
  </joint>`;

/** What robot and joints are called in the file. @param {Doc['robot']} robot */
export function urdfNames({ name, joints }) {
  const [robot] = idsFor([name], 'robot');
  const ids = joints.map(({ id }) => id);
  return { robot, joints: idsFor(ids, 'joint', ['flange_joint', 'tool0_joint']) };
}

/**
 * @param {Doc} doc
 * @returns {string}
 */
export function writeUrdf({ robot }) {
  const { joints, units, convention } = robot;
  const { robot: robotName, joints: jointNames } = urdfNames(robot);
  const links = ['base_link', ...joints.map((_, i) => `link_${i + 1}`)];
  const { T_parent_joints, T_last_flange, T_flange_tool } = armFrames(robot);
  const parts = joints.map(
    (joint, i) => `  <joint name="${jointNames[i]}" type="${urdfTypeOf(joint)}">
    ${originOf(T_parent_joints[i])}
    <parent link="${links[i]}"/>
    <child link="${links[i + 1]}"/>
    <axis xyz="0 0 1"/>
    ${limitOf(joint, units)}
  </joint>`,
  );
  const last = links[links.length - 1];
  return `<?xml version="1.0" encoding="UTF-8"?>
<!-- Made with Denavit from a ${convention} Denavit-Hartenberg table. Masses and inertias are placeholders, and so are an effort
     of ${PLACEHOLDERS.effort} and a velocity of ${PLACEHOLDERS.velocity}: the table does not have them. -->
<robot name="${robotName}">
${[...links.map(linkText), '  <link name="flange"/>', '  <link name="tool0"/>', ...parts].join('\n')}
${fixedText('flange_joint', last, 'flange', T_last_flange)}
${fixedText('tool0_joint', 'flange', 'tool0', T_flange_tool)}
</robot>
`;
}
