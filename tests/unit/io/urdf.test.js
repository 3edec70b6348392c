import fc from 'fast-check';
import { readFileSync, readdirSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { decodeText } from '../../../src/io/decodeText.js';
import { hasErrors } from '../../../src/io/fileIssues.js';
import { readRobotXml, writeRobotXml } from '../../../src/io/robotXml.js';
import { readUrdf, writeUrdf } from '../../../src/io/urdf.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { convertConvention } from '../../../src/model/robot/convertConvention.js';
import { LIBRARY } from '../../../src/model/library.js';
import { newDocument } from '../../../src/model/newDocument.js';
import { validateDocument } from '../../../src/model/validate.js';
import { SEED, runs } from '../../helpers/property.js';
import { rigid, rodrigues, times } from '../kinematics/oracle.js';
import { urdfLoaderPose } from './urdfLoaderPose.js';

/** @import { Doc } from '../../../src/model/document.js' */

const FOLDER = new URL('../../fixtures/urdf/', import.meta.url);
/** @typedef {{ base: string, tip: string, samples: { q: number[], T: number[][] }[] }} Reference */
/** @type {Record<string, Reference>} */
const REFERENCE = JSON.parse(readFileSync(new URL('reference.json', FOLDER), 'utf8'));
const textOf = (/** @type {string} */ name) => readFileSync(new URL(`${name}.urdf`, FOLDER), 'utf8');

/** @param {string} text @param {Parameters<typeof readUrdf>[1]} [options] @returns {Doc} */
function opened(text, options) {
  const { doc, issues } = readUrdf(text, options);
  if (!doc) throw new Error(issues.map(({ message }) => message).join(' '));
  return doc;
}

/** The largest difference between a pose (column-major) and three rows. @param {ArrayLike<number>} T @param {number[][]} rows */
const apart = (T, rows) => Math.max(...rows.flatMap((row, i) => row.map((value, j) => Math.abs(T[4 * j + i] - value))));

/** @param {Doc} doc @param {Reference} reference */
function error({ robot }, { samples }) {
  const chain = compileRobot(robot);
  return Math.max(...samples.map(({ q, T }) => apart(tcpPose(chain, q), T)));
}

/** Some postures of any robot, in kernel units: at random, far beyond its limits. @param {Doc} doc */
const somePostures = ({ robot }) =>
  [0.3, -1.1, 2.2].map((start) => Float64Array.from(robot.joints, (_, i) => start + 0.7 * i));

test('twelve real arms are in the folder', () => {
  expect(readdirSync(FOLDER).filter((name) => name.endsWith('.urdf'))).toHaveLength(12);
});

describe.each(Object.entries(REFERENCE))('%s', (name, reference) => {
  test('the chain that is meant is found, and is the same arm to 1e-8', () => {
    const { doc, issues, choices } = readUrdf(textOf(name));
    expect([choices?.base, choices?.tip]).toEqual([reference.base, reference.tip]);
    expect(hasErrors(issues)).toBe(false);
    expect(doc && validateDocument(doc)).toEqual([]);
    expect(doc && error(doc, reference)).toBeLessThan(1e-8);
  });

  test('through our own file it is the same to the last bit, and saves as the same bytes', () => {
    const saved = writeRobotXml(opened(textOf(name)));
    const { doc } = readRobotXml(saved);
    expect(doc && writeRobotXml(doc)).toBe(saved);
    expect(doc && error(doc, reference)).toBe(error(opened(textOf(name)), reference));
  });

  test('out to URDF again, another reader sees the same arm, and so do we', () => {
    const doc = opened(textOf(name));
    const text = writeUrdf(doc);
    const pose = urdfLoaderPose(text, 'tool0');
    const names = doc.robot.joints.map(({ id }) => id);
    for (const { q, T } of reference.samples) {
      const seen = pose(Object.fromEntries(names.map((id, i) => [id, q[i]])));
      expect(Math.max(...seen.flatMap((row, i) => row.map((value, j) => Math.abs(value - T[i][j]))))).toBeLessThan(
        1e-6,
      );
    }
    expect(error(opened(text), reference)).toBeLessThan(2e-8);
    expect(opened(text).robot.joints.map(({ lower, upper, velocity }) => [lower, upper, velocity ?? null])).toEqual(
      doc.robot.joints.map(({ type, lower, upper, velocity }) => [
        lower === undefined ? undefined : expect.closeTo(lower, 9),
        upper === undefined ? undefined : expect.closeTo(upper, 9),
        expect.closeTo(velocity ?? (type === 'prismatic' ? 1 : 180 / Math.PI), 9),
      ]),
    );
  });
});

test.each(Object.entries(LIBRARY))(
  '%s of the library goes out in both conventions and comes back as the same arm',
  (_, robot) => {
    const doc = newDocument(robot);
    const other = convertConvention(doc, robot.convention === 'standard' ? 'modified' : 'standard');
    for (const each of [doc, other]) {
      const text = writeUrdf(each);
      const [ours, back] = [compileRobot(each.robot), compileRobot(opened(text).robot)];
      const pose = urdfLoaderPose(text, 'tool0');
      for (const q of somePostures(each)) {
        const T = tcpPose(ours, q);
        const rows = [0, 1, 2].map((i) => [0, 1, 2, 3].map((j) => T[4 * j + i]));
        expect(apart(tcpPose(back, q), rows)).toBeLessThan(1e-8);
        const seen = pose(Object.fromEntries(each.robot.joints.map(({ id }, i) => [id, q[i]])));
        expect(apart(T, seen)).toBeLessThan(1e-6);
      }
    }
  },
);

const LINKS = ['a', 'b', 'c', 'd', 'e', 'f', 'g', 'tip'];
/**
 * A URDF with three joints that move, one thing of it replaced or added.
 * @param {{ joint?: string, more?: string, links?: readonly string[], robot?: string }} [parts]  joint: what is in the first
 */
const arm = ({
  joint = '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="2"/>',
  more = '',
  links = ['a', 'b', 'c', 'd'],
  robot = 'name="r"',
} = {}) =>
  `<robot ${robot}>
${links.map((name) => `<link name="${name}"/>`).join('')}
<joint name="one" type="revolute"><parent link="a"/><child link="b"/>${joint}</joint>
<joint name="two" type="prismatic"><parent link="b"/><child link="c"/><origin xyz="0.1 0.2 0.3" rpy="1.5707963267948966 0 0"/><axis xyz="0 0 -1"/><limit lower="0" upper="0.5" effort="1" velocity="1"/></joint>
<joint name="three" type="continuous"><parent link="c"/><child link="d"/><origin xyz="0.4 0 0"/><axis xyz="0 1 0"/></joint>
${more}
</robot>`;

test.each([
  [
    'an xacro',
    arm({ robot: 'xmlns:xacro="http://www.ros.org/wiki/xacro"', more: '<xacro:arm/>' }),
    'Line 6: the file has xacro macros',
  ],
  ['a property of xacro', arm({ joint: '<origin xyz="0 0 ${h}"/>' }), 'Line 3: the file has xacro macros'],
  ['no number', arm({ joint: '<origin xyz="0 0 x"/>' }), 'Line 3: the xyz of <origin> is "0 0 x"; expected 3 numbers'],
  [
    'no axis',
    arm({ joint: '<axis xyz="0 0 0"/>' }),
    'Line 3: the joint "one" has the axis 0 0 0; expected a direction',
  ],
  ['a planar joint', arm().replace('prismatic', 'planar'), 'Line 4: the joint "two" of this chain is planar'],
  [
    'a mimic',
    arm({ joint: '<mimic joint="three"/>' }),
    'Line 3: the joint "one" of this chain follows "three" (mimic)',
  ],
  [
    'a mimic of nothing',
    arm({ joint: '<mimic joint="four"/>' }),
    'Line 3: the joint that the joint "one" follows, "four", is not in this file.',
  ],
  [
    'a link that is not there',
    arm({ links: ['a', 'b', 'c'] }),
    'Line 5: the child of the joint "three" is "d", which is no link',
  ],
  [
    'two trees',
    arm({ links: ['a', 'b', 'c', 'd', 'e'] }),
    'Line 2: the links "a" and "e" are not joined; expected one tree.',
  ],
  [
    'a circle',
    arm({ more: '<joint name="four" type="fixed"><parent link="d"/><child link="a"/></joint>' }),
    'The links go round in a circle',
  ],
  [
    'a circle beside the tree',
    arm({
      links: ['a', 'b', 'c', 'd', 'e'],
      more: '<joint name="four" type="fixed"><parent link="e"/><child link="e"/></joint>',
    }),
    'Line 2: the link "e" goes round in a circle with others',
  ],
  [
    'a link carried twice',
    arm({ more: '<joint name="four" type="fixed"><parent link="a"/><child link="d"/></joint>' }),
    'Line 6: the link "d" is carried by two joints, "three" and "four"',
  ],
  ['two of one name', arm({ links: ['a', 'b', 'b', 'c', 'd'] }), 'Line 2: two links are called "b"'],
  [
    'one joint',
    arm().replace('prismatic', 'fixed').replace('continuous', 'fixed'),
    'No chain from "a" has 2 to 6 joints that move (the file has 1)',
  ],
  [
    'a type of its own',
    arm().replace('prismatic', 'screw'),
    'Line 4: the joint "two" is of the type "screw"; expected revolute',
  ],
  ['no type', arm().replace(' type="prismatic"', ''), 'Line 4: the joint "two" has no "type"'],
  ['no child', arm().replace('<child link="c"/>', ''), 'Line 4: the joint "two" has no <child>'],
  ['limits that cross', arm({ joint: '<limit lower="2" upper="1" effort="1" velocity="1"/>' }), 'Line 3: '],
  [
    'a quaternion of another length',
    arm({ joint: '<origin quat_xyzw="0 0 0 2"/>' }),
    'Line 3: the quaternion has the length 2; expected 1.',
  ],
])('%s is refused, with its line and what was expected', (_, text, message) => {
  const { doc, issues } = readUrdf(text);
  expect(doc).toBe(null);
  expect(issues.filter(({ severity }) => severity === 'error')[0].message).toMatch(
    new RegExp(`^${message.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')}`),
  );
});

test.each([
  [
    'an axis that is not of length 1',
    arm({ joint: '<axis xyz="0 0 5"/><limit lower="-1" upper="1"/>' }),
    'axis-length',
  ],
  ['no limits', arm({ joint: '<axis xyz="0 0 1"/>' }), 'limit-missing'],
  [
    'a mesh that is a script',
    arm({ more: '' }).replace(
      '<link name="b"/>',
      '<link name="b"><visual><geometry><mesh filename="javascript:alert(1)"/></geometry></visual></link>',
    ),
    'mesh-name',
  ],
])('%s is told, and the arm opens', (_, text, code) => {
  const { doc, issues } = readUrdf(text);
  expect(doc).not.toBe(null);
  expect(issues.map((issue) => issue.code)).toEqual([code]);
});

test('base and tip are chosen; what is nested in a transmission is no joint', () => {
  const text = arm({ more: '<transmission><joint name="one"/></transmission>' });
  const { choices } = readUrdf(text);
  expect(choices).toEqual({
    bases: ['a', 'b'],
    base: 'a',
    tips: [
      { link: 'c', moving: 2 },
      { link: 'd', moving: 3 },
    ],
    tip: 'd',
    isOpen: false,
  });
  expect(opened(text, { baseLink: 'b' }).robot.joints.map(({ label, id }) => label ?? id)).toEqual(['two', 'three']);
  expect(opened(text, { tipLink: 'c' }).robot.joints).toHaveLength(2);
  expect(readUrdf(text, { tipLink: 'x' }).issues[0].message).toBe('There is no link "x" in this file.');
  expect(readUrdf(text, { baseLink: 'd', tipLink: 'a' }).issues[0].message).toBe(
    'The link "d" does not carry "a"; expected a tip beyond the base.',
  );
});

test('an arm with seven joints is refused, unless a tip on the way is chosen', () => {
  const more = [4, 5, 6, 7].map(
    (i) =>
      `<joint name="j${i}" type="continuous"><parent link="${LINKS[i - 1]}"/><child link="${LINKS[i]}"/><origin xyz="0.1 0 0.2" rpy="1 0 0"/><axis xyz="0 0 1"/></joint>`,
  );
  const text = arm({ links: LINKS, more: more.join('') });
  const { doc, issues, choices } = readUrdf(text);
  expect(doc).toBe(null);
  expect(issues.map(({ message }) => message)).toEqual([
    'From "a" to "tip" 7 joints move; expected 2 to 6, or a tip to be named that comes before.',
  ]);
  expect(choices?.tips.map(({ link }) => link)).toEqual(['c', 'd', 'e', 'f', 'g']);
  expect(opened(text, { tipLink: 'g' }).robot.joints).toHaveLength(6);
  const withFinger = text.replaceAll('"j7"', '"finger"');
  expect(opened(withFinger).robot.joints).toHaveLength(6);
  expect(opened(text.replaceAll('"g"', '"tool0"')).robot.joints).toHaveLength(6);
});

/** @param {number} count @param {string} more */
const column = (count, more) =>
  `<robot name="column"><link name="l0"/>${Array.from(
    { length: count },
    (_, i) =>
      `<joint name="j${i + 1}" type="continuous"><parent link="l${i}"/><child link="l${i + 1}"/><origin xyz="0.1 0 0.3"/><axis xyz="0 ${i % 2} ${1 - (i % 2)}"/></joint><link name="l${i + 1}"/>`,
  ).join('')}${more}</robot>`;

/** @param {string} name @param {string} parent */
const fixedLink = (name, parent) =>
  `<joint name="to_${name}" type="fixed"><parent link="${parent}"/><child link="${name}"/></joint><link name="${name}"/>`;

test.for(
  /** @type {const} */ ([
    ['one line of links', '', false],
    ['a flange and tool0 beside it', fixedLink('flange', 'l4') + fixedLink('tool0', 'l4'), false],
    ['tool0 with a camera beside it and a gripper on it', fixedLink('tool0', 'l4') + fixedLink('camera', 'l4') + fixedLink('grip', 'tool0'), false], // prettier-ignore
    ['a camera half way', fixedLink('camera', 'l3'), false],
    ['a camera beside a gripper at the end', fixedLink('camera', 'l4') + fixedLink('grip', 'l4'), true],
    ['two named ends', fixedLink('tool0', 'l4') + column(4, fixedLink('right_tool0', 'r4')).replace(/<\/?robot[^>]*>|<link name="l0"\/>/g, '').replace(/"([lj])([1-4])"/g, (_, kind, n) => `"${kind === 'l' ? 'r' : 'i'}${n}"`), true], // prettier-ignore
  ]),
)('a file with %s leaves a choice: %s', ([, more, isOpen]) => {
  const { choices, doc } = readUrdf(column(4, more));
  expect([choices?.isOpen, doc !== null]).toEqual([isOpen, true]);
});

test('joint values keep zero and sign, limits and rates their units', () => {
  const { robot } = opened(arm());
  expect(robot.joints.map(({ type, lower, upper, velocity }) => [type, lower, upper, velocity])).toEqual([
    [
      'revolute',
      expect.closeTo(-180 / Math.PI, 12),
      expect.closeTo(180 / Math.PI, 12),
      expect.closeTo(360 / Math.PI, 12),
    ],
    ['prismatic', 0, 0.5, 1],
    ['continuous', undefined, undefined, undefined],
  ]);
});

test('axes nearly parallel stay as they are, with what making them parallel would do', () => {
  const text = arm({ joint: '<axis xyz="0 0 1"/><limit lower="-3" upper="3"/>' })
    .replace('type="prismatic"', 'type="revolute"')
    .replace('1.5707963267948966 0 0', '0.0000073 0 0')
    .replace('<axis xyz="0 1 0"/>', '<axis xyz="1 0 0"/>');
  const { doc, snaps } = readUrdf(text);
  expect(snaps).toEqual([{ after: 1, angle: expect.closeTo(0.000418, 6), moves: expect.any(Number) }]);
  expect(snaps[0].moves).toBeGreaterThan(1e-7);
  expect(snaps[0].moves).toBeLessThan(1e-5);
  expect(Math.max(...(doc?.robot.joints ?? []).map(({ d }) => Math.abs(d)))).toBeGreaterThan(1000);
  const snapped = readUrdf(text, { snap: 1e-5 });
  expect(Math.max(...(snapped.doc?.robot.joints ?? []).map(({ d }) => Math.abs(d)))).toBeLessThan(1);
  expect(snapped.snaps).toEqual(snaps.map((snap) => ({ ...snap, moves: expect.closeTo(snap.moves, 6) })));
});

test('where the numbers of the computer do not suffice, the arm is refused, and snapping is offered', () => {
  const text = arm({ joint: '<axis xyz="0 0 1"/>' })
    .replace('1.5707963267948966 0 0', '1.5707963 0 0.7')
    .replace('<axis xyz="0 0 -1"/>', '<axis xyz="0 1 0"/>')
    .replace('prismatic', 'revolute')
    .replace('xyz="0.1 0.2 0.3"', 'xyz="0 20 0"');
  const { doc, issues, snaps } = readUrdf(text);
  expect(doc).toBe(null);
  expect(issues.map(({ code }) => code)).toContain('not-exact');
  expect(snaps).toEqual([{ after: 1, angle: expect.closeTo(1.5e-6, 7), moves: expect.any(Number) }]);
  expect(readUrdf(text, { snap: 1e-7 }).doc).not.toBe(null);
});

const angle = fc.constantFrom(0, Math.PI / 2, -Math.PI / 2, Math.PI, 0.3, -2.1, 1.570796);
const length = fc.constantFrom(0, 0.1, -0.25, 0.7);
const step = fc.record({
  type: fc.constantFrom('revolute', 'continuous', 'prismatic', 'fixed'),
  xyz: fc.tuple(length, length, length),
  rpy: fc.tuple(angle, angle, angle),
  axis: fc.constantFrom('1 0 0', '0 1 0', '0 0 1', '0 0 -1', '0.6 0 0.8', '-0.6 0.8 0'),
});

/**
 * The tip by the rule of the format: origin, then motion, joint after joint.
 * @param {readonly { type: string, xyz: number[], rpy: number[], axis: string }[]} steps
 * @param {ArrayLike<number>} q  of those that move
 */
function rowByRow(steps, q) {
  let T = rigid(rodrigues([0, 0, 1], 0), [0, 0, 0]);
  let i = 0;
  for (const {
    type,
    xyz,
    rpy: [r, p, y],
    axis,
  } of steps) {
    const R = times(rodrigues([0, 0, 1], y), times(rodrigues([0, 1, 0], p), rodrigues([1, 0, 0], r)));
    T = times(T, rigid(R, xyz));
    if (type === 'fixed') continue;
    const [u, value] = [axis.split(' ').map(Number), q[i++]];
    const still = rodrigues(u, 0);
    T = times(
      T,
      type === 'prismatic'
        ? rigid(
            still,
            u.map((part) => part * value),
          )
        : rigid(rodrigues(u, value), [0, 0, 0]),
    );
  }
  return T;
}

test('any chain is the same arm to 1e-8: skew, crossing, parallel, antiparallel, one line', () => {
  fc.assert(
    fc.property(fc.array(step, { minLength: 2, maxLength: 7 }), (steps) => {
      const moving = steps.filter(({ type }) => type !== 'fixed');
      fc.pre(moving.length >= 2 && moving.length <= 6);
      const joints = steps.map(
        ({ type, xyz, rpy, axis }, i) =>
          `<joint name="j${i}" type="${type}"><parent link="${LINKS[i]}"/><child link="${LINKS[i + 1]}"/><origin xyz="${xyz.join(' ')}" rpy="${rpy.join(' ')}"/><axis xyz="${axis}"/><limit lower="-1" upper="1"/></joint>`,
      );
      const names = LINKS.slice(0, steps.length + 1);
      const text = `<robot name="r">${names.map((name) => `<link name="${name}"/>`).join('')}${joints.join('')}</robot>`;
      const { robot } = opened(text, { tipLink: names[names.length - 1] });
      const chain = compileRobot(robot);
      for (const q of somePostures(newDocument(robot))) {
        expect(apart(tcpPose(chain, q), rowByRow(steps, q).slice(0, 3))).toBeLessThan(6e-8); // slides go as far as 5 m
      }
      expect(compilePosture(robot, newDocument(robot).posture).every((value) => Math.abs(value) === 0)).toBe(true);
    }),
    { seed: SEED, numRuns: runs(150) },
  );
});

/** @type {{ file: string, expect: 'reject' | 'accept' | 'accept_warn' | 'any' }[]} */
const BAD = JSON.parse(readFileSync(new URL('bad/manifest.json', FOLDER), 'utf8'));

/** @param {string} file */
function openBytes(file) {
  const { text, issues } = decodeText(new Uint8Array(readFileSync(new URL(`bad/${file}`, FOLDER))));
  if (text === null) return { doc: null, issues };
  const read = readUrdf(text);
  return { doc: read.doc, issues: [...issues, ...read.issues] };
}

test('every bad or odd URDF of the collection has the outcome that its manifest states', () => {
  const outcomes = BAD.map(({ file, expect: stated }) => {
    const { doc, issues } = openBytes(file);
    expect({ file, isRefused: hasErrors(issues) }).toEqual({ file, isRefused: doc === null });
    if (doc) expect(validateDocument(doc)).toEqual([]);
    return { file, stated, came: doc ? (issues.length > 0 ? 'accept_warn' : 'accept') : 'reject' };
  });
  expect(outcomes.length).toBeGreaterThan(100);
  expect(outcomes.filter(({ stated, came }) => stated !== 'any' && stated !== came)).toEqual([]);
});
