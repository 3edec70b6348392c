import fc from 'fast-check';
import { expect, test } from 'vitest';
import { hasErrors } from '../../../src/io/fileIssues.js';
import { readRobotFile } from '../../../src/io/robotFile.js';
import { readSdf, writeSdf } from '../../../src/io/sdf.js';
import { sdfNames } from '../../../src/io/sdf/sdfWriter.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compileRobot } from '../../../src/model/compile.js';
import { convertConvention } from '../../../src/model/robot/convertConvention.js';
import { LIBRARY } from '../../../src/model/library.js';
import { newDocument } from '../../../src/model/newDocument.js';
import { validateDocument } from '../../../src/model/validate.js';
import { SEED, runs } from '../../helpers/property.js';
import { sdfPose } from './framesPose.js';
import { mutantsOf } from './mutants.js';

/** @import { Doc } from '../../../src/model/document.js' */

/** @param {string} text @param {Parameters<typeof readSdf>[1]} [options] @returns {Doc} */
function opened(text, options) {
  const { doc, issues } = readSdf(text, options);
  if (!doc) throw new Error(issues.map(({ message }) => message).join(' '));
  return doc;
}

/** The largest difference between a pose (column-major) and rows. @param {ArrayLike<number>} T @param {number[][]} rows */
const apart = (T, rows) =>
  Math.max(...rows.slice(0, 3).flatMap((row, i) => row.map((value, j) => Math.abs(T[4 * j + i] - value))));

/** How far what was read is from the file, at some postures. @param {string} text @param {Doc} doc @param {string} tip @param {readonly string[]} names */
function error(text, { robot }, tip, names) {
  const [chain, pose] = [compileRobot(robot), sdfPose(text, tip)];
  const errors = [0, 0.3, -1.1, 2.2].map((start) => {
    const q = Float64Array.from(robot.joints, (_, i) => start + 0.7 * i);
    return apart(tcpPose(chain, q), pose(Object.fromEntries(names.map((name, i) => [name, q[i]]))));
  });
  return Math.max(...errors);
}

test('every arm of the library, in both conventions, comes back as the same arm to 1e-8, with its limits', () => {
  for (const robot of Object.values(LIBRARY)) {
    for (const convention of /** @type {const} */ (['standard', 'modified'])) {
      const doc = convertConvention(newDocument(robot), convention);
      const text = writeSdf(doc);
      const { doc: back, issues } = readRobotFile(text);
      expect(hasErrors(issues)).toBe(false);
      expect(back && validateDocument(back)).toEqual([]);
      expect(back && error(text, back, 'tool0', sdfNames(doc.robot).joints)).toBeLessThan(1e-8);
      expect(
        back?.robot.joints.map(({ type, lower = null, upper = null }) => [type, lower !== null, upper !== null]),
      ).toEqual(doc.robot.joints.map(({ type, lower, upper }) => [type, lower !== undefined, upper !== undefined]));
    }
  }
});

const angle = fc.constantFrom(0, Math.PI / 2, -Math.PI / 2, Math.PI, 0.3, -2.1);
const length = fc.constantFrom(0, 0.1, -0.25, 0.7);
const pose = fc.tuple(length, length, length, angle, angle, angle).map((numbers) => numbers.join(' '));
const step = fc.record({
  type: fc.constantFrom('revolute', 'prismatic', 'continuous', 'fixed'),
  link: pose,
  joint: pose,
  from: fc.constantFrom('', ' relative_to="l0"', ' relative_to="__model__"'),
  axis: fc.constantFrom(
    '<xyz>0 0 1</xyz>',
    '<xyz>0 -2 0</xyz>',
    '<xyz expressed_in="__model__">1 0 0</xyz>',
    '<xyz expressed_in="l0">0.6 0 0.8</xyz>',
  ),
});

