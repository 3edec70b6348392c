/**
 * The real zeros of a trigonometric polynomial of degree 8,
 *
 *   r(θ) = c_0 + Σ_k c_{2k−1} cos kθ + c_{2k} sin kθ,   k = 1 … 8,
 *
 * every one of them, with proof. The circle is cut into eight arcs; on each, as a form of degree 16 in the cosine and sine of
 * half the angle, r is a Bézier curve: it has no more zeros than its control values change sign, and one if they change sign
 * once (Descartes' rule in Bernstein form; Lane & Riesenfeld 1981). Arcs that are not settled by that are halved (de
 * Casteljau). Sums of products of numbers below one: the rounding stays where it was, which is not so for a polynomial in
 * the tangent of the half angle, nor for the eigenvalues of a companion matrix.
 *
 * Where the polynomial is known only within some noise, a sign counts only above it. What remains unsettled is reported as
 * a cluster: two zeros, or one twice, or none, if the curve is plainly bent there; else any number.
 *
 * @typedef {object} Zero
 * @property {number} angle
 * @property {number} width  radians: how well the angle is known; half the width of a cluster
 * @property {number} count  1; 2 for a cluster of at most two; Infinity for any other cluster
 */

/** Highest multiple of the angle, and how many coefficients that makes. */
export const DEGREE = 8;
export const COUNT = 2 * DEGREE + 1;

const ARCS = 8;
const ARC = (2 * Math.PI) / ARCS;

/** Where the first arc begins: nowhere in particular, since solutions of real arms like multiples of 45°. */
const START = 0.3713;

/** Half of an arc, in the half angle. */
const COS = Math.cos(ARC / 2);
const SIN = Math.sin(ARC / 2);

/** An arc is halved so often at most; then it is 2e-7 wide. */
const DEEPEST = 22;

/** Arcs that end and begin within this (radians) are neighbours. */
const GAP = 1e-9;

/** A cluster wider than this to either side (radians) is not looked into. */
const WIDEST = 3e-3;

/** Zeros are refined until they move by less than this (radians), which takes fewer steps than that. */
const GRAIN = 1e-14;
const MOST_STEPS = 60;

/** Rows of control values for each arc, from the coefficients: 8 · 17 · 17, made once. @type {Float64Array | undefined} */
let toControl;

/** @param {number} n @param {number} k */
function binomial(n, k) {
  let product = 1;
  for (let i = 0; i < k; i++) product = (product * (n - i)) / (i + 1);
  return k < 0 || k > n ? 0 : product;
}

/**
 * With u = e^{iπ/8} and s from 0 to 1 along the arc, e^{ikφ} is (1 − s + s u)^{8+k} (1 − s + s/u)^{8−k}.
 */
function makeToControl() {
  const table = new Float64Array(ARCS * COUNT * COUNT);
  for (let arc = 0; arc < ARCS; arc++) {
    for (let j = 0; j < COUNT; j++) {
      for (let k = 0; k <= DEGREE; k++) {
        let [x, y] = [0, 0];
        for (let i = Math.max(0, j - DEGREE + k); i <= Math.min(j, DEGREE + k); i++) {
          const share = (binomial(DEGREE + k, i) * binomial(DEGREE - k, j - i)) / binomial(2 * DEGREE, j);
          const angle = ((2 * i - j) * ARC) / 2 + k * (START + arc * ARC);
          x += share * Math.cos(angle);
          y += share * Math.sin(angle);
        }
        const at = (arc * COUNT + j) * COUNT;
        if (k > 0) table.set([x, y], at + 2 * k - 1);
        else table[at] = x;
      }
    }
  }
  return table;
}

/** r, r′ and r″ at an angle, by the last call of `evaluate`. */
const jet = new Float64Array(3);

/**
 * @param {ArrayLike<number>} c
 * @param {number} angle
 * @returns {Float64Array} r and its first two derivatives, overwritten by the next call
 */
export function evaluate(c, angle) {
  const x = Math.cos(angle);
  const y = Math.sin(angle);
  let p = 1;
  let q = 0;
  let value = c[0];
  let slope = 0;
  let bend = 0;
  for (let k = 1; k <= DEGREE; k++) {
    const next = p * x - q * y;
    q = p * y + q * x;
    p = next;
    const a = c[2 * k - 1];
    const b = c[2 * k];
    const even = a * p + b * q;
    value += even;
    slope += k * (b * p - a * q);
    bend -= k * k * even;
  }
  jet[0] = value;
  jet[1] = slope;
  jet[2] = bend;
  return jet;
}

/** Control values of the arcs that wait, one row each, and where on the circle they are. */
const rows = new Float64Array((DEEPEST + 3) * COUNT);
const spans = new Float64Array(2 * (DEEPEST + 3));

/** @param {number} arc @param {number} s  0 to 1 along the arc */
const angleAt = (arc, s) => START + arc * ARC + 2 * Math.atan2(s * SIN, 1 - s + s * COS);

/**
 * How many zeros the control values allow: 0, 1 exactly, or −1 for not settled; −2 if nothing stands out of the noise.
 * @param {number} at
 * @param {number} noise
 */
