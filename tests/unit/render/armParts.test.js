import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { linkFrames } from '../../../src/kinematics/forward.js';
import { translation } from '../../../src/kinematics/pose.js';
import { armParts } from '../../../src/render/arm/armParts.js';
import { solidOf } from '../../../src/render/arm/solid.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyChain, anyRows, apply, framesByHand, libraryArms, placed, rangeOf, rowsOf, times } from './arms.js';

/**
 * @import { Chain } from '../../../src/kinematics/chain.js'
 * @import { JointRow } from '../../../src/kinematics/joint.js'
 * @import { Part } from '../../../src/render/arm/armParts.js'
 * @import { LinkStyle } from '../../../src/render/arm/linkPieces.js'
 */

const RIGHT = Math.PI / 2;
/** @param {number} theta @param {number} d @param {number} a @param {number} alpha @returns {JointRow} */
const turn = (theta, d, a, alpha) => ({ type: 'revolute', theta, d, a, alpha, lower: -3, upper: 3 });
/** @param {number} d @param {number} alpha @param {number} lower @param {number} upper @returns {JointRow} */
const slide = (d, alpha, lower, upper) => ({ type: 'prismatic', theta: 0, d, a: 0, alpha, lower, upper });
/** @param {JointRow[]} joints */
const standard = (joints) => createChain({ convention: 'standard', joints });
/** Fixed radii, so that what grows is only what the table says. @param {number} count @param {number} radius @returns {LinkStyle[]} */
const styles = (count, radius) => Array.from({ length: count }, () => ({ kind: 'auto', radius }));

/** All corners of some parts, in the world. @param {Part[]} parts @param {number[][][]} frames */
const corners = (parts, frames) => parts.flatMap((part) => placed(part, frames[part.link]));

/** @param {Chain} chain @param {ArrayLike<number>} q */
const kernelFrames = (chain, q) => {
  const frames = linkFrames(chain, q);
  return Array.from({ length: chain.dof + 1 }, (_, i) => rowsOf(frames.subarray(16 * i)));
};

describe.each(libraryArms)('%s', (_id, chain) => {
  const { parts, size } = armParts(chain);
  test('has finite corners in every part, and parts in every link', () => {
    for (const { shape, pose } of parts) {
      const { positions, normals } = solidOf(shape);
      expect([...positions, ...normals, ...pose].every(Number.isFinite)).toBe(true);
    }
    expect(new Set(parts.map(({ link }) => link)).size).toBe(chain.dof + 1);
  });
  test('stands on the floor at zero, or on a base just below its first axis', () => {
    const [low] = rangeOf(
      corners(
        parts.filter(({ link }) => link === 0),
        [rowsOf(chain.base)],
      ),
      2,
    );
    expect(low).toBeLessThanOrEqual(1e-12);
    expect(low).toBeGreaterThan(-0.15 * size);
  });
});

test('any chain of 2 to 6 joints, of any size and without limits or lengths, is drawn with finite numbers', () =>
  fc.assert(
    fc.property(anyChain, ({ chain }) => {
      const { parts, rods, joints, size, below } = armParts(chain);
      expect([size, below].every(Number.isFinite)).toBe(true);
      expect(size).toBeGreaterThan(0);
      for (const { shape, pose } of [...parts, ...rods]) {
        const { positions, normals, edges } = solidOf(shape);
        expect([...positions, ...normals, ...edges, ...pose].every(Number.isFinite)).toBe(true);
      }
      for (const { T_link_zero, aim, at, radius, low, high } of joints) {
        expect([...T_link_zero, aim, at, radius, low, high].every(Number.isFinite)).toBe(true);
      }
    }),
    { seed: SEED, numRuns: runs(150) },
  ));

test('an arm without any length at all is still something to see', () => {
  const { parts, size } = armParts(standard([turn(0, 0, 0, 0), turn(0, 0, 0, 0)]));
  expect(size).toBe(0.3);
  expect(parts.length).toBeGreaterThan(4);
});

