import fc from 'fast-check';
import { expect, test } from 'vitest';
import { DOCUMENT_ISSUES } from '../../../src/model/issues.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { reviewDocument } from '../../../src/model/review.js';
import { shownText } from '../../../src/model/shownText.js';
import { validateDocument } from '../../../src/model/validate.js';
import { runs, SEED } from '../../helpers/property.js';

/** @import { Doc, JointDoc } from '../../../src/model/document.js' */

const arm = newDocument(LIBRARY.planar2r);

/**
 * Values of wrong types are part of what is tested, hence the loose type.
 * @param {Record<string, unknown>} changes by path
 * @param {Doc} [doc]
 * @returns {Doc}
 */
function changed(changes, doc = arm) {
  const copy = structuredClone(doc);
  for (const [path, value] of Object.entries(changes)) {
    const keys = path.split('.');
    const last = String(keys.pop());
    /** @type {Record<string, unknown>} */
    let holder = /** @type {Record<string, unknown>} */ (/** @type {unknown} */ (copy));
    for (const key of keys) holder = /** @type {Record<string, unknown>} */ (holder[key]);
    holder[last] = value;
  }
  return copy;
}

/** @param {Record<string, unknown>} changes */
const faults = (changes) => validateDocument(changed(changes)).map(({ code, path, message }) => [code, path, message]);
/** @param {Record<string, unknown>} changes @param {Doc} [doc] */
const remarks = (changes, doc) =>
  reviewDocument(changed(changes, doc)).map(({ code, path, message }) => [code, path, message]);

const joint = (/** @type {string} */ id) => ({ ...arm.robot.joints[0], id });
const posture = (/** @type {number} */ i) => ({ id: `p${i}`, q: [0, 0] });

test('the robots of the library are sound, and there is nothing to remark', () => {
  for (const robot of Object.values(LIBRARY)) {
    expect(validateDocument(newDocument(robot))).toEqual([]);
    expect(reviewDocument(newDocument(robot))).toEqual([]);
  }
});

const RANGE = '-1000000000 to 1000000000';

