/** Each form's numbers, put together again by its own formula, are the orientation; the matrices are made here. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { ORIENTATION_FORMS, orientationForm, usersOf } from '../../../src/model/numbers/orientationForms.js';
import { SEED, runs } from '../../helpers/property.js';

/** @template T @param {import('fast-check').Arbitrary<T>} any @param {(value: T) => void} holds */
const property = (any, holds) => fc.assert(fc.property(any, holds), { seed: SEED, numRuns: runs(100) });

const DEG = /** @type {const} */ ({ length: 'mm', angle: 'deg' });

/** @param {number[][]} A @param {number[][]} B */
const times = (A, B) => A.map((row) => B[0].map((_, j) => row.reduce((sum, value, k) => sum + value * B[k][j], 0)));

/** @type {Record<string, (c: number, s: number) => number[][]>} */
const ABOUT = {
  x: (c, s) => [
    [1, 0, 0],
    [0, c, -s],
    [0, s, c],
  ],
  y: (c, s) => [
    [c, 0, s],
    [0, 1, 0],
    [-s, 0, c],
  ],
  z: (c, s) => [
    [c, -s, 0],
    [s, c, 0],
    [0, 0, 1],
  ],
};
/** @param {string} axis @param {number} degrees */
const turn = (axis, degrees) => ABOUT[axis](Math.cos((degrees / 180) * Math.PI), Math.sin((degrees / 180) * Math.PI));

/** v → R·v with R = exp(angle · [axis]×) @param {number[]} axis @param {number} degrees */
function rodrigues([x, y, z], degrees) {
  const K = [
    [0, -z, y],
    [z, 0, -x],
    [-y, x, 0],
  ];
  const [s, v] = [Math.sin((degrees / 180) * Math.PI), 1 - Math.cos((degrees / 180) * Math.PI)];
  const K2 = times(K, K);
  return K.map((row, i) => row.map((value, j) => (i === j ? 1 : 0) + s * value + v * K2[i][j]));
}

/** What a form's own words make of its numbers. @param {import('../../../src/model/numbers/orientationNumbers.js').OrientationForm} form @param {readonly number[]} values */
function rotationBy({ id, product, labels }, values) {
  const byName = Object.fromEntries(labels.map((label, k) => [label, values[k]]));
  if (product)
    return [...product.matchAll(/R([xyz])\((\S+?)\)/g)]
      .map(([, axis, label]) => turn(axis, byName[label]))
      .reduce(times);
  const { x, y, z, w, angle, rx, ry, rz } = byName;
  if (id === 'rotation-vector') {
    const degrees = Math.hypot(rx, ry, rz);
    return rodrigues(degrees === 0 ? [0, 0, 1] : [rx / degrees, ry / degrees, rz / degrees], degrees);
  }
  if (id === 'axis-angle') return rodrigues([x, y, z], angle);
  const sine = Math.hypot(x, y, z);
  const degrees = (2 * Math.atan2(sine, w) * 180) / Math.PI;
  return rodrigues(sine === 0 ? [0, 0, 1] : [x / sine, y / sine, z / sine], degrees);
}

/** @param {number[][]} R */
const poseOf = (R) =>
  Float64Array.from({ length: 16 }, (_, k) => (k % 4 < 3 && k < 12 ? R[k % 4][k >> 2] : +(k === 15)));

/** @param {Float64Array} T */
const rowsOf3 = (T) => [0, 1, 2].map((i) => [0, 1, 2].map((j) => T[4 * j + i]));

const anyAngle = fc.oneof(fc.double({ min: -360, max: 360, noNaN: true }), fc.constantFrom(0, 90, -90, 180, 45));
const anyRotation = fc
  .tuple(anyAngle, anyAngle, anyAngle)
  .map(([a, b, c]) => [turn('z', a), turn('y', b), turn('x', c)].reduce(times));

/** @param {number[][]} A @param {number[][]} B */
const apart = (A, B) => Math.max(...A.flatMap((row, i) => row.map((value, j) => Math.abs(value - B[i][j]))));

describe.each(ORIENTATION_FORMS.map((form) => [form.name, form]))('%s', (_, form) => {
  test('gives the orientation again by its own formula', () =>
    property(anyRotation, (R) => {
      const { values } = form.read(poseOf(R), DEG);
      expect(values).toHaveLength(form.labels.length);
      expect(form.quantities).toHaveLength(form.labels.length);
      expect(apart(rotationBy(form, values), R)).toBeLessThan(2e-7 ** (form.group === 'other' ? 1 : 2));
    }));

  test('takes its numbers back as its own formula does', () =>
    property(anyRotation, (R) => {
      const { values } = form.read(poseOf(R), DEG);
      const { T } = form.write(values, DEG);
      expect(T && apart(rowsOf3(T), rotationBy(form, values))).toBeLessThan(1e-12);
    }));
});

