/**
 * Sections in planes that no joint brings places into, such as beside a rail, and in half-planes at one angle of arms with joints to
 * spare: closed forms, and postures by the cosine rule.
 */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { sectionAtOnce } from '../../../src/workspace/section.js';
import { armOf, both, farthestOff, planar, right, sector, sliding, turning, wrongCells } from './arms.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */
/** @import { Cut } from '../../../src/workspace/cut.js' */
/** @import { Inside } from './arms.js' */

const isDeep = Boolean(process.env.DENAVIT_DEEP);
const QUARTER = Math.PI / 2;
const TOLERANCE = isDeep ? 2e-5 : 2e-4;

/** @param {ChainDescription} arm @param {Cut} cut */
function cutOf(arm, cut) {
  const section = sectionAtOnce(createChain(arm), { cut, tolerance: TOLERANCE, cell: isDeep ? 2e-3 : 0.01 });
  if (!section) throw new Error('Expected a section.');
  return section;
}

/** Of an upright rail seen from beside. @param {number} away @returns {Cut} */
const beside = (away) => ({ kind: 'plane', origin: [away, 0, 0], u: [0, 1, 0], v: [0, 0, 1] });

const travel = 0.1;
const [upper, lower] = [0.35, 0.15];

/** A shell about a shoulder that a rail carries: out of reach is what is too near to it wherever it stands. */
const shells = armOf(
  ...[sliding([0, QUARTER, 0, 0], [0, travel]), turning([0, QUARTER, 0, 0])],
  ...[upper, lower].map((a) => turning([a, 0, 0, 0])),
);
const away = 0.1;
const [outer, inner] = [upper + lower, upper - lower].map((radius) => Math.sqrt(radius ** 2 - away ** 2));
const lens = 2 * inner ** 2 * Math.acos(travel / 2 / inner) - (travel / 2) * Math.sqrt(4 * inner ** 2 - travel ** 2);
/** @type {Inside} */
const carried = (u, v) =>
  Math.min(
    outer - Math.hypot(u, v - Math.min(travel, Math.max(0, v))),
    Math.max(Math.hypot(u, v), Math.hypot(u, v - travel)) - inner,
  );

/** Two links whose elbow bends one way, in an upright plane that turns about an axis: it ends where the section is. */
const ending = armOf(
  turning([0, QUARTER, 0, 0], [-1, QUARTER]),
  turning([0.3, 0, 0, 0], [-QUARTER, QUARTER]),
  turning([0.2, 0, 0, 0], [0, Math.PI]),
);

/** Three links that turn about a shoulder beside the first axis, and reach over it: in front of it, or behind. */
const over = armOf(turning([0.1, QUARTER, 0, 0], [2, 4]), ...[0.25, 0.15, 0.1].map((a) => turning([a, 0, 0, 0])));
/** @param {number} at @returns {Inside} */
const disc = (at) => both((u, v) => 0.5 - Math.hypot(u - at, v), right);
const discArea = (/** @type {number} */ at) =>
  QUARTER * 0.25 + at * Math.sqrt(0.25 - at ** 2) + 0.25 * Math.asin(at / 0.5);

test.each(
  /** @type {[string, ChainDescription, Cut, Inside, number][]} */ ([
    ['beside a rail', shells, beside(away), carried, 2 * outer * travel + Math.PI * outer ** 2 - lens],
    ['where the arm ends at a limit', ending, beside(0), sector(0.3, 0.2), 2 * Math.PI * 0.3 * 0.2],
    ['at an angle', over, { kind: 'meridian', angle: 3.5 }, disc(0.1), discArea(0.1)],
    ['behind the arm', over, { kind: 'meridian', angle: 3.5 - Math.PI }, disc(-0.1), discArea(-0.1)],
    ...(isDeep ? [['at that of a limit', over, { kind: 'meridian', angle: 4 }, disc(0.1), discArea(0.1)]] : []),
  ]),
)('%s: boundary, area and cells are what its closed form says', (_name, arm, cut, inside, area) => {
  const section = cutOf(arm, cut);
  expect(farthestOff(section, inside)).toBeLessThan(2.5 * TOLERANCE);
  expect(wrongCells(section, inside, 2.5 * TOLERANCE)).toBe(0);
  expect(Math.abs(section.area - area)).toBeLessThan(section.areaError);
  expect(section.areaError).toBeLessThan(40 * TOLERANCE * area);
});

test('of a planar arm, across the plane that it never leaves, there is none', () => {
  expect(sectionAtOnce(createChain(planar([0.5, 0.3, 0.15])), { cut: beside(0.1) })).toBeNull();
});

test('at an angle that the arm cannot turn to, or beyond its reach, there is nothing', () => {
  for (const section of [cutOf(over, { kind: 'meridian', angle: 5 }), cutOf(shells, beside(0.51))])
    expect(section).toMatchObject({ area: 0, outlines: [] });
});