describe('lengths in the picture are those of the table', () => {
  const joints = [turn(0, 0.7, 0, RIGHT), turn(0, 0, 0.5, 0), turn(0, 0, 0.4, 0)];
  const arm = standard(joints);
  const { parts } = armParts(arm, styles(3, 0.04));
  const frames = framesByHand('standard', joints, [0, 0, 0]);
  const own = (/** @type {number} */ link, /** @type {string} */ kind) =>
    corners(
      parts.filter((part) => part.link === link && part.kind === kind),
      frames,
    );

  test('a long offset d is a tube from one end to the other, the part before its drum standing still', () => {
    const [floor, columnTop] = rangeOf(own(0, 'link'), 2);
    const [drumLow, drumHigh] = rangeOf(own(0, 'joint'), 2);
    const [tubeLow, tubeHigh] = rangeOf(own(1, 'link'), 2);
    expect(floor).toBe(0);
    expect(columnTop).toBeCloseTo(drumLow, 12);
    expect((drumLow + drumHigh) / 2).toBeCloseTo(0.72 * 0.7, 12);
    expect(tubeLow).toBeCloseTo(drumHigh, 12);
    expect(tubeHigh).toBeGreaterThan(0.7); // the fork about the next axis
  });

  test('a beam has its round ends about both axes', () => {
    // link 3 lies along x of the world, from x = 0.5 to 0.9 at the height of 0.7, with ends of 1.16 and 0.945 radii
    const beam = own(3, 'link');
    const [from, to] = rangeOf(beam, 0);
    expect(from).toBeCloseTo(0.5 - 1.16 * 0.04, 12);
    expect(to).toBeCloseTo(0.9 + 1.05 * 0.9 * 0.04, 12);
    const [low, high] = rangeOf(beam, 2);
    expect((low + high) / 2).toBeCloseTo(0.7, 12);
    const [back, front] = rangeOf(beam, 1);
    expect(back + front).toBeCloseTo(0, 12);
  });

  test('a fork holds the next link between its cheeks, with its pin along the axis', () => {
    const [pinLeft, pinRight] = rangeOf(own(2, 'joint'), 1);
    expect(pinLeft + pinRight).toBeCloseTo(0, 12);
    const pin = own(2, 'joint');
    for (const [axis, middle] of /** @type {const} */ ([
      [0, 0.5],
      [2, 0.7],
    ])) {
      const [least, most] = rangeOf(pin, axis);
      expect((least + most) / 2).toBeCloseTo(middle, 12);
    }
    // in the slot, where the next link turns, there is nothing of the fork
    const tongue = rangeOf(own(3, 'link'), 1)[1];
    const cheeks = own(2, 'link').filter(([x]) => x > 0.5);
    expect(cheeks.length).toBeGreaterThan(0);
    expect(Math.min(...cheeks.map(([, y]) => Math.abs(y)))).toBeGreaterThan(tongue);
  });

  test('a wrist without offsets stands out of its fork far enough to turn in it', () => {
    const wrist = libraryArms.filter(([id]) => id === 'puma560').map(([, chain]) => chain)[0];
    const zero = kernelFrames(wrist, [0, 0, 0, 0, 0, 0]);
    const above = (/** @type {number} */ link, /** @type {string} */ kind) =>
      rangeOf(
        corners(
          armParts(wrist).parts.filter((part) => part.link === link && part.kind === kind),
          zero,
        ),
        2,
      );
    const centre = zero[5][2][3];
    const [, cheeks] = above(4, 'link'); // the arm goes straight up beyond its elbow
    const [drum] = above(5, 'joint');
    expect(cheeks).toBeGreaterThan(centre);
    expect(drum).toBeGreaterThan(cheeks);
    expect(above(6, 'link')[0]).toBeGreaterThan(drum);
  });

  test('two links side by side are as far apart as d says', () => {
    const rows = [turn(0, 0.7, 0, RIGHT), turn(0, 0, 0.5, 0), turn(0, 0.12, 0.4, 0)];
    const beside = armParts(standard(rows), styles(3, 0.04)).parts;
    const at = framesByHand('standard', rows, [0, 0, 0]);
    const plate = (/** @type {number} */ link) => {
      const { shape, pose } = beside.filter((part) => part.link === link && part.kind === 'link').at(-1) ?? beside[0];
      const [back, front] = rangeOf(placed({ shape, pose }, at[link]), 1);
      return (back + front) / 2;
    };
    expect(plate(2)).toBeCloseTo(0, 12);
    expect(plate(3)).toBeCloseTo(-0.12, 12); // z of joint 3 points to −y of the world
  });

  test('a millimetre more of a or d makes its link a millimetre longer, whichever way it points', () => {
    /** @param {JointRow[]} rows @param {number} link @param {0 | 1 | 2} axis */
    const extent = (rows, link, axis) => {
      const some = armParts(standard(rows), styles(rows.length, 0.03)).parts.filter(
        (part) => part.link === link && part.kind !== 'tool',
      );
      const [least, most] = rangeOf(
        corners(
          some,
          framesByHand(
            'standard',
            rows,
            rows.map(() => 0),
          ),
        ),
        axis,
      );
      return most - least;
    };
    fc.assert(
      fc.property(
        fc.double({ min: 0.2, max: 1, noNaN: true }),
        fc.double({ min: 0.4, max: 1, noNaN: true }),
        fc.constantFrom(1, -1),
        (a, d, sign) => {
          const rows = (/** @type {number} */ more) => [
            turn(0, 0.5, 0, 0),
            turn(0, 0, sign * (a + more), 0),
            turn(0, 0, 0.3, 0),
          ];
          expect(extent(rows(0.001), 2, 0) - extent(rows(0), 2, 0)).toBeCloseTo(0.001, 9);
          // link 2 comes to a fork after 28 % of d: what stands still takes the rest
          const tubes = (/** @type {number} */ more) => [
            turn(0, 0.5, 0, RIGHT),
            turn(0, sign * (d + more), 0, RIGHT),
            turn(0, 0, 0.3, 0),
          ];
          const grown = extent(tubes(0.001), 1, 1) - extent(tubes(0), 1, 1);
          expect(grown).toBeCloseTo(0.72 * 0.001, 9);
          expect(extent(tubes(0.001), 2, 1) - extent(tubes(0), 2, 1)).toBeCloseTo(0.28 * 0.001, 9);
        },
      ),
      { seed: SEED, numRuns: runs(20) },
    );
  });

  test('a tool is drawn to its tip, and no tool is not drawn', () => {
    const tool = translation([0.03, -0.04, 0.2]);
    const withTool = createChain({ convention: 'standard', joints, tool });
    const drawn = armParts(withTool).parts.filter(({ kind }) => kind === 'tool');
    const [, tip] = rangeOf(corners(drawn, frames), 1); // z of the flange is −y of the world
    const expected = apply(frames[3], [0.03, -0.04, 0.2]);
    const nearest = Math.min(...corners(drawn, frames).map((p) => Math.hypot(...p.map((x, i) => x - expected[i]))));
    expect(nearest).toBeLessThan(0.002);
    expect(tip).toBeLessThan(0.02);
    expect(parts.filter(({ kind }) => kind === 'tool')).toEqual([]);
  });
});

