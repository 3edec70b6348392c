/**
 * An arm's body among obstacles, and how near it comes to them, and to itself, in one posture.
 *
 * Neighbours are not held against each other: two stretches that one joint alone moves against each other, or that the links
 * between them are too short to keep apart. Nor is what no joint can move.
 *
 * @import { ArmBodies } from './armBodies.js'
 * @import { Obstacle, PointDistance } from './obstacles.js'
 *
 * @typedef {object} Workcell
 * @property {ArmBodies} bodies
 * @property {readonly { distance: PointDistance, centre: ArrayLike<number>, radius: number }[]} obstacles
 * @property {boolean} looksAtItself
 * @property {{ ends: Float64Array, levers: Float64Array, reach: Float64Array, needs: Needs }} room  for what is reckoned; of this
 *   folder, and never of two looks at once
 *
 * @typedef {object} Nearest   two bodies and what is between them
 * @property {number} distance  m between their surfaces; below 0 where they overlap
 * @property {number} stretch   of the arm
 * @property {number | null} obstacle   index, or null:
 * @property {number | null} other      another stretch of the arm
 *
 * @typedef {Omit<Nearest, 'stretch'> & { link: number }} NearestLinks  the same by links, 0-based; other: another link
 */
import { ENDS, writeEnds } from './armBodies.js';
import { pointDistance, surroundings } from './obstacles.js';
import { segmentFrom, segmentsApart } from './segmentDistance.js';

/**
 * @param {ArmBodies} bodies
 * @param {readonly Obstacle[]} obstacles
 * @param {{ looksAtItself?: boolean }} [options]
 * @returns {Workcell}
 */
export function createWorkcell(bodies, obstacles, { looksAtItself = true } = {}) {
  const { stretches, pairs, chain } = bodies;
  return {
    bodies,
    obstacles: obstacles.map((obstacle) => ({ distance: pointDistance(obstacle), ...surroundings(obstacle) })),
    looksAtItself,
    room: {
      ends: new Float64Array(ENDS * stretches.length),
      levers: new Float64Array(chain.dof * stretches.length),
      reach: new Float64Array(chain.dof),
      needs: { ofStretch: new Float64Array(stretches.length), ofPair: new Float64Array(pairs.length) },
    },
  };
}

/**
 * The two bodies that come nearest to each other; null where there is nothing to come near to.
 * @param {Workcell} cell
 * @param {ArrayLike<number>} q
 * @returns {Nearest | null}
 */
export function clearance(cell, q) {
  writeEnds(cell.bodies, q, cell.room.ends);
  /** @type {Nearest | null} */
  let nearest = null;
  eachDistance(cell, Infinity, null, (found) => {
    if (nearest === null || found.distance < nearest.distance) nearest = { ...found };
    return nearest.distance;
  });
  return nearest;
}

/** @param {ArmBodies} bodies @param {Nearest} near @returns {NearestLinks} */
export const byLinks = ({ stretches }, { distance, stretch, obstacle, other }) => ({
  ...{ distance, obstacle, link: stretches[stretch].link },
  other: other === null ? null : stretches[other].link,
});

/**
 * All that touch in a posture, whatever else is nearer.
 * @param {Workcell} cell
 * @param {ArrayLike<number>} q
 * @returns {Nearest[]}
 */
export function touches(cell, q) {
  writeEnds(cell.bodies, q, cell.room.ends);
  /** @type {Nearest[]} */
  const all = [];
  eachDistance(cell, 0, null, (found) => {
    all.push({ ...found });
    return 0;
  });
  return all;
}

/**
 * The first two bodies that do not keep their distance in a posture, if any do not.
 * @param {Workcell} cell
 * @param {ArrayLike<number>} q
 * @param {Needs} needs
 * @returns {Nearest | null}
 */
export function tooNear(cell, q, needs) {
  writeEnds(cell.bodies, q, cell.room.ends);
  /** @type {Nearest | null} */
  let found = null;
  eachDistance(cell, 0, needs, (near) => {
    found = { ...near };
    return -Infinity;
  });
  return found;
}

/**
 * @typedef {object} Needs  what bodies have to keep, m
 * @property {Float64Array} ofStretch  of each stretch, to every obstacle
 * @property {Float64Array} ofPair     of each pair
 */

/** @type {Nearest} */
const near = { distance: 0, stretch: 0, obstacle: null, other: null };

/**
 * Goes through whatever may touch, and tells of those nearer than the bound and their need together. What is told answers with
 * the next bound; below all distances, it ends.
 * @param {Workcell} cell  its ends written
 * @param {number} bound
 * @param {Needs | null} needs
 * @param {(near: Nearest) => number} tell  the object is the same at each call
 */
function eachDistance({ bodies: { stretches, pairs }, obstacles, looksAtItself, room: { ends } }, bound, needs, tell) {
  for (let i = 0; i < stretches.length; i++) {
    const { radius, moves } = stretches[i];
    if (!moves) continue;
    const at = ENDS * i;
    const x = (ends[at] + ends[at + 3]) / 2;
    const y = (ends[at + 1] + ends[at + 4]) / 2;
    const z = (ends[at + 2] + ends[at + 5]) / 2;
    const half = Math.hypot(ends[at] - x, ends[at + 1] - y, ends[at + 2] - z);
    const need = needs === null ? 0 : needs.ofStretch[i];
    for (let k = 0; k < obstacles.length; k++) {
      const { distance, centre, radius: around } = obstacles[k];
      const atLeast = Math.hypot(x - centre[0], y - centre[1], z - centre[2]) - half - around - radius;
      if (atLeast > bound + need) continue;
      const apart = segmentFrom(ends, at, distance) - radius;
      if (apart > bound + need) continue;
      near.distance = apart;
      near.stretch = i;
      near.obstacle = k;
      near.other = null;
      bound = tell(near);
      if (bound === -Infinity) return;
    }
  }
  if (!looksAtItself) return;
  for (let k = 0; k < pairs.length; k++) {
    const [i, j] = pairs[k];
    const apart = segmentsApart(ends, ENDS * i, ENDS * j) - stretches[i].radius - stretches[j].radius;
    if (apart > bound + (needs === null ? 0 : needs.ofPair[k])) continue;
    near.distance = apart;
    near.stretch = i;
    near.obstacle = null;
    near.other = j;
    bound = tell(near);
    if (bound === -Infinity) return;
  }
}
