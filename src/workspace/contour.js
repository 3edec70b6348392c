/**
 * Where a function on a rectangle is zero: the rectangle is looked at in a grid (marching squares), the crossings of the grid's
 * lines are found to the last digits, and those of one square joined. Between two crossings the contour is found by going
 * square to the line that joins them; where branches cross that leads along the right ones.
 *
 * A closed contour that fits between the lines of the grid is not seen.
 */

/** Steps of halving, and of the false position that is tried first. */
const STEPS = 60;

/** @typedef {number[]} Point  two arguments */

/**
 * A zero between two places of opposite sign, by halving and false position in turns.
 * @param {(t: number) => number} of
 * @param {number} low
 * @param {number} high
 * @param {number} atLow   the function there
 * @param {number} atHigh
 */
function zeroBetween(of, low, high, atLow, atHigh) {
  for (let step = 0; step < STEPS && Math.abs(high - low) > 1e-15 * (1 + Math.abs(low)); step++) {
    if (atHigh === 0) return high;
    if (atLow === 0) return low;
    const t = step % 3 === 2 ? (low + high) / 2 : low + ((high - low) * atLow) / (atLow - atHigh);
    const value = of(t);
    if (value === 0) return t;
    if (value < 0 === atLow < 0) [low, atLow] = [t, value];
    else [high, atHigh] = [t, value];
  }
  return (low + high) / 2;
}

/**
 * @param {(p: number, q: number) => number} of
 * @param {{ low: number[], high: number[], grid: number }} rectangle  grid: squares along one side
 * @returns {{ pieces: Point[][], between: (a: Point, b: Point) => Point | null }}
 */
export function contourPieces(of, { low, high, grid }) {
  const stepP = (high[0] - low[0]) / grid;
  const stepQ = (high[1] - low[1]) / grid;
  const at = (/** @type {number} */ k, /** @type {0 | 1} */ axis) =>
    k === grid ? high[axis] : low[axis] + k * (axis ? stepQ : stepP);
  const side = grid + 1;
  const values = new Float64Array(side * side);
  let most = 0;
  for (let i = 0; i < side; i++) {
    for (let j = 0; j < side; j++) {
      const value = of(at(i, 0), at(j, 1));
      values[side * i + j] = value;
      most = Math.max(most, Math.abs(value));
    }
  }
  // A function that is zero everywhere has no contour; one that is zero up to rounding has none that means anything.
  const nothing = 1e-12 * most;
  if (most < 1e-14) return { pieces: [], between: () => null };
  for (let k = 0; k < values.length; k++) if (Math.abs(values[k]) <= nothing) values[k] = nothing || 1e-300;

  /** @type {Map<number, Point>} */
  const crossings = new Map();
  /** The crossing of the grid's line from node (i, j), along p or q. @param {number} i @param {number} j @param {0 | 1} axis */
  function crossing(i, j, axis) {
    const key = 2 * (side * i + j) + axis;
    const known = crossings.get(key);
    if (known) return known;
    const from = values[side * i + j];
    const to = values[axis ? side * i + j + 1 : side * (i + 1) + j];
    const [p, q] = [at(i, 0), at(j, 1)];
    /** @type {Point} */
    const point = axis
      ? [p, zeroBetween((t) => of(p, t), q, at(j + 1, 1), from, to)]
      : [zeroBetween((t) => of(t, q), p, at(i + 1, 0), from, to), q];
    crossings.set(key, point);
    return point;
  }

  /** @type {Point[][]} */
  const pieces = [];
  for (let i = 0; i < grid; i++) {
    for (let j = 0; j < grid; j++) {
      const k = side * i + j;
      const [a, b, c, d] = [values[k] > 0, values[k + side] > 0, values[k + side + 1] > 0, values[k + 1] > 0];
      if (a === b && b === c && c === d) continue;
      /** @type {Point[]} */
      const around = [];
      if (a !== b) around.push(crossing(i, j, 0));
      if (b !== c) around.push(crossing(i + 1, j, 1));
      if (c !== d) around.push(crossing(i, j + 1, 0));
      if (d !== a) around.push(crossing(i, j, 1));
      if (around.length === 2) {
        pieces.push(around);
      } else {
        // Two branches: the middle of the square tells which corners belong together.
        const middle = of(at(i, 0) + stepP / 2, at(j, 1) + stepQ / 2) > 0;
        if (middle === a) pieces.push([around[0], around[1]], [around[2], around[3]]);
        else pieces.push([around[3], around[0]], [around[1], around[2]]);
      }
    }
  }
  return { pieces: joined(pieces), between: (from, to) => between(of, from, to, stepP, stepQ) };
}

/**
 * Half-way on the contour: square to the line between two points, where the function changes its sign nearest to the line.
 * @param {(p: number, q: number) => number} of
 * @param {Point} a
 * @param {Point} b
 * @param {number} stepP
 * @param {number} stepQ
 * @returns {Point | null}
 */
function between(of, a, b, stepP, stepQ) {
  // both arguments in squares of the grid, which may be radians one way and metres the other
  const [dp, dq] = [(b[0] - a[0]) / stepP, (b[1] - a[1]) / stepQ];
  const middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  const point = (/** @type {number} */ t) => [middle[0] - t * dq * stepP, middle[1] + t * dp * stepQ];
  const at = (/** @type {number} */ t) => of(point(t)[0], point(t)[1]);
  const here = at(0);
  if (here === 0) return middle;
  for (let reach = 1 / 64; reach <= 1; reach *= 2) {
    for (const t of [reach, -reach]) {
      const there = at(t);
      if (there < 0 === here < 0 && there !== 0) continue;
      return point(zeroBetween(at, 0, t, here, there));
    }
  }
  return null;
}

/**
 * Pieces that share an end, joined to runs.
 * @param {Point[][]} pieces  of two points each; ends that are the same are the same array
 * @returns {Point[][]}
 */
export function joined(pieces) {
  /** @type {Map<Point, Point[][]>} */
  const at = new Map();
  for (const piece of pieces) {
    for (const end of piece) {
      const there = at.get(end);
      if (there) there.push(piece);
      else at.set(end, [piece]);
    }
  }
  const left = new Set(pieces);
  /** @param {Point} end @returns {Point | null} */
  const stepFrom = (end) => {
    const next = at.get(end)?.find((piece) => left.has(piece));
    if (!next) return null;
    left.delete(next);
    return next[0] === end ? next[1] : next[0];
  };
  const runs = [];
  for (const piece of pieces) {
    if (!left.delete(piece)) continue;
    const run = [...piece];
    for (let next = stepFrom(run[run.length - 1]); next; next = stepFrom(next)) run.push(next);
    for (let next = stepFrom(run[0]); next; next = stepFrom(next)) run.unshift(next);
    runs.push(run);
  }
  return runs;
}
