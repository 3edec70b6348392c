/** Sections against closed forms: the boundary everywhere, area and volume, and every cell. */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { sectionAtOnce } from '../../../src/workspace/section.js';
import { coveredAngle } from '../../../src/workspace/swept.js';
import {
  armOf,
  annulus,
  anthropomorphic,
  both,
  cartesian,
  cylindrical,
  planar,
  rectangle,
  right,
  scara,
  sector,
  spherical,
} from './arms.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */
/** @import { Section, SectionOptions } from '../../../src/workspace/section.js' */
/** @import { Inside } from './arms.js' */

/** What is promised of the boundary, m. */
const BOUNDARY = 5e-5;
const CELL = 8e-3;

/** Lines may be off the curves by a little less than that. */
const TOLERANCE = 4.5e-5;

/** @param {ChainDescription} arm @param {SectionOptions} [options] */
function sectionOf(arm, options) {
  const section = sectionAtOnce(createChain(arm), { cell: CELL, tolerance: TOLERANCE, ...options });
  if (!section) throw new Error('Expected a section.');
  return section;
}

/** How far the outlines are from the true boundary, at their vertices and half-way between. @param {Section} section @param {Inside} inside */
function farthestOff({ outlines }, inside) {
  let worst = 0;
  for (const { places } of outlines) {
    const n = places.length / 2;
    for (let i = 0; i < n; i++) {
      const j = (i + 1) % n;
      for (const t of [0, 0.5]) {
        const u = places[2 * i] * (1 - t) + places[2 * j] * t;
        const v = places[2 * i + 1] * (1 - t) + places[2 * j + 1] * t;
        worst = Math.max(worst, Math.abs(inside(u, v)));
      }
    }
  }
  return worst;
}

/** Cells that are told wrongly although their middle is farther than a little from the boundary. @param {Section} section @param {Inside} inside */
function wrongCells({ cells }, inside) {
  let wrong = 0;
  for (let k = 0; k < cells.reached.length; k++) {
    const u = cells.u + ((k % cells.columns) + 0.5) * cells.size;
    const v = cells.v + (Math.floor(k / cells.columns) + 0.5) * cells.size;
    const room = inside(u, v);
    if (Math.abs(room) > BOUNDARY && room > 0 !== (cells.reached[k] === 1)) wrong++;
  }
  return wrong;
}

/** A flat section has its x along the arm's, its y to the left. */
const DEGREE = Math.PI / 180;
const HALF = [-90 * DEGREE, 90 * DEGREE];

/** Slanting through the middle of a box: where the box ends upwards, the slide that crosses the plane is at its limits. */
const SLANT = Math.SQRT1_2;

/** @type {[name: string, arm: ChainDescription, options: SectionOptions, inside: Inside, area: number, volume: number | null][]} */
const CASES = [
  ['a planar 2R arm', planar([0.5, 0.3]), {}, annulus(0.2, 0.8), 4 * Math.PI * 0.15, null],
  [
    'a planar 2R arm whose elbow bends one way',
    planar([0.5, 0.3], [HALF, [0, Math.PI]]),
    {},
    sector(0.5, 0.3),
    0.9424777960769379,
    null,
  ],
  [
    'the same arm, limits ignored',
    planar([0.5, 0.3], [HALF, [0, Math.PI]]),
    { withLimits: false },
    annulus(0.2, 0.8),
    4 * Math.PI * 0.15,
    null,
  ],
  [
    'an anthropomorphic 3R arm',
    anthropomorphic(0.4, 0.3),
    {},
    both(annulus(0.1, 0.7), right),
    (Math.PI / 2) * (0.7 ** 2 - 0.1 ** 2),
    1.4325662500369452,
  ],
  ['a SCARA arm', scara(0.4, 0.3, 0.2), {}, rectangle([0.1, 0.7], [-0.2, 0]), 0.6 * 0.2, 0.3015928947446201],
  [
    'a SCARA arm from above',
    scara(0.4, 0.3, 0.2),
    { cut: { kind: 'plane', origin: [0, 0, -0.1], u: [1, 0, 0], v: [0, 1, 0] } },
    annulus(0.1, 0.7),
    Math.PI * (0.7 ** 2 - 0.1 ** 2),
    null,
  ],
  [
    'a SCARA arm with limits from above',
    scara(0.5, 0.3, 0.2, [HALF, [0, Math.PI]]),
    { cut: { kind: 'plane', origin: [0, 0, -0.1], u: [1, 0, 0], v: [0, 1, 0] } },
    sector(0.5, 0.3),
    0.9424777960769379,
    null,
  ],
  [
    'a cylindrical arm',
    cylindrical([0.1, 0.6], [0.3, 0.9]),
    {},
    rectangle([0.3, 0.9], [0.1, 0.6]),
    0.6 * 0.5,
    Math.PI * (0.9 ** 2 - 0.3 ** 2) * 0.5,
  ],
  [
    'a spherical arm',
    spherical([0, Math.PI], [0.3, 0.8]),
    {},
    both(annulus(0.3, 0.8), right),
    (Math.PI / 2) * (0.8 ** 2 - 0.3 ** 2),
    (4 / 3) * Math.PI * (0.8 ** 3 - 0.3 ** 3),
  ],
  [
    'a Cartesian arm',
    cartesian([-0.2, 0.5], [0.1, 0.7], [0, 0.4]),
    { cut: { kind: 'plane', origin: [0, 0, 0.2], u: [1, 0, 0], v: [0, 1, 0] } },
    rectangle([-0.2, 0.5], [0.1, 0.7]),
    0.7 * 0.6,
    null,
  ],
  [
    'a Cartesian arm, slanting',
    cartesian([-0.2, 0.5], [0.1, 0.7], [0, 0.4]),
    { cut: { kind: 'plane', origin: [0.15, 0.4, 0.2], u: [SLANT, 0, SLANT], v: [0, 1, 0] } },
    rectangle([-0.2 / SLANT, 0.2 / SLANT], [-0.3, 0.3]),
    (0.4 / SLANT) * 0.6,
    null,
  ],
  [
    'a Cartesian arm, slanting, whose height is not the same either way',
    cartesian([-0.2, 0.5], [0.1, 0.7], [0.1, 0.4]),
    { cut: { kind: 'plane', origin: [0.15, 0.4, 0.2], u: [SLANT, 0, SLANT], v: [0, 1, 0] } },
    rectangle([-0.1 / SLANT, 0.2 / SLANT], [-0.3, 0.3]),
    (0.3 / SLANT) * 0.6,
    null,
  ],
  [
    'a Cartesian arm, upright',
    cartesian([-0.2, 0.5], [0.1, 0.7], [0, 0.4]),
    { cut: { kind: 'plane', origin: [0, 0.3, 0], u: [1, 0, 0], v: [0, 0, 1] } },
    rectangle([-0.2, 0.5], [0, 0.4]),
    0.7 * 0.4,
    null,
  ],
];

