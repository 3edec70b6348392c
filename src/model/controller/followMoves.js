/**
 * Where the joints go along moves, on the branch on which the arm begins, without time: by the postures of joint moves, and
 * along the tool's ways of the others.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { PosturePath } from '../../motion/posturePath.js'
 * @import { Move } from '../../motion/moves.js'
 *
 * @typedef {object} FollowedMove
 * @property {Chain} chain           with the move's tool
 * @property {PosturePath} path      by the share of the way
 * @property {Float64Array} end      posture
 * @property {{ length: number, turn: number, viaShare?: number } | null} way   of the tool: m, rad, and of an arc the share at
 *   which it passes the point on the way; null for a joint move
 */
import { tcpPose } from '../../kinematics/forward.js';
import { followPath } from '../../motion/followPath.js';
import { pathMomentAt, straightPath } from '../../motion/posturePath.js';
import { arcPath, hasArc, linePath } from '../../motion/toolPath.js';

/**
 * @param {Chain} chain  with the move's tool
 * @param {Float64Array} from
 * @param {Exclude<Move, { kind: 'wait' }>} move
 * @returns {FollowedMove | { message: string }}
 */
export function followMove(chain, from, move) {
  if (move.kind === 'joint') {
    return { chain, path: straightPath([0, 1], [from, move.posture]), end: move.posture, way: null };
  }
  const T_base_from = tcpPose(chain, from);
  const { T_base_tcp } = move;
  if (move.kind === 'circular' && !hasArc(T_base_from, move.via.subarray(12, 15), T_base_tcp))
    return { message: 'no circle passes the three points' };
  const way =
    move.kind === 'circular'
      ? arcPath(T_base_from, move.via.subarray(12, 15), T_base_tcp)
      : linePath(T_base_from, T_base_tcp);
  const found = followPath(chain, way, from);
  if (found.status === 'refused') return { message: REFUSED[found.reason] ?? 'the arm cannot follow this way' };
  return { chain, path: found.path, end: postureAlong(found.path, 1), way };
}

/** The posture at a share of a way. @param {PosturePath} path @param {number} share */
export const postureAlong = (path, share) => pathMomentAt(path, share).posture.slice();

const REFUSED = /** @type {Readonly<Record<string, string>>} */ ({
  limit: 'a joint would have to go past its limit on the way',
  singularity: 'the way leads to a singular posture',
  reach: 'the way leads out of reach',
  orientation: 'the arm reaches the places on the way, but not so turned',
});
