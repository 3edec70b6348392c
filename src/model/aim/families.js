/**
 * Solutions that are not points but a line: the arm can be moved along them while the tool stays. One joint leads, in steps;
 * at each, the others are solved for from where they were, and what came out is judged by forward kinematics.
 *
 * @import { RobotDoc } from '../document.js'
 * @import { Chain } from '../../kinematics/chain.js'
 *
 * @typedef {object} FamilyLine
 * @property {'wrist' | 'shoulder' | 'other'} kind
 * @property {number} leader               the joint that leads, from 0
 * @property {readonly number[]} joints    all that move along it
 * @property {readonly { readonly value: number, readonly posture: readonly number[] }[]} members  in order of the leader's
 *   value; document units, all inside the limits but where the arm stands outside already
 * @property {number} start  which of them is the one that was found
 */
import { createChain } from '../../kinematics/chain.js';
import { followPose } from '../../kinematics/follow.js';
import { tcpPose } from '../../kinematics/forward.js';
import { poseDifference } from '../../kinematics/pose.js';
import { postureFromKernel } from '../compile.js';
import { quantityOf } from '../document.js';
import { fromKernel, toRadians } from '../units.js';

/** How far the leader goes from member to member; a slide goes so many arm lengths. */
const STEP = toRadians(5);
const MOST_STEPS = 72; // to either side: a full turn

/** A member is one if the tool is no farther off than this: metres in arm lengths, radians. */
const THERE = 1e-7;

/** A joint that goes farther than this in a step (radians, arm lengths) has gone to other solutions. */
const SAME_LINE = 0.6;

/**
 * @param {RobotDoc} robot
 * @param {Chain} chain
 * @param {Float64Array} T_world_target
 * @param {{ kind: FamilyLine['kind'], q: Float64Array, joints: readonly number[] }} family
 * @returns {Generator<undefined, FamilyLine>} pauses after each member: all of them may take some tenths of a second
 */
export function* walkFamily(robot, chain, T_world_target, { kind, q, joints }) {
  const leader = joints[0];
  const down = yield* walk(chain, T_world_target, q, leader, -1);
  const up = yield* walk(chain, T_world_target, q, leader, 1);
  const quantity = quantityOf(robot.joints[leader], 'home');
  const members = [...down.reverse(), q, ...up].map((member) => ({
    value: fromKernel(quantity, member[leader], robot.units),
    posture: postureFromKernel(robot, member),
  }));
  return { kind, leader, joints, members, start: down.length };
}

/** All at once. @param {Parameters<typeof walkFamily>} given @returns {FamilyLine} */
export function familyLine(...given) {
  const walking = walkFamily(...given);
  for (;;) {
    const step = walking.next();
    if (step.done) return step.value;
  }
}

/**
 * @param {Chain} chain
 * @param {Float64Array} T
 * @param {Float64Array} q
 * @param {number} leader
 * @param {1 | -1} sense
 * @returns {Generator<undefined, Float64Array[]>}
 */
function* walk(chain, T, q, leader, sense) {
  const { joints } = chain;
  const slides = joints[leader].type === 'prismatic';
  const step = sense * STEP * (slides ? chain.characteristicLength : 1);
  /** @type {Float64Array[]} */
  const members = [];
  let here = q;
  for (let i = 1; i <= MOST_STEPS; i++) {
    const wanted = q[leader] + i * step;
    const value = Math.min(joints[leader].upper, Math.max(joints[leader].lower, wanted));
    if (Math.abs(value - here[leader]) < 1e-9) break;
    const next = held(chain, T, here, leader, value);
    if (!next) break;
    members.push(next);
    here = next;
    yield;
  }
  return members;
}

/**
 * The other joints solved for, with the leader held at a value.
 * @param {Chain} chain
 * @param {Float64Array} T
 * @param {Float64Array} from
 * @param {number} leader
 * @param {number} value
 */
function held(chain, T, from, leader, value) {
  const joints = chain.joints.map((joint, i) => (i === leader ? { ...joint, lower: value, upper: value } : joint));
  const { convention, base, tool, characteristicLength } = chain;
  const seed = from.with(leader, value);
  const { q } = followPose(createChain({ convention, base, tool, joints }), { q: seed }, T, { task: 'pose' });
  const [x, y, z, rx, ry, rz] = poseDifference(tcpPose(chain, q), T);
  if (Math.hypot(x, y, z) > THERE * characteristicLength || Math.hypot(rx, ry, rz) > THERE) return null;
  const goesFar = q.some((each, i) => {
    const way = Math.abs(each - from[i]) / (chain.joints[i].type === 'prismatic' ? characteristicLength : 1);
    return way > SAME_LINE;
  });
  return goesFar ? null : Float64Array.from(q).with(leader, value);
}
