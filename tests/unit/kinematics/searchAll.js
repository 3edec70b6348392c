/**
 * Every posture that many descents find: Newton's method, damped, on forward differences of the oracle's matrices. Slow, and
 * shares nothing with the kernel.
 * @import { ChainDescription } from '../../../src/kinematics/chain.js'
 * @import { Matrix } from './oracle.js'
 */
import { oracleForward } from './oracle.js';

const STEPS = 40;
const SAME = 1e-6;

/** The angle by which two joint values differ, full turns aside. @param {number} a @param {number} b */
export const turnsApart = (a, b) => Math.abs(Math.atan2(Math.sin(a - b), Math.cos(a - b)));

/** Twelve numbers that are zero where two poses are the same. @param {Matrix} A @param {Matrix} B */
const openings = (A, B) => [0, 1, 2].flatMap((i) => [0, 1, 2, 3].map((j) => A[i][j] - B[i][j]));

/** A x = b by Gauss, with the largest pivot of each column. @param {Matrix} A @param {number[]} b @returns {number[]} */
export function solve(A, b) {
  const rows = A.map((row, i) => [...row, b[i]]);
  const n = rows.length;
  for (let k = 0; k < n; k++) {
    const largest = rows
      .slice(k)
      .reduce((best, row, i) => (Math.abs(row[k]) > Math.abs(rows[best][k]) ? k + i : best), k);
    [rows[k], rows[largest]] = [rows[largest], rows[k]];
    for (let i = k + 1; i < n; i++) {
      const share = rows[i][k] / rows[k][k];
      for (let j = k; j <= n; j++) rows[i][j] -= share * rows[k][j];
    }
  }
  const x = new Array(n).fill(0);
  for (let i = n - 1; i >= 0; i--) {
    x[i] = (rows[i][n] - x.reduce((sum, value, j) => (j > i ? sum + rows[i][j] * value : sum), 0)) / rows[i][i];
  }
  return x;
}

/**
 * The Jacobian by differences, from the matrices: rows of linear and angular velocity, in the base's axes.
 * @param {ChainDescription} description
 * @param {number[]} q
 * @returns {Matrix} 6 rows
 */
export function differenceOf(description, q) {
  const { tcp } = oracleForward(description, q);
  const h = 1e-5;
  const columns = q.map((value, i) => {
    const [more, less] = [value + h, value - h].map((at) => oracleForward(description, q.with(i, at)).tcp);
    const slope = more.map((row, r) => row.map((entry, c) => (entry - less[r][c]) / (2 * h)));
    const spin = (/** @type {number} */ r, /** @type {number} */ c) =>
      slope[r].slice(0, 3).reduce((sum, entry, k) => sum + entry * tcp[c][k], 0);
    return [slope[0][3], slope[1][3], slope[2][3], spin(2, 1), spin(0, 2), spin(1, 0)];
  });
  return [0, 1, 2, 3, 4, 5].map((row) => columns.map((column) => column[row]));
}

/**
 * @param {ChainDescription} description  all joints turn
 * @param {Matrix} goal
 * @param {number} starts
 * @param {() => number} random
 * @returns {number[][]} distinct postures
 */
export function searchAll(description, goal, starts, random) {
  /** @type {number[][]} */
  const found = [];
  const openAt = (/** @type {number[]} */ q) => openings(goal, oracleForward(description, q).tcp);
  const size = (/** @type {number[]} */ values) => Math.hypot(...values);
  for (let start = 0; start < starts; start++) {
    let q = description.joints.map(() => (2 * random() - 1) * Math.PI);
    let open = openAt(q);
    let damping = 0.1;
    for (let k = 0; k < STEPS && size(open) > 1e-12 && damping < 1e6; k++) {
      const h = 1e-7;
      const slopes = q.map((value, i) => openAt(q.with(i, value + h)).map((entry, r) => (entry - open[r]) / h));
      const A = slopes.map((a, i) =>
        slopes.map((b, j) => a.reduce((sum, entry, r) => sum + entry * b[r], i === j ? damping * size(open) ** 2 : 0)),
      );
      const step = solve(
        A,
        slopes.map((a) => -a.reduce((sum, entry, r) => sum + entry * open[r], 0)),
      );
      const next = q.map((value, i) => value + step[i]);
      const nextOpen = openAt(next);
      if (size(nextOpen) < size(open)) {
        [q, open] = [next, nextOpen];
        damping /= 4;
      } else damping *= 8;
    }
    const isNew = found.every((other) => q.some((value, i) => turnsApart(value, other[i]) > SAME));
    if (size(open) < 1e-9 && isNew) found.push(q);
  }
  return found;
}
