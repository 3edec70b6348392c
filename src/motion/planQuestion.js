/**
 * What has to be planned, as plain data that can be posted to another thread, and its answer there. Chains become their
 * descriptions and chains again; moves with the same tool have the same one on both sides.
 *
 * @import { Chain, ChainDescription } from '../kinematics/chain.js'
 * @import { JointLimits, Move, Wait } from './moves.js'
 *
 * @typedef {Move extends infer One ? One extends Wait ? One : Omit<One, 'chain'> & { chain?: ChainDescription } : never} PlainMove
 *
 * @typedef {object} PlanQuestion
 * @property {ChainDescription} chain
 * @property {Float64Array} start
 * @property {readonly PlainMove[]} moves
 * @property {JointLimits} limits
 */
import { createChain } from '../kinematics/chain.js';
import { planMotion } from './plan.js';

/**
 * @param {Chain} chain
 * @param {Float64Array} start
 * @param {readonly Move[]} moves
 * @param {JointLimits} limits
 * @returns {PlanQuestion}
 */
export function planQuestion(chain, start, moves, limits) {
  const describe = once(
    /** @returns {ChainDescription} */
    (/** @type {Chain} */ { convention, base, tool, joints }) => ({ convention, base, tool, joints }),
  );
  return {
    chain: describe(chain),
    start,
    moves: moves.map((move) =>
      'chain' in move && move.chain ? { ...move, chain: describe(move.chain) } : /** @type {PlainMove} */ (move),
    ),
    limits,
  };
}

/**
 * @param {PlanQuestion} question
 * @param {(planned: number) => void} [onMove]
 */
export function answerPlanQuestion({ chain, start, moves, limits }, onMove) {
  const chainOf = once(createChain);
  const own = moves.map((move) =>
    'chain' in move && move.chain ? { ...move, chain: chainOf(move.chain) } : /** @type {Move} */ (move),
  );
  return planMotion(chainOf(chain), start, own, limits, { onMove });
}

/** The same answer to the same thing. @template {object} A @template B @param {(asked: A) => B} make @returns {(asked: A) => B} */
function once(make) {
  /** @type {Map<A, B>} */
  const made = new Map();
  return (asked) => {
    const known = made.get(asked);
    if (known !== undefined) return known;
    const fresh = make(asked);
    made.set(asked, fresh);
    return fresh;
  };
}
