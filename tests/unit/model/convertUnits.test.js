/** Other units, the same robot: nothing is relabelled, nothing gathers dirt, and the way back gives the same numbers. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { readRobotXml, writeRobotXml } from '../../../src/io/robotXml.js';
import { applyCommand } from '../../../src/model/commands.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { refusal } from '../../../src/model/refusals.js';
import { reduce, startState } from '../../../src/model/session.js';
import { commonAngle, convertAngle, convertLength, toRadians } from '../../../src/model/units.js';
import { validateDocument } from '../../../src/model/validate.js';
import { SEED, runs } from '../../helpers/property.js';
import { documents } from '../io/documents.js';

/** @typedef {import('../../../src/model/document.js').Doc} Doc */
/** @typedef {import('../../../src/model/document.js').Units} Units */

/** A number as a person types it, of up to 12 digits. */
const typed = fc
  .tuple(fc.integer({ min: -999_999_999_999, max: 999_999_999_999 }), fc.integer({ min: 0, max: 12 }))
  .map(([digits, decimals]) => Number(`${digits}e${-decimals}`));
const lengthUnit = fc.constantFrom(
  /** @type {const} */ ('mm'),
  /** @type {const} */ ('cm'),
  /** @type {const} */ ('m'),
);

/** By the bits, not by a formula: how many doubles lie between two of one sign. @param {number} a @param {number} b */
function doublesBetween(a, b) {
  const [x, y] = new BigInt64Array(Float64Array.of(a, b).buffer);
  return Number(x > y ? x - y : y - x);
}

test('lengths are shifted by decimals, there and back to the same number', () => {
  expect(convertLength(671.83, 'mm', 'cm')).toBe(67.183);
  expect(convertLength(20.3, 'mm', 'm')).toBe(0.0203);
  expect(convertLength(1e-7, 'm', 'mm')).toBe(1e-4);
  expect(convertLength(2.5e21, 'mm', 'm')).toBe(2.5e18);
  expect(Object.is(convertLength(-0, 'mm', 'm'), -0)).toBe(true);
  fc.assert(
    fc.property(typed, lengthUnit, lengthUnit, (value, from, to) => {
      expect(convertLength(convertLength(value, from, to), to, from)).toBe(value);
    }),
    { seed: SEED, numRuns: runs(1000) },
  );
});

describe('angles', () => {
  test('come back as the same number, either way round, and are the same radians to one unit in the last place', () => {
    fc.assert(
      fc.property(typed, (value) => {
        const radians = convertAngle(value, 'deg', 'rad');
        expect(doublesBetween(radians, toRadians(value))).toBeLessThanOrEqual(1);
        expect(convertAngle(radians, 'rad', 'deg')).toBe(value);
        const degrees = convertAngle(value, 'rad', 'deg');
        expect(doublesBetween(toRadians(degrees), value)).toBeLessThanOrEqual(1);
        expect(convertAngle(degrees, 'deg', 'rad')).toBe(value);
      }),
      { seed: SEED, numRuns: runs(1000) },
    );
  });

  test('that are common are fractions of π, exactly', () => {
    expect(commonAngle(180)).toEqual({ text: 'pi', value: Math.PI });
    expect(commonAngle(-135)).toEqual({ text: '-3*pi/4', value: (-3 * Math.PI) / 4 });
    expect(commonAngle(22.5)).toEqual({ text: 'pi/8', value: Math.PI / 8 });
    expect([0, 1, 89.999, 1e9, NaN, Infinity].map(commonAngle)).toEqual([null, null, null, null, null, null]);
    for (let degrees = -720; degrees <= 720; degrees += 7.5) {
      const radians = convertAngle(degrees, 'deg', 'rad');
      expect(convertAngle(radians, 'rad', 'deg')).toBe(degrees);
      if (degrees !== 0) expect(doublesBetween(radians, toRadians(degrees))).toBeLessThanOrEqual(1);
    }
  });
});

