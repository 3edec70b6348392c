/** What the boundary is made of: of arms whose boundary everybody knows; and traces of single joints, which are circles and lines. */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../../src/kinematics/chain.js';
import { criticalOnes } from '../../../../src/model/workspace/criticalOnes.js';
import { angleInSection, placeInSection, seenInSection, sweptPlaces } from '../../../../src/model/workspace/sweep.js';
import { sectionAtOnce } from '../../../../src/workspace/section.js';
import { oracleForward } from '../../kinematics/oracle.js';
import { publishedArm } from '../../kinematics/publishedArms.js';
import { anthropomorphic, planar, scara } from '../../workspace/arms.js';

/** @import { ChainDescription } from '../../../../src/kinematics/chain.js' */

/** @param {ChainDescription} arm @param {{ cell: number, tolerance: number }} [fine]  m */
function onesOf(arm, fine = { cell: 0.02, tolerance: 2e-4 }) {
  const section = sectionAtOnce(createChain(arm), { ...fine, withVolume: false });
  if (!section) throw new Error('Expected a section.');
  return { section, ones: criticalOnes(createChain(arm), section) };
}

const HALF = Math.PI / 2;

describe('the boundary of', () => {
  test('two links without limits: stretched outside, folded inside', () => {
    const { ones } = onesOf(planar([0.5, 0.3]));
    expect(ones.map(({ shape, held, free }) => ({ shape, held, free }))).toEqual([
      { shape: 'stretched', held: [], free: [0, 1] },
      { shape: 'folded', held: [], free: [0, 1] },
    ]);
    expect(Math.hypot(ones[0].u, ones[0].v)).toBeCloseTo(0.8, 4);
    expect(Math.hypot(ones[1].u, ones[1].v)).toBeCloseTo(0.2, 4);
  });

  test('two links, the elbow bent one way only: each joint at its limits', () => {
    const { ones } = onesOf(planar([0.5, 0.3], [[-HALF, HALF], [0.4, 2]])); // prettier-ignore
    const names = ones.map(({ held }) => held.map(({ joint, bound }) => `${joint} ${bound}`).join());
    expect(names.sort()).toEqual(['0 lower', '0 upper', '1 lower', '1 upper']);
  });

  test('a SCARA arm: its slide at its ends, its elbow straight and folded', () => {
    const { ones } = onesOf(scara(0.4, 0.3, 0.2));
    expect(ones.filter(({ held }) => held.some(({ joint }) => joint === 2))).toHaveLength(2);
    expect(ones.filter(({ free }) => free.includes(1) && !free.includes(2)).length).toBeGreaterThan(0);
  });

  test('an arm with a shoulder: no posture is named for where the half-plane ends', () => {
    const { ones } = onesOf(anthropomorphic(0.4, 0.3));
    expect(ones.map(({ shape }) => shape)).toEqual(['stretched', 'folded']);
    for (const { u } of ones) expect(u).toBeGreaterThan(0.01);
  });

  test('Puma 560 and UR5: the tool is there, by plain matrices, and the joints said to be at limits are', () => {
    for (const name of ['puma560', 'ur5']) {
      const arm = publishedArm(name);
      const { section, ones } = onesOf(arm, { cell: 0.05, tolerance: 1e-3 }); // a posture is exact, however coarse the curve it was found along
      expect(ones.some(({ shape, u }) => shape === 'stretched' && u > 0.5)).toBe(true);
      expect(ones.length).toBeGreaterThan(1);
      for (const { u, v, q, held } of ones) {
        const { tcp } = oracleForward(arm, [...q]);
        const [out, up] = seenInSection(section, [tcp[0][3], tcp[1][3], tcp[2][3]]);
        expect(Math.hypot(out - u, up - v)).toBeLessThan(1e-4);
        for (const { joint, bound } of held) expect(q[joint]).toBeCloseTo(Number(arm.joints[joint][bound]), 9);
      }
    }
  });
});

test('a joint that is swept leaves a circle about its axis, with both ends', () => {
  const chain = createChain(planar([0.5, 0.3]));
  const places = sweptPlaces(chain, [0.3, 0.7], 1, -1, 2);
  const elbow = [0.5 * Math.cos(0.3), 0.5 * Math.sin(0.3)];
  for (let k = 0; k < places.length; k += 3)
    expect(Math.hypot(places[k] - elbow[0], places[k + 1] - elbow[1])).toBeCloseTo(0.3, 12);
  expect(places[0]).toBeCloseTo(elbow[0] + 0.3 * Math.cos(0.3 - 1), 12);
  expect(places.at(-3)).toBeCloseTo(elbow[0] + 0.3 * Math.cos(0.3 + 2), 12);
});

test('a place of a section is seen where it was picked', () => {
  const { section } = onesOf(anthropomorphic(0.4, 0.3));
  const [u, v] = seenInSection(section, placeInSection(section, 0.31, -0.12));
  expect([u, v].map((value) => Math.round(value * 1e9) / 1e9)).toEqual([0.31, -0.12]);
});

test('a place is turned from the half-plane by as much as it was turned about its axis', () => {
  const { section } = onesOf(anthropomorphic(0.4, 0.3));
  const { origin, v } = section.frame;
  const place = placeInSection(section, 0.31, -0.12);
  for (const angle of [0, 0.4, -2, 3]) {
    const r = place.map((value, i) => value - origin[i]);
    const turned = turnAbout(v, angle, r).map((value, i) => value + origin[i]);
    expect(angleInSection(section, turned)).toBeCloseTo(angle, 12);
  }
  expect(angleInSection(section, placeInSection(section, 0, 0.5))).toBe(0);
});

/** Rodrigues. @param {ArrayLike<number>} axis @param {number} angle @param {number[]} r */
function turnAbout(axis, angle, r) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const along = r.reduce((sum, value, i) => sum + value * axis[i], 0);
  return r.map((value, i) => {
    const [j, k] = [(i + 1) % 3, (i + 2) % 3];
    return c * value + s * (axis[j] * r[k] - axis[k] * r[j]) + (1 - c) * along * axis[i];
  });
}
