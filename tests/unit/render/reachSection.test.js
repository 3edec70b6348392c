/** The section in the scene: it covers what is reached, and is made in pieces. */
import { describe, expect, it } from 'vitest';
import { sectionOf } from '../../../src/render/marks/reachSection.js';
import { skinOf } from '../../../src/render/skins.js';

/** @import { Group, Mesh } from 'three' */
/** @import { SectionWanted } from '../../../src/render/marks/reachSection.js' */

/** A square about a place, turning left, or right if it is a hole. @param {number} u @param {number} v @param {number} half */
const square = (u, v, half, isHole = false) => {
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => [u + a * half, v + b * half]); // prettier-ignore
  const area = 4 * half * half;
  return { places: Float64Array.from((isHole ? corners.reverse() : corners).flat()), area: isHole ? -area : area };
};

const SKIN = skinOf('light', () => '#000000');
const outlines = [square(0, 0, 3), square(0, 0, 2, true), square(0, 0, 1), square(10, 0, 2)];
const section = /** @type {SectionWanted} */ (
  /** @type {unknown} */ ({
    kind: 'plane',
    frame: { origin: [1, 2, 3], u: [0, 1, 0], v: [0, 0, 1] },
    cells: { size: 0.1, columns: 160, rows: 60, u: -3, v: -3, reached: new Uint8Array(160 * 60).fill(1) },
    outlines,
  })
);

/** @param {import('three').BufferGeometry} geometry */
function areaOf({ index, attributes: { position } }) {
  let area = 0;
  for (let k = 0; k < (index?.count ?? 0); k += 3) {
    const [a, b, c] = [0, 1, 2].map((i) => index?.getX(k + i) ?? 0);
    const [y, z] = [(/** @type {number} */ i) => position.getY(i), (/** @type {number} */ i) => position.getZ(i)];
    area += Math.abs((y(b) - y(a)) * (z(c) - z(a)) - (z(b) - z(a)) * (y(c) - y(a))) / 2;
  }
  return area;
}

describe('the section in the scene', () => {
  it.each([
    ['its outlines', outlines, outlines.reduce((sum, { area }) => sum + area, 0)],
    ['the cells of its first picture', [], 16 * 6],
  ])('covers what %s enclose, and is not made in the frame that asks for it', (_, given, area) => {
    /** @type {Group[]} */
    const made = [];
    const work = sectionOf({ ...section, outlines: given }, SKIN, (group) => void made.push(group));
    work.next();
    expect(made).toEqual([]);
    // one region after the other
    for (const { area: each } of given) {
      if (each > 0) expect(work.next().done).toBe(false);
    }
    expect(work.next().done).toBe(true);
    const { geometry } = /** @type {Mesh} */ (made[0].children[0]);
    expect(areaOf(geometry)).toBeCloseTo(area, 9);
    expect(geometry.attributes.position.getX(0)).toBe(1);
  });
});
