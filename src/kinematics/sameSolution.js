/**
 * Which of the postures that take a pose are one solution.
 *
 * Two are, if there is a way between them that leaves the pose no more than they do: then the pose does not tell them apart.
 * A posture that meets the pose to the last digit is a solution in its own right, and two of these are one only if all that is between them
 * meets it to the last digit too, as what rounding makes of a multiple solution (an elbow that is exactly straight). One that is
 * merely within tolerance came to rest in a valley, as there are next to several singularities at once, where a thousandth of a
 * radian changes the pose by less than the tolerance; it is one with whatever can be reached from it within tolerance.
 *
 * Valleys are bent. So the way goes through the posture half-way, brought down to the bottom of the valley straight across the
 * way, and so on between that and the ends. Along a short straight piece the difference from the pose is a parabola, but for at
 * most 1/125 of the cube of all that the joints turn on it; so to look half-way is to look everywhere.
 *
 * @import { Chain } from './chain.js'
 * @import { Tolerances } from './poseErrors.js'
 */
import { isSlide } from './limits.js';
import { polish } from './polish.js';
import { errorsAt, isWithin } from './poseErrors.js';
import { jointWay, wayBetween } from './way.js';

/** Two postures nearer than this (radians, arm lengths) are the same one, found twice. */
const SAME = 1e-8;

/**
 * Two that meet the pose to the last digit and are farther apart than this are not. And who finds nearer than this to a solution what
 * is only within tolerance has found that again.
 */
const NEIGHBOURS = 1e-3;

/** Valleys next to singularities are shorter. */
const VALLEY = 0.1;

/** A piece is short if no joint goes farther than so many cube roots of the tolerance: that leaves a quarter of the tolerance in doubt. */
const PIECE = 0.5;

/** No piece is halved more often. */
const HALVINGS = 12;

/** What rounding leaves of a pose that is met exactly: arm lengths, radians. */
const LAST_DIGIT = 2e-14;

/** @param {Chain} chain @returns {Tolerances} */
const lastDigit = ({ characteristicLength }) => ({
  positionTolerance: LAST_DIGIT * characteristicLength,
  orientationTolerance: LAST_DIGIT,
});

/**
 * From a to b, full turns aside.
 * @param {Chain} chain
 * @param {Float64Array} a
 * @param {Float64Array} b
 * @returns {{ middle: Float64Array, along: Float64Array }} the posture half-way, and the direction, of length 1 in radians and arm lengths
 */
function halfWay(chain, a, b) {
  const middle = new Float64Array(a.length);
  const along = new Float64Array(a.length);
  let square = 0;
  for (let i = 0; i < a.length; i++) {
    const way = jointWay(chain, i, a[i], b[i]);
    middle[i] = a[i] + way / 2;
    along[i] = isSlide(chain.packed, i) ? way / chain.characteristicLength : way;
    square += along[i] * along[i];
  }
  for (let i = 0; i < a.length; i++) along[i] /= Math.sqrt(square);
  return { middle, along };
}

/**
 * Whether there is a way from a to b that stays within tolerances. It is looked for where it should be; that there is none is not proven.
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Float64Array} a
 * @param {Float64Array} b
 * @param {Tolerances} tolerances
 * @param {number} [halvings]  how often the way may be halved
 * @returns {boolean}
 */
export function isWayWithin(chain, T_base_goal, a, b, tolerances, halvings = HALVINGS) {
  const way = wayBetween(chain, a, b);
  const { middle, along } = halfWay(chain, a, b);
  const grain = Math.min(tolerances.positionTolerance / chain.characteristicLength, tolerances.orientationTolerance);
  if (isWithin(chain, T_base_goal, middle, tolerances)) {
    if (way < PIECE * Math.cbrt(grain)) return true;
  } else {
    polish(chain, T_base_goal, middle, grain / 2, along);
    if (!isWithin(chain, T_base_goal, middle, tolerances)) return false;
    if (Math.max(wayBetween(chain, a, middle), wayBetween(chain, middle, b)) > way) return false; // nowhere near
  }
  return (
    halvings > 0 &&
    isWayWithin(chain, T_base_goal, a, middle, tolerances, halvings - 1) &&
    isWayWithin(chain, T_base_goal, middle, b, tolerances, halvings - 1)
  );
}

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Float64Array} a
 * @param {Float64Array} b
 * @param {Tolerances} tolerances  that both are within
 * @param {boolean} areProven  whether each is proven to be there, so that near ones are one only if it was found twice
 * @returns {boolean} whether they are one solution
 */
export function areSame(chain, T_base_goal, a, b, tolerances, areProven) {
  const way = wayBetween(chain, a, b);
  if (way < SAME) return true;
  if (way > VALLEY) return false;
  const rounding = lastDigit(chain);
  const areExact = isWithin(chain, T_base_goal, a, rounding) && isWithin(chain, T_base_goal, b, rounding);
  if (areExact && way > NEIGHBOURS) return false;
  if (areExact) return isWayWithin(chain, T_base_goal, a, b, rounding);
  return (!areProven && way < NEIGHBOURS) || isWayWithin(chain, T_base_goal, a, b, tolerances);
}

/**
 * How far a posture is from the pose, in radians and arm lengths: nothing if it meets it to the last digit.
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Float64Array} q
 */
function missedBy(chain, T_base_goal, q) {
  const { positionError, orientationError } = errorsAt(chain, T_base_goal, q);
  const missed = Math.max(positionError / chain.characteristicLength, orientationError);
  return missed > LAST_DIGIT ? missed : 0;
}

/**
 * Of two postures that are one solution, the one that meets the pose better; the first if both do to the last digit.
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Float64Array} a
 * @param {Float64Array} b
 */
export const better = (chain, T_base_goal, a, b) =>
  missedBy(chain, T_base_goal, b) < missedBy(chain, T_base_goal, a) ? b : a;

/** @param {Chain} chain @param {readonly Float64Array[]} postures */
function areFarApart(chain, postures) {
  for (let i = 1; i < postures.length; i++) {
    for (let j = 0; j < i; j++) if (wayBetween(chain, postures[i], postures[j]) <= VALLEY) return false;
  }
  return true;
}

/**
 * Each solution once, by the best of the postures that are it.
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Float64Array[]} postures
 * @param {Tolerances} tolerances  that all are within
 * @param {boolean} areProven  as for areSame
 * @returns {Float64Array[]} in their order
 */
export function onlyOnce(chain, T_base_goal, postures, tolerances, areProven) {
  if (areFarApart(chain, postures)) return postures;
  const missed = new Map(postures.map((q) => [q, missedBy(chain, T_base_goal, q)]));
  /** @type {Float64Array[]} */
  const distinct = [];
  for (const q of postures.toSorted((a, b) => (missed.get(a) ?? 0) - (missed.get(b) ?? 0))) {
    if (!distinct.some((other) => areSame(chain, T_base_goal, q, other, tolerances, areProven))) distinct.push(q);
  }
  return postures.filter((q) => distinct.includes(q));
}
