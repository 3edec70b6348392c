/**
 * Jogging, as on a teach pendant: the tool goes straight along an axis of a frame, or turns about one through its own point,
 * and stops where the arm cannot follow. The way is measured from where the press began, so that however many frames of the
 * screen it takes, it does not drift off its line.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Followed } from '../../kinematics/follow.js'
 * @import { JointDoc, RobotDoc } from '../document.js'
 *
 * @typedef {'world' | 'base' | 'tool' | 'user'} JogFrame
 *
 * @typedef {object} JogStop   why it goes no further
 * @property {'limit' | 'reach' | 'orientation' | 'singularity' | 'freedom' | 'outside'} why
 *   reach: the edge of what the tool can reach. orientation: it could be there, but not so turned. freedom: the arm has no
 *   joint to go that way with. outside: a joint stands past its limits, and has to come back first
 * @property {number} [joint]  with limit and outside
 *
 * @typedef {object} JogPress  a press of a button, from its beginning
 * @property {Float64Array} T_world_start    the tool then
 * @property {readonly number[]} direction   of the way or of the turn's axis, in world axes
 * @property {boolean} isTurn
 * @property {Float64Array} q        where the arm is now, metres and radians
 * @property {number} travelled      metres or radians, with the sign of the direction
 * @property {JogStop | null} stop
 * @property {boolean} isTilting     the tool's place was met, and its orientation could not be kept
 */
import { tcpPose } from '../../kinematics/forward.js';
import { followPose } from '../../kinematics/follow.js';
import { geometricJacobian } from '../../kinematics/jacobian.js';
import { poseFromAxisAngle } from '../../kinematics/orientations/axisAngle.js';
import { compose } from '../../kinematics/pose.js';
import { limitsOf } from '../document.js';
import { LARGEST_NUMBER } from '../documentRules.js';

/** The way is taken in pieces so long at most: metres, radians. */
const PIECE = { way: 0.01, turn: 0.05 };

/** Where it ends is found to this many binary digits of a piece. */
const BISECTIONS = 14;

/** After so many digits a miss is still clear of what a search leaves, and a joint that runs into its limit is so near to it: radians, metres. */
const CLEAR = { digits: 10, gap: 1e-4 };

/** So little of a piece is no way to go: a joint is turning as fast as it may and the tool hardly moves. */
const HARDLY = 1e-3;

/** A piece on which joints go far is taken in so many parts at most. */
const MOST_TAKES = 60;

/** As far as a joint ever has to go at once: radians, or characteristic lengths of a slide. */
const ANY_STEP = Math.PI;

/** A turn that is missed by more than this was not made, metres and radians. */
const MISSED = 1e-6;

/** A direction of which more than this is left by what the joints can do is none of theirs. */
const NONE_OF_THEIRS = 0.5;

/**
 * @param {Chain} chain
 * @param {Float64Array} q
 * @param {Float64Array} T_world_frame  whose axes are meant; of the tool, those that it has now
 * @param {number} axis  0 … 2: along x, y, z; 3 … 5: about them
 * @returns {JogPress}
 */
export function beginJog(chain, q, T_world_frame, axis) {
  const k = 4 * (axis % 3);
  return {
    T_world_start: tcpPose(chain, q),
    direction: [T_world_frame[k], T_world_frame[k + 1], T_world_frame[k + 2]],
    isTurn: axis > 2,
    q: q.slice(),
    travelled: 0,
    stop: firstOutside(chain, q),
    isTilting: false,
  };
}

/**
 * @param {Chain} chain
 * @param {JogPress} press
 * @param {number} amount     metres or radians
 * @param {number} [mostTurn] how far a joint may go for it, radians (of a slide: arm lengths); where it has to go farther the
 *   tool does not come as far; without it, the joints take what they need
 * @returns {JogPress}
 */
export function jogFurther(chain, press, amount, mostTurn) {
  if (press.stop || amount === 0) return press;
  const end = press.travelled + amount;
  const pieces = Math.ceil(Math.abs(amount) / (press.isTurn ? PIECE.turn : PIECE.way));
  const options = mostTurn === undefined ? {} : { mostStep: mostTurn / pieces };
  let now = press;
  for (let k = 1; k <= pieces; k++) {
    const to = k === pieces ? end : press.travelled + (amount * k) / pieces;
    for (let takes = 0; now.travelled !== to; takes++) {
      now = takePiece(chain, now, to, options);
      if (now.stop || (mostTurn !== undefined && now.travelled !== to)) return now;
      if (takes > MOST_TAKES) return { ...now, stop: { why: 'singularity' } };
    }
  }
  return now;
}

/**
 * As far along as the arm follows.
 * @param {Chain} chain
 * @param {JogPress} press
 * @param {number} to
 * @param {{ mostStep?: number }} options
 * @returns {JogPress}
 */