test.for([
  [
    { 'robot.name': 'a'.repeat(201) },
    'text-length',
    'robot.name',
    'The robot has a name of 201 characters; expected a text of at most 200.',
  ],
  [{ 'robot.name': 5 }, 'text-length', 'robot.name', 'The robot has a name 5; expected a text of at most 200.'],
  [
    { 'robot.info.author': 'a'.repeat(201) },
    'text-length',
    'robot.info.author',
    'The robot has as author a text of 201 characters; expected a text of at most 200.',
  ],
  [
    { 'robot.info.description': 'a'.repeat(10_001) },
    'text-length',
    'robot.info.description',
    'The robot has as description a text of 10001 characters; expected a text of at most 10000.',
  ],
  [
    { 'robot.units.length': 'inch' },
    'choice',
    'robot.units.length',
    'The robot has the length unit "inch"; expected m, cm, mm.',
  ],
  [
    { 'robot.units.angle': 'grad' },
    'choice',
    'robot.units.angle',
    'The robot has the angle unit "grad"; expected deg, rad.',
  ],
  [
    { 'robot.convention': 'craig' },
    'choice',
    'robot.convention',
    'The robot has the convention "craig"; expected standard, modified.',
  ],
  [
    { 'robot.joints.0.type': 'planar' },
    'choice',
    'robot.joints.0.type',
    'Joint "joint_1" has the type "planar"; expected revolute, prismatic, continuous.',
  ],
  [
    { 'robot.joints.0.label': 'a'.repeat(201) },
    'text-length',
    'robot.joints.0.label',
    'Joint "joint_1" has a label of 201 characters; expected a text of at most 200.',
  ],
  [
    { 'robot.joints.0.a': NaN },
    'number',
    'robot.joints.0.a',
    `Joint "joint_1" has a NaN; expected a number from ${RANGE}.`,
  ],
  [
    { 'robot.joints.0.theta': '90' },
    'number',
    'robot.joints.0.theta',
    `Joint "joint_1" has theta "90"; expected a number from ${RANGE}.`,
  ],
  [
    { 'robot.joints.0.upper': Infinity },
    'number',
    'robot.joints.0.upper',
    `Joint "joint_1" has the upper limit Infinity; expected a number from ${RANGE}.`,
  ],
  [
    { 'robot.joints.0.home': 1.1e9 },
    'number',
    'robot.joints.0.home',
    `Joint "joint_1" has the home value 1100000000; expected a number from ${RANGE}.`,
  ],
  [
    { 'robot.joints.0.velocity': 0 },
    'number',
    'robot.joints.0.velocity',
    'Joint "joint_1" has velocity 0; expected a number above 0 and up to 1000000000.',
  ],
  [
    { 'robot.joints.0.text': { d: 'x'.repeat(201) } },
    'text-length',
    'robot.joints.0.text.d',
    'Joint "joint_1" has as d an expression of 201 characters; expected a text of at most 200.',
  ],
  [
    { 'robot.joints.0.lower': 181 },
    'limits-crossed',
    'robot.joints.0.lower',
    'Joint "joint_1" has the lower limit 181 above its upper limit 180; expected lower <= upper.',
  ],
  [
    { 'robot.joints.0.id': 'a b' },
    'id',
    'robot.joints.0.id',
    'Joint 1 has the id "a b"; expected a letter or _, then letters, digits or _, at most 64 characters.',
  ],
  [
    { 'robot.joints.1.id': 'joint_1' },
    'id-taken',
    'robot.joints.1.id',
    'Two joints have the id "joint_1"; expected a different id for each.',
  ],
  [
    { 'robot.joints.0.link.kind': 'ball' },
    'choice',
    'robot.joints.0.link.kind',
    'The link of joint "joint_1" has the kind "ball"; expected auto, cylinder, box, none.',
  ],
  [
    { 'robot.joints.0.link.radius': -1 },
    'number',
    'robot.joints.0.link.radius',
    'The link of joint "joint_1" has radius -1; expected a number above 0 and up to 1000000000.',
  ],
  [
    { 'robot.joints.0.link.color': 'red' },
    'colour',
    'robot.joints.0.link.color',
    'The link of joint "joint_1" has the colour "red"; expected one such as #ffcc00.',
  ],
  [
    { 'robot.joints.0.controller.sign': 2 },
    'choice',
    'robot.joints.0.controller.sign',
    'The controller of joint "joint_1" has the sign 2; expected 1, -1.',
  ],
  [
    { 'robot.joints.0.controller.offset': NaN },
    'number',
    'robot.joints.0.controller.offset',
    `The controller of joint "joint_1" has the offset NaN; expected a number from ${RANGE}.`,
  ],
  [
    { 'robot.joints.0.controller.coupling': -1 },
    'coupling-without-joint',
    'robot.joints.0.controller.coupling',
    'The controller of joint "joint_1" has the coupling -1 to no joint; expected the id of one in coupledTo.',
  ],
  [
    { 'robot.joints.0.controller.coupledTo': 'joint_9' },
    'coupling-unknown',
    'robot.joints.0.controller.coupledTo',
    'The controller of joint "joint_1" is coupled to "joint_9"; expected the id of another joint.',
  ],
  [
    { 'robot.joints.1.controller.coupledTo': 'joint_2' },
    'coupling-circle',
    'robot.joints.1.controller.coupledTo',
    'The controller of joint "joint_2" is coupled to itself; expected another joint.',
  ],
  [{ 'robot.base': { xyz: [0, 0] } }, 'vector-length', 'robot.base.xyz', 'The base has 2 numbers in xyz; expected 3.'],
  [
    { 'robot.tool': { xyz: [0, 0, NaN] } },
    'number',
    'robot.tool.xyz',
    `The tool has in xyz the value NaN; expected a number from ${RANGE}.`,
  ],
  [
    { 'robot.tool': { xyz: [0, 0, 0], rpy: [0] } },
    'vector-length',
    'robot.tool.rpy',
    'The tool has 1 numbers in rpy; expected 3.',
  ],
  [
    { 'robot.tool': { xyz: [0, 0, 0], rpy: [0, 0, 0], quaternion: [0, 0, 0, 1] } },
    'orientation-twice',
    'robot.tool.quaternion',
    'The tool has both rpy and a quaternion; expected one of them.',
  ],
  [
    { 'robot.tool': { xyz: [0, 0, 0], quaternion: [0, 0, 0, 1.00001] } },
    'quaternion-length',
    'robot.tool.quaternion',
    'The tool has a quaternion of length 1.00001; expected length 1.',
  ],
  [
    { posture: [0] },
    'posture-length',
    'posture',
    'The present posture has 1 joint value; expected 2, one for each joint.',
  ],
  [
    { posture: [0, NaN] },
    'number',
    'posture',
    `The present posture has the joint value NaN; expected a number from ${RANGE}.`,
  ],
  [
    { postures: [{ id: 'p1', q: [0, 0, 0] }] },
    'posture-length',
    'postures.0.q',
    'Posture "p1" has 3 joint values; expected 2, one for each joint.',
  ],
  [
    { postures: [{ id: 'current', q: [0, 0] }] },
    'id-reserved',
    'postures.0.id',
    'A recorded posture has the id "current", which stands for where the arm is; expected another.',
  ],
  [
    { postures: [posture(1), posture(1)] },
    'id-taken',
    'postures.1.id',
    'Two postures have the id "p1"; expected a different id for each.',
  ],
  [
    { postures: Array.from({ length: 1000 }, (_, i) => posture(i)) },
    'too-many-postures',
    'postures',
    'The model has 1000 postures; expected at most 999.',
  ],
  [
    { frames: Array.from({ length: 101 }, (_, i) => ({ kind: 'user', id: `f${i}`, xyz: [0, 0, 0] })) },
    'too-many-frames',
    'frames',
    'The model has 101 frames; expected at most 100.',
  ],
  [
    { frames: [{ kind: 'user', id: 'f', number: 1.5, xyz: [0, 0, 0] }] },
    'number',
    'frames.0.number',
    'Frame "f" has the number 1.5; expected a whole number above 0.',
  ],
  [
    { frames: [{ kind: 'world', id: 'f', xyz: [0, 0, 0] }] },
    'choice',
    'frames.0.kind',
    'Frame "f" has the kind "world"; expected user, tool.',
  ],
  [
    { targets: Array.from({ length: 201 }, (_, i) => ({ id: `t${i}`, xyz: [0, 0, 0] })) },
    'too-many-targets',
    'targets',
    'The model has 201 targets; expected at most 200.',
  ],
  [
    { obstacles: Array.from({ length: 101 }, (_, i) => ({ kind: 'plane', id: `o${i}`, xyz: [0, 0, 0] })) },
    'too-many-obstacles',
    'obstacles',
    'A model keeps at most 100 obstacles.',
  ],
  [
    { obstacles: ['a', 'b', 'a'].map((id) => ({ kind: 'plane', id, xyz: [0, 0, 0] })) },
    'id-taken',
    'obstacles.2.id',
    'Another obstacle is called "a" already.',
  ],
  [
    { obstacles: [{ kind: 'cylinder', id: 'a', xyz: [0, 0, 0], radius: 1, height: 0 }] },
    'number',
    'obstacles.0.height',
    'The height of a cylinder is a number above 0, up to 10⁹; got 0.',
  ],
  [
    { targets: ['a', 'b', 'a'].map((id) => ({ id, xyz: [0, 0, 0] })) },
    'id-taken',
    'targets.2.id',
    'Two targets have the id "a"; expected a different id for each.',
  ],
  [
    { targets: [{ id: 'a', xyz: [0, 0, 0], configuration: 'x'.repeat(201) }] },
    'text-length',
    'targets.0.configuration',
    'Target "a" has as configuration a text of 201 characters; expected a text of at most 200.',
  ],
  [
    { targets: [{ id: 'a', xyz: [0, 0, 0], quaternion: [0, 0, 1, 1] }] },
    'quaternion-length',
    'targets.0.quaternion',
    'Target "a" has a quaternion of length 1.4142135623730951; expected length 1.',
  ],
  [
    { programs: [{ id: '1', language: 'krl', text: '' }] },
    'id',
    'programs.0.id',
    'Program 1 has the id "1"; expected a letter or _, then letters, digits or _, at most 64 characters.',
  ],
  [
    { programs: [{ id: 'p', language: 'rapid', text: '' }] },
    'choice',
    'programs.0.language',
    'Program "p" has the language "rapid"; expected karel, fanuc-tp, krl.',
  ],
  [
    { programs: [{ id: 'p', language: 'krl', text: 1 }] },
    'text-length',
    'programs.0.text',
    'Program "p" has a text 1; expected a text.',
  ],
  [
    { programs: Array.from({ length: 21 }, (_, i) => ({ id: `p${i}`, language: 'krl', text: '' })) },
    'too-many-programs',
    'programs',
    'The model has 21 programs; expected at most 20.',
  ],
])('one fault is one issue: %#', ([changes, code, path, message]) => {
  expect(faults(/** @type {Record<string, unknown>} */ (changes))).toEqual([[code, path, message]]);
});