/**
 * Whether two links reach a place by angles inside their limits: the cosine rule, both bends.
 * @param {number[]} place
 * @param {number[]} links
 * @param {number} bent   what the second is bent by at zero
 * @param {number[][]} limits
 */
function isReachedByTwo([x, y], [a, b], bent, limits) {
  const cosine = (x * x + y * y - a * a - b * b) / (2 * a * b);
  if (Math.abs(cosine) > 1) return false;
  return [Math.acos(cosine), -Math.acos(cosine)].some((bend) => {
    const first = Math.atan2(y, x) - Math.atan2(b * Math.sin(bend), a + b * cosine);
    return isWithin(first, limits[0]) && isWithin(bend - bent, limits[1]);
  });
}

/** @param {number} angle @param {number[]} limits */
const isWithin = (angle, [low, high]) =>
  [-1, 0, 1].some((turns) => angle + 2 * Math.PI * turns >= low && angle + 2 * Math.PI * turns <= high);

/** All the way round: no limits. */
const ROUND = [-Math.PI, Math.PI];

/** A rail, a shoulder beside its own axis, and two links. */
const LIMITS = [[-1.7, 1.4], isDeep ? [-0.5, 1.9] : ROUND, [-2.1, -0.2]]; // prettier-ignore
const limited = armOf(
  sliding([0, QUARTER, 0, 0], [0, 0.8]),
  ...[0.05, 0.3, 0.2].map((a, k) => turning([a, k === 0 ? QUARTER : 0, 0, 0], LIMITS[k])),
);

/** With any slide. @type {(u: number, v: number) => boolean} */
const byRail = (u, v) => {
  for (let slide = 0; slide <= 0.8; slide += 0.002) {
    const [ahead, turn] = [Math.hypot(0.15, v - slide), Math.atan2(v - slide, 0.15)];
    for (const [out, q] of [
      [ahead, turn],
      [-ahead, turn + Math.PI],
    ])
      // prettier-ignore
      if (isWithin(q, LIMITS[0]) && isReachedByTwo([out - 0.05, -u], [0.3, 0.2], 0, LIMITS.slice(1))) return true;
  }
  return false;
};

/** Four joints, of which the last brings the tool to either side. */
const SWAYS = [[-1.05, 1.75], isDeep ? [-2.5, 2.5] : ROUND, [-2.8, 2.8], [-2, 2]]; // prettier-ignore
const swaying = armOf(
  turning([0.1, QUARTER, 0, 0], SWAYS[0]),
  turning([0.3, 0, 0, 0], SWAYS[1]),
  turning([0.25, QUARTER, 0, 0], SWAYS[2]),
  turning([0.2, 0, 0.15, 0], SWAYS[3]),
);
const SIDE = -1.22;

/** With the last at any angle. @type {(u: number, v: number) => boolean} */
const bySway = (u, v) => {
  for (let sway = -2; sway <= 2; sway += 0.01) {
    const [fore, side] = [0.25 + 0.2 * Math.cos(sway), -0.2 * Math.sin(sway)];
    if (Math.abs(side) > u) continue;
    const [link, bent] = [Math.hypot(fore, 0.15), Math.atan2(-0.15, fore)];
    for (const out of [1, -1].map((sign) => sign * Math.sqrt(u * u - side * side)))
      if (
        isWithin(SIDE - Math.atan2(side, out), SWAYS[0]) &&
        isReachedByTwo([out - 0.1, v], [0.3, link], bent, SWAYS.slice(1, 3))
      )
        return true;
  }
  return false;
};

describe('the cosine rule and the section agree, but for cells at the boundary,', () => {
  test.each(
    /** @type {[string, ChainDescription, Cut, (u: number, v: number) => boolean][]} */ ([
      ['beside a rail', limited, beside(0.15), byRail],
      ['at an angle that the arm reaches over its axis', swaying, { kind: 'meridian', angle: SIDE }, bySway],
    ]),
  )('%s', (_name, arm, cut, isReached) => {
    const { cells, area, areaError, gap } = cutOf(arm, cut);
    const { size, columns, rows, reached } = cells;
    const random = createRandom(3);
    let [told, wrong] = [0, 0];
    for (let count = 0; count < (isDeep ? 5000 : 250); count++) {
      const [i, j] = [1 + Math.floor(random() * (columns - 2)), 1 + Math.floor(random() * (rows - 2))];
      const k = j * columns + i;
      if (![-1, 0, 1].every((a) => [-1, 0, 1].every((b) => reached[k + a + b * columns] === reached[k]))) continue;
      told++;
      if ((reached[k] === 1) !== isReached(cells.u + (i + 0.5) * size, cells.v + (j + 0.5) * size)) wrong++;
    }
    expect(wrong).toBe(0);
    expect(told).toBeGreaterThan(isDeep ? 4000 : 120);
    expect(gap).toBeLessThan(10 * TOLERANCE);
    expect(areaError).toBeLessThan(0.005 * area);
  });
});
