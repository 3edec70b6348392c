/**
 * A motion that running code asks for, as moves of the arm and as a plan in time. The controller counts in millimetres and degrees,
 * in its own way of counting joints, and in the frames that are chosen (codeFrames.js).
 *
 * An approximation: every motion stops at its end. How the speed of a joint motion of KAREL is taken is in moveSettings.js, what becomes
 * of NEAR, AWAY and AXIS in codeOffsets.js.
 *
 * @import { CodeFrames, SystemValues } from './codeFrames.js'
 * @import { Doc } from '../document.js'
 * @import { CodeMove } from '../controller/codeMoves.js'
 * @import { MoveSettings } from '../controller/moveSettings.js'
 * @import { Effect } from '../../karel/run/machine.js'
 * @import { JointLimits, WayMove } from '../../motion/moves.js'
 * @import { MotionPlan } from '../../motion/plan.js'
 * @import { Chain } from '../../kinematics/chain.js'
 */
import { isJoints } from '../../karel/run/positions.js';
import { keyOfText } from '../../karel/run/systemVariables.js';
import { inverseKinematics } from '../../kinematics/inverse.js';
import { compose } from '../../kinematics/pose.js';
import { planMotion } from '../../motion/plan.js';
import { configurationAt } from '../aim/solutions.js';
import { compilePosture, postureFromKernel } from '../compile.js';
import { codeMove, controllerPose } from '../controller/codeMoves.js';
import { pendantValues } from '../controller/controllerValues.js';
import { controllerFrames } from '../controller/frameNumbers.js';
import { FIRST_SPEED, moveSettings } from '../controller/moveSettings.js';
import { limitsOf } from '../program/motionLimits.js';
import { ASSUMED_TOOL_ACCELERATION, ASSUMED_TOOL_TURN, UNREACHED } from '../program/motionPlan.js';
import { toKernel } from '../units.js';
import { codeFrames, OWN_FRAME } from './codeFrames.js';
import { asPlainMove } from './codeOffsets.js';

const MM = /** @type {const} */ ({ length: 'mm', angle: 'deg' });
const INCH = 25.4;
const MINUTE = 60;
/** mm/s and degrees/s of a speed of 1. @type {Readonly<Record<string, number>>} */
const SPEEDS = { 'mm/sec': 1, 'cm/min': 10 / MINUTE, 'inch/min': INCH / MINUTE, 'deg/sec': 1 };

/**
 * @param {Doc} doc
 * @param {readonly number[]} posture  where the arm stands, in document units
 * @param {Effect} effect              of kind 'move', of TP, KAREL or KRL
 * @param {SystemValues} system        variables of the controller
 * @returns {{ plan: MotionPlan, missing: readonly string[] } | { message: string }}
 */
export function planOfMove(doc, posture, effect, system) {
  const found = movesOf(doc, compilePosture(doc.robot, posture), effect, system);
  if ('message' in found) return found;
  const { limits } = limitsOf(doc.robot.joints, doc.robot.units);
  const start = compilePosture(doc.robot, posture);
  let /** @type {Float64Array} */ from = start;
  /** @type {WayMove[]} */
  const moves = [];
  for (const { move, effect: one } of found.moves) {
    const timed = inTime(move, one, from, limits, Number(system.OVERRIDE ?? 100) / 100);
    if ('message' in timed) return timed;
    moves.push(timed);
    from = move.followed.end;
  }
  return { plan: planMotion(found.moves[0].move.followed.chain, start, moves, limits), missing: found.missing };
}

/** What WITH of a MOVE sets for it alone: its frame and its tool, too. @param {Effect} effect @param {SystemValues} system @returns {SystemValues} */
export function withOwnFrames({ settings }, system) {
  const own = Object.entries(settings ?? {}).filter(([name]) => /U(FRAME|TOOL)$/.test(name));
  return own.length === 0
    ? system
    : { ...system, ...Object.fromEntries(own.map(([name, to]) => [keyOfText(name), to])) };
}

/**
 * @param {Doc} doc
 * @param {Float64Array} start
 * @param {Effect} effect
 * @param {SystemValues} controller
 * @returns {{ moves: { move: CodeMove, effect: Effect }[], missing: readonly string[] } | { message: string }}
 */
export function movesOf(doc, start, effect, controller) {
  const system = withOwnFrames(effect, controller);
  const frames = effect.brand === 'kuka' ? { ...controllerFrames(doc, 'kuka'), missing: [] } : codeFrames(doc, system);
  const plain = effect.settings ? asPlainMove(doc, start, effect, system) : effect;
  if ('message' in plain) return { message: String(plain.message) };
  const settings = effect.settings ? moveSettings(effect, system) : null;
  if (settings && 'message' in settings) return settings;
  const asked = settings ? asTp(plain, settings) : [effect];
  if ('message' in asked) return asked;
  let /** @type {Float64Array} */ from = start;
  /** @type {{ move: CodeMove, effect: Effect }[]} */
  const moves = [];
  for (const one of asked) {
    const ready = placed(doc, one, frames, from);
    if ('message' in ready) return { message: String(ready.message) };
    const move = codeMove(doc, frames, from, ready);
    if ('message' in move) return { message: move.message };
    moves.push({ move, effect: one });
    from = move.followed.end;
  }
  if (moves.length === 0) return { message: 'The path that is moved along has no nodes.' };
  return { moves, missing: [...new Set(frames.missing)] };
}

