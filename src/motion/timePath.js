/**
 * How quickly the arm can go along a path: the rate of the way is looked for over a grid (phasePlane.js), looked at between its
 * points, and the grid made finer where a limit is passed.
 *
 * @import { Plane } from './phasePlane.js'
 * @import { PosturePath } from './posturePath.js'
 * @import { TimeLaw } from './timeLaw.js'
 *
 * @typedef {object} Section    of a path, up to a place along it
 * @property {number} to
 * @property {number} acceleration   what that of the way is at most; Infinity leaves it to the joints
 * @property {number} share     of the joints' accelerations
 * @property {number} ceiling   what the rate of the way is at most
 * @property {number} jerk      what that of the way is at most; Infinity where it may jump
 *
 * @typedef {object} Slowed   a stretch where the way is gone along more slowly than its law says
 * @property {number} from    along the way
 * @property {number} to
 * @property {number | null} joint   the one that is at its limit there; null where it is the tool's own acceleration, on a bend
 *
 * @typedef {{ rates: ArrayLike<number>, accelerations: ArrayLike<number>, jerks?: ArrayLike<number> }} Limits   jerks: kept where
 *   the way's is limited
 */
import { quickestProfile } from './phasePlane.js';
import { pathMoment, pathMomentAt } from './posturePath.js';
import { stretched, timeLaw } from './timeLaw.js';

/**
 * Between the points of the grid a rate may pass its limit by this share of it, and an acceleration by twice that; else the
 * grid is made finer, so many times at most.
 */
export const OVER = 2e-4;
const FINER = 5;

/** Intervals of the grid: about so many over the whole time, and in each piece of the path. */
export const IN_TIME = 160;
const IN_PIECE = 8;

/** A stretch is told if a rate in it is less than the law's by this share of it, and goes as far as rates are less by the other. */
const SLOWER = 1e-3;
const LESS = 1e-6;

/** Of moves that lead into each other: a joint that uses less of its limits is not why; a bend is, about which the law is rounded. */
const NEAR = 0.95;

/**
 * @param {PosturePath} path
 * @param {Limits} limits
 * @param {readonly Section[]} sections
 * @param {((s: number) => number) | null} lawRate   what the rate of the way is at most besides, and with what `slowed` compares
 * @param {readonly number[]} points
 * @returns {{ law: TimeLaw, plane: Plane, grid: Float64Array, x: Float64Array, over: number, slowedBy: (x: Float64Array) => Slowed[] }}
 *   x: squares of the rate at the points of the grid; slowedBy: where such squares are slower; over: by how much the whole had to be stretched in the end; 1 for not at all
 */
export function alongGrid(path, limits, sections, lawRate, points) {
  const { dof, knots } = path;
  const inPieces = [...knots].flatMap((knot, k) =>
    k + 1 < knots.length
      ? Array.from({ length: IN_PIECE }, (_, j) => knot + ((knots[k + 1] - knot) * j) / IN_PIECE)
      : [knot],
  );
  let grid = ascending([...points, ...inPieces, ...sections.map(({ to }) => to)], knots);
  const now = pathMoment(dof);
  for (let finer = 0; ; finer++) {
    const count = grid.length;
    const plane = {
      grid,
      dof,
      first: new Float64Array(dof * count),
      second: new Float64Array(dof * count),
      rates: limits.rates,
      accelerations: limits.accelerations,
      shares: new Float64Array(count - 1),
      own: new Float64Array(count - 1),
      ceiling: new Float64Array(count),
    };
    for (let i = 0, section = 0; i < count; i++) {
      pathMomentAt(path, grid[i], now);
      plane.first.set(now.first, dof * i);
      plane.second.set(now.second, dof * i);
      const before = sections[section];
      while (section < sections.length - 1 && grid[i] >= sections[section].to) section++;
      const { acceleration, share, ceiling } = sections[section];
      if (i < count - 1) {
        plane.shares[i] = share;
        plane.own[i] = acceleration;
      }
      plane.ceiling[i] = Math.min(ceiling, before.ceiling, lawRate ? lawRate(grid[i]) : Infinity) ** 2;
    }
    const x = quickestProfile(plane);
    const uses = usesBetween(path, plane, x);
    if (finer < FINER && uses.some(({ use }) => use > 1 + OVER)) {
      const split = uses.flatMap(({ use }, i) =>
        use > 1 + OVER ? [0.25, 0.5, 0.75].map((at) => grid[i] + at * (grid[i + 1] - grid[i])) : [],
      );
      grid = ascending([...grid, ...split], knots);
      continue;
    }
    const most = uses.reduce((found, { use }) => Math.max(found, use), 1);
    const over = most > 1 + OVER ? most : 1;
    const law = timeLaw(grid[0], grid[grid.length - 1], partsOf(grid, x));
    const wanted = lawRate ? plane.ceiling.slice() : withoutJoints(plane);
    const slowedBy = (/** @type {Float64Array} */ squares) =>
      slowedOf(plane, wanted, squares, uses, lawRate ? 0 : NEAR);
    return { law: over > 1 ? stretched(law, over) : law, plane, grid, x, over, slowedBy };
  }
}

