import fc from 'fast-check';
import { expect, test } from 'vitest';
import { linkFrames } from '../../../src/kinematics/forward.js';
import { ROW_MOTIONS, motionAt } from '../../../src/model/robot/rowMotions.js';
import { carried, rowSteps } from '../../../src/render/marks/rowSteps.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyChain, framesByHand } from './arms.js';

/** @param {ArrayLike<number>} T @param {number[][]} rows */
const distance = (T, rows) => Math.max(...rows.flatMap((row, i) => row.map((x, j) => Math.abs(x - T[i + 4 * j]))));

test('the four motions of a row lead from its first frame to its second, in either convention', () =>
  fc.assert(
    fc.property(anyChain, ({ chain, q }) => {
      const frames = linkFrames(chain, q);
      const expected = framesByHand(chain.convention, chain.joints, q);
      const scale = Math.max(1, ...chain.joints.map(({ a, d }) => Math.abs(a) + Math.abs(d)), ...q.map(Math.abs));
      for (let i = 0; i < chain.dof; i++) {
        const steps = rowSteps(chain, frames, q, i);
        expect(steps.map(({ field }) => field).sort()).toEqual(['a', 'alpha', 'd', 'theta']);
        expect(distance(steps[0].before, expected[i])).toBeLessThan(1e-11 * scale);
        expect(distance(steps[3].after, expected[i + 1])).toBeLessThan(1e-11 * scale);
        for (let k = 1; k < 4; k++) expect(steps[k].before).toBe(steps[k - 1].after);
        for (const step of steps) {
          expect(carried(step.before, step, step.value)).toEqual(step.after);
          expect(
            Array.from(carried(step.before, step, 0)).every((x, j) => Math.abs(x - step.before[j]) < 1e-15 * scale),
          ).toBe(true);
        }
      }
    }),
    { seed: SEED, numRuns: runs(60) },
  ));

test('a motion is about or along the axis that the definitions of the table name', () => {
  const said = (/** @type {'standard' | 'modified'} */ convention) =>
    Object.fromEntries(
      ROW_MOTIONS[convention].map(({ field, axis, number, turns }) => [
        field,
        `${axis}${number} ${turns ? 'turn' : 'slide'}`,
      ]),
    );
  expect(said('standard')).toEqual({ theta: 'z0 turn', d: 'z0 slide', a: 'x1 slide', alpha: 'x1 turn' });
  expect(said('modified')).toEqual({ theta: 'z1 turn', d: 'z1 slide', a: 'x0 slide', alpha: 'x0 turn' });
});

test('a row is built up motion by motion', () => {
  expect(motionAt('standard', 0)).toBe(null);
  expect(motionAt('standard', 1)).toMatchObject({ index: 0, share: 1 });
  expect(motionAt('standard', 1.5)).toMatchObject({ index: 1, share: 0.5, motion: { field: 'd' } });
  expect(motionAt('modified', 1.5)).toMatchObject({ index: 1, share: 0.5, motion: { field: 'a' } });
  expect(motionAt('modified', 4)).toMatchObject({ index: 3, share: 1, motion: { field: 'd' } });
});