test('links anywhere, joints seen from anywhere, axes expressed in anything: the same arm to 1e-8', () => {
  fc.assert(
    fc.property(fc.array(step, { minLength: 2, maxLength: 6 }), pose, (steps, first) => {
      const moving = steps.flatMap(({ type }, i) => (type === 'fixed' ? [] : [`j${i + 1}`]));
      fc.pre(moving.length >= 2);
      const parts = steps.map(
        ({ type, link, joint, from, axis }, i) => `<link name="l${i + 1}"><pose>${link}</pose></link>
<joint name="j${i + 1}" type="${type}"><pose${from}>${joint}</pose><parent>l${i}</parent><child>l${i + 1}</child><axis>${axis}</axis></joint>`,
      );
      const text = `<sdf version="1.9"><model name="m"><pose>1 2 3 0 0 1</pose><link name="l0"><pose>${first}</pose></link>
<joint name="w" type="fixed"><parent>world</parent><child>l0</child></joint>${parts.join('')}</model></sdf>`;
      const tip = `l${steps.length}`;
      const placed = opened(text, { tipLink: tip });
      // the oracle sees the tip from the model, which stands in the world here
      const inModel = text.replace('<pose>1 2 3 0 0 1</pose>', '');
      expect(error(inModel, opened(inModel, { tipLink: tip }), tip, moving)).toBeLessThan(1e-7);
      expect(placed.robot.joints).toHaveLength(moving.length);
    }),
    { seed: SEED, numRuns: runs(100) },
  );
});

/** A model with two joints, one thing of it replaced. @param {string} from @param {string} to */
const spoilt = (from, to) => ARM.replace(from, to);
const ARM = `<sdf version="1.9">
<model name="arm"><link name="a"/><link name="b"/><link name="c"/>
<joint name="one" type="revolute"><pose relative_to="a">0 0 1 0 0 0</pose><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>inf</upper><velocity>2</velocity><effort>-1</effort></limit></axis></joint>
<joint name="two" type="prismatic"><pose relative_to="b" degrees="true">0.5 0 0 90 0 0</pose><parent>b</parent><child>c</child><axis><xyz>0 0 1</xyz><limit><lower>-1e16</lower><upper>1</upper></limit></axis></joint>
</model></sdf>`;

test('of two chains that are as likely one is read, and the other may be chosen', () => {
  const second = ARM.slice(ARM.indexOf('<joint'), ARM.indexOf('</model>'))
    .replaceAll('"one"', '"three"')
    .replaceAll('"two"', '"four"')
    .replaceAll(/>b<|"b"/g, (found) => found.replace('b', 'd'))
    .replaceAll('>c<', '>e<');
  const text = spoilt('</model>', `<link name="d"/><link name="e"/>${second}</model>`);
  const { doc, issues, chain } = readRobotFile(text);
  expect(issues).toEqual([]);
  expect(doc?.robot.joints.map(({ id }) => id)).toEqual(['one', 'two']);
  expect(chain?.choices).toMatchObject({ base: 'a', tip: 'c', isOpen: true, tips: [{ link: 'c' }, { link: 'e' }] });
  const other = chain?.read({ tipLink: 'e' });
  expect(other?.doc?.robot.joints.map(({ id }) => id)).toEqual(['three', 'four']);
  expect(other?.doc?.robot.info.source).toBe('SDFormat, a to e');
});

test('limits, units and the place of the model', () => {
  const { robot } = opened(ARM);
  expect(robot.joints.map(({ lower, upper, velocity, effort }) => [lower, upper, velocity, effort])).toEqual([
    [expect.closeTo(-180 / Math.PI, 9), undefined, expect.closeTo(360 / Math.PI, 9), undefined],
    [undefined, 1, undefined, undefined],
  ]);
  expect(robot.info.source).toBe('SDFormat, a to c');
  const fixed = '<joint name="w" type="fixed"><parent>world</parent><child>a</child></joint>';
  const placed = spoilt('<link name="a"/>', `<pose>1 2 3 0 0 0</pose><link name="a"/>${fixed}`);
  const still = Float64Array.of(0, 0);
  const [there, here] = [placed, ARM].map((text) => tcpPose(compileRobot(opened(text).robot), still));
  expect([12, 13, 14].map((i) => there[i] - here[i])).toEqual([1, 2, 3].map((value) => expect.closeTo(value, 12)));
});