/** One of everything that has a number. @type {Doc} */
const everything = {
  robot: {
    ...{ name: 'test', info: {}, units: { length: 'mm', angle: 'deg' }, convention: 'standard' },
    base: { xyz: [1, 2, 3], rpy: [90, 0, -45] },
    tool: { xyz: [0, 0, 12.5], quaternion: [0, 0, 0.6, 0.8] },
    joints: [
      {
        ...{ id: 'a', type: 'revolute', theta: 12, d: 671.83, a: 431.8, alpha: -90 },
        ...{ lower: -160, upper: 160, home: 45, velocity: 90, acceleration: 180, jerk: 360, effort: 7 },
        text: { d: '671.83 mm', a: '400+31.8', theta: '12°' },
        link: { kind: 'cylinder', radius: 60, width: 61, height: 62, color: '#ffcc00' },
        controller: { sign: -1, offset: 30, coupling: 0 },
      },
      {
        ...{ id: 'b', type: 'prismatic', theta: 30, d: 0, a: 0, alpha: 0 },
        ...{ lower: 0, upper: 210, home: 80, velocity: 100, acceleration: 200, jerk: 300, effort: 8 },
        link: { kind: 'auto' },
        controller: { sign: 1, offset: 5, coupledTo: 'a', coupling: -1 },
      },
    ],
  },
  posture: [60, 100],
  postures: [{ id: 'p1', q: [-180, 33.3] }],
  frames: [{ kind: 'user', id: 'u', number: 3, xyz: [100, 0, 0], rpy: [0, 0, 180] }],
  targets: [{ id: 'aim', xyz: [500, 0, 25.4], rpy: [180, 0, -45], configuration: 'N U T, 0, 0, 0' }],
  obstacles: [
    { kind: 'box', id: 'table', xyz: [1000, 0, 500], rpy: [0, 0, 90], width: 800, depth: 600, height: 20 },
    { kind: 'cylinder', id: 'post', xyz: [0, 700, 0], radius: 50, height: 1200 },
    { kind: 'plane', id: 'floor', xyz: [0, 0, -10], quaternion: [0, 0, 0, 1] },
  ],
  motionPrograms: [
    {
      ...{ id: 'm', name: 'M' },
      steps: [
        {
          ...{ id: 's1', kind: 'joint', target: { kind: 'posture', values: [90, 50] }, speed: 50, speedUnit: '%' },
          ...{ acceleration: 100, ending: { kind: 'percent', value: 20 } },
        },
        {
          ...{ id: 's2', kind: 'circular', via: { kind: 'target', id: 'aim' }, speed: 250, speedUnit: 'length/s' },
          target: { kind: 'pose', xyz: [400, 0, 5], rpy: [0, 0, 180], configuration: 'N U T' },
          ...{ acceleration: 80, ending: { kind: 'distance', value: 10 }, frame: 'u' },
        },
        {
          ...{ id: 's3', kind: 'linear', target: { kind: 'target', id: 'aim' }, speed: 45, speedUnit: 'angle/s' },
          ...{ acceleration: 80, ending: { kind: 'fine' } },
        },
        { id: 's4', kind: 'wait', seconds: 2 },
      ],
    },
  ],
  programs: [{ id: 'k', language: 'karel', text: 'x = 100' }],
  extensions: [],
};
const inMetres = () => applyCommand(everything, { type: 'convert-units', units: { length: 'm', angle: 'rad' } });

test('every number of the document converts, and what has no unit does not', () => {
  const { PI } = Math;
  const { steps } = everything.motionPrograms[0];
  const radians = 0.2094395102393196; // one digit less than 12 * (PI / 180), one unit in the last place from it
  expect(inMetres()).toEqual({
    ...everything,
    robot: {
      ...everything.robot,
      units: { length: 'm', angle: 'rad' },
      base: { xyz: [0.001, 0.002, 0.003], rpy: [PI / 2, 0, -PI / 4] },
      tool: { xyz: [0, 0, 0.0125], quaternion: [0, 0, 0.6, 0.8] },
      joints: [
        {
          ...{ id: 'a', type: 'revolute', theta: radians, d: 0.67183, a: 0.4318, alpha: -PI / 2 },
          ...{ lower: toRadians(-160), upper: toRadians(160), home: PI / 4, velocity: PI / 2, acceleration: PI },
          ...{ jerk: 2 * PI, effort: 7, text: { theta: '12°', d: '671.83 mm', alpha: '-pi/2' } },
          link: { kind: 'cylinder', radius: 0.06, width: 0.061, height: 0.062, color: '#ffcc00' },
          controller: { sign: -1, offset: PI / 6, coupling: 0 },
        },
        {
          ...{ id: 'b', type: 'prismatic', theta: PI / 6, d: 0, a: 0, alpha: 0, text: { theta: 'pi/6' } },
          ...{ lower: 0, upper: 0.21, home: 0.08, velocity: 0.1, acceleration: 0.2, jerk: 0.3, effort: 8 },
          link: { kind: 'auto' },
          controller: { sign: 1, offset: 0.005, coupledTo: 'a', coupling: -1 },
        },
      ],
    },
    posture: [PI / 3, 0.1],
    postures: [{ id: 'p1', q: [-PI, 0.0333] }],
    frames: [{ kind: 'user', id: 'u', number: 3, xyz: [0.1, 0, 0], rpy: [0, 0, PI] }],
    targets: [{ id: 'aim', xyz: [0.5, 0, 0.0254], rpy: [PI, 0, -PI / 4], configuration: 'N U T, 0, 0, 0' }],
    obstacles: [
      { kind: 'box', id: 'table', xyz: [1, 0, 0.5], rpy: [0, 0, PI / 2], width: 0.8, depth: 0.6, height: 0.02 },
      { kind: 'cylinder', id: 'post', xyz: [0, 0.7, 0], radius: 0.05, height: 1.2 },
      { kind: 'plane', id: 'floor', xyz: [0, 0, -0.01], quaternion: [0, 0, 0, 1] },
    ],
    motionPrograms: [
      {
        ...{ id: 'm', name: 'M' },
        steps: [
          { ...steps[0], target: { kind: 'posture', values: [PI / 2, 0.05] } },
          {
            ...{ ...steps[1], speed: 0.25, ending: { kind: 'distance', value: 0.01 } },
            target: { kind: 'pose', xyz: [0.4, 0, 0.005], rpy: [0, 0, PI], configuration: 'N U T' },
          },
          { ...steps[2], speed: PI / 4 },
          steps[3],
        ],
      },
    ],
  });
});

