/**
 * User frames and tools, as on a controller: kept in one list with ids and numbers, at most one of each kind active. The
 * active tool is what `robot.tool` says, and both change together (ADR 6); a user frame is seen from the world.
 *
 * @import { Doc, FrameDoc, PoseDoc, TargetDoc, Units } from '../document.js'
 *
 * @typedef {FrameDoc['kind']} FrameKind
 */
import { compilePose } from '../compile.js';
import { identityPose } from '../document.js';
import { compose, identity, invert } from '../../kinematics/pose.js';

/** Which of the document's fields names the active frame of a kind. */
export const ACTIVE = /** @type {const} */ ({ tool: 'activeTool', user: 'activeUser' });

/**
 * The active frame of a kind; null where none is: the world, or a tool that is not in the list.
 * @param {Pick<Doc, 'frames' | 'activeTool' | 'activeUser'>} doc
 * @param {FrameKind} kind
 * @returns {FrameDoc | null}
 */
export const activeFrame = (doc, kind) =>
  doc.frames.find((frame) => frame.kind === kind && frame.id === doc[ACTIVE[kind]]) ?? null;

/** What of a thing with a pose is the pose. @param {PoseDoc} pose @returns {PoseDoc} */
export const poseOnly = ({ xyz, rpy, quaternion }) => ({
  xyz: [...xyz],
  ...(rpy && { rpy: [...rpy] }),
  ...(quaternion && { quaternion: [...quaternion] }),
});

/** The same frame elsewhere. @param {FrameDoc} frame @param {PoseDoc} pose @returns {FrameDoc} */
export const atPose = ({ kind, id, number }, pose) => ({
  kind,
  id,
  ...(number !== undefined && { number }),
  ...poseOnly(pose),
});

const NO_TURN = [0, 0, 0];

/**
 * Whether two poses are the same numbers; no orientation is no turn.
 * @param {PoseDoc} one
 * @param {PoseDoc} other
 */
export function agree(one, other) {
  const numbers = (/** @type {PoseDoc} */ { xyz, rpy, quaternion }) => [...xyz, ...(quaternion ?? rpy ?? NO_TURN)];
  const [a, b] = [numbers(one), numbers(other)];
  return a.length === b.length && a.every((value, i) => value === b[i]);
}

/**
 * A tool that is in use and in no list: nothing has its numbers.
 * @param {Doc} doc
 */
export const hasUnlistedTool = (doc) =>
  activeFrame(doc, 'tool') === null &&
  !agree(doc.robot.tool, identityPose()) &&
  !doc.frames.some((frame) => frame.kind === 'tool' && agree(frame, doc.robot.tool));

/** The first of tool_1, tool_2, … that no frame has. @param {readonly FrameDoc[]} frames @param {FrameKind} kind */
export function freeFrameId(frames, kind) {
  const taken = new Set(frames.map(({ id }) => id));
  let number = 1;
  while (taken.has(`${kind}_${number}`)) number++;
  return `${kind}_${number}`;
}

/** The least number that no other of its kind has. @param {readonly FrameDoc[]} frames @param {FrameKind} kind */
export function freeFrameNumber(frames, kind) {
  const taken = new Set(frames.filter((frame) => frame.kind === kind).map(({ number }) => number));
  let number = 1;
  while (taken.has(number)) number++;
  return number;
}

/** The targets that are given in a user frame. @param {Doc} doc @param {string} id */
export const targetsIn = ({ targets }, id) => targets.filter(({ frame }) => frame === id);

/**
 * A user frame seen from the world, a tool seen from the flange; no frame is the world, or the flange itself.
 * @param {FrameDoc | null} frame
 * @param {Units} units
 * @returns {Float64Array} column-major, metres
 */
export const framePose = (frame, units) => (frame ? compilePose(frame, units) : identity());

/**
 * Where a named target is, whatever frame it is given in.
 * @param {Pick<Doc, 'frames' | 'robot'>} doc
 * @param {TargetDoc} target
 * @returns {Float64Array} seen from the world, metres
 */
export function targetPose({ frames, robot: { units } }, target) {
  const T = compilePose(target, units);
  const frame = target.frame !== undefined && frames.find(({ kind, id }) => kind === 'user' && id === target.frame);
  return frame ? compose(compilePose(frame, units), T) : T;
}

/**
 * A pose that is given in the world, as a target in a user frame keeps it.
 * @param {Pick<Doc, 'frames' | 'robot'>} doc
 * @param {string} id  of a user frame
 * @param {Float64Array} T_world_target
 */
export function seenFromUser({ frames, robot: { units } }, id, T_world_target) {
  const frame = frames.find((one) => one.kind === 'user' && one.id === id) ?? null;
  return compose(invert(framePose(frame, units)), T_world_target);
}
