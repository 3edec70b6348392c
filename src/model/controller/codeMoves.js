/**
 * What code does, as moves of the arm: the effects of a run (TP, KAREL, KRL) → postures and ways, in the kernel's units. A position
 * with a configuration, or with S and T, is gone to in that one, full turns included.
 *
 * @import { Doc } from '../document.js'
 * @import { ControllerFrames } from './frameNumbers.js'
 * @import { FollowedMove } from './followMoves.js'
 * @import { Effect } from '../../karel/run/machine.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Move } from '../../motion/moves.js'
 *
 * @typedef {object} CodeMove
 * @property {number} line
 * @property {'joint' | 'linear' | 'circular'} motion
 * @property {Exclude<Move, { kind: 'wait' }>} kernel
 * @property {FollowedMove} followed
 * @property {{ value: number | null, unit: string }} speed
 * @property {number} userFrame
 * @property {number} tool
 * @property {boolean} isJoint
 * @property {Float64Array} T_base_said   the tool's pose that the target says, which an arm with few joints may be beside
 * @property {{ kind: string, value?: number }} ending
 * @property {number | null} acceleration   %; null where the language does not say
 * @property {readonly number[] | null} via    of a circular move: the numbers of the point on the way
 * @property {boolean} viaIsJoint
 * @property {string | null} configuration   that it asks for
 */
import { configOf, configText } from '../../karel/run/positions.js';
import { allInverseKinematics } from '../../kinematics/allInverse.js';
import { tcpPose } from '../../kinematics/forward.js';
import { poseFromRollPitchYaw } from '../../kinematics/orientation.js';
import { compose } from '../../kinematics/pose.js';
import { configurationAt } from '../aim/solutions.js';
import { compilePosture, postureFromKernel } from '../compile.js';
import { toKernel } from '../units.js';
import { followMove, isFull, postureAlong } from './followMoves.js';
import { fanucTurns, kukaTurns } from './fullTurns.js';
import { postureFromPendant } from './pendantNumbers.js';

const UNITS = /** @type {const} */ ({ length: 'mm', angle: 'deg' });
const MOTIONS = /** @type {Readonly<Record<string, CodeMove['motion']>>} */ ({
  J: 'joint',
  L: 'linear',
  C: 'circular',
});

/**
 * @param {Doc} doc
 * @param {ControllerFrames} frames
 * @param {Float64Array} from   where the arm stands
 * @param {Effect} effect       of kind move
 * @param {boolean} [isCompared]  with a program: what decimals put past a limit is no fault of the code
 * @returns {CodeMove | { message: string }}
 */
export function codeMove(doc, frames, from, effect, isCompared = false) {
  const { robot } = doc;
  const read = /** @type {MoveEffect} */ (/** @type {unknown} */ (effect));
  const motion = MOTIONS[read.motion];
  if (!motion) return { message: `a motion of the type ${read.motion} is not followed here` };
  const chain = frames.chainOf(read.toolFrame);
  const T_world_user = frames.userPose(read.userFrame);
  if (!chain) return { message: `tool ${read.toolFrame} is not in the document` };
  if (!T_world_user) return { message: `user frame ${read.userFrame} is not in the document` };
  const poseOf = (/** @type {readonly number[]} */ values, /** @type {boolean} */ isJoint) =>
    isJoint ? tcpPose(chain, jointPosture(values)) : compose(T_world_user, controllerPose(values));
  function jointPosture(/** @type {readonly number[]} */ values) {
    return compilePosture(robot, postureFromPendant(robot, values.slice(0, robot.joints.length)));
  }
  if (read.isJoint && read.position.length < robot.joints.length)
    return { message: `${read.position.length} joint values for ${robot.joints.length} joints` };
  const T_target = poseOf(read.position, read.isJoint);
  const asked = askedOf(read);
  /** @type {Float64Array | null} */
  let posture = null;
  if (motion === 'joint') {
    posture = read.isJoint ? jointPosture(read.position) : postureIn(doc, chain, from, T_target, asked);
    if (!posture)
      return { message: `the arm has no posture there${asked ? ` in the configuration ${asked.text}` : ''}` };
  }
  const manner = /** @type {const} */ ({ acceleration: 1, ending: { kind: 'fine' } });
  const tool = { T_base_tcp: T_target, speed: 1, turnSpeed: 1, ...manner };
  /** @type {Exclude<Move, { kind: 'wait' }>} */
  const kernel = posture
    ? { kind: 'joint', posture, speed: 1, ...manner }
    : read.via
      ? { kind: 'circular', via: poseOf(read.via, read.viaIsJoint === true), ...tool }
      : { kind: 'linear', ...tool };
  const followed = followMove(chain, from, kernel, { isRounded: true, hasRoom: isCompared });
  if ('message' in followed) return followed;
  return {
    ...{ line: read.line ?? 0, motion, kernel: asReached(kernel, followed) },
    ...{ followed, speed: read.speed, ending: read.termination },
    ...{ userFrame: read.userFrame, tool: read.toolFrame, isJoint: read.isJoint },
    acceleration: read.acceleration ?? (read.hasStatus === undefined ? 100 : null), // TP is silent of 100
    ...{ T_base_said: T_target, via: read.via ?? null, viaIsJoint: read.viaIsJoint === true },
    configuration: read.isJoint ? null : (asked?.text ?? null),
  };
}

