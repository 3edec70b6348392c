import { expect, test } from 'vitest';
import { GENERATOR } from '../../../src/io/robotXmlWriter.js';
import { readRobotXml } from '../../../src/io/robotXml.js';
import packageJson from '../../../package.json';
import { robotFile, rootWith } from './files.js';

/** @param {Parameters<typeof robotFile>[0]} [parts] */
const messages = (parts) => readRobotXml(robotFile(parts)).issues.map(({ message }) => message);
/** @param {Parameters<typeof robotFile>[0]} [parts] */
function open(parts) {
  const { doc, issues } = readRobotXml(robotFile(parts));
  if (!doc) throw new Error(issues.map(({ message }) => message).join('\n'));
  return doc;
}

test('a small file is this document', () => {
  const joint = {
    type: 'revolute',
    theta: 0,
    d: 0.5,
    a: 1,
    alpha: 90,
    link: { kind: 'auto' },
    controller: { sign: 1, offset: 0, coupling: 0 },
  };
  expect(readRobotXml(robotFile())).toStrictEqual({
    doc: {
      robot: {
        name: '',
        info: {},
        units: { length: 'm', angle: 'deg' },
        convention: 'standard',
        base: { xyz: [0, 0, 0], rpy: [0, 0, 0] },
        tool: { xyz: [0, 0, 0], rpy: [0, 0, 0] },
        joints: [
          { id: 'joint_1', ...joint },
          { id: 'joint_2', ...joint },
        ],
      },
      posture: [0, 0],
      postures: [],
      frames: [],
      targets: [],
      obstacles: [],
      motionPrograms: [],
      programs: [],
      extensions: [],
    },
    issues: [],
  });
});

test('everything in a file has its place in the document', () => {
  const doc = open({
    root: rootWith('standard', 'modified'),
    before:
      '<info><name>Arm</name><author>A</author><description>D</description></info><base xyz="1 2 3" quat_xyzw="0 0 0 1"/>',
    joint: 'id="joint_1" label="J1" type="prismatic"',
    dh: '<dh theta="1" d="2" a="3" alpha="4" aText="sqrt(9)"/>',
    inJoint:
      '<limits lower="-1" upper="2" home="0.5" velocity="3" acceleration="4" jerk="5" effort="6"/><link kind="box" radius="1" width="2" height="3" color="#ffcc00"/><controller sign="-1" offset="7" coupledTo="joint_2" coupling="-1"/>',
    after:
      '<tool rpy="0 0 90"/><frames><toolFrame id="t" number="2"/><userFrame id="u" xyz="1 1 1"/></frames><obstacles><plane id="floor" rpy="0 0 0"/><box id="table" width="1" depth="2" height="3" xyz="4 5 6"/><sphere id="ball" radius="7"/><cylinder id="post" radius="8" height="9"/></obstacles><postures><posture id="p1" q="1 2"/></postures><motionPrograms><motionProgram id="m" name="Weld"><jointMove id="s1" to="posture" q="1 2" speed="50" speedUnit="%" acceleration="100" ending="percent" endingValue="20" law="quintic"/><circularMove id="s2" via="pose" viaXyz="1 2 3" to="pose" xyz="4 5 6" rpy="0 0 90" configuration="N U T" speed="0.2" speedUnit="length/s" acceleration="80" ending="fine" tool="t" frame="u" comment="c" disabled="true"/><wait id="s3" seconds="0.5"/><setOutput id="s4" output="1" value="on"/><waitInput id="s5" input="2" value="off"/><call id="s6" program="m"/><label id="s7" label="again"/><comment id="s8" text="a b"/></motionProgram></motionPrograms><programs><program id="pick" language="karel">PROGRAM pick\nEND pick</program></programs>',
  });
  expect(doc).toStrictEqual({
    robot: {
      name: 'Arm',
      info: { author: 'A', description: 'D' },
      units: { length: 'm', angle: 'deg' },
      convention: 'modified',
      base: { xyz: [1, 2, 3], quaternion: [0, 0, 0, 1] },
      tool: { xyz: [0, 0, 0], rpy: [0, 0, 90] },
      joints: [
        {
          id: 'joint_1',
          label: 'J1',
          type: 'prismatic',
          theta: 1,
          d: 2,
          a: 3,
          alpha: 4,
          text: { a: 'sqrt(9)' },
          lower: -1,
          upper: 2,
          home: 0.5,
          velocity: 3,
          acceleration: 4,
          jerk: 5,
          effort: 6,
          link: { kind: 'box', radius: 1, width: 2, height: 3, color: '#ffcc00' },
          controller: { sign: -1, offset: 7, coupledTo: 'joint_2', coupling: -1 },
        },
        expect.objectContaining({ id: 'joint_2' }),
      ],
    },
    posture: [0.5, 0],
    postures: [{ id: 'p1', q: [1, 2] }],
    frames: [
      { kind: 'tool', id: 't', number: 2, xyz: [0, 0, 0] },
      { kind: 'user', id: 'u', xyz: [1, 1, 1] },
    ],
    targets: [],
    obstacles: [
      { kind: 'plane', id: 'floor', xyz: [0, 0, 0], rpy: [0, 0, 0] },
      { kind: 'box', id: 'table', width: 1, depth: 2, height: 3, xyz: [4, 5, 6] },
      { kind: 'sphere', id: 'ball', radius: 7, xyz: [0, 0, 0] },
      { kind: 'cylinder', id: 'post', radius: 8, height: 9, xyz: [0, 0, 0] },
    ],
    motionPrograms: [
      {
        id: 'm',
        name: 'Weld',
        steps: [
          {
            ...{ id: 's1', kind: 'joint', target: { kind: 'posture', values: [1, 2] }, speed: 50, speedUnit: '%' },
            ...{ acceleration: 100, ending: { kind: 'percent', value: 20 }, law: 'quintic' },
          },
          {
            ...{ id: 's2', kind: 'circular', via: { kind: 'pose', xyz: [1, 2, 3] } },
            target: { kind: 'pose', xyz: [4, 5, 6], rpy: [0, 0, 90], configuration: 'N U T' },
            ...{ speed: 0.2, speedUnit: 'length/s', acceleration: 80, ending: { kind: 'fine' }, tool: 't', frame: 'u' },
            ...{ comment: 'c', disabled: true },
          },
          { id: 's3', kind: 'wait', seconds: 0.5 },
          { id: 's4', kind: 'set-output', output: 1, value: 'on' },
          { id: 's5', kind: 'wait-input', input: 2, value: 'off' },
          { id: 's6', kind: 'call', program: 'm' },
          { id: 's7', kind: 'label', label: 'again' },
          { id: 's8', kind: 'comment', text: 'a b' },
        ],
      },
    ],
    programs: [{ id: 'pick', language: 'karel', text: 'PROGRAM pick\nEND pick' }],
    extensions: [],
  });
});

