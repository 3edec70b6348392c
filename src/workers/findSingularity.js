/**
 * The nearest singular posture, off the page's thread: a question comes as plain numbers, and the answer goes back with the
 * question's own id.
 *
 * @import { ChainDescription } from '../kinematics/chain.js'
 *
 * @typedef {{ id: number, chain: ChainDescription, q: Float64Array }} FindSingularityQuestion
 */
import { createChain } from '../kinematics/chain.js';
import { distanceToSingularity } from '../kinematics/singularity.js';

self.onmessage = ({ data }) => {
  const { id, chain, q } = /** @type {FindSingularityQuestion} */ (data);
  self.postMessage({ id, found: distanceToSingularity(createChain(chain), q) });
};
