/** Sampled places are those of the postures they say, whoever asks for them in whatever slices. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { movingJoints, rangesOf, whyNotMapped } from '../../../src/workspace/placement.js';
import { createSampler } from '../../../src/workspace/sampler.js';
import { runs, SEED } from '../../helpers/property.js';
import { anyChain, oracleForward } from '../kinematics/oracle.js';
import { ALL_ARMS, publishedArm } from '../kinematics/publishedArms.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */

const TOOL = Float64Array.of(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0.03, -0.02, 0.15, 1);

/** @param {ChainDescription} description @param {number} count @param {object} [options] */
function farthestOff(description, count, options = {}) {
  const sampler = createSampler(createChain(description), options);
  const places = new Float32Array(3 * count);
  sampler.fill(2000, places);
  let worst = 0;
  for (let k = 0; k < count; k++) {
    const { tcp } = oracleForward(description, Array.from(sampler.postureAt(2000 + k)));
    for (let axis = 0; axis < 3; axis++) worst = Math.max(worst, Math.abs(tcp[axis][3] - places[3 * k + axis]));
  }
  return worst;
}

describe('sampled places', () => {
  test.each(ALL_ARMS)('of %s are where forward kinematics puts the TCP, with a tool and without', (name) => {
    const description = publishedArm(name);
    expect(farthestOff(description, 60)).toBeLessThan(1e-6); // places are of single precision
    expect(farthestOff({ ...description, tool: TOOL }, 60, { seed: 7 })).toBeLessThan(1e-6);
  });

  test('of any chain with limited slides', () => {
    fc.assert(
      fc.property(anyChain, ({ description }) => {
        const joints = description.joints.map((row) =>
          row.type === 'prismatic' ? { ...row, lower: -0.5, upper: 0.75 } : { ...row, lower: -1, upper: 2.5 },
        );
        expect(farthestOff({ ...description, joints }, 20)).toBeLessThan(1e-5);
      }),
      { numRuns: runs(20), seed: SEED },
    );
  });

  test('are the same in any slices, and for the same seed only', () => {
    const chain = createChain(publishedArm('ur5'));
    const places = (/** @type {number} */ seed, /** @type {number} */ from, /** @type {number} */ count) => {
      const out = new Float32Array(3 * count);
      createSampler(chain, { seed }).fill(from, out);
      return Array.from(out);
    };
    const whole = places(1, 0, 3000);
    expect([...places(1, 0, 700), ...places(1, 700, 1300), ...places(1, 2000, 1000)]).toEqual(whole);
    expect(places(2, 0, 3000)).not.toEqual(whole);
  });

  test('stay inside the limits, and come near both ends of them', () => {
    const chain = createChain(publishedArm('puma560'));
    const sampler = createSampler(chain);
    const seen = [0, 1, 2].map(() => ({ low: Infinity, high: -Infinity }));
    for (let k = 0; k < 2000; k++) {
      const q = sampler.postureAt(k);
      seen.forEach((each, i) => {
        each.low = Math.min(each.low, q[i]);
        each.high = Math.max(each.high, q[i]);
      });
    }
    seen.forEach(({ low, high }, i) => {
      const { lower, upper } = chain.joints[i];
      expect(low).toBeGreaterThanOrEqual(lower);
      expect(high).toBeLessThanOrEqual(upper);
      expect(high - low).toBeGreaterThan(0.99 * (upper - lower));
    });
  });
});

describe('the joints that move the TCP', () => {
  test.each([
    ['puma560', undefined, [0, 1, 2]],
    ['puma560', TOOL, [0, 1, 2, 3, 4, 5]],
    ['ur5', undefined, [0, 1, 2, 3, 4]],
    ['kuka_kr6_r900', undefined, [0, 1, 2, 3, 4]],
    ['scara_cobra600', undefined, [0, 1, 2]],
    ['planar3r', undefined, [0, 1, 2]],
  ])('%s', (name, tool, joints) => {
    expect(movingJoints(createChain({ ...publishedArm(name), tool }))).toEqual(joints);
  });

  test('a joint that can make a full turn has no ends, nor has any that turns when limits do not count', () => {
    const ur5 = createChain(publishedArm('ur5'));
    expect(rangesOf(ur5, true).isClosed).toEqual([true, true, true, true, true]);
    const scara = createChain(publishedArm('scara_cobra600'));
    expect(rangesOf(scara, true).isClosed).toEqual([false, false, false]);
    expect(rangesOf(scara, false).isClosed).toEqual([true, true, false]);
    expect(rangesOf(scara, false).upper[2]).toBe(0.21);
  });

  test('an arm without bounds, or that goes nowhere, is not mapped, and it is said why', () => {
    const row = { a: 0, alpha: 0, d: 0, theta: 0 };
    const slide = createChain({ convention: 'standard', joints: [{ ...row, type: 'prismatic', lower: 0 }] });
    expect(whyNotMapped(slide)).toEqual({ code: 'unlimited-slide', joint: 0 });
    const still = createChain({ convention: 'standard', joints: [{ ...row, type: 'revolute' }] });
    expect(whyNotMapped(still)).toEqual({ code: 'nothing-moves' });
    expect(whyNotMapped(createChain(publishedArm('puma560')))).toBeNull();
  });
});
