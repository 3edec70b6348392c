/**
 * Why a plan does otherwise than it was asked to.
 *
 * @import { PathRefusal } from './followPath.js'
 *
 * @typedef {'last' | 'wait' | 'still' | 'short' | 'law' | PathRefusal['reason']} NotBlended
 *   last: no move follows, or one that is refused. wait: a wait follows. still: one of both has no way to go. short: the zone would
 *   have no length. law: one of both is by a law that goes on only into its own. The others: the postures of the zone, as of a path
 *   that is refused
 *
 * @typedef {object} MotionRefusal
 * @property {number} move
 * @property {PathRefusal['reason'] | 'arc'} reason   arc: no circle passes the three points
 * @property {number} share     of the move's way, where it can be gone to
 * @property {Float64Array} posture   there
 * @property {number} [joint]   with limit: the joint that would have to go past it
 */
export {};
