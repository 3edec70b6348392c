/**
 * The DH table as code for the toolboxes of a course, in metres and radians: Python's Robotics Toolbox, and the rigid body
 * tree of MATLAB's Robotics System Toolbox, which leaves θ of a joint that turns and d of one that slides out of the row it
 * is given. So what is added to a joint value stands apart, as an offset, in both.
 *
 * @import { Doc, JointDoc, RobotDoc } from '../document.js'
 */
import { digits } from '../numbers/copyText.js';
import { compilePose, compilePosture } from '../compile.js';
import { isSliding, limitsOf, quantityOf } from '../document.js';
import { rowsOf } from '../numbers/poseRows.js';
import { commonAngle, convertAngle, convertLength } from '../units.js';

/** One line, whatever a robot is called. @param {RobotDoc} robot */
const nameOf = ({ name }) => name.replace(/\s+/g, ' ').trim() || 'Robot';

/** In metres, or in radians as a fraction of pi where it is one. @param {RobotDoc} robot @param {'length' | 'angle'} quantity @param {number} value */
function si({ units }, quantity, value) {
  if (!Number.isFinite(value)) return null;
  if (quantity === 'length') return digits(convertLength(value, units.length, 'm'));
  const radians = convertAngle(value, units.angle, 'rad');
  const common = commonAngle(convertAngle(value, units.angle, 'deg'));
  return common?.value === radians ? common.text : digits(radians);
}

/** The row of a joint, what is added to its value, and its limits, as texts. @param {RobotDoc} robot @param {JointDoc} joint */
function rowOf(robot, joint) {
  const { lower, upper } = limitsOf(joint);
  const own = quantityOf(joint, 'home');
  const text = (/** @type {'theta' | 'd' | 'a' | 'alpha'} */ field) =>
    /** @type {string} */ (si(robot, quantityOf(joint, field), joint[field]));
  return {
    isSlide: isSliding(joint),
    theta: text('theta'),
    d: text('d'),
    a: text('a'),
    alpha: text('alpha'),
    lower: si(robot, own, lower),
    upper: si(robot, own, upper),
  };
}

/** @param {Float64Array} T */
const isNoTurnNorShift = (T) => rowsOf(T).every((row, i) => row.every((value, j) => value === (i === j ? 1 : 0)));

/** @param {Doc} doc */
const valuesOf = ({ robot, posture }) => Array.from(compilePosture(robot, posture), digits).join(', ');

/** @param {Doc} doc */
export function dhTablePython(doc) {
  const { robot } = doc;
  const suffix = robot.convention === 'standard' ? 'DH' : 'MDH';
  const links = robot.joints.map((joint) => {
    const { isSlide, theta, d, a, alpha, lower, upper } = rowOf(robot, joint);
    const limits = lower !== null && upper !== null ? `, qlim=[${lower}, ${upper}]` : '';
    return isSlide
      ? `        rtb.Prismatic${suffix}(theta=${theta}, a=${a}, alpha=${alpha}, offset=${d}${limits}),`
      : `        rtb.Revolute${suffix}(d=${d}, a=${a}, alpha=${alpha}, offset=${theta}${limits}),`;
  });
  const ends = /** @type {const} */ (['base', 'tool']).flatMap((end) => {
    const T = compilePose(robot[end], robot.units);
    if (isNoTurnNorShift(T)) return [];
    const rows = rowsOf(T).map((row) => `        [${row.map(digits).join(', ')}],`);
    return [`    ${end}=SE3(np.array([`, ...rows, '    ])),'];
  });
  return [
    `# ${nameOf(robot)}: ${robot.convention} DH, metres and radians; Robotics Toolbox for Python`,
    'from math import pi',
    '',
    ...(ends.length > 0 ? ['import numpy as np'] : []),
    'import roboticstoolbox as rtb',
    ...(ends.length > 0 ? ['from spatialmath import SE3'] : []),
    '',
    'robot = rtb.DHRobot(',
    '    [',
    ...links,
    '    ],',
    `    name=${JSON.stringify(nameOf(robot))},`,
    ...ends,
    ')',
    `q = [${valuesOf(doc)}]`,
    'print(robot.fkine(q))  # the tool, seen from the world',
    '',
  ].join('\n');
}

/** @param {Doc} doc */
export function dhTableMatlab(doc) {
  const { robot } = doc;
  const rows = robot.joints.map((joint) => rowOf(robot, joint));
  const matrix = (/** @type {'base' | 'tool'} */ end) =>
    rowsOf(compilePose(robot[end], robot.units)).map((row) => `    ${row.map(digits).join(' ')}`);
  return [
    `% ${nameOf(robot)}: ${robot.convention} DH, metres and radians; Robotics System Toolbox`,
    'dh = [ % a alpha d theta; what is added to a joint value is 0 here',
    ...rows.map(({ isSlide, theta, d, a, alpha }) => `    ${a} ${alpha} ${isSlide ? `0 ${theta}` : `${d} 0`}`),
    '];',
    `offset = [${rows.map(({ isSlide, theta, d }) => (isSlide ? d : theta)).join(' ')}]; % added to the joint values`,
    `types = {${rows.map(({ isSlide }) => (isSlide ? "'prismatic'" : "'revolute'")).join(', ')}};`,
    `limits = [ % of the joint values, without the offset`,
    ...rows.map(({ lower, upper }) => `    ${lower ?? '-Inf'} ${upper ?? 'Inf'}`),
    '];',
    'T_world_base = [',
    ...matrix('base'),
    '];',
    'T_flange_tool = [',
    ...matrix('tool'),
    '];',
    '',
    "robot = rigidBodyTree('DataFormat', 'row');",
    "base = rigidBody('frame0');",
    'setFixedTransform(base.Joint, T_world_base);',
    'addBody(robot, base, robot.BaseName);',
    'for i = 1:size(dh, 1)',
    "    joint = rigidBodyJoint(sprintf('joint%d', i), types{i});",
    `    setFixedTransform(joint, dh(i, :), '${robot.convention === 'standard' ? 'dh' : 'mdh'}');`,
    "    body = rigidBody(sprintf('frame%d', i));",
    '    body.Joint = joint;',
    "    addBody(robot, body, sprintf('frame%d', i - 1));",
    'end',
    "tool = rigidBody('tool');",
    'setFixedTransform(tool.Joint, T_flange_tool);',
    `addBody(robot, tool, 'frame${rows.length}');`,
    '',
    `q = [${valuesOf(doc).replaceAll(',', '')}];`,
    "T_world_tool = getTransform(robot, q + offset, 'tool')",
    '',
  ].join('\n');
}