describe('sliding joints', () => {
  const cobra = [turn(0, 0.387, 0.325, 0), turn(0, 0, 0.275, Math.PI), slide(0, 0, 0, 0.21), turn(0, 0, 0, 0)];

  test('a ram and all beyond it move along the axis by the joint value; its sleeve stays', () => {
    const { parts } = armParts(standard(cobra));
    const [at0, at1] = [0, 0.1].map((q3) => framesByHand('standard', cobra, [0.3, -0.4, q3, 0]));
    const low = (/** @type {number[][][]} */ frames, /** @type {number} */ link) =>
      rangeOf(
        corners(
          parts.filter((part) => part.link === link),
          frames,
        ),
        2,
      )[0];
    for (const link of [3, 4]) expect(low(at0, link) - low(at1, link)).toBeCloseTo(0.1, 12);
    expect(low(at0, 2)).toBe(low(at1, 2));
  });

  test('a ram never leaves its sleeve within the limits', () =>
    fc.assert(
      fc.property(
        fc.double({ min: -1, max: 1, noNaN: true }),
        fc.double({ min: -1, max: 0.9, noNaN: true }),
        fc.double({ min: 0.05, max: 1, noNaN: true }),
        (d, lower, travel) => {
          const rows = [turn(0, 0.4, 0, RIGHT), slide(d, 0, lower, lower + travel)];
          const { parts } = armParts(standard(rows));
          const sleeve = parts.filter(({ link, kind }) => link === 1 && kind === 'joint');
          const ram = parts.filter(({ link, kind }) => link === 2 && kind === 'link').slice(0, 1);
          for (const q2 of [lower, lower + travel]) {
            const frames = framesByHand('standard', rows, [0, q2]);
            const [s0, s1] = rangeOf(corners(sleeve, frames), 1); // the slide's axis is −y of the world
            const [r0, r1] = rangeOf(corners(ram, frames), 1);
            expect(Math.min(s1, r1) - Math.max(s0, r0)).toBeGreaterThan(0);
          }
        },
      ),
      { seed: SEED, numRuns: runs(60) },
    ));

  test('a carriage stays on its mast within the limits', () => {
    const rows = [turn(0, 0.5, 0, 0), slide(0.1, -RIGHT, -0.2, 0.8), turn(0, 0, 0.4, 0)];
    const { parts } = armParts(standard(rows));
    for (const q2 of [-0.2, 0.8]) {
      const frames = framesByHand('standard', rows, [0, q2, 0]);
      const [mastLow, mastHigh] = rangeOf(
        corners(
          parts.filter(({ link }) => link === 1),
          frames,
        ),
        2,
      );
      const carriage = parts.filter(({ link, kind }) => link === 2 && kind === 'joint').slice(0, 1);
      const [low, high] = rangeOf(corners(carriage, frames), 2);
      expect(low).toBeGreaterThan(mastLow);
      expect(high).toBeLessThan(mastHigh);
      expect((low + high) / 2).toBeCloseTo(0.5 + 0.1 + q2, 12);
    }
  });

  test('a rod joins a slide to the link before it, however far it has gone', () => {
    const rows = [
      turn(0.2, 0.4, 0, RIGHT),
      { ...slide(0.1, RIGHT, -Infinity, Infinity), theta: 0.7 },
      turn(0, 0, 0.3, 0),
    ];
    const { rods } = armParts(standard(rows));
    expect(rods.length).toBe(1);
    const [{ pose, link, joint, constant }] = rods;
    expect([link, joint]).toEqual([1, 1]);
    for (const q2 of [-5, 0.3, 40]) {
      const frames = framesByHand('standard', rows, [0.5, q2, 0]);
      const end = apply(times(frames[link], rowsOf(pose)), [0, 0, constant + q2]);
      const next = frames[2].slice(0, 3).map((row) => row[3]);
      end.forEach((x, i) => expect(x).toBeCloseTo(next[i], 9));
    }
  });
});

