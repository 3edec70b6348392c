import { expect, test } from 'vitest';
import { poseFromXyzwpr } from '../../../src/model/aim/aim.js';
import { LIBRARY } from '../../../src/model/library.js';
import { lookingAt, pointInWorld, tidy, toolDown, turnedAs } from '../../../src/model/aim/targetHelpers.js';

const T = poseFromXyzwpr(LIBRARY.puma560, [400, -100, 700, 30, -50, 110]);
const column = (/** @type {Float64Array} */ M, /** @type {number} */ k) => [...M.subarray(4 * k, 4 * k + 3)];
const dot = (/** @type {number[]} */ a, /** @type {number[]} */ b) =>
  a.reduce((sum, value, i) => sum + value * b[i], 0);

/** Square, of length one, right-handed. @param {Float64Array} M */
function expectRigid(M) {
  const [x, y, z] = [0, 1, 2].map((k) => column(M, k));
  for (const [a, b, wanted] of /** @type {const} */ ([[x, x, 1], [y, y, 1], [z, z, 1], [x, y, 0], [y, z, 0], [z, x, 0]])) expect(dot([...a], [...b])).toBeCloseTo(wanted, 12); // prettier-ignore
  expect(x[0] * y[1] - x[1] * y[0]).toBeCloseTo(z[2], 12);
}

test('the tool down stays in its place, from any way and from straight up', () => {
  const up = poseFromXyzwpr(LIBRARY.puma560, [400, -100, 700, 0, 0, 30]);
  for (const from of [T, up, toolDown(T)]) {
    const down = toolDown(from);
    expectRigid(down);
    expect(column(down, 2)).toEqual([0, 0, -1]);
    expect(column(down, 3)).toEqual(column(from, 3));
  }
});

test('looking at a point puts it on the z axis; the point of the tool itself is refused', () => {
  const look = lookingAt(T, [0.4, 0.9, 0.2]);
  if (!look) throw new Error('Expected a pose.');
  expectRigid(look);
  const length = Math.hypot(1, -0.5);
  [0, 1 / length, -0.5 / length].forEach((value, i) => expect(look[8 + i]).toBeCloseTo(value, 12));
  expect(lookingAt(T, column(T, 3))).toBeNull();
});

test('turned as another pose keeps its place', () => {
  const mixed = turnedAs(T, toolDown(T));
  expect(column(mixed, 3)).toEqual(column(T, 3));
  expect(column(mixed, 2)).toEqual([0, 0, -1]);
});

test('a point of a user frame is looked at where it stands in the world', () => {
  // the frame stands at (400, −200, 50) mm, turned by a quarter about the vertical: its x is the world's y, its y the world's −x
  const T_world_user = poseFromXyzwpr(LIBRARY.puma560, [400, -200, 50, 0, 0, 90]);
  const point = pointInWorld(T_world_user, [0.3, 0.1, 0.02]);
  [0.3, 0.1, 0.07].forEach((value, k) => expect(point[k]).toBeCloseTo(value, 15));
  expect(pointInWorld(null, [0.3, 0.1, 0.02])).toEqual([0.3, 0.1, 0.02]);
  // and in a frame that is turned about all three axes, as its own columns say
  const sum = [0, 1, 2].map((k) => T[k] * 0.3 + T[4 + k] * 0.1 + T[8 + k] * 0.02 + T[12 + k]);
  pointInWorld(T, [0.3, 0.1, 0.02]).forEach((value, k) => expect(value).toBeCloseTo(sum[k], 15));
});

test('what rounding left of a right angle is not a number to read', () => {
  expect([-1.3e-13, 90.00000000000001, -0, 12.3456789].map(tidy)).toEqual([0, 90, 0, 12.3456789]);
});