/** MOVE of KAREL, as moves of TP: one, or one for each node. @param {Effect} effect @param {MoveSettings} settings @returns {Effect[] | { message: string }} */
function asTp(effect, { motion, speed }) {
  const { to, via } = effect;
  const places = to === 'ALONG' ? nodesOf(effect.nodes) : [effect.position];
  const isWhole = (/** @type {unknown} */ place) =>
    Array.isArray(place) &&
    place.slice(0, 6).length > 0 &&
    place.slice(0, 6).every((value) => typeof value === 'number');
  if (!places.every(isWhole) || (motion === 'C' && !isWhole(via)))
    return { message: 'A position that is moved to is uninitialised.' };
  return places.map((position) => ({
    ...{ kind: 'move', to: 'TO', line: effect.line, motion, speed, position, isJoint: isJoints(position) },
    ...(motion === 'C' && { via, viaIsJoint: isJoints(via) }),
    termination: { kind: 'FINE' },
    ...{ userFrame: OWN_FRAME, toolFrame: OWN_FRAME },
    settings: null,
  }));
}

/** The positions of a path: its nodes are positions, or structures that begin with one. @param {unknown} nodes @returns {unknown[]} */
const nodesOf = (nodes) =>
  /** @type {unknown[]} */ (nodes).map((node) =>
    Array.isArray(node) ? node : Object.values(/** @type {object} */ (node ?? {})).find(Array.isArray),
  );

/**
 * The same move, with joint values where nothing says in which configuration the arm is to arrive: those nearest to where it comes
 * from. A word of 0 may be one that nobody has set; arms whose postures have no such names have none.
 * @param {Doc} doc
 * @param {Effect} effect
 * @param {CodeFrames} frames
 * @param {Float64Array} from
 * @returns {Effect | { message: string }}
 */
function placed(doc, effect, frames, from) {
  if (effect.motion !== 'J' || effect.isJoint) return effect;
  const chain = frames.chainOf(Number(effect.toolFrame));
  const T_world_user = frames.userPose(Number(effect.userFrame));
  if (!chain || !T_world_user) return effect;
  const { robot } = doc;
  const position = /** @type {number[]} */ (effect.position);
  const isKuka = effect.status !== undefined && effect.turn !== undefined;
  const hasNames = configurationAt(robot, chain, postureFromKernel(robot, from)).fanuc.text !== null;
  const isAsked = isKuka || ((position[6] ?? 0) !== 0 && hasNames && effect.hasStatus !== false);
  const found = inverseKinematics(chain, compose(T_world_user, controllerPose(position)), { seed: from });
  const isMet = found.status === 'converged' || found.status === 'subspace';
  if (!isMet) return { message: UNREACHED[found.reason ?? 'distance'] };
  if (isAsked) return effect;
  return { ...effect, position: pendantValues(robot, postureFromKernel(robot, found.q)), isJoint: true };
}

/**
 * With the speeds that the code says.
 * @param {CodeMove} move
 * @param {Effect} effect
 * @param {Float64Array} from
 * @param {JointLimits} limits
 * @param {number} override  share
 * @returns {WayMove | { message: string }}
 */
function inTime({ kernel, followed, speed }, effect, from, limits, override) {
  const value = speed.value ?? (kernel.kind === 'joint' ? 100 : FIRST_SPEED);
  if (!(value > 0)) return { message: `Expected a speed above 0, got ${value}.` };
  const share = Math.min(1, Number(effect.acceleration ?? 100) / 100);
  const seconds = speed.unit === 'sec' ? value : speed.unit === 'msec' ? value / 10 ** 3 : null;
  const chain = /** @type {Chain} */ (followed.chain);
  if (kernel.kind === 'joint') {
    const rate =
      seconds === null ? (value / 100) * override : shareFor(seconds / override, from, kernel.posture, limits);
    return /** @type {WayMove} */ ({ ...kernel, speed: Math.min(1, rate), acceleration: share });
  }
  const { length, turn } = /** @type {{ length: number, turn: number }} */ (followed.way);
  const isTurn = speed.unit === 'deg/sec';
  const along =
    seconds !== null ? length / seconds : isTurn ? 1 : toKernel('length', value * (SPEEDS[speed.unit] ?? 1), MM);
  const about = seconds !== null ? turn / seconds : isTurn ? toKernel('angle', value, MM) : ASSUMED_TOOL_TURN;
  return /** @type {WayMove} */ ({
    ...kernel,
    ...{ chain, speed: Math.max(along * override, SLOWEST), turnSpeed: Math.max(about * override, SLOWEST) },
    acceleration: ASSUMED_TOOL_ACCELERATION * share,
  });
}

/** m/s and rad/s; a way of no length takes no time at any speed. */
const SLOWEST = 1e-6;

/** The share of the rates at which a joint move takes so long, without the time that it takes to get going. @param {number} seconds @param {Float64Array} from @param {Float64Array} to @param {JointLimits} limits */
function shareFor(seconds, from, to, { rates }) {
  const least = rates.reduce((most, rate, i) => Math.max(most, Math.abs(to[i] - from[i]) / rate), 0);
  return Math.max(least / seconds, SLOWEST);
}