test('an arm in modified convention is drawn as the same arm in standard convention is, converted by hand', () =>
  fc.assert(
    fc.property(anyRows, (drawn) => {
      const joints = drawn.map(([row]) => row);
      const q = drawn.map(([, value]) => value);
      const modified = createChain({ convention: 'modified', joints });
      // the a and alpha of a modified row come before its joint: they belong to the standard row before, the first to the base
      const rows = joints.map((row, i) => ({ ...row, a: joints[i + 1]?.a ?? 0, alpha: joints[i + 1]?.alpha ?? 0 }));
      const { a, alpha } = joints[0];
      const [cos, sin] = [Math.cos(alpha), Math.sin(alpha)];
      const base = [1, 0, 0, 0, 0, cos, sin, 0, 0, -sin, cos, 0, a, 0, 0, 1];
      const converted = createChain({ convention: 'standard', base, joints: rows });
      const [one, other] = [modified, converted].map((chain) => armParts(chain, styles(chain.dof, 0.04)));
      expect(one.parts.map(({ link, kind }) => [link, kind])).toEqual(
        other.parts.map(({ link, kind }) => [link, kind]),
      );
      const [left, right] = [
        corners(one.parts, kernelFrames(modified, q)),
        corners(other.parts, kernelFrames(converted, q)),
      ];
      let worst = 0;
      left.forEach((point, i) => point.forEach((x, k) => (worst = Math.max(worst, Math.abs(x - right[i][k])))));
      expect(worst).toBeLessThan(1e-9);
    }),
    { seed: SEED, numRuns: runs(40) },
  ));

describe('how a link is to be drawn', () => {
  const joints = [turn(0, 0.7, 0, RIGHT), turn(0, 0, 0.5, 0), turn(0, 0, 0.4, 0)];
  const frames = framesByHand('standard', joints, [0, 0, 0]);
  /** @param {LinkStyle} style */
  const secondLink = (style) =>
    armParts(standard(joints), [{ kind: 'auto' }, style]).parts.filter(({ link }) => link === 2);

  test('as nothing leaves its joint to be seen', () => {
    expect(secondLink({ kind: 'none' }).map(({ kind }) => kind)).toEqual(['joint']);
  });
  test('as a box has the width and the height that were asked for, and the length of the table', () => {
    const box = secondLink({ kind: 'box', width: 0.06, height: 0.1 }).filter(({ kind }) => kind === 'link');
    const spans = /** @type {const} */ ([0, 1, 2]).map((axis) => rangeOf(corners(box, frames), axis));
    const sides = spans.map(([least, most]) => most - least);
    expect(sides[0]).toBeCloseTo(0.5, 12);
    expect([sides[1], sides[2]].sort()).toEqual([expect.closeTo(0.06, 12), expect.closeTo(0.1, 12)]);
  });
  test('as a cylinder has the radius that was asked for, and the length of the table', () => {
    const tube = secondLink({ kind: 'cylinder', radius: 0.03 }).filter(({ kind }) => kind === 'link');
    const [from, to] = rangeOf(corners(tube, frames), 0);
    expect(to - from).toBeCloseTo(0.5, 12);
    const [low, high] = rangeOf(corners(tube, frames), 2);
    expect(high - low).toBeCloseTo(0.06, 3);
  });
});