test('the posture called current is where the arm stands, wherever it is in the list', () => {
  const postures = '<posture id="a" q="1 2"/><posture id="current" q="3 4"/><posture id="b" q="5 6"/>';
  const doc = open({ after: `<postures>${postures}</postures>` });
  expect(doc.posture).toEqual([3, 4]);
  expect(doc.postures.map(({ id }) => id)).toEqual(['a', 'b']);
});

test('there is one posture called current', () => {
  const current = '<posture id="current" q="1 2"/>';
  const { doc, issues } = readRobotXml(robotFile({ after: `<postures>${current}\n${current}</postures>` }));
  expect(doc).toBeNull();
  expect(issues).toEqual([
    {
      severity: 'error',
      code: 'id-taken',
      path: 'posture',
      line: 13,
      message: 'Line 13: two postures have the id "current"; expected a different id for each.',
    },
  ]);
});

test('without it the arm stands at home, or at zero brought inside the limits', () => {
  expect(open({ inJoint: '<limits lower="10" upper="20"/>' }).posture).toEqual([10, 0]);
  expect(open({ inJoint: '<limits lower="10" upper="20" home="15"/>' }).posture).toEqual([15, 0]);
});

test('a prefix does not matter', () => {
  const text = robotFile({ inJoint: '<limits lower="1"/>' });
  const prefixed = text.replace('xmlns=', 'xmlns:rm=').replace(/<(\/?)(?=[a-z])/gi, '<$1rm:');
  expect(readRobotXml(prefixed)).toStrictEqual(readRobotXml(text));
});