test.each([
  [
    'an old version',
    spoilt('1.9', '1.4'),
    'Line 1: the file is SDFormat "1.4"; expected version 1.5 or later, such as 1.9.',
  ],
  [
    'an include',
    spoilt('<link name="a"/>', '<include><uri>model://x</uri></include>'),
    'Line 2: a model is put together of others (<include>); expected one model with all its links.',
  ],
  [
    'a model in the model',
    spoilt('<link name="a"/>', '<model name="x"/>'),
    'Line 2: a model is put together of others (<model>)',
  ],
  ['no model', '<sdf version="1.9"/>', 'Line 1: the file has no <model>; expected one.'],
  [
    'a ball joint',
    spoilt('type="revolute"', 'type="ball"'),
    'Line 3: the joint "one" is of the type "ball"; expected revolute, prismatic, continuous or fixed.',
  ],
  [
    'a name twice',
    spoilt('name="b"', 'name="a"'),
    'Line 2: two things are called "a"; expected a name of its own for each.',
  ],
  [
    'a child that is not there',
    spoilt('<child>c</child>', '<child>x</child>'),
    'Line 4: the joint "two" refers to "x", which is on no link of this file.',
  ],
  ['no child', spoilt('<child>c</child>', ''), 'Line 4: the joint "two" has no <child>'],
  [
    'a place that is not there',
    spoilt('relative_to="b"', 'relative_to="x"'),
    'Line 4: the joint "two" is placed by "x", which is nothing in this file.',
  ],
  [
    'places in a circle',
    spoilt('<link name="b"/>', '<link name="b"><pose relative_to="one"/></link>').replace(
      'relative_to="a"',
      'relative_to="b"',
    ),
    'Line 2: the link "b" is placed by',
  ],
  [
    'a pose of five numbers',
    spoilt('0 0 1 0 0 0', '0 0 1 0 0'),
    'Line 3: the <pose> is "0 0 1 0 0"; expected 6 numbers with blanks between them.',
  ],
  [
    'a limit that is none',
    spoilt('<upper>1</upper>', '<upper>1,5</upper>'),
    'Line 4: <upper> is "1,5"; expected a number such as 12.5.',
  ],
  ['no axis', spoilt('<xyz>0 0 1</xyz>', '<xyz>0 0 0</xyz>'), 'Line 3: the joint "one" has the axis 0 0 0'],
  [
    'a closed loop',
    spoilt('</model>', '<joint name="x" type="fixed"><parent>a</parent><child>c</child></joint></model>'),
    'Line 5: the link "c" is carried by two joints, "two" and "x"; expected one.',
  ],
  [
    'a mimic',
    spoilt('<limit><lower>-1e16', '<mimic joint="one"/><limit><lower>-1e16'),
    'Line 4: the joint "two" of this chain follows "one" (mimic)',
  ],
])('%s is refused, with its line and what was expected', (_, text, message) => {
  const { doc, issues } = readSdf(text);
  expect(doc).toBe(null);
  expect(issues[0].message.slice(0, message.length)).toBe(message);
});

test('spoilt files are refused, or opened as sound and finite documents', () => {
  const texts = [
    ARM,
    ...Object.values(LIBRARY)
      .slice(0, 6)
      .map((robot) => writeSdf(newDocument(robot))),
  ];
  fc.assert(
    fc.property(mutantsOf(texts), (text) => {
      const { doc, issues } = readRobotFile(text);
      expect(hasErrors(issues)).toBe(doc === null);
      for (const { message } of issues) expect(message).toMatch(/^[^\p{Cc}\p{Cf}\p{Cs}]{20,500}\.$/u);
      if (!doc) return;
      expect(validateDocument(doc)).toEqual([]);
      expect(tcpPose(compileRobot(doc.robot), new Float64Array(doc.robot.joints.length)).every(Number.isFinite)).toBe(
        true,
      );
    }),
    { seed: SEED, numRuns: runs(100) },
  );
});