test('there and back gives the same numbers; an expression without a unit is then its number', () => {
  const back = applyCommand(inMetres(), { type: 'convert-units', units: { length: 'mm', angle: 'deg' } });
  const [first, second] = everything.robot.joints;
  const text = { theta: '12°', d: '671.83 mm' };
  expect(back).toEqual({ ...everything, robot: { ...everything.robot, joints: [{ ...first, text }, second] } });
});

test('an expression in a column whose unit stays is left alone', () => {
  const { robot } = applyCommand(everything, { type: 'convert-units', units: { length: 'mm', angle: 'rad' } });
  expect(robot.joints[0].text).toEqual({ theta: '12°', d: '671.83 mm', a: '400+31.8', alpha: '-pi/2' });
});

test('the compiled arm and postures are the same but for three roundings; undo brings the same object back', () => {
  const anyUnits = fc.record({
    length: lengthUnit,
    angle: fc.constantFrom(/** @type {const} */ ('deg'), /** @type {const} */ ('rad')),
  });
  /** @type {import('fast-check').Arbitrary<Doc>} */
  const anyArm = fc.array(typed, { minLength: 12, maxLength: 12 }).map((numbers) => {
    const [theta, d, a, alpha, ...more] = numbers.map((value) => value % 1e5);
    const [first, second] = everything.robot.joints;
    const [lower, upper] = more.slice(0, 2).sort((x, y) => x - y);
    const joints = [
      { ...first, theta, d, a, alpha, lower, upper },
      { ...second, theta: more[2], d: more[3], a: more[4] },
    ];
    return { ...everything, robot: { ...everything.robot, joints }, posture: more.slice(5, 7) };
  });
  let converted = 0;
  fc.assert(
    fc.property(fc.oneof(documents, anyArm), anyUnits, (doc, units) => {
      if (refusal(doc, { type: 'convert-units', units })) return;
      const before = startState(doc);
      const after = reduce(before, { type: 'convert-units', units });
      if (after === before) return;
      converted++;
      expect(validateDocument(after.doc)).toEqual([]);
      expect(reduce(after, { type: 'undo' }).doc).toBe(doc);
      const [old, now] = [doc, after.doc].map(({ robot, posture }) => [
        ...compileRobot(robot).joints.flatMap(({ theta, d, a, alpha, lower, upper }) => [
          theta,
          d,
          a,
          alpha,
          lower,
          upper,
        ]),
        ...compilePosture(robot, posture),
      ]);
      old.forEach((value, i) => {
        if (value === 0 || !Number.isFinite(value)) expect(now[i]).toBe(value);
        else expect(doublesBetween(now[i], value)).toBeLessThanOrEqual(2);
      });
    }),
    { seed: SEED, numRuns: runs(200) },
  );
  expect(converted).toBeGreaterThan(30);
});

test('a converted document saves and opens', () => {
  for (const length of /** @type {const} */ (['mm', 'cm', 'm'])) {
    const doc = applyCommand(everything, { type: 'convert-units', units: { length, angle: 'rad' } });
    const { doc: opened, issues } = readRobotXml(writeRobotXml(doc));
    expect(issues.filter(({ severity }) => severity === 'error')).toEqual([]);
    expect(opened).toEqual(doc);
  }
});

test('limits that are neighbours in binary do not cross', () => {
  const [first, second] = everything.robot.joints;
  for (let lower = 7.5; lower <= 720; lower += 7.5) {
    const upper = lower + lower * 0.75 * Number.EPSILON;
    expect(upper).toBeGreaterThan(lower);
    const narrow = { ...everything, robot: { ...everything.robot, joints: [{ ...first, lower, upper }, second] } };
    const now = applyCommand(narrow, { type: 'convert-units', units: { length: 'm', angle: 'rad' } });
    expect(validateDocument(now)).toEqual([]);
  }
});

test('what no document can hold is refused, and what is no unit', () => {
  const reason = (/** @type {unknown} */ units, doc = everything) =>
    refusal(doc, { type: 'convert-units', units: /** @type {Units} */ (units) })?.message;
  const large = { ...everything, robot: { ...everything.robot, units: { length: 'm', angle: 'deg' } } };
  const far = /** @type {Doc} */ ({ ...large, posture: [0, 1e7] });
  expect(reason({ length: 'mm', angle: 'deg' }, far)).toBe('In mm, a number of this robot would be beyond 10⁹.');
  expect(reason({ length: 'cm', angle: 'deg' }, far)).toBeUndefined();
  expect(reason({ length: 'in', angle: 'deg' })).toBe('Expected m or cm or mm as the unit of length, got "in".');
  expect(reason({ length: 'm' })).toBe('Expected deg or rad as the unit of angle, got undefined.');
  expect(reason(null)).toBe('Expected a unit of length and one of angle, got null.');
});
