/**
 * A time law: how far along its way something is at each moment. It is a chain of polynomials, so that rate, acceleration
 * and jerk are exact derivatives, and it stands still before it begins and after it has ended.
 *
 * @typedef {object} Piece   position at `start + τ`, 0 ≤ τ ≤ `duration`: Σ coefficients[k] τᵏ
 * @property {number} start      s
 * @property {number} duration   s
 * @property {readonly number[]} coefficients   of the position, the constant one first
 *
 * @typedef {object} TimeLaw
 * @property {number} duration   s
 * @property {readonly Piece[]} pieces   each begins where the one before ends
 * @property {number} from   position before it begins
 * @property {number} to     position after it has ended
 *
 * @typedef {object} Moment   in units of the way: of whatever the law moves
 * @property {number} position
 * @property {number} rate           per second; the derivatives likewise
 * @property {number} acceleration
 * @property {number} jerk
 */

/**
 * @param {number} from
 * @param {number} to
 * @param {readonly { duration: number, coefficients: readonly number[] }[]} parts  those that take no time are left out
 * @returns {TimeLaw}
 */
export function timeLaw(from, to, parts) {
  /** @type {Piece[]} */
  const pieces = [];
  let start = 0;
  for (const { duration, coefficients } of parts) {
    if (!(duration > 0)) continue;
    pieces.push({ start, duration, coefficients });
    start += duration;
  }
  return { duration: start, pieces, from, to };
}

/**
 * Where it is at a moment, and how fast.
 * @example
 * momentAt(timeLaw(0, 6, [{ duration: 2, coefficients: [0, 3] }]), 1) // → { position: 3, rate: 3, acceleration: 0, jerk: 0 }
 * @param {TimeLaw} law
 * @param {number} t  s, from the beginning; before 0 and after the end it stands still
 * @returns {Moment}
 */
export function momentAt({ duration, pieces, from, to }, t) {
  if (!(t >= 0) || pieces.length === 0) return still(t >= 0 ? to : from);
  if (t > duration) return still(to);
  const piece = pieceAt(pieces, t);
  return derivatives(piece.coefficients, Math.min(t - piece.start, piece.duration));
}

/** @param {number} position @returns {Moment} */
const still = (position) => ({ position, rate: 0, acceleration: 0, jerk: 0 });

/** The last that has begun, by halving. @param {readonly Piece[]} pieces  1 or more @param {number} t */
export function pieceAt(pieces, t) {
  let [low, high] = [0, pieces.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (pieces[middle].start <= t) low = middle;
    else high = middle - 1;
  }
  return pieces[low];
}

/** A polynomial and its first three derivatives, by Horner's scheme. @param {readonly number[]} c @param {number} x @returns {Moment} */
export function derivatives(c, x) {
  let [position, rate, half, sixth] = [0, 0, 0, 0];
  for (let k = c.length - 1; k >= 0; k--) {
    sixth = sixth * x + half;
    half = half * x + rate;
    rate = rate * x + position;
    position = position * x + c[k];
  }
  return { position, rate, acceleration: 2 * half, jerk: 6 * sixth };
}

/**
 * The same way in more time, or less: rates scale with 1/f, accelerations with 1/f², jerks with 1/f³.
 * @param {TimeLaw} law
 * @param {number} factor  of its duration, above 0
 * @returns {TimeLaw}
 */
export const stretched = ({ from, to, pieces }, factor) =>
  timeLaw(
    from,
    to,
    pieces.map(({ duration, coefficients }) => ({
      duration: duration * factor,
      coefficients: coefficients.map((c, k) => c / factor ** k),
    })),
  );

/**
 * What of a law is between two moments, as parts of another.
 * @param {TimeLaw} law
 * @param {number} from   s
 * @param {number} to
 */
export const between = ({ pieces }, from, to) =>
  pieces
    .filter(({ start, duration }) => start < to && start + duration > from)
    .map(({ start, duration, coefficients }) => {
      const begin = Math.max(0, from - start);
      return { duration: Math.min(duration, to - start) - begin, coefficients: shifted(coefficients, begin) };
    });

/** The same polynomial by the time since `x`. @param {readonly number[]} coefficients @param {number} x */
export function shifted(coefficients, x) {
  const c = [...coefficients];
  // by Horner's scheme again and again, each time without the last remainder
  for (let done = 0; done < c.length - 1; done++) for (let k = c.length - 2; k >= done; k--) c[k] += x * c[k + 1];
  return c;
}

/** Halvings of a law's time: as near as numbers are. */
const HALVINGS = 50;

/**
 * When a law is at a place: it never goes back.
 * @param {TimeLaw} law
 * @param {number} position
 */
export function timeAt(law, position) {
  let [low, high] = [0, law.duration];
  for (let k = 0; k < HALVINGS && low < high; k++) {
    const middle = (low + high) / 2;
    if (momentAt(law, middle).position < position) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}
