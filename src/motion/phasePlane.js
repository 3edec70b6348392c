/**
 * The quickest way through the phase plane: at how much rate a path can be gone along at each of its points, so that no joint
 * is faster than its limits or accelerates more. Over a grid of the path, x is the square of the rate of the way and u its
 * acceleration, constant between two points, so that x grows by 2 Δ u. A joint's rate is q′√x and its acceleration q′u + q″x:
 * linear in u and x, and held to the limit at both ends of each interval.
 *
 * From the end backwards: the largest x from which the end can still be met. From the beginning forwards: as much u as the
 * limits and that bound allow. (Reachability analysis: Pham & Pham, A New Approach to Time-Optimal Path Parameterization
 * Based on Reachability Analysis, IEEE T-RO 2018.) Standing still is always possible, so that there is always an answer.
 *
 * @typedef {object} Plane
 * @property {Float64Array} grid      ascending, N + 1 points
 * @property {number} dof
 * @property {Float64Array} first     dof a point: q′
 * @property {Float64Array} second    dof a point: q″
 * @property {ArrayLike<number>} rates
 * @property {ArrayLike<number>} accelerations
 * @property {Float64Array} shares    of those accelerations, one an interval
 * @property {Float64Array} own       what |u| is at most whatever the joints do, one an interval; perhaps Infinity
 * @property {Float64Array} ceiling   what x is at most whatever the joints do, one a point
 */

/** Derivatives below this are none. */
const NOTHING = 1e-12;

/** Newton's method for a convex function of straight pieces ends at one of them. */
const MOST_STEPS = 50;

/** Limits are aimed at with so much to spare: rounding. */
const SPARE = 1 - 1e-9;

/**
 * @param {Plane} plane
 * @returns {Float64Array}  x at each point; 0 at both ends
 */
export function quickestProfile(plane) {
  const { grid } = plane;
  const last = grid.length - 1;
  const most = caps(plane);
  const lines = createLines(plane.dof);
  const x = new Float64Array(last + 1);
  for (let i = last - 1; i >= 0; i--) {
    writeLines(plane, i, lines);
    x[i] = largest(lines, most[i], x[i + 1], 2 * (grid[i + 1] - grid[i]));
  }
  x[0] = 0;
  for (let i = 0; i < last; i++) {
    writeLines(plane, i, lines);
    const step = 2 * (grid[i + 1] - grid[i]);
    const wanted = (x[i + 1] - x[i]) / step;
    let u = wanted;
    for (let k = 0; k < lines.count; k++) {
      if (lines.isUpper[k]) u = Math.min(u, lines.at0[k] + lines.slope[k] * x[i]);
    }
    if (u < wanted) x[i + 1] = Math.max(0, x[i] + step * u);
  }
  return x;
}

/** What x is at most at each point: by the rates, and where a joint's acceleration does not depend on u, by that. @param {Plane} plane */
function caps({ grid, dof, first, second, rates, accelerations, shares, ceiling }) {
  const last = grid.length - 1;
  const most = ceiling.slice();
  for (let i = 0; i <= last; i++) {
    const share = SPARE * Math.min(shares[Math.min(i, last - 1)], shares[Math.max(0, i - 1)]);
    for (let j = 0, at = dof * i; j < dof; j++, at++) {
      const speed = Math.abs(first[at]);
      if (speed > NOTHING) most[i] = Math.min(most[i], ((SPARE * rates[j]) / speed) ** 2);
      else if (second[at] !== 0) most[i] = Math.min(most[i], (share * accelerations[j]) / Math.abs(second[at]));
    }
  }
  return most;
}

/** Bounds u ≤ at0 + slope x (upper) or u ≥ of it. @param {number} dof */
function createLines(dof) {
  const room = 4 * dof + 2;
  return {
    count: 0,
    at0: new Float64Array(room),
    slope: new Float64Array(room),
    isUpper: new Uint8Array(room),
  };
}
/** @typedef {ReturnType<typeof createLines>} Lines */

/** @param {Lines} lines @param {number} factor  of u @param {number} bend  of x @param {number} limit */
function addPair(lines, factor, bend, limit) {
  if (Math.abs(factor) <= NOTHING) return;
  const [slope, half] = [-bend / factor, limit / Math.abs(factor)];
  for (const upper of [1, 0]) {
    lines.at0[lines.count] = upper ? half : -half;
    lines.slope[lines.count] = slope;
    lines.isUpper[lines.count++] = upper;
  }
}

/** The joints' accelerations at both ends of an interval. @param {Plane} plane @param {number} i @param {Lines} lines */
function writeLines({ grid, dof, first, second, accelerations, shares, own }, i, lines) {
  lines.count = 0;
  const step = 2 * (grid[i + 1] - grid[i]);
  if (own[i] < Infinity) addPair(lines, 1, 0, own[i]);
  for (let j = 0; j < dof; j++) {
    const limit = SPARE * shares[i] * accelerations[j];
    const [a, b] = [dof * i + j, dof * (i + 1) + j];
    addPair(lines, first[a], second[a], limit);
    addPair(lines, first[b] + step * second[b], second[b], limit);
  }
}

/**
 * The largest x with a u that all bounds allow and that leads to an x between 0 and `next`. Where the bounds cross is a zero of
 * a convex function that is not above 0 at x = 0.
 * @param {Lines} lines @param {number} most @param {number} next @param {number} step
 */
function largest({ count, at0, slope, isUpper }, most, next, step) {
  let x = most;
  for (let k = 0; k < MOST_STEPS; k++) {
    let [low, lowSlope, high, highSlope] = [-x / step, -1 / step, (next - x) / step, -1 / step];
    for (let j = 0; j < count; j++) {
      const u = at0[j] + slope[j] * x;
      if (isUpper[j]) {
        if (u < high) [high, highSlope] = [u, slope[j]];
      } else if (u > low) [low, lowSlope] = [u, slope[j]];
    }
    if (low <= high) return x;
    const lower = x - (low - high) / (lowSlope - highSlope);
    if (!(lower < x)) return Math.max(0, x);
    x = Math.max(0, lower);
  }
  return x;
}
