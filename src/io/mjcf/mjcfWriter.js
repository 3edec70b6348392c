/**
 * A robot of ours → MJCF, the format of MuJoCo: bodies in one another at the frames of armFrames.js, each with a joint about or
 * along its z; flange and tool are sites. What MJCF has no place for is left out, which mjcfLosses.js tells.
 *
 * @import { Doc, JointDoc, RobotDoc, Units } from '../../model/document.js'
 */
import { quaternionOf } from '../../kinematics/orientations/quaternion.js';
import { position } from '../../kinematics/pose.js';
import { isSliding, limitsOf } from '../../model/document.js';
import { armFrames } from '../armFrames.js';
import { bothLimits, PLACEHOLDERS } from '../placeholders.js';
import { idsFor } from '../urdf/ids.js';
import { escapeWithBlanks } from '../xmlText.js';

/** MuJoCo wants the upper limit above the lower one; a locked joint gets this much room, in radians or metres. */
export const ROOM = 1e-6;

/** @param {number} value */
const number = (value) => String(value + 0); // no −0
/** @param {readonly number[]} values */
const numbers = (values) => values.map(number).join(' ');

/** @param {ArrayLike<number>} T */
function placeOf(T) {
  const [x, y, z, w] = quaternionOf(T);
  return `pos="${numbers(position(T))}" quat="${numbers([w, x, y, z])}"`;
}

/** What the joints are called in the file. @param {RobotDoc} robot */
export const mjcfNames = ({ joints }) =>
  idsFor(
    joints.map(({ id }) => id),
    'joint',
  );

/**
 * Limits in radians or metres as MuJoCo takes them: both or none, the upper one higher.
 * @param {JointDoc} joint
 * @param {Units} units
 * @returns {{ lower: number, upper: number, isLocked: boolean } | null}
 */
export function rangeOf(joint, units) {
  const ends = limitsOf(joint);
  if (ends.lower === -Infinity && ends.upper === Infinity) return null;
  const { lower, upper } = bothLimits(joint, units);
  const isLocked = upper - lower < ROOM;
  return { lower, upper: isLocked ? lower + ROOM : upper, isLocked };
}

/** @param {JointDoc} joint @param {string} name @param {Units} units */
function jointText(joint, name, units) {
  const range = rangeOf(joint, units);
  const limits = range ? `limited="true" range="${numbers([range.lower, range.upper])}"` : 'limited="false"';
  const { effort } = joint;
  const forces =
    effort === undefined ? '' : ` actuatorfrclimited="true" actuatorfrcrange="${numbers([-effort, effort])}"`;
  return `<joint name="${name}" type="${isSliding(joint) ? 'slide' : 'hinge'}" pos="0 0 0" axis="0 0 1" ${limits}${forces}/>`;
}

/**
 * @param {Doc} doc
 * @returns {string}
 */
export function writeMjcf({ robot }) {
  const { name, joints, units, convention } = robot;
  const names = mjcfNames(robot);
  const { T_parent_joints, T_last_flange, T_flange_tool } = armFrames(robot);
  const { mass, inertia } = PLACEHOLDERS;
  const indent = (/** @type {number} */ depth) => '  '.repeat(depth + 3);
  const down = joints.map(
    (joint, i) => `${indent(i)}<body name="link_${i + 1}" ${placeOf(T_parent_joints[i])}>
${indent(i + 1)}<inertial pos="0 0 0" mass="${mass}" diaginertia="${numbers([inertia, inertia, inertia])}"/>
${indent(i + 1)}${jointText(joint, names[i], units)}`,
  );
  const last = joints.length;
  const tool = `${indent(last)}<body name="flange" ${placeOf(T_last_flange)}>
${indent(last + 1)}<site name="flange"/>
${indent(last + 1)}<site name="tool0" ${placeOf(T_flange_tool)}/>
${indent(last)}</body>`;
  const up = joints.map((_, i) => `${indent(last - 1 - i)}</body>`);
  return `<?xml version="1.0" encoding="UTF-8"?>
<!-- Made with Denavit from a ${convention} Denavit-Hartenberg table. Masses and inertias are placeholders: the table does not
     have them. -->
<mujoco${name === '' ? '' : ` model="${escapeWithBlanks(name)}"`}>
  <compiler angle="radian"/>
  <worldbody>
    <body name="base_link">
${[...down, tool, ...up].join('\n')}
    </body>
  </worldbody>
</mujoco>
`;
}