test('line ends of Windows and of old Macs do not matter', () => {
  const text = robotFile({ before: '<info><name>two\nlines</name></info>', dh: '<dh d="12,5"\n a="1"/>' });
  for (const end of ['\r\n', '\r']) expect(readRobotXml(text.replaceAll('\n', end))).toStrictEqual(readRobotXml(text));
});

test('what is opened cannot be changed', () => {
  const doc = open({ after: '<postures><posture id="p1" q="1 2"/></postures>' });
  for (const part of [
    doc,
    doc.robot,
    doc.robot.joints,
    doc.robot.joints[0].link,
    doc.robot.base.xyz,
    doc.postures[0].q,
  ]) {
    expect(Object.isFrozen(part)).toBe(true);
  }
});

test.for([
  [
    { dh: '<dh theta="0" d="0" a="12,5" alpha="0"/>' },
    'Line 4: <dh> of joint "joint_1" has a="12,5"; expected a number such as 12.5.',
  ],
  [
    { dh: '<dh theta="0" d="0" a="1e10" alpha="0"/>' },
    'Line 4: <dh> of joint "joint_1" has a="1e10"; expected a number from -1000000000 to 1000000000.',
  ],
  [
    { dh: '<dh theta="0" d="0" alpha="0"/>' },
    'Line 4: <dh> of joint "joint_1" has no a; expected one such as a="12.5".',
  ],
  [
    { dh: '<dh\n theta="0"\n d="0"\n a="x"\n alpha="0"/>' },
    'Line 7: <dh> of joint "joint_1" has a="x"; expected a number such as 12.5.',
  ],
  [{ dh: '' }, 'Line 3: joint "joint_1" has no <dh>; expected one.'],
  [{ inJoint: '<limits/><limits/>' }, 'Line 5: joint "joint_1" has a second <limits>; expected one.'],
  [
    { inJoint: '<mass/>' },
    'Line 5: joint "joint_1" contains <mass>; expected only <dh>, <limits>, <link>, <controller>.',
  ],
  [
    { inJoint: '<link colour="red"/>' },
    'Line 5: <link> of joint "joint_1" has the attribute "colour"; expected only kind, radius, width, height, color.',
  ],
  [
    { joint: 'id="joint_1" type="planar"' },
    'Line 3: joint "joint_1" has type="planar"; expected revolute, prismatic or continuous.',
  ],
  [{ joint: 'type="revolute"' }, 'Line 3: joint 1 has no id; expected one such as id="joint_1".'],
  [
    { joint: 'id="joint_2" type="revolute"' },
    'Line 7: two joints have the id "joint_2"; expected a different id for each.',
  ],
  [
    { inJoint: '<limits\n lower="170"\n upper="-170"/>' },
    'Line 6: joint "joint_1" has the lower limit 170 above its upper limit -170; expected lower <= upper.',
  ],
  [
    { inJoint: '<controller coupledTo="joint_9"/>' },
    'Line 5: the controller of joint "joint_1" is coupled to "joint_9"; expected the id of another joint.',
  ],
  [
    { inJoint: '<controller coupling="-1"/>' },
    'Line 5: the controller of joint "joint_1" has the coupling -1 to no joint; expected the id of one in coupledTo.',
  ],
  [
    { before: '<base xyz="0 0 1,5"/>' },
    'Line 1: <base> has xyz="0 0 1,5"; expected 3 numbers with blanks between them, each a number such as 12.5.',
  ],
  [{ before: '<base xyz="0 0"/>' }, 'Line 1: <base> has xyz="0 0"; expected 3 numbers with blanks between them.'],
  [{ after: '<tool quat_xyzw="0 0 0 1.1"/>' }, 'Line 12: the tool has a quaternion of length 1.1; expected length 1.'],
  [
    { after: '<postures><posture id="home" q="0 0 0"/></postures>' },
    'Line 12: posture "home" has 3 joint values; expected 2, one for each joint.',
  ],
  [
    { after: '<postures><posture id="current" q="0 0 0"/></postures>' },
    'Line 12: the present posture has 3 joint values; expected 2, one for each joint.',
  ],
  [{ more: 'oops' }, 'Line 2: <chain> contains the text "oops"; expected only elements.'],
  [
    { dh: '<dh theta="0" d="0" a="0" alpha="0"> </dh>' },
    'Line 4: <dh> of joint "joint_1" contains blanks; expected nothing in it.',
  ],
  [
    { root: rootWith('version="1.0" ', '') },
    'Line 1: <robotModel> has no version; expected one such as version="1.0".',
  ],
  [{ root: rootWith('1.0', '1') }, 'Line 1: <robotModel> has version="1"; expected a version such as 1.0.'],
  [
    { root: rootWith('xmlns="urn:denavit:robot-model:1"', '') },
    'Line 1: <robotModel> has no namespace; expected <robotModel xmlns="urn:denavit:robot-model:1">.',
  ],
  [
    { after: '<extensions><note xmlns=""/></extensions>' },
    'Line 12: <extensions> contains <note>, which is in no namespace; expected elements of other namespaces.',
  ],
])('a refusal says what, where, and what was expected: %#', ([parts, message]) => {
  expect(messages(/** @type {Parameters<typeof robotFile>[0]} */ (parts))).toEqual([message]);
});