test('ranges of angles together cover what one of them does', () => {
  expect(coveredAngle([])).toBe(0);
  expect(coveredAngle([[1, 2], [1.5, 3]])).toBeCloseTo(2, 12); // prettier-ignore
  expect(coveredAngle([[-1, 1], [5, 6.5]])).toBeCloseTo(2 * Math.PI - 5 + 1, 12); // prettier-ignore
  expect(coveredAngle([[0, 4], [3, 8]])).toBeCloseTo(2 * Math.PI, 12); // prettier-ignore
});

describe('the section of', () => {
  test.each(CASES)('%s is what its closed form says', (_name, arm, options, inside, area, volume) => {
    const section = sectionOf(arm, options);
    expect(section.sides).toBe('proven');
    expect(section.gap).toBeLessThan(5e-3); // tips are thinner than what is asked beside a curve, and not followed to their end
    expect(farthestOff(section, inside)).toBeLessThan(BOUNDARY);
    expect(wrongCells(section, inside)).toBe(0);
    expect(Math.abs(section.area - area)).toBeLessThanOrEqual(section.areaError + 1e-9);
    expect(Math.abs(section.area / area - 1)).toBeLessThan(1e-3);
    if (volume === null) {
      expect(section.volume).toBeNull();
    } else {
      expect(Math.abs((section.volume ?? 0) - volume)).toBeLessThanOrEqual((section.volumeError ?? 0) + 1e-9);
      expect(Math.abs((section.volume ?? 0) / volume - 1)).toBeLessThan(1e-3);
    }
  });

  test('a plane that the arm never comes to is empty, and one that no joint crosses is none', () => {
    const above = sectionOf(cartesian([0, 1], [0, 1], [0, 0.4]), {
      cut: { kind: 'plane', origin: [0, 0, 0.5], u: [1, 0, 0], v: [0, 1, 0] },
    });
    expect(above.area).toBe(0);
    expect(above.extent).toBeNull();
    expect(above.cells.reached.every((value) => value === 0)).toBe(true);
    const aside = sectionAtOnce(createChain(planar([0.5, 0.3])), {
      cut: { kind: 'plane', origin: [0, 0, 0], u: [1, 0, 0], v: [0, 0, 1] },
    });
    expect(aside).toBeNull();
  });

  test('an arm whose first joint has no full turn makes as much of the solid as it turns through', () => {
    const [heights, reaches] = [
      [0.1, 0.6],
      [0.3, 0.9],
    ];
    const { joints } = cylindrical(heights, reaches);
    const part = sectionOf(armOf({ ...joints[0], lower: -1, upper: 1.5 }, ...joints.slice(1)), { cell: 1e-2 });
    const volume = 1.25 * (0.9 ** 2 - 0.3 ** 2) * 0.5;
    expect(Math.abs((part.volume ?? 0) - volume)).toBeLessThan((part.volumeError ?? 0) + 1e-9);
    expect(Math.abs((part.volume ?? 0) / volume - 1)).toBeLessThan(5e-3);
    // in front and behind, by the elbow over the top: both ranges count, what they share once
    const over = armOf(
      { ...anthropomorphic(0.4, 0.3).joints[0], lower: -1, upper: 1.5 },
      ...anthropomorphic(0.4, 0.3).joints.slice(1),
    );
    const shell = sectionOf(over, { cell: 1e-2, tolerance: 1e-4 });
    const share = 5 / (2 * Math.PI);
    expect(Math.abs((shell.volume ?? 0) / (share * 1.4325662500369452) - 1)).toBeLessThan(5e-3);
  });

  test('a finer tolerance brings the area nearer', () => {
    const off = [4e-4, 2e-5].map((tolerance) =>
      Math.abs(sectionOf(planar([0.5, 0.3]), { tolerance }).area - 4 * Math.PI * 0.15),
    );
    expect(off[1]).toBeLessThan(off[0] / 10);
  });
});