test('a robot has 2 to 6 joints', () => {
  const withJoints = (/** @type {number} */ count) => ({
    'robot.joints': Array.from({ length: count }, (_, i) => joint(`j${i}`)),
    posture: Array(count).fill(0),
  });
  for (const count of [2, 3, 4, 5, 6]) expect(faults(withJoints(count))).toEqual([]);
  expect(faults(withJoints(1))).toEqual([['joint-count', 'robot.joints', 'The robot has 1 joint; expected 2 to 6.']]);
  expect(faults(withJoints(7))).toEqual([['joint-count', 'robot.joints', 'The robot has 7 joints; expected 2 to 6.']]);
});

test('the most that is allowed is allowed', () => {
  expect(
    faults({
      'robot.name': '😀'.repeat(200),
      'robot.joints.0.id': `_${'a'.repeat(63)}`,
      'robot.joints.0.a': -1e9,
      'robot.joints.0.lower': 5,
      'robot.joints.0.upper': 5,
      'robot.base': { xyz: [0, 0, 0], quaternion: [0, 0, 0, 1.0000009] },
      'robot.joints.1.controller': { sign: -1, offset: 0, coupledTo: `_${'a'.repeat(63)}`, coupling: 0 },
      postures: Array.from({ length: 999 }, (_, i) => posture(i)),
    }),
  ).toEqual([]);
});

