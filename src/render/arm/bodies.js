/**
 * A chain as rigid bodies: each link lies between two joint axes, whatever the convention. A link's *body frame* has the
 * joint that moves it as z axis, at the far end of its offset d, and x along its length a; its *next frame* is the body
 * frame moved by a and turned by alpha: there z is the axis of the following joint, or the flange's.
 *
 * With standard DH the frame that the kernel gives a link is its next frame, with modified DH its body frame; so a picture
 * that is built on body frames is the same for both.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Pose } from '../../kinematics/pose.js'
 *
 * @typedef {object} Body
 * @property {boolean} slides   whether its joint does; the fixed link 0 has none
 * @property {number} theta     constants of the row, as in standard DH
 * @property {number} d
 * @property {number} a
 * @property {number} alpha
 * @property {number} low       where a slide's d is, at its limits
 * @property {number} high
 * @property {Pose} T_link_body  from the kernel's frame of this link
 * @property {Pose} T_body_next
 */
import { poseFromRollPitchYaw } from '../../kinematics/orientation.js';
import { compose, identity, invert, position } from '../../kinematics/pose.js';

/** What is shorter is no length at all, in metres; and how large an arm of nothing else is drawn. */
const NOTHING = 1e-9;
const SIZE_OF_NOTHING = 0.3;

/**
 * @param {Chain} chain
 * @returns {{ bodies: Body[], size: number }}  link 0 … link n, and the length that everything else is drawn in proportion
 *   to: that of all links laid end to end, in metres, never zero
 */
export function bodiesOf({ convention, joints, tool }) {
  const isModified = convention === 'modified';
  const last = joints.length;
  const links = joints.reduce((sum, { type, a, d, lower, upper }, i) => {
    const travel = type === 'prismatic' ? [lower, upper].filter(Number.isFinite) : [];
    const along = Math.max(Math.abs(d), ...travel.map((q) => Math.abs(d + q)));
    return sum + Math.hypot(isModified ? (joints[i + 1]?.a ?? 0) : a, along);
  }, 0);
  const size = [links, Math.hypot(...position(tool))].find((length) => length > NOTHING) ?? SIZE_OF_NOTHING;
  const bodies = Array.from({ length: last + 1 }, (_, i) => {
    const joint = joints[i - 1];
    // a modified row holds the length and twist of the link before
    const { a, alpha } = (isModified ? joints[i] : joint) ?? { a: 0, alpha: 0 };
    const T_body_next = poseFromRollPitchYaw([a, 0, 0], [alpha, 0, 0]);
    const shape = { slides: joint?.type === 'prismatic', theta: joint?.theta ?? 0, d: joint?.d ?? 0 };
    const travel = joint ? travelOf(joint, size) : { low: 0, high: 0 };
    // the base is no link of the table: all it has is a frame 1 that may begin elsewhere
    if (i === 0) return { ...shape, ...travel, a: 0, alpha: 0, T_link_body: T_body_next, T_body_next: identity() };
    return { ...shape, ...travel, a, alpha, T_link_body: isModified ? identity() : invert(T_body_next), T_body_next };
  });
  return { bodies, size };
}

/**
 * An unlimited slide is drawn a good piece long; the rod that always reaches its far end shows it going farther.
 * @param {Chain['joints'][number]} joint
 * @param {number} size
 */
function travelOf({ d, lower, upper }, size) {
  const piece = size / 2;
  const isFree = !Number.isFinite(lower) && !Number.isFinite(upper);
  const from = Number.isFinite(lower) ? lower : isFree ? -piece / 2 : upper - piece;
  const to = Number.isFinite(upper) ? upper : from + piece;
  return { low: d + from, high: d + to };
}

/**
 * The axis of joint k (counted from 1), before it moves, seen from the kernel's frame of the link before.
 * @param {readonly Body[]} bodies
 * @param {number} k
 * @returns {Pose}
 */
export const axisInLink = (bodies, k) => compose(bodies[k - 1].T_link_body, bodies[k - 1].T_body_next);
