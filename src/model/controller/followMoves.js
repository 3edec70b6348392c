/**
 * Where the joints go along moves, on the branch on which the arm begins, without time: by the postures of joint moves, and
 * along the tool's ways of the others.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { PosturePath } from '../../motion/posturePath.js'
 * @import { Move } from '../../motion/moves.js'
 * @import { PathRefusal } from '../../motion/followPath.js'
 * @import { ToolPath } from '../../motion/toolPath.js'
 *
 * @typedef {object} FollowedMove
 * @property {Chain} chain           with the move's tool
 * @property {PosturePath} path      by the share of the way
 * @property {Float64Array} end      posture
 * @property {(ToolPath & { viaShare?: number }) | null} way   of the tool, and of an arc the share at which it passes the point on
 *   the way; null for a joint move
 */
import { createChain } from '../../kinematics/chain.js';
import { tcpPose } from '../../kinematics/forward.js';
import { followPath, postureOn } from '../../motion/followPath.js';
import { pathMomentAt, straightPath } from '../../motion/posturePath.js';
import { arcPath, hasArc, linePath } from '../../motion/toolPath.js';

/** What decimals may put a joint past the limit that it stands at: rad, m. */
const PAST = { turn: 2e-4, slide: 1e-5 };

/**
 * @param {Chain} chain  with the move's tool
 * @param {Float64Array} from
 * @param {Exclude<Move, { kind: 'wait' }>} move
 * @param {object} [options]
 * @param {boolean} [options.isRounded]  by decimals, beside the poses of an arm with few joints
 * @param {boolean} [options.hasRoom]    a little past the limits, where decimals may put joints
 * @returns {FollowedMove | { message: string }}
 */
export function followMove(chain, from, move, { isRounded = false, hasRoom = false } = {}) {
  if (move.kind === 'joint') {
    return { chain, path: straightPath([0, 1], [from, move.posture]), end: move.posture, way: null };
  }
  const way = wayOf(tcpPose(chain, from), move.kind === 'circular' ? move.via : null, move.T_base_tcp);
  if (!way) return { message: 'no circle passes the three points' };
  const strict = followPath(chain, way, from, { isRounded });
  const isAtLimit = hasRoom && strict.status === 'refused' && strict.reason === 'limit';
  const found = isAtLimit ? followPath(withRoom(chain), way, from, { isRounded }) : strict;
  if (found.status === 'refused') return { message: whyRefused(found) };
  return { chain, path: found.path, end: postureAlong(found.path, 1), way };
}

/**
 * The line between two poses, or the arc past the place of another one; null: no circle passes the three.
 * @param {Float64Array} from
 * @param {Float64Array | null} via
 * @param {Float64Array} to
 * @returns {FollowedMove['way']}
 */
export function wayOf(from, via, to) {
  if (!via) return linePath(from, to);
  const place = via.subarray(12, 15);
  return hasArc(from, place, to) ? arcPath(from, place, to) : null;
}

/** @type {WeakMap<Chain, Chain>} */
const roomy = new WeakMap();

/** The same arm with limits a little farther out. @param {Chain} chain */
function withRoom(chain) {
  const { convention, base, tool, joints } = chain;
  const wider = joints.map((joint) => {
    const room = joint.type === 'prismatic' ? PAST.slide : PAST.turn;
    return { ...joint, lower: joint.lower - room, upper: joint.upper + room };
  });
  const known = roomy.get(chain) ?? createChain({ convention, base, tool, joints: wider });
  roomy.set(chain, known);
  return known;
}

/** The posture at a share of a way. @param {PosturePath} path @param {number} share */
export const postureAlong = (path, share) => pathMomentAt(path, share).posture.slice();

/** Joints of an arm that meets whole poses. */
const FULL = 6;

/** @param {Chain} chain */
export const isFull = ({ dof }) => dof >= FULL;

/** Shares of a way at which two are compared. */
export const SHARES = [0.25, 0.5, 0.75, 1];

/** From in a singular posture the way out of it is not found, but from before it: so much of the way. */
const BEFORE = 1 / 64;

/** The posture on the way itself, between whose knots the path is off by what it promises. @param {FollowedMove} followed @param {number} share */
export function postureOnWay({ chain, path, way }, share) {
  const near = [share, share - BEFORE].map((one) => postureAlong(path, one));
  return way ? postureOn(chain, way, share, near) : near[0];
}

/** The tool there. @param {FollowedMove} followed @param {number} share */
export const toolOnWay = (followed, share) =>
  followed.way && isFull(followed.chain)
    ? followed.way.poseAt(share)
    : tcpPose(followed.chain, postureOnWay(followed, share));

/** Shares of the way so short that the arm is where it began. */
const AT_ONCE = 1e-5;

/** @param {PathRefusal} refused */
function whyRefused({ reason, share }) {
  if (reason === 'singularity' && share < AT_ONCE)
    return 'it stands in a singular posture, from which it cannot go this way';
  return REFUSED[reason] ?? 'the arm cannot follow this way';
}

const REFUSED = /** @type {Readonly<Record<string, string>>} */ ({
  limit: 'a joint would have to go past its limit on the way',
  singularity: 'the way leads to a singular posture',
  reach: 'the way leads out of reach',
  orientation: 'the arm reaches the places on the way, but not so turned',
});
