/**
 * A tree of postures in joint space, as one end of a search grows it.
 *
 * @import { JointSpace } from './jointSpace.js'
 *
 * @typedef {object} Tree
 * @property {Float64Array[]} postures  the first is the root
 * @property {number[]} parents         by index; the root's is -1
 */

/** @param {ArrayLike<number>} root @returns {Tree} */
export const createTree = (root) => ({ postures: [Float64Array.from(root)], parents: [-1] });

/** @param {Tree} tree @param {Float64Array} posture @param {number} parent @returns {number} its index */
export function grow(tree, posture, parent) {
  tree.parents.push(parent);
  return tree.postures.push(posture) - 1;
}

/** The posture of the tree that is nearest to another. @param {JointSpace} space @param {Tree} tree @param {ArrayLike<number>} to */
export function nearestIn({ dof, weights }, { postures }, to) {
  let best = 0;
  let least = Infinity;
  for (let i = 0; i < postures.length; i++) {
    const posture = postures[i];
    let sum = 0;
    for (let j = 0; j < dof && sum < least; j++) {
      const way = weights[j] * (posture[j] - to[j]);
      sum += way * way;
    }
    if (sum < least) {
      least = sum;
      best = i;
    }
  }
  return best;
}

/** From the root to a posture. @param {Tree} tree @param {number} index */
export function wayTo({ postures, parents }, index) {
  const way = [];
  for (let i = index; i !== -1; i = parents[i]) way.push(postures[i]);
  return way.reverse();
}
