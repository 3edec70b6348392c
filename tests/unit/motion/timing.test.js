/** Paths that joints can follow only so fast: the quickest way along them, and laws that have to slow down. */
import { describe, expect, test } from 'vitest';
import { quickestLaw } from '../../../src/motion/quickestLaw.js';
import { pathMomentAt } from '../../../src/motion/posturePath.js';
import { momentAt } from '../../../src/motion/timeLaw.js';
import { TOPPRA } from './references.js';

/**
 * The cubic spline without a knot at the first and last inner points, by elimination on its second derivatives.
 * @param {readonly number[]} s @param {readonly number[][]} points
 */
function notAKnot(s, points) {
  const [n, dof] = [s.length, points[0].length];
  const h = s.slice(1).map((x, i) => x - s[i]);
  const bends = points[0].map((_, j) => {
    const slope = h.map((width, i) => (points[i + 1][j] - points[i][j]) / width);
    if (n === 3) return s.map(() => (2 * (slope[1] - slope[0])) / (h[0] + h[1]));
    const A = s.map((_x, i) => {
      const row = new Array(n + 1).fill(0);
      if (i === 0) row.splice(0, 3, h[1], -(h[0] + h[1]), h[0]);
      else if (i === n - 1) row.splice(n - 3, 3, h[n - 2], -(h[n - 3] + h[n - 2]), h[n - 3]);
      else {
        row.splice(i - 1, 3, h[i - 1], 2 * (h[i - 1] + h[i]), h[i]);
        row[n] = 6 * (slope[i] - slope[i - 1]);
      }
      return row;
    });
    for (let c = 0; c < n; c++) {
      const pivot = A.slice(c).reduce((best, row, k) => (Math.abs(row[c]) > Math.abs(A[best][c]) ? c + k : best), c);
      [A[c], A[pivot]] = [A[pivot], A[c]];
      for (const row of A) {
        if (row === A[c]) continue;
        const factor = row[c] / A[c][c];
        for (let k = c; k <= n; k++) row[k] -= factor * A[c][k];
      }
    }
    return A.map((row, i) => row[n] / row[i]);
  });
  const coefficients = h.flatMap((width, k) =>
    bends.flatMap((m, j) => [
      points[k][j],
      points[k + 1][j] - points[k][j] - (width * width * (2 * m[k] + m[k + 1])) / 6,
      (m[k] * width * width) / 2,
      ((m[k + 1] - m[k]) * width * width) / 6,
      0,
      0,
    ]),
  );
  return { dof, knots: Float64Array.from(s), coefficients: Float64Array.from(coefficients) };
}

describe('the quickest way along a path', () => {
  test.each(TOPPRA.map((each) => /** @type {const} */ ([each.name, each])))(
    '%s: as long as toppra says, and within the limits',
    (_, { s, waypoints, vmax: rates, amax: accelerations, duration }) => {
      const path = notAKnot(s, waypoints);
      const end = s[s.length - 1];
      const { law } = quickestLaw(path, { rates, accelerations }, [
        { to: end, acceleration: Infinity, share: 1, ceiling: Infinity, jerk: Infinity },
      ]);
      expect(Math.abs(law.duration / duration - 1)).toBeLessThan(0.005);
      expect(momentAt(law, 0).rate).toBe(0);
      expect(Math.abs(momentAt(law, law.duration).rate)).toBeLessThan(1e-12);
      let most = 0;
      for (const { start, duration: lasting } of law.pieces) {
        for (const at of [0.001, 0.3, 0.6, 0.999]) {
          const now = momentAt(law, start + at * lasting);
          const { first, second } = pathMomentAt(path, now.position);
          for (let i = 0; i < path.dof; i++) {
            const acceleration = Math.abs(first[i] * now.acceleration + second[i] * now.rate ** 2);
            most = Math.max(most, (Math.abs(first[i]) * now.rate) / rates[i], acceleration / accelerations[i]);
          }
        }
      }
      expect(most).toBeLessThan(1.001);
      expect(most).toBeGreaterThan(0.999);
    },
  );
});
