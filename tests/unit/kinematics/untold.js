/**
 * Whether a pose tells two postures apart, by the matrices of oracle.js: what is asked of lists next to singularities, where
 * a pose that is rounded to 1e-16 leaves a posture fewer digits than it has.
 *
 * A motion that is lost changes the pose by the square of what the joints turn, κδ²/2. Where the square is below the rounding
 * of the pose, both ends and all that is between them meet it to the last digit, and no solver can know which of them was
 * meant: with κ and the lengths of order 1, δ up to 1e-7 or so. Where two motions are lost at once what is between may be a
 * long way: a wrist that is bent by 1e-8 is in line as well, and then its outer axes turn freely.
 *
 * @import { ChainDescription } from '../../../src/kinematics/chain.js'
 * @import { Matrix } from './oracle.js'
 */
import { angleBetween, distanceBetween, oracleForward } from './oracle.js';
import { differenceOf, solve } from './searchAll.js';

/** Metres and radians: what rounding leaves of a pose that is met, docs/model.md, section 10. */
const LAST_DIGIT = 2e-14;

/** The way is looked at in steps no longer than this (radians, metres), and at least in this many. */
const STEP = 0.05;
const LEAST_STEPS = 4;

/** Squares of what the joints do to the pose that are smaller are of motions that are lost. */
const LOST = 1e-10;
const PULLS = 6;

/** Rounding pulls a posture this far, at the most: 1e-16 over the root of `LOST`, and some. */
const PULLED_BY_ROUNDING = 1e-10;

/** @param {Matrix} A @param {Matrix} B */
const missBetween = (A, B) => Math.max(distanceBetween(A, B), angleBetween(A, B));

/** The small twist from A to B. @param {Matrix} A @param {Matrix} B */
function twistBetween(A, B) {
  const spin = (/** @type {number} */ r, /** @type {number} */ c) =>
    [0, 1, 2].reduce((sum, k) => sum + (B[r][k] - A[r][k]) * A[c][k], 0);
  return [B[0][3] - A[0][3], B[1][3] - A[1][3], B[2][3] - A[2][3], spin(2, 1), spin(0, 2), spin(1, 0)];
}

/** The nearest posture that meets the goal, by the motions that are not lost. @param {ChainDescription} description @param {Matrix} goal @param {number[]} from */
function pulled(description, goal, from) {
  let q = from;
  for (let k = 0; k < PULLS; k++) {
    const J = differenceOf(description, q);
    const square = J.map((a, i) => J.map((b, j) => a.reduce((sum, v, n) => sum + v * b[n], i === j ? LOST : 0)));
    const force = solve(square, twistBetween(oracleForward(description, q).tcp, goal));
    q = q.map((value, n) => value + force.reduce((sum, part, i) => sum + part * J[i][n], 0));
  }
  return q;
}

/**
 * @param {ChainDescription} description
 * @param {number[]} q         whose pose is meant
 * @param {ArrayLike<number>} other
 * @returns {boolean} whether there is a way between them, near the straight one, on which the pose is kept to the last digit
 */
export function isUntold(description, q, other) {
  const goal = oracleForward(description, q).tcp;
  const way = description.joints.map(({ type }, i) => {
    const along = other[i] - q[i];
    return type === 'prismatic' ? along : Math.atan2(Math.sin(along), Math.cos(along));
  });
  const longest = Math.max(...way.map(Math.abs));
  const steps = Math.max(LEAST_STEPS, Math.ceil(longest / STEP));
  return Array.from({ length: steps }, (_, k) => (k + 1) / steps).every((share) => {
    const straight = q.map((value, i) => value + share * way[i]);
    const there = share < 1 ? pulled(description, goal, straight) : straight;
    // half a step aside at the most, or it may have gone to one end, or to yet another solution
    const isOnTheWay = there.every(
      (value, i) => Math.abs(value - straight[i]) <= longest / steps / 2 + PULLED_BY_ROUNDING,
    );
    return isOnTheWay && missBetween(oracleForward(description, there).tcp, goal) < LAST_DIGIT;
  });
}