test('all 24 sequences are there, and those that go by a name stand first', () => {
  const by = (/** @type {string} */ group) => ORIENTATION_FORMS.filter((form) => form.group === group);
  expect(by('moving').map(({ sequence }) => sequence?.toLowerCase())).toEqual(
    by('fixed').map(({ sequence }) => sequence),
  );
  expect(new Set([...by('moving'), ...by('fixed')].map(({ sequence }) => sequence)).size).toBe(24);
  expect(ORIENTATION_FORMS.slice(0, 5).map(({ name }) => name)).toEqual([
    'FANUC WPR',
    'KUKA ABC',
    'URDF rpy',
    'Roll-pitch-yaw',
    'ZYZ',
  ]);
  expect(new Set(ORIENTATION_FORMS.map(({ id }) => id)).size).toBe(ORIENTATION_FORMS.length);
  expect(new Set(ORIENTATION_FORMS.map(({ name }) => name)).size).toBe(ORIENTATION_FORMS.length);
});

test('KUKA writes what FANUC writes the other way round', () => {
  const T = poseOf([turn('z', 10), turn('y', 20), turn('x', 30)].reduce(times));
  const [wpr, abc] = ['wpr', 'abc'].map((id) => orientationForm(id).read(T, DEG).values);
  [30, 20, 10].forEach((value, k) => expect(wpr[k]).toBeCloseTo(value, 12));
  expect(abc).toEqual(wpr.toReversed());
});

test('at gimbal lock the angle that is set to zero is the one that the form says', () => {
  const across = poseOf(turn('y', 90).map((row) => row.map(Math.round)));
  for (const [id, free] of /** @type {const} */ ([
    ['wpr', 'R'],
    ['abc', 'A'],
    ['roll-pitch-yaw', 'yaw'],
  ])) {
    const form = orientationForm(id);
    const { freedom, setToZero, values } = form.read(across, DEG);
    expect(freedom).toBe('locked');
    expect(form.labels[setToZero ?? -1]).toBe(free);
    expect(values[setToZero ?? -1]).toBe(0);
  }
  const { freedom, setToZero } = orientationForm('zyz-euler').read(poseOf(turn('z', 30)), DEG);
  expect([freedom, setToZero]).toEqual(['locked', 0]);
  expect(orientationForm('zyz-euler').read(across, DEG).freedom).toBeNull();
});

test('an axis that might as well be another is said to be', () => {
  const form = orientationForm('axis-angle');
  expect(form.read(poseOf(turn('x', 0)), DEG).freedom).toBe('noTurn');
  expect(form.read(poseOf(turn('x', 180).map((row) => row.map(Math.round))), DEG).freedom).toBe('halfTurn');
  expect(form.read(poseOf(turn('x', 20)), DEG).freedom).toBeNull();
});

test('who else writes a sequence is known by name', () => {
  expect(usersOf(orientationForm('zyz-euler'))).toContain('Kawasaki O A T');
  expect(usersOf(orientationForm('wpr'))).not.toContain('FANUC W P R');
  expect(usersOf(orientationForm('xyzw'))).toEqual([]);
});

test('a quaternion or an axis that is not of length 1 is refused, with its length and what it would be', () => {
  for (const [id, values, length, mended] of /** @type {const} */ ([
    ['xyzw', [0, 0, 3, 4], 5, [0, 0, 0.6, 0.8]],
    ['wxyz', [0, 0, 3, 4], 5, [0, 0, 0.6, 0.8]],
    ['axis-angle', [0, 3, 4, 90], 5, [0, 0.6, 0.8, 90]],
  ])) {
    const { T, fault } = orientationForm(id).write(values, DEG);
    expect(T).toBeNull();
    expect([fault?.length, fault?.mended]).toEqual([length, mended]);
    expect(orientationForm(id).write(mended, DEG).fault).toBeNull();
  }
  expect(orientationForm('xyzw').write([0, 0, 0, 0], DEG).fault).toEqual({ of: 'quaternion', length: 0, mended: null });
  expect(orientationForm('xyzw').write([0, 0, 0.70711, 0.70711], DEG).fault?.length).toBeCloseTo(1.0000046, 6);
});

test('the scalar of a quaternion stands where the form says', () => {
  const [last, first] = [
    orientationForm('xyzw').write([0, 0, Math.SQRT1_2, Math.SQRT1_2], DEG).T,
    orientationForm('wxyz').write([Math.SQRT1_2, 0, 0, Math.SQRT1_2], DEG).T,
  ];
  expect(first).toEqual(last);
  expect(last && apart(rowsOf3(last), turn('z', 90))).toBeLessThan(1e-15);
});
