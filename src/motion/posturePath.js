/**
 * Postures along a way: a chain of polynomials of the fifth degree for each joint, by how far along the way the arm is. It
 * says where, never when, and is plain data, so that it can be posted to another thread.
 *
 * @typedef {object} PosturePath
 * @property {number} dof
 * @property {Float64Array} knots         where the pieces begin, ascending, and at last where the last one ends
 * @property {Float64Array} coefficients  6 · dof a piece, those of a joint together, the constant one first: of λ, which goes
 *   from 0 to 1 through the piece
 *
 * @typedef {object} PathMoment   derivatives are by the way
 * @property {Float64Array} posture
 * @property {Float64Array} first
 * @property {Float64Array} second
 * @property {Float64Array} third
 */

/** Coefficients of a joint in a piece. */
export const TERMS = 6;

/** @param {number} dof @returns {PathMoment} */
export const pathMoment = (dof) => ({
  posture: new Float64Array(dof),
  first: new Float64Array(dof),
  second: new Float64Array(dof),
  third: new Float64Array(dof),
});

/**
 * @param {PosturePath} path
 * @param {number} s     along the way; beyond its ends it stands there
 * @param {PathMoment} [out]
 * @returns {PathMoment}
 */
export function pathMomentAt({ dof, knots, coefficients: c }, s, out = pathMoment(dof)) {
  const piece = pieceAt(knots, s);
  const width = knots[piece + 1] - knots[piece];
  const x = width > 0 ? Math.min(1, Math.max(0, (s - knots[piece]) / width)) : 1;
  const per = width > 0 ? 1 / width : 0;
  for (let i = 0, at = TERMS * dof * piece; i < dof; i++, at += TERMS) {
    let [p, d, half, sixth] = [0, 0, 0, 0];
    for (let k = TERMS - 1; k >= 0; k--) {
      sixth = sixth * x + half;
      half = half * x + d;
      d = d * x + p;
      p = p * x + c[at + k];
    }
    out.posture[i] = p;
    out.first[i] = d * per;
    out.second[i] = 2 * half * per * per;
    out.third[i] = 6 * sixth * per * per * per;
  }
  return out;
}

/** The last piece that begins at or before s, by halving. @param {ArrayLike<number>} knots @param {number} s */
export function pieceAt(knots, s) {
  let [low, high] = [0, knots.length - 2];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (knots[middle] <= s) low = middle;
    else high = middle - 1;
  }
  return low;
}

/**
 * Straight from one posture to the next.
 * @param {readonly number[]} knots
 * @param {readonly ArrayLike<number>[]} postures   one a knot
 * @returns {PosturePath}
 */
export function straightPath(knots, postures) {
  const dof = postures[0].length;
  const coefficients = new Float64Array(TERMS * dof * (knots.length - 1));
  for (let k = 0, at = 0; k < knots.length - 1; k++) {
    for (let i = 0; i < dof; i++, at += TERMS) {
      coefficients[at] = postures[k][i];
      coefficients[at + 1] = postures[k + 1][i] - postures[k][i];
    }
  }
  return { dof, knots: Float64Array.from(knots), coefficients };
}

/**
 * The same path by another measure: shifted and stretched.
 * @param {PosturePath} path
 * @param {number} begin    where it begins then
 * @param {number} factor
 * @returns {PosturePath}
 */
export const measuredBy = (path, begin, factor) => ({
  ...path,
  knots: path.knots.map((knot) => begin + (knot - path.knots[0]) * factor),
});

/**
 * The derivatives of a moment by another measure of the way.
 * @param {PathMoment} moment
 * @param {number} factor   what the new measure's unit is of the old one
 */
export const headingBy = ({ first, second }, factor) => ({
  first: first.map((value) => value * factor),
  second: second.map((value) => value * factor * factor),
});

/**
 * Paths one after another; each begins where the one before ends.
 * @param {readonly PosturePath[]} paths  1 or more
 * @returns {PosturePath}
 */
export function joined(paths) {
  if (paths.length === 1) return paths[0];
  const knots = [paths[0].knots[0]];
  for (const path of paths) for (const knot of path.knots.subarray(1)) knots.push(knot);
  const coefficients = new Float64Array(paths.reduce((sum, path) => sum + path.coefficients.length, 0));
  let at = 0;
  for (const path of paths) {
    coefficients.set(path.coefficients, at);
    at += path.coefficients.length;
  }
  return { dof: paths[0].dof, knots: Float64Array.from(knots), coefficients };
}
