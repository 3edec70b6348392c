/**
 * A robot of ours → rlkin, valid under the schema of the Robotics Library: standard rows in metres and degrees, base and tool
 * as transforms. What it has no place for is left out, which rlkinLosses.js tells.
 *
 * @import { Doc, JointDoc, PoseDoc, RobotDoc, Units } from '../../model/document.js'
 */
import { rollPitchYawOf } from '../../kinematics/orientation.js';
import { compilePose } from '../../model/compile.js';
import { convertConvention } from '../../model/robot/convertConvention.js';
import { quantityOf } from '../../model/document.js';
import { convertAngle, convertLength } from '../../model/units.js';
import { idsFor } from '../urdf/ids.js';
import { escapeWithBlanks } from '../xmlText.js';

/** @param {number} value */
const number = (value) => String(value + 0); // no −0

/** What the joints are called in the file: an id stands for one thing there. @param {RobotDoc} robot */
export function rlkinNames({ joints }) {
  const links = Array.from({ length: joints.length + 1 }, (_, i) => `link${i}`);
  const ids = joints.map(({ id }) => id);
  return idsFor(ids, 'joint', ['world', 'base', 'tool', 'tcp', ...links]);
}

/** @param {string} name @param {readonly number[]} values @param {string} indent */
const tripleText = (name, [x, y, z], indent) => `${indent}<${name}>
${indent}  <x>${number(x)}</x>
${indent}  <y>${number(y)}</y>
${indent}  <z>${number(z)}</z>
${indent}</${name}>`;

/** @param {string} id @param {string} from @param {string} to @param {PoseDoc} pose @param {Units} units */
function transformText(id, from, to, pose, units) {
  const degrees = pose.quaternion
    ? rollPitchYawOf(compilePose(pose, units)).map((angle) => convertAngle(angle, 'rad', 'deg'))
    : (pose.rpy ?? [0, 0, 0]).map((angle) => convertAngle(angle, units.angle, 'deg'));
  const metres = pose.xyz.map((length) => convertLength(length, units.length, 'm'));
  return `    <transform id="${id}">
${endsText(from, to)}
${tripleText('rotation', degrees, '      ')}
${tripleText('translation', metres, '      ')}
    </transform>`;
}

/** @param {string} from @param {string} to */
const endsText = (from, to) => `      <frame>
        <a idref="${from}"/>
        <b idref="${to}"/>
      </frame>`;

/** Links that a joint joins touch each other, which is no collision. @param {number} i @param {number} last */
function linkText(i, last) {
  const next = [i - 1, i + 1].filter((other) => other >= 0 && other <= last);
  const ignored = next.map((other) => `\n      <ignore idref="link${other}"/>`).join('');
  return `    <link id="link${i}">${ignored}\n    </link>`;
}

/** @param {JointDoc} joint @param {number} i @param {string} id @param {Units} units */
function jointText(joint, i, id, units) {
  const length = (/** @type {number} */ value) => convertLength(value, units.length, 'm');
  const angle = (/** @type {number} */ value) => convertAngle(value, units.angle, 'deg');
  const value = quantityOf(joint, 'lower') === 'length' ? length : angle;
  const element = joint.type === 'prismatic' ? 'prismatic' : 'revolute';
  /** @param {string} name @param {number | undefined} typed */
  const optional = (name, typed) => (typed === undefined ? '' : `\n      <${name}>${number(value(typed))}</${name}>`);
  return `    <${element} id="${id}">
${endsText(`link${i}`, `link${i + 1}`)}
      <dh>
        <d>${number(length(joint.d))}</d>
        <theta>${number(angle(joint.theta))}</theta>
        <a>${number(length(joint.a))}</a>
        <alpha>${number(angle(joint.alpha))}</alpha>
      </dh>${optional('max', joint.upper)}${optional('min', joint.lower)}${optional('speed', joint.velocity)}${joint.type === 'continuous' ? '\n      <wraparound/>' : ''}
    </${element}>`;
}

/**
 * @param {Doc} doc
 * @returns {string}
 */
export function writeRlkin(doc) {
  const { robot } = convertConvention(doc, 'standard');
  const { name, info, joints, units, base, tool } = robot;
  const ids = rlkinNames(robot);
  const last = joints.length;
  const { manufacturer } = info;
  const head = [
    ...(manufacturer === undefined ? [] : [`    <manufacturer>${escapeWithBlanks(manufacturer)}</manufacturer>`]),
    ...(name === '' ? [] : [`    <name>${escapeWithBlanks(name)}</name>`]),
    '    <world id="world"/>',
  ];
  const parts = joints.flatMap((joint, i) => [jointText(joint, i, ids[i], units), linkText(i + 1, last)]);
  return `<?xml version="1.0" encoding="UTF-8"?>
<rlkin xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="rlkin.xsd">
  <kinematics>
${head.join('\n')}
${transformText('base', 'world', 'link0', base, units)}
${[linkText(0, last), ...parts].join('\n')}
${transformText('tool', `link${last}`, 'tcp', tool, units)}
    <frame id="tcp"/>
  </kinematics>
</rlkin>
`;
}