function zerosAllowed(at, noise) {
  let changes = 0;
  let last = 0;
  let doubts = 0;
  for (let j = at; j < at + COUNT; j++) {
    const value = rows[j];
    if (value > noise) {
      if (last < 0) changes++;
      last = 1;
    } else if (value < -noise) {
      if (last > 0) changes++;
      last = -1;
    } else doubts++;
  }
  if (doubts > 0) return doubts === COUNT ? -2 : -1;
  return changes < 2 ? changes : -1;
}

/** Row `at` becomes its second half, the row after it its first. @param {number} at */
function halve(at) {
  const first = at + COUNT;
  for (let k = 0; k < COUNT; k++) {
    rows[first + k] = rows[at];
    for (let j = at; j < at + COUNT - 1 - k; j++) rows[j] = 0.5 * (rows[j] + rows[j + 1]);
  }
}

/**
 * The zero between two angles where the sign changes once: Newton's method, kept inside.
 * @param {ArrayLike<number>} c
 * @param {number} low
 * @param {number} high
 * @param {boolean} isRising
 * @param {number} noise
 * @returns {Zero}
 */
function refine(c, low, high, isRising, noise) {
  let angle = (low + high) / 2;
  for (let k = 0; k < MOST_STEPS; k++) {
    const [value, slope] = evaluate(c, angle);
    if (value < 0 === isRising) low = angle;
    else high = angle;
    const way = -value / slope;
    if (Math.abs(way) < GRAIN) break;
    angle = angle + way > low && angle + way < high ? angle + way : (low + high) / 2;
    if (high - low < GRAIN) break;
  }
  return { angle, width: noise / Math.abs(evaluate(c, angle)[1]), count: 1 };
}

/**
 * @param {ArrayLike<number>} c  17 coefficients
 * @param {number} noise  by how much r may be wrong anywhere
 * @returns {Zero[]} in the order of their angles
 */
export function circleZeros(c, noise) {
  const table = (toControl ??= makeToControl());
  /** @type {Zero[]} */
  const zeros = [];
  /** @type {[number, number][]} */
  const unsettled = [];
  for (let arc = 0, row = 0; arc < ARCS; arc++) {
    for (let j = 0; j < COUNT; j++, row += COUNT) {
      let sum = 0;
      for (let k = 0; k < COUNT; k++) sum += table[row + k] * c[k];
      rows[j] = sum;
    }
    spans[0] = 0;
    spans[1] = 1;
    for (let top = 0; top >= 0; top--) {
      const [from, to] = [spans[2 * top], spans[2 * top + 1]];
      const allowed = zerosAllowed(top * COUNT, noise);
      if (allowed === 1) zeros.push(refine(c, angleAt(arc, from), angleAt(arc, to), rows[top * COUNT] < 0, noise));
      else if (allowed === -2 || (allowed === -1 && to - from < 2 ** -DEEPEST)) {
        unsettled.push([angleAt(arc, from), angleAt(arc, to)]);
      } else if (allowed === -1) {
        const middle = (from + to) / 2;
        halve(top * COUNT);
        spans.set([middle, to, from, middle], 2 * top);
        top += 2;
      }
    }
  }
  for (const [low, high] of joined(unsettled)) zeros.push(...settle(c, low, high, noise));
  return zeros.sort((a, b) => a.angle - b.angle);
}

/** Neighbours become one, also where the circle closes. @param {[number, number][]} spans @returns {[number, number][]} */
function joined(spans) {
  /** @type {[number, number][]} */
  const whole = [];
  for (const [low, high] of spans) {
    const last = whole.at(-1);
    if (last && low - last[1] < GAP) last[1] = high;
    else whole.push([low, high]);
  }
  const last = whole.at(-1);
  if (last && whole.length > 1 && whole[0][0] + 2 * Math.PI - last[1] < GAP) {
    whole[0][0] = last[0] - 2 * Math.PI;
    whole.pop();
  }
  return whole;
}

/**
 * One zero that happened to lie where an arc was cut is no cluster, since the curve is steep there; and where it is plainly
 * bent there are two at most.
 * @param {ArrayLike<number>} c
 * @param {number} low
 * @param {number} high
 * @param {number} noise
 * @returns {Zero[]}
 */
function settle(c, low, high, noise) {
  const middle = (low + high) / 2;
  const half = (high - low) / 2;
  const [value, slope, bend] = evaluate(c, middle);
  if (half < WIDEST) {
    if (Math.abs(slope) * half > noise / 8 && isEven(c, low, high, 1)) {
      const away = -value / slope;
      const width = noise / Math.abs(slope);
      return Math.abs(away) > half + width ? [] : [{ angle: middle + away, width, count: 1 }];
    }
    if (Math.abs(bend) * half * half > noise / 16 && isEven(c, low, high, 2)) {
      return [{ angle: middle, width: half, count: 2 }];
    }
  }
  return [{ angle: middle, width: half, count: Infinity }];
}

/**
 * Whether a derivative is at both ends about what it is in the middle.
 * @param {ArrayLike<number>} c
 * @param {number} low
 * @param {number} high
 * @param {1 | 2} order
 */
function isEven(c, low, high, order) {
  const middle = evaluate(c, (low + high) / 2)[order];
  return [low, high].every((end) => Math.abs(evaluate(c, end)[order] - middle) < Math.abs(middle) / 2);
}
