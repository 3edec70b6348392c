/** An obstacle that was dragged: typed numbers stay where the hand did nothing, and the others are those of a hand. */
import { expect, test } from 'vitest';
import { compilePose } from '../../../src/model/compile.js';
import { obstacleMoved } from '../../../src/model/workcell/obstacleMoved.js';

/** @import { ObstacleDoc } from '../../../src/model/document.js' */

const MM = /** @type {const} */ ({ length: 'mm', angle: 'deg' });
const STEP = { metres: 0.01, radians: Math.PI / 36 };
/** @type {ObstacleDoc} */
const BALL = { kind: 'sphere', id: 'ball', xyz: [100.123456, 1 / 3, 7], rpy: [0.1, 12.3456789, 0], radius: 5 };

/** @param {readonly number[]} by  m @param {ObstacleDoc} [obstacle] */
function shifted(by, obstacle = BALL) {
  const T = compilePose(obstacle, MM);
  by.forEach((value, k) => (T[12 + k] += value));
  return T;
}

test('along an axis, one number changes, to the finest that a hand has; the turn stays as it was typed', () => {
  const moved = obstacleMoved(BALL, shifted([0, 0, 0.0123456]), MM, STEP);
  expect(moved).toEqual({ ...BALL, xyz: [100.123456, 1 / 3, 19.3] });
  expect(obstacleMoved(BALL, shifted([0, 0, 0]), MM, STEP)).toEqual(BALL);
  const inMetres = { ...BALL, xyz: [1, 2, 3] };
  const units = /** @type {const} */ ({ length: 'm', angle: 'rad' });
  const T = compilePose(inMetres, units);
  T[12] += 0.01234;
  expect(obstacleMoved(inMetres, T, units, STEP).xyz).toEqual([1.0123, 2, 3]);
});

test('turned, it has roll, pitch and yaw to a tenth of a degree, whatever it had', () => {
  const T = compilePose({ xyz: BALL.xyz, rpy: [0, 0, 30.04] }, MM);
  expect(obstacleMoved(BALL, T, MM, STEP)).toMatchObject({ xyz: BALL.xyz, rpy: [0, 0, 30] });
  /** @type {ObstacleDoc} */
  const quaternion = { kind: 'sphere', id: 'ball', xyz: BALL.xyz, quaternion: [0, 0, 0, 1], radius: 5 };
  expect(obstacleMoved(quaternion, shifted([0.01, 0, 0], quaternion), MM, STEP)).toMatchObject({
    quaternion: [0, 0, 0, 1],
  });
  expect(obstacleMoved(quaternion, T, MM, STEP)).toMatchObject({ quaternion: undefined, rpy: [0, 0, 30] });
});
