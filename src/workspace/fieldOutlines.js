/**
 * The outlines of a section whose sides are not told by closed-form inverse kinematics: its curves part the plane into fields, each
 * of which is reached or not, and the border between the two is the outline.
 *
 * Whatever place was not come to, the nearest one to it is on the boundary, and the way that is missing is square to that: so there
 * is a curve. If none was known it is followed from there, and all is looked at again. Where a curve's end met nothing the border
 * is closed by a line, which is the gap that is stated.
 *
 * @import { Drawn } from './criticalPostures.js'
 * @import { Arrival, GoTo } from './goneTo.js'
 * @import { Outline } from './outline.js'
 * @import { SectionMap } from './sectionMap.js'
 * @import { Traced, Vertex } from './traced.js'
 *
 * @typedef {{ stage: 'curves' | 'sides' | 'volume', share: number }} SectionProgress
 */
import { arranged } from './arrangement.js';
import { criticalFrom, isDrawn } from './criticalPostures.js';
import { leaksOf } from './leaks.js';
import { onlyOnce } from './outline.js';
import { outlinesBetween, reachedFields } from './reachedFields.js';

/** So often it is looked again. */
const ROUNDS = 4;

/**
 * @param {SectionMap} map
 * @param {Traced[]} curves  added to
 * @param {GoTo} goTo
 * @param {Drawn} drawn      all of them
 * @param {number} tolerance
 * @returns {Generator<SectionProgress, Outline[]>}
 */
export function* outlinesOfFields(map, curves, goTo, drawn, tolerance) {
  /** @type {[Vertex, Vertex][]} */
  const bridges = [];
  for (let round = 1; ; round++) {
    const before = curves.length + bridges.length;
    const pieces = curves.flatMap((curve) =>
      curve.vertices.slice(1).map((to, i) => ({ from: curve.vertices[i], to, curve })),
    );
    const arrangement = arranged(onlyOnce(pieces, tolerance, true), bridges, tolerance);
    /** @param {number} u @param {number} v @param {Arrival} arrival */
    const fellShort = (u, v, { x, ...at }) => {
      if (isDrawn(drawn, at, tolerance)) return;
      curves.push(...criticalFrom(map, tolerance, drawn, { x, theta: Math.atan2(v - at.v, u - at.u) }));
    };
    const asking = reachedFields(arrangement, goTo, tolerance, fellShort);
    let step = asking.next();
    for (; !step.done; step = asking.next()) yield { stage: 'sides', share: step.value };
    const fields = step.value;
    if (round < ROUNDS && curves.length + bridges.length === before)
      for (const ring of fields.mixed) bridges.push(...leaksOf(arrangement, ring, goTo, tolerance));
    if (round === ROUNDS || curves.length + bridges.length === before) return outlinesBetween(arrangement, fields);
  }
}
