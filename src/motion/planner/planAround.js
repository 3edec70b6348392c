/**
 * A way around obstacles from one posture to another: as often as its iterations allow, two trees are grown until they meet, the way is
 * shortened, and the next try looks only where a shorter one could lead. What it answers is clear all along, by proof
 * (clearWay.js); where it finds none it says only that: it never knows that there is none.
 *
 * @import { NearestLinks, Workcell } from '../clearance/workcell.js'
 *
 * @typedef {object} FoundWay
 * @property {'found'} status
 * @property {Float64Array[]} way   postures, both ends among them; between two, every joint goes straight
 * @property {number} length        of the way in joint space (jointSpace.js)
 * @property {number} iterations    spent in all
 *
 * @typedef {{ status: 'not-found', iterations: number }} NoWay
 * @typedef {{ status: 'start' | 'goal', touch: NearestLinks }} BlockedEnd   an end that is not clear itself
 *
 * @typedef {object} PlanOptions
 * @property {number} [seed]
 * @property {number} [iterations]  in all
 * @property {number} [ways]        so many are found, and the shortest is taken
 * @property {number} [margin]      m, kept to obstacles
 */
import { createRandom } from '../../kinematics/random.js';
import { touchOnWay } from '../clearance/clearWay.js';
import { byLinks } from '../clearance/workcell.js';
import { connectTrees } from './connectTrees.js';
import { jointSpace, lengthOf } from './jointSpace.js';
import { shorten, withoutNeedless } from './shorten.js';

/** A pair of trees that has not met by now is given up for a fresh one: rarely, luck was bad. */
const PATIENCE = 2500;

/** A shorter way is looked for no longer than this at a time. */
const HOPE = 300;

/** Cuts that are tried for every way that is found. */
const CUTS = 150;

/**
 * Yields the iterations spent, one by one, so that whoever asks can show progress, or stop.
 * @param {Workcell} cell
 * @param {ArrayLike<number>} from
 * @param {ArrayLike<number>} to
 * @param {PlanOptions} [options]
 * @returns {Generator<number, FoundWay | NoWay | BlockedEnd, void>}
 */
export function* planAround(cell, from, to, { seed = 1, iterations = 10_000, ways = 6, margin = 0 } = {}) {
  for (const [status, end] of /** @type {const} */ ([
    ['start', from],
    ['goal', to],
  ])) {
    const touch = touchOnWay(cell, end, end, { margin });
    if (touch !== null) return { status, touch: byLinks(cell.bodies, touch) };
  }
  const straight = [Float64Array.from(from), Float64Array.from(to)];
  const space = jointSpace(cell.bodies.chain, from, to);
  if (touchOnWay(cell, from, to, { margin }) === null)
    return { status: 'found', way: straight, length: lengthOf(space, straight), iterations: 0 };

  const random = createRandom(seed);
  /** @type {FoundWay | null} */
  let best = null;
  let spent = 0;
  for (let k = 0; k < ways && spent < iterations;) {
    const search = { cell, space, random, margin, within: best?.length ?? Infinity };
    const trees = connectTrees(search, from, to, Math.min(best ? HOPE : PATIENCE, iterations - spent));
    let turn = trees.next();
    for (; !turn.done; turn = trees.next()) yield ++spent;
    k += turn.value === null && best === null ? 0 : 1;
    if (turn.value === null) continue;
    const way = withoutNeedless(search, shorten(search, turn.value, CUTS));
    const length = lengthOf(space, way);
    if (best === null || length < best.length) best = { status: 'found', way, length, iterations: spent };
  }
  return best === null ? { status: 'not-found', iterations: spent } : { ...best, iterations: spent };
}

/**
 * The same without a pause.
 * @param {Parameters<typeof planAround>} given
 * @returns {FoundWay | NoWay | BlockedEnd}
 */
export function planAtOnce(...given) {
  const plan = planAround(...given);
  for (;;) {
    const turn = plan.next();
    if (turn.done) return turn.value;
  }
}