test('a circle of couplings is found wherever it begins, and once', () => {
  const coupled = (/** @type {(string | undefined)[]} */ ...to) =>
    to.map((coupledTo, i) => ({
      ...joint(`j${i}`),
      controller: { sign: 1, offset: 0, coupling: 0, ...(coupledTo && { coupledTo }) },
    }));
  const circles = (/** @type {(string | undefined)[]} */ ...to) =>
    faults({ 'robot.joints': coupled(...to), posture: to.map(() => 0) }).map(([, path]) => path);
  expect(circles(undefined, 'j0', 'j1')).toEqual([]);
  expect(circles('j1', 'j0', 'j1')).toEqual(['robot.joints.0.controller.coupledTo']);
  expect(circles('j2', 'j2', 'j3', 'j1')).toEqual(['robot.joints.1.controller.coupledTo']);
  expect(circles('j0', 'j2', 'j1')).toEqual([
    'robot.joints.0.controller.coupledTo',
    'robot.joints.1.controller.coupledTo',
  ]);
  expect(faults({ 'robot.joints': coupled('j1', 'j0'), posture: [0, 0] })[0][2]).toBe(
    'The controllers of joints "j0", "j1" are coupled in a circle; expected a coupling that ends.',
  );
});

test.for([
  [
    { posture: [181, 0] },
    'posture-outside-limits',
    'posture',
    'The present posture has 181 for joint "joint_1", outside its limits, -180 to 180.',
  ],
  [
    { postures: [{ id: 'p1', q: [0, -200] }] },
    'posture-outside-limits',
    'postures.0.q',
    'Posture "p1" has -200 for joint "joint_2", outside its limits, -180 to 180.',
  ],
  [
    { 'robot.joints.0.home': 200 },
    'home-outside-limits',
    'robot.joints.0.home',
    'Joint "joint_1" has its home value 200 outside its limits, -180 to 180.',
  ],
  [
    { 'robot.joints.0.home': -200, 'robot.joints.0.upper': undefined },
    'home-outside-limits',
    'robot.joints.0.home',
    'Joint "joint_1" has its home value -200 outside its limits, -180 to ∞.',
  ],
  [
    { 'robot.joints.0.lower': 30, 'robot.joints.0.upper': 30 },
    'joint-locked',
    'robot.joints.0.lower',
    'Joint "joint_1" has equal limits, 30, so it cannot move.',
  ],
  [
    { 'robot.joints.0.type': 'continuous', posture: [999, 0] },
    'limits-unused',
    'robot.joints.0.lower',
    'Joint "joint_1" is continuous, so its limits are not used.',
  ],
  [
    { 'robot.joints.0.type': 'prismatic', 'robot.joints.1.controller': { sign: 1, offset: 0, coupling: -1, coupledTo: 'joint_1' } }, // prettier-ignore
    'coupling-kinds',
    'robot.joints.1.controller.coupledTo',
    'Joint "joint_2" turns and is coupled to "joint_1", which slides: an angle and a length have no sum, so its pendant number means nothing.',
  ],
  [
    { 'robot.joints.0.a': 0, 'robot.joints.1.a': 0 },
    'no-extent',
    'robot.joints',
    'All link lengths and offsets of the robot are 0, so all its joints are in one place.',
  ],
  [
    { 'robot.joints.0.a': 1, 'robot.joints.1.a': -2 },
    'very-small',
    'robot.units.length',
    'All links of the robot together are 0.003 m long, so its length unit "mm" may be wrong.',
  ],
  [
    { 'robot.joints.0.d': -1e9, 'robot.units.length': 'm' },
    'very-large',
    'robot.units.length',
    'A link of the robot is 1000000000 m long, so its length unit "m" may be wrong, and positions are not exact to a nanometre.',
  ],
])('what is allowed and seldom meant is remarked: %#', ([changes, code, path, message]) => {
  expect(remarks(/** @type {Record<string, unknown>} */ (changes))).toEqual([[code, path, message]]);
  expect(validateDocument(changed(/** @type {Record<string, unknown>} */ (changes)))).toEqual([]);
});