/** An arm with few joints is beside the poses that decimals say: what it is to be planned by is where it is. @param {CodeMove['kernel']} kernel @param {FollowedMove} followed @returns {CodeMove['kernel']} */
function asReached(kernel, { chain, path, way }) {
  if (kernel.kind === 'joint' || isFull(chain)) return kernel;
  const at = (/** @type {number} */ share) => tcpPose(chain, postureAlong(path, share));
  const T_base_tcp = at(1);
  return kernel.kind === 'linear' ? { ...kernel, T_base_tcp } : { ...kernel, T_base_tcp, via: at(way?.viaShare ?? 0) };
}

/**
 * @typedef {object} MoveEffect
 * @property {string} motion
 * @property {readonly number[]} position
 * @property {boolean} isJoint
 * @property {readonly number[]} [via]
 * @property {boolean} [viaIsJoint]
 * @property {{ value: number | null, unit: string }} speed
 * @property {{ kind: string, value?: number }} termination
 * @property {number} userFrame
 * @property {number} toolFrame
 * @property {number} [status]   of KRL
 * @property {number} [turn]
 * @property {boolean} [hasStatus]
 * @property {number} [acceleration]
 * @property {number} [line]
 */

/** x y z w p r, mm and degrees → a pose. @param {readonly number[]} values */
export const controllerPose = (values) =>
  poseFromRollPitchYaw(
    values.slice(0, 3).map((value) => toKernel('length', value, UNITS)),
    values.slice(3, 6).map((value) => toKernel('angle', value, UNITS)),
  );

/** @typedef {{ text: string, isKuka: boolean, turns: readonly number[], turn: number }} Asked */

/** The configuration that an effect asks for. @param {MoveEffect} read @returns {Asked | null} */
function askedOf({ status, turn, position, isJoint, hasStatus }) {
  if (isJoint || hasStatus === false) return null;
  if (status !== undefined && turn !== undefined)
    return { text: `S ${status} T ${turn}`, isKuka: true, turns: [], turn };
  if (hasStatus) return null;
  const word = position[6] ?? 0;
  return {
    text: configText(word),
    isKuka: false,
    turns: [0, 8, 16].map((shift) => (word << (24 - shift)) >> 24),
    turn: 0,
  };
}

/**
 * @param {Doc} doc
 * @param {Chain} chain
 * @param {Float64Array} seed
 * @param {Float64Array} T
 * @param {Asked | null} asked
 * @returns {Float64Array | null}
 */
function postureIn({ robot }, chain, seed, T, asked) {
  const { solutions } = allInverseKinematics(chain, T, { seed });
  for (const { q } of solutions) {
    if (!asked) return q;
    const found = postureFromKernel(robot, q);
    const posture = asked.isKuka ? kukaTurns(robot, found, asked.turn) : fanucTurns(robot, found, asked.turns);
    const { fanuc, kuka } = configurationAt(robot, chain, posture);
    const text = asked.isKuka ? `S ${kuka.status} T ${kuka.turn}` : fanuc.text && configText(configOf(fanuc.text) ?? 0);
    if (text === asked.text) return compilePosture(robot, posture);
  }
  return null;
}