/** Sorted, from the path's beginning to its end, without what is next to the same. @param {readonly number[]} values @param {Float64Array} knots */
function ascending(values, knots) {
  const [begin, end] = [knots[0], knots[knots.length - 1]];
  const least = 1e-9 * (end - begin);
  const sorted = values.filter((s) => s > begin + least && s < end - least).sort((a, b) => a - b);
  return Float64Array.from([begin, ...sorted.filter((s, i) => i === 0 || s - sorted[i - 1] > least), end]);
}

/**
 * How much of the limits is used within each interval, and by which joint: of a rate as it is, of an acceleration its root, for
 * so much more time would do.
 * @param {PosturePath} path @param {Plane} plane @param {Float64Array} x
 */
function usesBetween(path, { grid, dof, rates, accelerations, shares }, x) {
  const now = pathMoment(dof);
  return Array.from(shares, (share, i) => {
    const width = grid[i + 1] - grid[i];
    const u = (x[i + 1] - x[i]) / (2 * width);
    let [use, joint] = [0, -1];
    for (const at of [0.01, 0.25, 0.5, 0.75, 0.99]) {
      pathMomentAt(path, grid[i] + at * width, now);
      const square = x[i] + 2 * u * at * width;
      for (let j = 0; j < dof; j++) {
        const rate = (Math.abs(now.first[j]) * Math.sqrt(Math.max(0, square))) / rates[j];
        const acceleration = Math.abs(now.first[j] * u + now.second[j] * square) / (share * accelerations[j]);
        const own = Math.max(rate, Math.sqrt(acceleration));
        if (own > use) [use, joint] = [own, j];
      }
    }
    return { use, joint };
  });
}

/** One part an interval, at a constant acceleration. @param {Float64Array} grid @param {Float64Array} x  at each point */
export const partsOf = (grid, x) =>
  Array.from({ length: grid.length - 1 }, (_, i) => {
    const width = grid[i + 1] - grid[i];
    const [before, after] = [Math.sqrt(x[i]), Math.sqrt(x[i + 1])];
    const u = (x[i + 1] - x[i]) / (2 * width);
    return { duration: (2 * width) / (before + after), coefficients: [grid[i], before, u / 2] };
  });

/** Stretches of the way where it is slower than the law. @param {Plane} plane @param {Float64Array} wanted  squares, as x @param {Float64Array} x @param {ReturnType<typeof usesBetween>} uses @param {number} near  a joint that uses less of its limits is not why @returns {Slowed[]} */
function slowedOf({ grid }, wanted, x, uses, near) {
  /** @type {(Slowed & { use: number, least: number })[]} */
  const found = [];
  let isOpen = false;
  for (let i = 0; i < uses.length; i++) {
    const share = Math.min(...[i, i + 1].map((k) => (wanted[k] > 0 ? Math.sqrt(x[k] / wanted[k]) : 1)));
    const isSlower = share < 1 - LESS;
    if (isSlower) {
      const { use, joint } = uses[i];
      if (!isOpen) found.push({ from: grid[i], to: grid[i + 1], joint, use, least: 1 });
      const stretch = found[found.length - 1];
      stretch.to = grid[i + 1];
      stretch.least = Math.min(stretch.least, share);
      if (use > stretch.use) [stretch.use, stretch.joint] = [use, joint];
    }
    isOpen = isSlower;
  }
  return found
    .filter(({ least }) => least < 1 - SLOWER)
    .map(({ from, to, joint, use }) => ({ from, to, joint: use > near ? joint : null }));
}

/** How quick it would be if no joint had limits. @param {Plane} plane */
const withoutJoints = (plane) =>
  quickestProfile({ ...plane, dof: 0, first: new Float64Array(0), second: new Float64Array(0) });