function takePiece(chain, press, to, options) {
  const { travelled: from } = press;
  const tryTo = (/** @type {number} */ travelled) =>
    followPose(chain, { q: press.q }, goalOf(press, travelled), options);
  const isMet = (/** @type {Followed} */ { status, orientationError }) =>
    status === 'there' && !(press.isTurn && orientationError > MISSED);
  /** @param {number} travelled @param {Followed} found @returns {JogPress} */
  const at = (travelled, { q, orientationError }) => {
    return { ...press, q, travelled, isTilting: press.isTilting || orientationError > MISSED };
  };

  const whole = tryTo(to);
  if (isMet(whole)) return at(to, whole);
  let best = press;
  let missed = whole;
  let clear = whole;
  let [on, off] = [0, 1];
  for (let n = 0; n < BISECTIONS; n++) {
    const middle = (on + off) / 2;
    const found = tryTo(from + (to - from) * middle);
    if (isMet(found)) {
      best = at(from + (to - from) * middle, found);
      on = middle;
    } else {
      missed = found;
      if (n < CLEAR.digits) clear = found;
      off = middle;
    }
  }
  const isSlow = whole.status === 'behind' || whole.status === 'singularity';
  if (isSlow && on > HARDLY) return best;
  // A joint that is as fast as it may be hides what it runs into: that shows where the joints take what they need.
  const cause = isSlow ? followPose(chain, { q: best.q }, goalOf(press, to), { mostStep: ANY_STEP }) : missed;
  if (isSlow && isMet(cause)) return { ...best, stop: { why: 'singularity' } };
  // Beyond the limit that the arm has run into there may be another end, or so little left that it tells nothing.
  const reason = [clear, missed].find((end) => runsInto(chain, best.q, end)) ?? cause;
  return { ...best, stop: reasonFor(chain, best, to - from, reason) };
}

/** Whether a posture stands at the limit that ended a way. @param {Chain} chain @param {Float64Array} q @param {Followed} followed */
function runsInto({ packed: { lower, upper } }, q, { status, joint }) {
  if (status !== 'limit' || joint === undefined) return false;
  return Math.min(q[joint] - lower[joint], upper[joint] - q[joint]) < CLEAR.gap;
}

/**
 * @param {Chain} chain
 * @param {JogPress} press
 * @param {number} amount
 * @param {Followed} followed
 * @returns {JogStop}
 */
function reasonFor(chain, press, amount, { status, joint }) {
  if (status === 'limit') return { why: 'limit', joint };
  if (status === 'there' || !hasFreedom(chain, press, amount)) return { why: 'freedom' };
  return { why: status === 'behind' ? 'singularity' : status };
}

/**
 * Whether the arm has joints for such a motion of its tool at all, here or in a posture beside this one: at the edge of the
 * reach it has none for the moment, but a planar arm never has one that lifts it.
 * @param {Chain} chain
 * @param {JogPress} press
 */
function hasFreedom(chain, { q, direction, isTurn }, /** @type {number} */ amount) {
  if (chain.dof >= 6 || amount === 0) return true;
  return [0, 0.3].some((aside) => {
    const beside = q.map((value, i) => value + aside * (i + 1));
    const J = geometricJacobian(chain, beside);
    const rows = isTurn ? 3 : 0;
    const columns = Array.from({ length: chain.dof }, (_, i) => Array.from(J.subarray(6 * i + rows, 6 * i + rows + 3)));
    return Math.hypot(...leftOf(direction, columns)) < NONE_OF_THEIRS;
  });
}

/** What is left of a direction after all that these columns can make of it. @param {readonly number[]} direction @param {number[][]} columns */
function leftOf(direction, columns) {
  /** @type {number[][]} */
  const units = [];
  const without = (/** @type {readonly number[]} */ vector) =>
    units.reduce((rest, unit) => {
      const along = rest[0] * unit[0] + rest[1] * unit[1] + rest[2] * unit[2];
      return rest.map((value, k) => value - along * unit[k]);
    }, Array.from(vector));
  for (const column of columns) {
    const rest = without(column);
    const length = Math.hypot(...rest);
    if (length > 1e-6) units.push(rest.map((value) => value / length));
  }
  return without(direction);
}

/**
 * Where the tool is wanted after so much of the way.
 * @param {JogPress} press
 * @param {number} travelled
 */
function goalOf({ T_world_start, direction, isTurn }, travelled) {
  if (isTurn) {
    const T = compose(poseFromAxisAngle([0, 0, 0], direction, travelled), T_world_start);
    T.set(T_world_start.subarray(12, 15), 12);
    return T;
  }
  const T = T_world_start.slice();
  for (let k = 0; k < 3; k++) T[12 + k] += direction[k] * travelled;
  return T;
}

/** @param {Chain} chain @param {Float64Array} q @returns {JogStop | null} */
function firstOutside({ packed: { lower, upper } }, q) {
  const joint = q.findIndex((value, i) => value < lower[i] - MISSED || value > upper[i] + MISSED);
  return joint < 0 ? null : { why: 'outside', joint };
}

/**
 * One joint by so much, in the document's units, as far as its limits, and no farther than numbers are kept.
 * @param {JointDoc} joint
 * @param {number} value
 * @param {number} amount
 * @param {boolean} keepsLimits
 * @returns {{ value: number, isStopped: boolean }}
 */
export function jogJoint(joint, value, amount, keepsLimits) {
  const { lower, upper } = limitsOf(joint);
  const asked = Number((value + amount).toPrecision(14));
  const wanted = Math.min(LARGEST_NUMBER, Math.max(-LARGEST_NUMBER, asked));
  if (!keepsLimits) return { value: wanted, isStopped: wanted !== asked };
  // One that stands outside may come back, and goes no further out.
  const least = Math.min(lower, value);
  const most = Math.max(upper, value);
  const held = Math.min(most, Math.max(least, wanted));
  return { value: held, isStopped: held !== asked };
}

/** The arm as if it had no limits, for those who have said that they are not to be kept. @param {RobotDoc} robot @returns {RobotDoc} */
export const withoutLimits = (robot) => ({
  ...robot,
  joints: robot.joints.map((joint) => ({ ...joint, lower: undefined, upper: undefined })),
});