test('nothing is remarked of what real arms have', () => {
  expect(remarks({ 'robot.joints.0.d': 574_241.384, 'robot.joints.1.d': -56_000_000 })).toEqual([]); // UR5 as calibrated; Kinova Gen3
  expect(remarks({ 'robot.joints.0.lower': undefined, 'robot.joints.0.upper': undefined, posture: [1e6, 0] })).toEqual(
    [],
  );
  const gantry = {
    'robot.joints.0.a': 0,
    'robot.joints.1.a': 0,
    'robot.joints.0.type': 'prismatic',
    'robot.joints.1.type': 'prismatic',
  };
  expect(remarks(gantry)).toEqual([]); // it is as long as it travels
  const screw = { sign: 1, offset: 0, coupling: 0.5, coupledTo: 'joint_2' };
  expect(remarks({ ...gantry, 'robot.joints.0.controller': screw })).toEqual([]); // both slide
  const endless = { 'robot.joints.1.type': 'continuous', 'robot.joints.1.lower': undefined, 'robot.joints.1.upper': undefined }; // prettier-ignore
  expect(remarks({ ...endless, 'robot.joints.0.controller': screw })).toEqual([]); // both turn
});

test('every issue is of a kind that is listed, with the severity listed there', () => {
  for (const issue of [
    ...validateDocument(changed({ posture: [] })),
    ...reviewDocument(changed({ posture: [999, 0] })),
  ]) {
    expect(Object.entries(DOCUMENT_ISSUES)).toContainEqual([issue.code, issue.severity]);
  }
});

test('text is shown short, on one line, with nothing hidden', () => {
  expect(shownText('12,5 mm <b> é😀')).toBe('12,5 mm <b> é😀');
  expect(shownText('a\tb\u202Ec\u200Bd\u2028e\u00A0f\uD800\0')).toBe(
    'a\\u{9}b\\u{202E}c\\u{200B}d\\u{2028}e\\u{A0}f\\u{D800}\\u{0}',
  );
  expect(shownText('x'.repeat(80))).toBe('x'.repeat(80));
  expect(shownText('x'.repeat(81))).toBe(`${'x'.repeat(79)}…`);
  fc.assert(
    fc.property(fc.string({ unit: 'binary', maxLength: 400 }), (text) => {
      const shown = shownText(text);
      expect(shown.length).toBeLessThanOrEqual(80);
      expect(shown).toMatch(/^[^\p{Cc}\p{Cf}\p{Cs}\p{Zl}\p{Zp}]*$/u);
    }),
    { seed: SEED, numRuns: runs(200) },
  );
});
