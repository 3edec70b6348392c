/**
 * All solutions of an arm that has to be searched, off the page's thread: a question comes as plain numbers, and the answer
 * goes back with the question's own id.
 *
 * @import { ChainDescription } from '../kinematics/chain.js'
 *
 * @typedef {object} SolveAllQuestion
 * @property {number} id
 * @property {ChainDescription} chain
 * @property {Float64Array} T
 * @property {Float64Array} seed
 */
import { allInverseKinematics } from '../kinematics/allInverse.js';
import { createChain } from '../kinematics/chain.js';

self.onmessage = ({ data }) => {
  const { id, chain, T, seed } = /** @type {SolveAllQuestion} */ (data);
  self.postMessage({ id, all: allInverseKinematics(createChain(chain), T, { seed }) });
};
