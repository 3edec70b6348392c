/**
 * A robot of ours → URDF 1.0. A joint moves before its link, so that each row's constant part goes into the origin of the next
 * joint: no helper joints, and every axis is z.
 *
 *   standard  A_i(q) = Z(q) · C_i  with  C_i = Rz(θ) Tz(d) Tx(a) Rx(α):  xyz = (a cos θ, a sin θ, d), rpy = (α, 0, θ)
 *   modified  A_i(q) = C_i · Z(q)  with  C_i = Rx(α) Tx(a) Tz(d) Rz(θ)
 *
 * What URDF has no place for is left out, which urdfLosses.js tells.
 *
 * @import { Doc, JointDoc, Units } from '../../model/document.js'
 */
import { exactCosine, exactSine } from '../../kinematics/angles.js';
import { rollPitchYawOf } from '../../kinematics/orientation.js';
import { compose, identity, position } from '../../kinematics/pose.js';
import { compilePose } from '../../model/compile.js';
import { isSliding, limitsOf, quantityOf } from '../../model/document.js';
import { toKernel } from '../../model/units.js';
import { idsFor } from './ids.js';

/** What the format asks for and the model does not have. Real values are the maker's. */
export const PLACEHOLDERS = { mass: 1, inertia: 0.01, effort: 1000, velocity: 1 };

/** An end that is not there while the other is: farther than any arm goes, in radians or metres. */
export const FAR = 1e6;

/** @param {number} value */
const number = (value) => String(value + 0); // no −0
/** @param {readonly number[]} values */
const numbers = (values) => values.map(number).join(' ');

/** The constant part of a row. @param {JointDoc} joint @param {Doc['robot']} robot */
function constantOf(joint, { convention, units }) {
  const [theta, alpha] = [joint.theta, joint.alpha].map((value) => toKernel('angle', value, units));
  const [d, a] = [joint.d, joint.a].map((value) => toKernel('length', value, units));
  const [ct, st, ca, sa] = [exactCosine(theta), exactSine(theta), exactCosine(alpha), exactSine(alpha)];
  return convention === 'standard'
    ? Float64Array.of(ct, st, 0, 0, -st * ca, ct * ca, sa, 0, st * sa, -ct * sa, ca, 0, a * ct, a * st, d, 1)
    : Float64Array.of(ct, ca * st, sa * st, 0, -st, ca * ct, sa * ct, 0, 0, -sa, ca, 0, a, -sa * d, ca * d, 1);
}

/** @param {ArrayLike<number>} T */
const originOf = (T) => `<origin xyz="${numbers(position(T))}" rpy="${numbers(rollPitchYawOf(T))}"/>`;

/** @param {JointDoc} joint @param {Units} units */
function limitOf(joint, units) {
  const value = (/** @type {number} */ typed) => toKernel(quantityOf(joint, 'lower'), typed, units);
  const { lower, upper } = limitsOf(joint);
  const { effort = PLACEHOLDERS.effort, velocity } = joint;
  const rates = `effort="${number(effort)}" velocity="${number(velocity === undefined ? PLACEHOLDERS.velocity : value(velocity))}"`;
  if (urdfTypeOf(joint) === 'continuous') return `<limit ${rates}/>`;
  const [low, high] = [Number.isFinite(lower) ? value(lower) : -FAR, Number.isFinite(upper) ? value(upper) : FAR];
  return `<limit lower="${number(low)}" upper="${number(high)}" ${rates}/>`;
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
  /** What stands between the joint before and this one. */
  let between = compilePose(robot.base, units);
  const parts = [];
  for (const [i, joint] of joints.entries()) {
    const constant = constantOf(joint, robot);
    const T = convention === 'standard' ? between : compose(between, constant);
    between = convention === 'standard' ? constant : identity();
    parts.push(`  <joint name="${jointNames[i]}" type="${urdfTypeOf(joint)}">
    ${originOf(T)}
    <parent link="${links[i]}"/>
    <child link="${links[i + 1]}"/>
    <axis xyz="0 0 1"/>
    ${limitOf(joint, units)}
  </joint>`);
  }
  const last = links[links.length - 1];
  return `<?xml version="1.0" encoding="UTF-8"?>
<!-- Made with Denavit from a ${convention} Denavit-Hartenberg table. Masses and inertias are placeholders, and so are an effort
     of ${PLACEHOLDERS.effort} and a velocity of ${PLACEHOLDERS.velocity}: the table does not have them. -->
<robot name="${robotName}">
${[...links.map(linkText), '  <link name="flange"/>', '  <link name="tool0"/>', ...parts].join('\n')}
${fixedText('flange_joint', last, 'flange', between)}
${fixedText('tool0_joint', 'flange', 'tool0', compilePose(robot.tool, units))}
</robot>
`;
}
