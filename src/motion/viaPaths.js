/**
 * Ways of all joints through points, or past them. The times between the points are in proportion to what each move alone would
 * take from rest to rest, and as short as the joints allow. The way is measured in seconds; a piece of it for each move, cut where the points are due.
 *
 * @import { JointLimits, ViaMove } from './moves.js'
 * @import { PosturePath } from './posturePath.js'
 * @import { TimeLaw } from './timeLaw.js'
 */
import { leastDuration } from './polynomialLaws.js';
import { TERMS } from './posturePath.js';
import { between } from './timeLaw.js';
import { blendsOf, cubicSpline, parabolicBlends } from './viaPoints.js';

/** s; less is rounding: powers of it would leave the range of numbers. */
const SHORTEST = 1e-9;

/** Moments that are nearer to each other, over the whole time, are the same. */
const SAME = 1e-12;

const HALVINGS = 60;

/** What all times are shortened to at most in the end: there is no way to go where less would do. */
const LEAST_FACTOR = 1 / 2;

/**
 * @param {readonly ArrayLike<number>[]} points   2 or more
 * @param {readonly ViaMove[]} moves   one less: to each but the first
 * @param {JointLimits} limits
 * @returns {PosturePath[]}   one a move
 */
export function splinePaths(points, moves, limits) {
  const lines = linesOf(points);
  const given = apart(points, moves, limits);
  let factor = LEAST_FACTOR;
  for (const [joint, line] of lines.entries()) {
    for (const [i, { duration: T, coefficients: c }] of cubicSpline(line, given).pieces.entries()) {
      const { speed, acceleration: share } = moves[i];
      const turning = -c[2] / (3 * c[3]); // where the rate is largest, if it is not at an end
      const rates = [0, T, ...(turning > 0 && turning < T ? [turning] : [])].map((t) =>
        Math.abs(c[1] + t * (2 * c[2] + 3 * t * c[3])),
      );
      const acceleration = Math.max(Math.abs(2 * c[2]), Math.abs(2 * c[2] + 6 * c[3] * T));
      factor = Math.max(
        factor,
        Math.max(...rates) / (speed * limits.rates[joint]),
        Math.sqrt(acceleration / (share * limits.accelerations[joint])),
        limits.jerks ? Math.cbrt((6 * Math.abs(c[3])) / (share * limits.jerks[joint])) : 0,
      );
    }
  }
  const durations = given.map((duration) => duration * factor);
  return pathsOf(
    lines.map((line) => cubicSpline(line, durations)),
    durations,
  );
}

/**
 * @param {readonly ArrayLike<number>[]} points   2 or more
 * @param {readonly ViaMove[]} moves   one less: to each but the first
 * @param {JointLimits} limits
 * @returns {PosturePath[]}   one a move
 */
export function blendPaths(points, moves, limits) {
  const share = Math.min(...moves.map(({ acceleration }) => acceleration));
  const lines = linesOf(points);
  const accelerations = Array.from(limits.accelerations, (most) => share * most);
  const given = apart(points, moves, limits);
  const isEnough = (/** @type {number} */ factor) => {
    const longer = given.map((duration) => duration * factor);
    return lines.every((line, joint) => {
      const { rates, lacking } = blendsOf(line, longer, accelerations[joint]);
      // the mean of two rates is what it has in the middle of a blend, where one move ends and the other begins
      const isSlow = (/** @type {number} */ rate, /** @type {number} */ i) =>
        Math.abs(rate) <= moves[i].speed * limits.rates[joint];
      const keeps = (/** @type {number} */ rate, /** @type {number} */ i) =>
        isSlow(rate, i) && (i === 0 || [i - 1, i].every((move) => isSlow((rates[i - 1] + rate) / 2, move)));
      return !lacking && rates.every(keeps);
    });
  };
  // the more time there is the shorter blends are, and the lower rates
  let [low, high] = [LEAST_FACTOR, 1];
  while (!isEnough(high)) [low, high] = [high, 2 * high];
  for (let k = 0; k < HALVINGS; k++) {
    const middle = (low + high) / 2;
    if (isEnough(middle)) high = middle;
    else low = middle;
  }
  const durations = given.map((duration) => duration * high);
  return pathsOf(
    lines.map((line, joint) => parabolicBlends(line, durations, accelerations[joint]).law),
    durations,
  );
}

/** What each move would take from rest to rest by a cubic. @param {readonly ArrayLike<number>[]} points @param {readonly ViaMove[]} moves @param {JointLimits} limits */
const apart = (points, moves, { rates, accelerations }) =>
  moves.map(({ speed, acceleration: share }, i) =>
    rates.reduce((most, rate, joint) => {
      const limits = { rate: speed * rate, acceleration: share * accelerations[joint] };
      return Math.max(most, leastDuration('cubic', points[i + 1][joint] - points[i][joint], limits));
    }, SHORTEST),
  );

/** The values of each joint. @param {readonly ArrayLike<number>[]} points */
const linesOf = (points) => Array.from(points[0], (_, joint) => points.map((point) => point[joint]));

/**
 * @param {readonly TimeLaw[]} laws   one a joint: its value by the time
 * @param {readonly number[]} durations
 * @returns {PosturePath[]}
 */
function pathsOf(laws, durations) {
  const dof = laws.length;
  let due = 0;
  const dues = [0, ...durations.map((duration) => (due += duration))];
  const ends = laws.flatMap(({ pieces }) => pieces.map(({ start }) => start));
  return durations.map((_, move) => {
    const [begin, end] = [dues[move], dues[move + 1]];
    const least = SAME * due;
    const inside = ends.filter((t) => t > begin + least && t < end - least).sort((a, b) => a - b);
    const knots = [begin, ...inside.filter((t, k) => k === 0 || t - inside[k - 1] > least), end];
    const coefficients = new Float64Array(TERMS * dof * (knots.length - 1));
    for (let k = 0, at = 0; k < knots.length - 1; k++) {
      const width = knots[k + 1] - knots[k];
      for (const law of laws) {
        const [own] = between(law, knots[k], knots[k + 1]).sort((a, b) => b.duration - a.duration);
        own.coefficients.forEach((c, power) => (coefficients[at + power] = c * width ** power));
        at += TERMS;
      }
    }
    return { dof, knots: Float64Array.from(knots), coefficients };
  });
}
