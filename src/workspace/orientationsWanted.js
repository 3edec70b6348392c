/**
 * Orientations to ask inverse kinematics for. Of a cone: its middle and two rings, each with some turns about the tool's own z,
 * which is approximate: a place that is reached only between them is not found.
 *
 * @import { Vector } from '../kinematics/lines.js'
 *
 * @typedef {{ kind: 'any' } | { kind: 'fixed', T: ArrayLike<number> } | { kind: 'cone', T: ArrayLike<number>, halfAngle: number }} Wanted
 *   T: a pose whose rotation is wanted; of a cone its z axis is the middle, and any turn about that will do
 */
import { cross, product, turn, unit } from '../kinematics/lines.js';

const AROUND = 8;
const ROLLS = 4;

/** @param {Exclude<Wanted, { kind: 'any' }>} wanted @returns {Float64Array[]} poses at the origin */
export function orientationsWanted(wanted) {
  const { T } = wanted;
  const R = [T[0], T[1], T[2], T[4], T[5], T[6], T[8], T[9], T[10]];
  const pose = (/** @type {readonly number[]} */ M) =>
    Float64Array.of(M[0], M[1], M[2], 0, M[3], M[4], M[5], 0, M[6], M[7], M[8], 0, 0, 0, 0, 1);
  if (wanted.kind === 'fixed') return [pose(R)];
  /** @type {Vector} */
  const axis = [R[6], R[7], R[8]];
  /** @type {Vector} */
  const side = [R[0], R[1], R[2]];
  const tilts = [turn(axis, 0)];
  for (const share of [1, 0.5]) {
    for (let k = 0; k < AROUND; k++) {
      const about = cross(
        axis,
        product(turn(axis, (2 * Math.PI * k) / AROUND), [...side, 0, 0, 0, 0, 0, 0]).slice(0, 3),
      );
      tilts.push(turn(unit(about), share * wanted.halfAngle));
    }
  }
  const rolls = Array.from({ length: ROLLS }, (_, k) => turn([0, 0, 1], (2 * Math.PI * k) / ROLLS));
  return tilts.flatMap((tilt) => rolls.map((roll) => pose(product(product(tilt, R), roll))));
}
