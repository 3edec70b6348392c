/**
 * RRT-Connect: a tree from either end, one grown a step towards a random posture, the other towards what was gained, as far as it
 * goes. Kuffner & LaValle, RRT-Connect: an efficient approach to single-query path planning, ICRA 2000.
 *
 * @import { Workcell } from '../clearance/workcell.js'
 * @import { JointSpace } from './jointSpace.js'
 * @import { Tree } from './tree.js'
 *
 * @typedef {object} Search
 * @property {Workcell} cell
 * @property {JointSpace} space
 * @property {() => number} random
 * @property {number} margin     m
 * @property {number} within     only postures by which a way no longer than this could lead; Infinity for any
 */
import { touchOnWay } from '../clearance/clearWay.js';
import { apart, between } from './jointSpace.js';
import { createTree, grow, nearestIn, wayTo } from './tree.js';

/** rad: a step of a tree. */
const STEP = 0.25;

/** A random posture is drawn anew so often when none by which a short way leads has come. */
const DRAWS = 30;

/**
 * One iteration at each turn; the last value is the way, from one end to the other, or null when the iterations are spent.
 * @param {Search} search
 * @param {ArrayLike<number>} from
 * @param {ArrayLike<number>} to
 * @param {number} iterations
 * @returns {Generator<void, Float64Array[] | null, void>}
 */
export function* connectTrees(search, from, to, iterations) {
  let grown = createTree(from);
  let other = createTree(to);
  let isForward = true;
  for (let i = 0; i < iterations; i++) {
    const aim = drawn(search, from, to);
    const gained = aim && stepTowards(search, grown, aim, nearestIn(search.space, grown, aim));
    if (aim && gained !== null) {
      const met = /** @type {number} */ (gained);
      const end = leadTo(search, other, grown.postures[met]);
      if (end !== null) {
        const [first, second] = isForward
          ? [wayTo(grown, met), wayTo(other, end)]
          : [wayTo(other, end), wayTo(grown, met)];
        return [...first, ...second.reverse().slice(1)];
      }
    }
    [grown, other, isForward] = [other, grown, !isForward];
    yield;
  }
  return null;
}

/** @param {Search} search @param {ArrayLike<number>} from @param {ArrayLike<number>} to */
function drawn({ space, random, within }, from, to) {
  const posture = new Float64Array(space.dof);
  for (let i = 0; i < DRAWS; i++) {
    for (let j = 0; j < posture.length; j++) posture[j] = space.lower[j] + random() * (space.upper[j] - space.lower[j]);
    if (within === Infinity || apart(space, from, posture) + apart(space, posture, to) < within) return posture;
  }
  return null;
}

/**
 * @param {Search} search
 * @param {Tree} tree
 * @param {Float64Array} aim
 * @param {number} start  index of the posture to go from
 * @returns {number | null}  index of what was gained; null where something stands in the way
 */
function stepTowards({ cell, space, margin }, tree, aim, start) {
  const from = tree.postures[start];
  const far = apart(space, from, aim);
  if (far === 0) return start;
  const to = far <= STEP ? Float64Array.from(aim) : between(from, aim, STEP / far);
  return touchOnWay(cell, from, to, { margin }) === null ? grow(tree, to, start) : null;
}

/**
 * Grows a tree towards a posture as far as it goes.
 * @param {Search} search
 * @param {Tree} tree
 * @param {Float64Array} aim
 * @returns {number | null}  index of that posture in the tree, if it was reached
 */
function leadTo(search, tree, aim) {
  let at = nearestIn(search.space, tree, aim);
  for (;;) {
    const next = stepTowards(search, tree, aim, at);
    if (next === null) return null;
    if (apart(search.space, tree.postures[next], aim) === 0) return next;
    at = next;
  }
}