test('all that is wrong is said, in the order of the file', () => {
  const { doc, issues } = readRobotXml(
    robotFile({ root: rootWith('"deg"', '"°"'), dh: '<dh theta="" d="0" a="?" alpha="0"/>', after: '<tool xyz="0"/>' }),
  );
  expect(doc).toBeNull();
  expect(issues.map(({ code, path, line }) => ({ code, path, line }))).toEqual([
    { code: 'choice', path: 'robot.units.angle', line: 1 },
    { code: 'number', path: 'robot.joints.0.theta', line: 4 },
    { code: 'number', path: 'robot.joints.0.a', line: 4 },
    { code: 'number', path: 'robot.tool.xyz', line: 12 },
  ]);
});

test('of very much that is wrong a hundred things are said', () => {
  const { doc, issues } = readRobotXml(robotFile({ after: '<unknown/>'.repeat(500) }));
  expect(doc).toBeNull();
  expect(issues).toHaveLength(100);
});

test('files of other formats are called by their name', () => {
  expect(readRobotXml('<?xml version="1.0"?>\n<robot name="arm"><link name="a"/></robot>').issues).toEqual([
    {
      severity: 'error',
      code: 'not-a-robot',
      path: '',
      line: 2,
      message:
        'Line 2: the file is in the format URDF (it begins with <robot>); expected <robotModel xmlns="urn:denavit:robot-model:1">.',
    },
  ]);
});

test('what is unknown is refused in a newer file too, and its version is said to be newer', () => {
  const { doc, issues } = readRobotXml(robotFile({ root: rootWith('"1.0"', '"1.2"'), after: '<wishes/>' }));
  expect(doc).toBeNull();
  expect(issues.map(({ code }) => code)).toEqual(['newer-version', 'unknown-element']);
});

test('a quaternion with six good digits is kept as typed, one with three is brought to length 1', () => {
  const quaternion = (/** @type {string} */ typed) =>
    open({ before: `<base quat_xyzw="${typed}"/>` }).robot.base.quaternion;
  expect(quaternion('0 0 0 1.0000009')).toEqual([0, 0, 0, 1.0000009]);
  expect(quaternion('0 0 0 -1.000002')).toEqual([0, 0, 0, -1]);
  expect(quaternion('0 0 0.6 0.801')?.map((value) => value.toFixed(6))).toEqual([
    '0.000000',
    '0.000000',
    '0.599520',
    '0.800360',
  ]);
});

test('a quaternion with two good digits is refused', () => {
  expect(messages({ before: '<base quat_xyzw="0 0 0 1.0011"/>' })).toEqual([
    'Line 1: the base has a quaternion of length 1.0011; expected length 1.',
  ]);
});

test('equal limits are allowed, and said to lock the joint', () => {
  expect(messages({ inJoint: '<limits lower="5" upper="5"/>' })).toEqual([
    'Line 5: joint "joint_1" has equal limits, 5, so it cannot move.',
  ]);
});

test('a model too long to be saved is refused, so that all that opens can be saved and opened again', () => {
  const text = '&'.repeat(400_000);
  const { doc, issues } = readRobotXml(
    robotFile({ after: `<programs><program id="a" language="krl"><![CDATA[${text}]]></program></programs>` }),
  );
  expect(doc).toBeNull();
  expect(issues.map(({ code }) => code)).toEqual(['too-large']);
});

test('the version of the program in the file is that of the package', () => {
  expect(GENERATOR).toBe(`Denavit ${packageJson.version}`);
});
