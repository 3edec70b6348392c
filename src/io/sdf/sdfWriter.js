/**
 * A robot of ours → SDFormat 1.9: joints at the frames of armFrames.js, whose poses are given in the link before; flange and tool are
 * frames. The base stands fast in the world. What SDFormat has no place for is left out, which sdfLosses.js tells.
 *
 * @import { Doc, JointDoc, RobotDoc, Units } from '../../model/document.js'
 */
import { rollPitchYawOf } from '../../kinematics/orientation.js';
import { position } from '../../kinematics/pose.js';
import { limitsOf, quantityOf } from '../../model/document.js';
import { toKernel } from '../../model/units.js';
import { armFrames } from '../armFrames.js';
import { PLACEHOLDERS } from '../placeholders.js';
import { idsFor } from '../urdf/ids.js';

/** @param {number} value */
const number = (value) => String(value + 0); // no −0

/** @param {ArrayLike<number>} T */
const poseOf = (T) => [...position(T), ...rollPitchYawOf(T)].map(number).join(' ');

/** @param {RobotDoc} robot */
const linkNames = ({ joints }) => ['base_link', ...joints.map((_, i) => `link_${i + 1}`)];

/** Names that begin and end with two underscores are the format's own. @param {string} name */
const notReserved = (name) => (/^__.*__$/.test(name) ? `_${name.slice(2)}` : name);

/** What robot and joints are called in the file, where links, joints and frames may not share a name. @param {RobotDoc} robot */
export function sdfNames(robot) {
  const ids = robot.joints.map(({ id }) => notReserved(id));
  const taken = ['world', 'world_joint', 'flange', 'tool0', ...linkNames(robot)];
  const [name] = idsFor([notReserved(robot.name)], 'robot', ['world']);
  return { robot: notReserved(name), joints: idsFor(ids, 'joint', taken) };
}

/** @param {string} name @param {string} pose  an element, or nothing */
const linkText = (name, pose) => {
  const { mass, inertia } = PLACEHOLDERS;
  return `    <link name="${name}">${pose}
      <inertial>
        <mass>${mass}</mass>
        <inertia><ixx>${inertia}</ixx><ixy>0</ixy><ixz>0</ixz><iyy>${inertia}</iyy><iyz>0</iyz><izz>${inertia}</izz></inertia>
      </inertial>
    </link>`;
};

/** @param {JointDoc} joint @param {Units} units */
function limitText(joint, units) {
  const { lower, upper } = limitsOf(joint);
  const value = (/** @type {number} */ typed) => number(toKernel(quantityOf(joint, 'lower'), typed, units));
  const parts = [
    Number.isFinite(lower) ? `<lower>${value(lower)}</lower>` : '',
    Number.isFinite(upper) ? `<upper>${value(upper)}</upper>` : '',
    joint.effort === undefined ? '' : `<effort>${number(joint.effort)}</effort>`,
    joint.velocity === undefined ? '' : `<velocity>${value(joint.velocity)}</velocity>`,
  ].join('');
  return parts === '' ? '' : `\n        <limit>${parts}</limit>`;
}

/**
 * @param {Doc} doc
 * @returns {string}
 */
export function writeSdf({ robot }) {
  const { joints, units, convention } = robot;
  const names = sdfNames(robot);
  const links = linkNames(robot);
  const { T_parent_joints, T_last_flange, T_flange_tool } = armFrames(robot);
  const parts = joints.map(
    (joint, i) => `    <joint name="${names.joints[i]}" type="${joint.type}">
      <pose relative_to="${links[i]}">${poseOf(T_parent_joints[i])}</pose>
      <parent>${links[i]}</parent>
      <child>${links[i + 1]}</child>
      <axis>
        <xyz>0 0 1</xyz>${limitText(joint, units)}
      </axis>
    </joint>
${linkText(links[i + 1], `\n      <pose relative_to="${names.joints[i]}">0 0 0 0 0 0</pose>`)}`,
  );
  return `<?xml version="1.0" encoding="UTF-8"?>
<!-- Made with Denavit from a ${convention} Denavit-Hartenberg table. Masses and inertias are placeholders: the table does not
     have them. -->
<sdf version="1.9">
  <model name="${names.robot}">
${linkText(links[0], '')}
    <joint name="world_joint" type="fixed">
      <parent>world</parent>
      <child>base_link</child>
    </joint>
${parts.join('\n')}
    <frame name="flange" attached_to="${links[links.length - 1]}">
      <pose>${poseOf(T_last_flange)}</pose>
    </frame>
    <frame name="tool0" attached_to="flange">
      <pose>${poseOf(T_flange_tool)}</pose>
    </frame>
  </model>
</sdf>
`;
}
