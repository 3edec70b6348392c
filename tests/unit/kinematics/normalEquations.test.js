import fc from 'fast-check';
import { expect, test } from 'vitest';
import { writeNormalEquations } from '../../../src/kinematics/descent/normalEquations.js';
import { SEED, runs } from '../../helpers/property.js';
import { times, transpose } from './oracle.js';

const number = fc.integer({ min: -1000, max: 1000 }); // sums and products of them are exact

test('Jᵀ W J and Jᵀ W r are the matrix products, for each number of joints', () => {
  fc.assert(
    fc.property(
      fc.integer({ min: 1, max: 8 }),
      fc.array(number, { minLength: 48, maxLength: 48 }),
      fc.array(number, { minLength: 6, maxLength: 6 }),
      fc.constantFrom(0.25, 1, 16),
      (n, numbers, r, weight) => {
        const J = Float64Array.from(numbers.slice(0, 6 * n));
        const [H, gradient] = [new Float64Array(n * n), new Float64Array(n)];
        writeNormalEquations({ J, weight, residual: Float64Array.from(r), H, gradient });
        const columns = Array.from({ length: n }, (_, i) => Array.from(J.slice(6 * i, 6 * i + 6)));
        const weighted = columns.map((column) => column.map((value, k) => (k < 3 ? value * weight : value)));
        const wanted = times(columns, transpose(weighted));
        wanted.forEach((row, i) => {
          row.slice(0, i + 1).forEach((value, j) => expect(H[i * n + j] - value).toBe(0)); // −0 is 0
        });
        times(
          weighted,
          r.map((value) => [value]),
        ).forEach(([value], i) => expect(gradient[i] - value).toBe(0));
      },
    ),
    { seed: SEED, numRuns: runs(100) },
  );
});
