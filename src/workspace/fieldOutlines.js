/**
 * The outlines of a section whose sides are not told by closed-form inverse kinematics: its curves part the plane into fields, each
 * of which is reached or not, and the border between the two is the outline.
 *
 * Whatever place was not come to, the nearest one to it is on the boundary, and the way that is missing is square to that: so there
 * is a curve. If none was known it is followed from there, and all is looked at again. Where a curve's end met nothing the border
 * is closed by a line, which is the gap that is stated.
 *
 * @import { Drawn, FellShort } from './criticalPostures.js'
 * @import { GoTo } from './goneTo.js'
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

/** Not nothing, m. */
const TINY = 1e-9;

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
  // the axis of a half-plane is its edge, whatever is brought there
  const isBrought = (/** @type {Vertex} */ { x, u }) =>
    (map.kind === 'meridian' && u === 0) || (map.write(x), map.isBrought());
  for (let round = 1; ; round++) {
    const before = curves.length + bridges.length;
    const pieces = curves
      .flatMap((curve) => curve.vertices.slice(1).map((to, i) => ({ from: curve.vertices[i], to, curve })))
      .filter(({ from, to }) => isBrought(from) || isBrought(to));
    const once = onlyOnce(pieces, tolerance, true);
    yield { stage: 'sides', share: 0 };
    const arranging = arranged(once, bridges, tolerance);
    let part = arranging.next();
    for (; !part.done; part = arranging.next()) yield { stage: 'sides', share: 0 };
    const arrangement = part.value;
    /** @type {(FellShort & { u: number, v: number })[]} */
    const short = [];
    const asking = reachedFields(arrangement, goTo, tolerance, (u, v, { x, beside, held, ...at }) => {
      const [du, dv] = [u - at.u, v - at.v];
      short.push({
        x,
        theta: Math.atan2(dv, du),
        mu: beside / Math.max(TINY, Math.hypot(du, dv)),
        held,
        u: at.u,
        v: at.v,
      });
    });
    let step = asking.next();
    for (; !step.done; step = asking.next()) {
      yield { stage: 'sides', share: step.value };
      for (const from of short.splice(0)) {
        if (isDrawn(drawn, from, tolerance)) continue;
        const following = criticalFrom(map, tolerance, drawn, from);
        let more = following.next();
        for (; !more.done; more = following.next()) yield { stage: 'sides', share: step.value };
        curves.push(...more.value);
      }
    }
    const fields = step.value;
    if (round < ROUNDS && curves.length + bridges.length === before)
      for (const ring of fields.mixed) bridges.push(...leaksOf(arrangement, ring, goTo, tolerance));
    if (round === ROUNDS || curves.length + bridges.length === before) return outlinesBetween(arrangement, fields);
  }
}
