import fc from 'fast-check';
import { readFileSync, readdirSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { decodeText } from '../../../src/io/decodeText.js';
import { hasErrors } from '../../../src/io/fileIssues.js';
import { readRlkin, writeRlkin } from '../../../src/io/rlkin.js';
import { rlkinLosses } from '../../../src/io/rlkin/rlkinLosses.js';
import { readRobotFile } from '../../../src/io/robotFile.js';
import { readRobotXml, writeRobotXml } from '../../../src/io/robotXml.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compileRobot } from '../../../src/model/compile.js';
import { convertConvention } from '../../../src/model/robot/convertConvention.js';
import { LIBRARY } from '../../../src/model/library.js';
import { newDocument } from '../../../src/model/newDocument.js';
import { validateDocument } from '../../../src/model/validate.js';
import { SEED, runs } from '../../helpers/property.js';
import { documents } from './documents.js';
import { rlkinPose } from './rlkinPose.js';
import { schemaErrors } from './xmllint.js';

/** @import { Doc } from '../../../src/model/document.js' */

const FOLDER = new URL('../../fixtures/rlkin/', import.meta.url);
const textOf = (/** @type {string} */ name) => readFileSync(new URL(name, FOLDER), 'utf8');
const SCHEMA = textOf('rlkin.xsd');
/** @type {Record<string, { q: number[], T: number[][] }[]>} */
const REFERENCE = JSON.parse(textOf('reference.json'));

/** @param {string} text @returns {Doc} */
function opened(text) {
  const { doc, issues } = readRlkin(text);
  if (!doc) throw new Error(issues.map(({ message }) => message).join(' '));
  return doc;
}

/** The largest difference between a pose (column-major) and three rows. @param {ArrayLike<number>} T @param {number[][]} rows */
const apart = (T, rows) =>
  Math.max(...rows.slice(0, 3).flatMap((row, i) => row.map((value, j) => Math.abs(T[4 * j + i] - value))));

/** @param {Doc} doc @param {{ q: number[], T: number[][] }[]} samples */
function error({ robot }, samples) {
  const chain = compileRobot(robot);
  return Math.max(...samples.map(({ q, T }) => apart(tcpPose(chain, q), T)));
}

test('there are four arms', () => {
  expect(readdirSync(FOLDER).filter((name) => name.endsWith('.xml'))).toHaveLength(4);
});

describe.each(Object.entries(REFERENCE))('%s', (name, samples) => {
  const text = textOf(`${name}.xml`);

  test('is read without a remark, and is the same arm to 1e-12', () => {
    const { doc, issues } = readRlkin(text);
    expect(issues).toEqual([]);
    expect(doc && validateDocument(doc)).toEqual([]);
    expect(doc && error(doc, samples)).toBeLessThan(1e-12);
    expect(readRobotFile(text)).toEqual({ doc, issues });
  });

  test('goes through our own file without losing a bit', () => {
    const saved = writeRobotXml(opened(text));
    const { doc } = readRobotXml(saved);
    expect(doc).toStrictEqual(opened(text));
    expect(doc && error(doc, samples)).toBeLessThan(1e-12);
  });

  test('goes out valid under the schema, and comes in again the same', async () => {
    const written = writeRlkin(opened(text));
    expect(await schemaErrors([text, written], SCHEMA)).toEqual([[], []]);
    expect(opened(written)).toStrictEqual(opened(text));
    expect(writeRlkin(opened(written))).toBe(written);
  });
});

test('every arm of the library, in both conventions, goes out valid and is the same arm to another reader and to ours', async () => {
  const docs = Object.values(LIBRARY)
    .map((robot) => newDocument(robot))
    .flatMap((doc) => [doc, convertConvention(doc, doc.robot.convention === 'standard' ? 'modified' : 'standard')]);
  const texts = docs.map(writeRlkin);
  expect((await schemaErrors(texts, SCHEMA)).flat()).toEqual([]);
  for (const [i, doc] of docs.entries()) {
    const [ours, back, pose] = [compileRobot(doc.robot), compileRobot(opened(texts[i]).robot), rlkinPose(texts[i])];
    for (const start of [0.3, -1.1, 2.2]) {
      const q = Float64Array.from(doc.robot.joints, (_, k) => start + 0.7 * k);
      expect(apart(tcpPose(ours, q), pose(q))).toBeLessThan(1e-12);
      expect(apart(tcpPose(back, q), pose(q))).toBeLessThan(1e-12);
    }
  }
});

/**
 * The same document with numbers that are not astronomical: a file of ours takes none beyond 10⁹, and degrees are more than
 * radians.
 * @param {Doc} doc
 * @returns {Doc}
 */
function smaller(doc) {
  const number = (/** @type {number} */ value) => (Math.abs(value) < 1e6 ? value : value % 1000);
  /** @param {Doc['robot']['base']} pose */
  const pose = ({ xyz, rpy, ...rest }) => ({ ...rest, xyz: xyz.map(number), ...(rpy && { rpy: rpy.map(number) }) });
  const joints = doc.robot.joints.map(({ lower, upper, ...joint }) => ({
    ...joint,
    ...Object.fromEntries(
      Object.entries(joint).flatMap(([name, value]) => (typeof value === 'number' ? [[name, number(value)]] : [])),
    ),
    ...(joint.velocity !== undefined && { velocity: Math.min(joint.velocity, 1e6) }),
    ...(lower !== undefined && { lower: Math.max(lower, -1e6) - (lower > 1e6 ? lower : 0) }),
    ...(upper !== undefined && { upper: Math.min(upper, 1e6) - (upper < -1e6 ? upper : 0) }),
  }));
  return {
    ...doc,
    robot: {
      ...doc.robot,
      base: pose(doc.robot.base),
      tool: pose(doc.robot.tool),
      joints: joints.map((joint) =>
        joint.lower !== undefined && joint.upper !== undefined && joint.lower > joint.upper
          ? { ...joint, lower: joint.upper, upper: joint.lower }
          : joint,
      ),
    },
  };
}

test('whatever the document: valid under the schema, the same arm, and what is not told to be lost comes back', async () => {
  /** @type {string[]} */
  const texts = [];
  fc.assert(
    fc.property(documents.map(smaller), (doc) => {
      const text = writeRlkin(doc);
      texts.push(text);
      const back = opened(text);
      expect(writeRlkin(opened(writeRlkin(back)))).toBe(writeRlkin(back));
      const [ours, theirs] = [compileRobot(doc.robot), compileRobot(back.robot)];
      const pose = rlkinPose(text);
      const q = Float64Array.from(doc.robot.joints, (_, k) => 0.3 - 0.7 * k);
      const scale = 1 + Math.max(...pose(q).flat().map(Math.abs), ...tcpPose(ours, q).map(Math.abs), 1e6);
      expect(apart(tcpPose(ours, q), pose(q)) / scale).toBeLessThan(1e-9);
      expect(apart(tcpPose(theirs, q), pose(q)) / scale).toBeLessThan(1e-9);
      const told = rlkinLosses(doc).map(({ path }) => path);
      const { robot } = back;
      if (!told.includes('robot.name')) expect(robot.name).toBe(doc.robot.name);
      if (!told.includes('robot.info.manufacturer')) expect(robot.info.manufacturer).toBe(doc.robot.info.manufacturer);
      if (!told.includes('robot.joints'))
        expect(robot.joints.map(({ id }) => id)).toEqual(doc.robot.joints.map(({ id }) => id));
      expect(robot.joints.map(({ type }) => type)).toEqual(doc.robot.joints.map(({ type }) => type));
      if (told.includes('robot.units') || told.includes('robot.convention')) return;
      for (const field of /** @type {const} */ (['theta', 'd', 'a', 'alpha', 'lower', 'upper', 'velocity'])) {
        const [is, was] = [robot, doc.robot].map(({ joints }) => joints.map((joint) => (joint[field] ?? NaN) + 0));
        expect(is).toEqual(was);
      }
    }),
    { seed: SEED, numRuns: runs(60) },
  );
  expect((await schemaErrors(texts.slice(0, 500), SCHEMA)).flat()).toEqual([]);
});

/** A row of an rlkin file. @param {number} i @param {string} [type] @param {string} [more] */
const row = (i, type = 'revolute', more = '') => `<${type} id="j${i}">
<frame><a idref="l${i}"/><b idref="l${i + 1}"/></frame>
<dh><d>0.1</d><theta>30</theta><a>0.2</a><alpha>90</alpha></dh>${more}
</${type}><link id="l${i + 1}"/>`;
/** @param {string} content */
const arm = (content, first = '<link id="l0"/>') => `<rlkin><kinematics><world id="w"/>
<transform id="base"><frame><a idref="w"/><b idref="l0"/></frame></transform>${first}
${content}
</kinematics></rlkin>`;

test.each([
  [
    'a number that is none',
    arm(row(0).replace('0.2', 'zwei') + row(1)),
    'Line 5: <a> of revolute "j0" has the text "zwei"; expected a number such as 12.5.',
  ],
  [
    'a missing number',
    arm(row(0).replace('<d>0.1</d>', '') + row(1)),
    'Line 5: <dh> of revolute "j0" has no <d>; expected one.',
  ],
  [
    'a missing row',
    arm(row(0).replace(/<dh>.*<\/dh>/, '') + row(1)),
    'Line 3: revolute "j0" has no <dh>; expected one.',
  ],
  [
    'an unknown element',
    arm(`${row(0)}<screw/>${row(1)}`),
    'Line 6: <kinematics> contains <screw/>'.replace('/>', '>; expected only <manufacturer>, <name>'),
  ],
  [
    'a missing id',
    arm(row(0).replace(' id="j0"', '') + row(1)),
    'Line 3: revolute 1 has no id; expected one such as id="joint0".',
  ],
  [
    'a reference to nothing',
    arm(row(0).replace('b idref="l1"', 'b idref="l9"') + row(1)),
    'Line 3: the element "j0" refers to "l9", which is no frame of this file.',
  ],
  [
    'an id twice',
    arm(row(0) + row(1).replace('j1', 'j0')),
    'Line 6: two elements have the id "j0"; expected a different id for each.',
  ],
  [
    'a frame that is carried twice',
    arm(row(0) + row(1).replace('b idref="l2"', 'b idref="l1"')),
    'Line 6: the frame "l1" is carried by two, "j0" and "j1"; expected one.',
  ],
  [
    'a frame that hangs in the air',
    arm(`${row(0)}${row(1)}<frame id="f"/>`),
    'Line 9: the frame "f" is not joined to the world; expected one tree.',
  ],
  [
    'a world that is carried',
    arm(`${row(0)}${row(1)}<transform id="t"><frame><a idref="l2"/><b idref="w"/></frame></transform>`),
    'Line 9: the world is carried by "t"; expected nothing.',
  ],
  ['one joint', arm(row(0)), 'Line 6: the chain from the world to "l1" has 1 joint; expected 2 to 6.'],
  [
    'seven joints',
    arm([0, 1, 2, 3, 4, 5, 6].map((i) => row(i)).join('')),
    'Line 24: the chain from the world to "l7" has 7 joints; expected 2 to 6.',
  ],
  ['no robot', '<rlkin/>', 'Line 1: <rlkin> holds no robot; expected <kinematics>, <puma> or <rhino>.'],
  [
    'two robots',
    '<rlkin><puma><world id="w"/></puma><puma><world id="w"/></puma></rlkin>',
    'Line 1: <rlkin> has a second <puma>; expected one.',
  ],
  ['limits that cross', arm(row(0, 'revolute', '<max>-10</max><min>10</min>') + row(1)), 'Line 3: '],
  [
    'a speed below zero',
    arm(row(0, 'revolute', '<speed>-1</speed>') + row(1)),
    'Line 5: <speed> of revolute "j0" has the text "-1"; expected a number from 0 to',
  ],
  ['the other half of the library', '<rl><mdl/></rl>', 'Line 1: <rl> contains <mdl>; expected only <kin>.'],
])('%s is refused, with its line and what was expected', (_, text, message) => {
  const { doc, issues } = readRlkin(text);
  expect(doc).toBe(null);
  expect(issues.filter(({ severity }) => severity === 'error')[0].message.slice(0, message.length)).toBe(message);
});

test('what is not on the chain of the arm, or says nothing of how it moves, is told and not read', () => {
  const finger =
    '<prismatic id="f"><frame><a idref="l1"/><b idref="g"/></frame><dh><d>0</d><theta>0</theta><a>0</a><alpha>0</alpha></dh></prismatic><link id="g"/>';
  const slide = row(1, 'prismatic', '<wraparound/>').replace('<dh>', '<center>3</center><dh>');
  const { doc, issues } = readRlkin(arm(`${row(0)}${finger}${slide}${row(2)}`));
  expect(doc?.robot.joints.map(({ type }) => type)).toEqual(['revolute', 'prismatic', 'revolute']);
  expect(issues.map(({ severity, message }) => [severity, message])).toEqual([
    ['warning', 'Line 6: the element "f" is not on the chain from the world to "l3" and is not read.'],
    [
      'warning',
      'Line 6: the element "j1" has a rotation, a translation or a center of its own, which says nothing of how the arm moves and is not read.',
    ],
    ['warning', 'Line 6: the slide "j1" has a <wraparound>, which only a turn can have and which is not read.'],
  ]);
});

test('offsets are constants of the row; a turn that wraps round is continuous; both names of the root are read', () => {
  const text = arm(
    row(0, 'revolute', '<offset>60</offset><speed>0</speed><wraparound/>') +
      row(1, 'prismatic', '<max>0.5</max><min>-1</min><offset>0.25</offset>'),
  );
  const doc = opened(text);
  expect(
    doc.robot.joints.map(({ type, theta, d, lower, upper, velocity }) => [type, theta, d, lower, upper, velocity]),
  ).toEqual([
    ['continuous', 90, 0.1, undefined, undefined, undefined],
    ['prismatic', 30, 0.35, -1, 0.5, undefined],
  ]);
  const q = [0.4, -0.3];
  expect(apart(tcpPose(compileRobot(doc.robot), q), rlkinPose(text)(q))).toBeLessThan(1e-14);
  expect(opened(text.replace('<rlkin>', '<rl><kin>').replace('</rlkin>', '</kin></rl>'))).toStrictEqual(doc);
});

test('world, base and tool come together in any orientation', () => {
  const text =
    arm(`${row(0)}${row(1)}<transform id="tool"><frame><a idref="l2"/><b idref="m"/></frame><rotation><y>90</y></rotation></transform><frame id="m"/>
<transform id="pen"><frame><a idref="m"/><b idref="t"/></frame><rotation><x>10</x><z>-20</z></rotation><translation><z>0.3</z></translation></transform><frame id="t"/>`)
      .replace(
        '<world id="w"/>',
        '<world id="w"><rotation><x>30</x><y>40</y><z>50</z></rotation><translation><x>1</x></translation></world>',
      )
      .replace(
        '<b idref="l0"/></frame>',
        '<b idref="l0"/></frame><rotation><x>-45</x></rotation><translation><y>2</y></translation>',
      );
  const q = [0.4, -0.3];
  expect(apart(tcpPose(compileRobot(opened(text).robot), q), rlkinPose(text)(q))).toBeLessThan(1e-14);
});

test('a constant transform between two joints: a table is found from the axes, the same arm to 1e-8', () => {
  const between =
    '<transform id="t"><frame><a idref="l1"/><b idref="m"/></frame><rotation><x>20</x><y>-70</y></rotation><translation><y>0.3</y><z>0.1</z></translation></transform><link id="m"/>';
  const text = arm(
    row(0, 'revolute', '<max>100</max><speed>90</speed>') +
      between +
      row(1, 'prismatic').replace('"l1"', '"m"') +
      row(2, 'revolute', '<wraparound/>'),
  );
  const { robot } = opened(text);
  expect(robot.joints.map(({ type, lower, upper, velocity }) => [type, lower, upper, velocity])).toEqual([
    ['revolute', undefined, 100, 90],
    ['prismatic', undefined, undefined, undefined],
    ['continuous', undefined, undefined, undefined],
  ]);
  for (const q of [
    [0, 0, 0],
    [0.4, -0.3, 1],
    [-2, 0.5, 3],
  ]) {
    expect(apart(tcpPose(compileRobot(robot), q), rlkinPose(text)(q))).toBeLessThan(1e-8);
  }
});

/** @type {{ file: string, case: string, expect: 'reject' | 'accept' | 'accept_warn' | 'any' }[]} */
const BAD = JSON.parse(textOf('bad/manifest.json'));

/** @param {string} file */
function openBytes(file) {
  const { text, issues } = decodeText(new Uint8Array(readFileSync(new URL(`bad/${file}`, FOLDER))));
  if (text === null) return { doc: null, issues };
  const read = readRobotFile(text);
  return { doc: read.doc, issues: [...issues, ...read.issues] };
}

test('every bad or odd file of the collection has the outcome that its manifest states, in one sentence each', () => {
  const outcomes = BAD.map(({ file, expect: stated }) => {
    const { doc, issues } = openBytes(file);
    expect({ file, isRefused: hasErrors(issues) }).toEqual({ file, isRefused: doc === null });
    for (const { message, line } of issues) {
      expect({ file, message }).toEqual({
        file,
        message: expect.stringMatching(/^[^\p{Cc}\p{Cf}\u2028\u2029]{20,400}\.$/u),
      });
      expect(message.startsWith(`Line ${line}: `)).toBe(line !== undefined);
    }
    if (doc) expect(validateDocument(doc)).toEqual([]);
    return { file, stated, came: doc ? (issues.length > 0 ? 'accept_warn' : 'accept') : 'reject' };
  });
  expect(outcomes).toHaveLength(55);
  expect(outcomes.filter(({ stated, came }) => stated !== 'any' && stated !== came)).toEqual([]);
});

test.for([
  ['unclosed tag', 'is not closed'],
  ['billion laughs', 'document type declaration, <!DOCTYPE'],
  ["dh a = '1 2'", 'has the text "1 2"; expected a number such as 12.5.'],
  ["dh a = '${pi/2}'", 'has the text "${pi/2}"; expected a number such as 12.5.'],
  ["dh a = '1e400'", 'has the text "1e400"; expected a number from -1000000000 to 1000000000.'],
])('%s is refused in plain words', ([name, words]) => {
  const file = BAD.find((entry) => entry.case === name)?.file ?? '';
  expect(openBytes(file).issues[0].message).toContain(words);
});
