/**
 * An obstacle that a hand has moved: what the hand did not change keeps the number that was typed, and what it did is no finer
 * than a hand.
 *
 * @import { Doc, ObstacleDoc } from '../document.js'
 * @import { NewObstacle } from './obstacles.js'
 */
import { compilePose } from '../compile.js';
import { poseInUnits } from '../numbers/poseNumbers.js';
import { fromKernel } from '../units.js';

/** Metres, and the entries of a matrix: what differs by less was not moved. */
const UNMOVED = 1e-9;

/** Shares of a step that snaps: no hand is finer. */
const FINEST = { metres: 1 / 100, radians: 1 / 50 };

/** Digits of a number that is a whole count of steps. */
const DIGITS = 12;

/**
 * @param {ObstacleDoc} obstacle
 * @param {Float64Array} T    where it is wanted, seen from the world
 * @param {Doc['robot']['units']} units
 * @param {{ metres: number, radians: number }} step   of a drag that snaps
 * @returns {NewObstacle}
 */
export function obstacleMoved(obstacle, T, units, step) {
  const old = compilePose(obstacle, units);
  const wanted = poseInUnits(T, units);
  const even = (/** @type {number} */ value, /** @type {number} */ finest) =>
    Number((Math.round(value / finest) * finest).toPrecision(DIGITS)) + 0;
  const length = fromKernel('length', step.metres * FINEST.metres, units);
  const xyz = obstacle.xyz.map((value, k) =>
    Math.abs(T[12 + k] - old[12 + k]) < UNMOVED ? value : even(wanted.xyz[k], length),
  );
  const isTurned = [0, 1, 2, 4, 5, 6, 8, 9, 10].some((i) => Math.abs(T[i] - old[i]) > UNMOVED);
  if (!isTurned) return { ...obstacle, xyz };
  const angle = fromKernel('angle', step.radians * FINEST.radians, units);
  const rpy = (wanted.rpy ?? [0, 0, 0]).map((value) => even(value, angle));
  return /** @type {NewObstacle} */ ({ ...obstacle, xyz, rpy, quaternion: undefined });
}
