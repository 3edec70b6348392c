/**
 * Commands for user frames and tools. What can be said against them is in frameRefusals.js.
 *
 * `choose-tool` with a posture moves the arm in the same step: the one in which the new TCP is where the old one was
 * (toolChange.js). A tool that was in use and in no list is put into it before another takes its place, so that its numbers
 * are not lost. An active tool that is removed leaves the flange itself; targets that are given in a removed user frame stay
 * where they are, seen from the world.
 *
 * @import { Doc, FrameDoc, PoseDoc } from '../document.js'
 * @import { FrameKind } from './frames.js'
 *
 * @typedef {{ type: 'add-frame', kind: FrameKind, pose: PoseDoc }
 *   | { type: 'rename-frame', index: number, id: string }
 *   | { type: 'number-frame', index: number, number: number | undefined }
 *   | { type: 'edit-frame', index: number, pose: PoseDoc }
 *   | { type: 'remove-frame', index: number }
 *   | { type: 'choose-tool', index: number | null, posture?: readonly number[] }
 *   | { type: 'choose-user', index: number | null }} FrameCommand  null: the flange itself; the world
 */
import { identityPose } from '../document.js';
import {
  ACTIVE,
  activeFrame,
  agree,
  atPose,
  freeFrameId,
  freeFrameNumber,
  hasUnlistedTool,
  poseOnly,
  targetPose,
  targetsIn,
} from './frames.js';
import { withMoves } from '../program/motionProgram.js';
import { poseInUnits } from '../numbers/poseNumbers.js';
import { isSamePose } from '../samePose.js';

/**
 * @param {Doc} doc
 * @param {FrameCommand} command  that `frameRefusal` has nothing against
 * @returns {Doc} the same object when nothing changed
 */
export function applyFrameCommand(doc, command) {
  const { frames } = doc;
  switch (command.type) {
    case 'add-frame': {
      const added = newFrame(frames, command.kind, command.pose);
      const next = { ...doc, frames: [...frames, added] };
      // the tool that is in use already, and was in no list
      const isInUse = added.kind === 'tool' && hasUnlistedTool(doc) && agree(added, doc.robot.tool);
      return isInUse ? active(next, 'tool', added.id) : next;
    }
    case 'rename-frame':
      return renamed(doc, command.index, command.id);
    case 'number-frame': {
      const { number: old, ...rest } = frames[command.index];
      if (old === command.number) return doc;
      const numbered = { ...rest, ...(command.number !== undefined && { number: command.number }) };
      return { ...doc, frames: frames.with(command.index, numbered) };
    }
    case 'edit-frame': {
      const old = frames[command.index];
      if (isSamePose(old, command.pose)) return doc;
      if (old === activeFrame(doc, 'tool')) return withTool(doc, command.pose);
      return { ...doc, frames: frames.with(command.index, atPose(old, command.pose)) };
    }
    case 'remove-frame':
      return removed(doc, command.index);
    case 'choose-tool':
      return toolChosen(doc, command);
    case 'choose-user': {
      const id = command.index === null ? undefined : frames[command.index].id;
      return doc.activeUser === id ? doc : active(doc, 'user', id);
    }
    default: {
      /** @type {never} */
      const unknown = command;
      throw new TypeError(`Unknown command: ${JSON.stringify(unknown)}`);
    }
  }
}

/**
 * The tool in use with other numbers: in the robot, and in the list if it stands there.
 * @param {Doc} doc
 * @param {PoseDoc} pose
 * @returns {Doc} the same object when nothing changed
 */
export function withTool(doc, pose) {
  const { robot, frames } = doc;
  if (isSamePose(robot.tool, pose)) return doc;
  const tool = poseOnly(pose);
  const inUse = activeFrame(doc, 'tool');
  return {
    ...doc,
    robot: { ...robot, tool },
    ...(inUse && { frames: frames.with(frames.indexOf(inUse), atPose(inUse, tool)) }),
  };
}

/** @param {readonly FrameDoc[]} frames @param {FrameKind} kind @param {PoseDoc} pose @returns {FrameDoc} */
const newFrame = (frames, kind, pose) => ({
  kind,
  id: freeFrameId(frames, kind),
  number: freeFrameNumber(frames, kind),
  ...poseOnly(pose),
});

/** @param {Doc} doc @param {FrameKind} kind @param {string | undefined} id @returns {Doc} */
function active(doc, kind, id) {
  const next = { ...doc };
  if (id === undefined) delete next[ACTIVE[kind]];
  else next[ACTIVE[kind]] = id;
  return next;
}

/** @param {Doc} doc @param {number} index @param {string} id @returns {Doc} */
function renamed(doc, index, id) {
  const old = doc.frames[index];
  if (old.id === id) return doc;
  const frames = doc.frames.with(index, { ...old, id });
  const isActive = doc[ACTIVE[old.kind]] === old.id;
  const field = old.kind === 'tool' ? 'tool' : 'frame';
  const motionPrograms = withMoves(doc.motionPrograms, (move) =>
    move[field] === old.id ? { ...move, [field]: id } : move,
  );
  const next = { ...doc, frames, motionPrograms, ...(isActive && { [ACTIVE[old.kind]]: id }) };
  const options = doc.codeOptions?.replace(RegExp(`\\buserFrame=${old.id}(?= |$)`), `userFrame=${id}`);
  if (old.kind === 'user' && options) next.codeOptions = options;
  if (old.kind !== 'user' || targetsIn(doc, old.id).length === 0) return next;
  return {
    ...next,
    targets: doc.targets.map((target) => (target.frame === old.id ? { ...target, frame: id } : target)),
  };
}

/** @param {Doc} doc @param {number} index @returns {Doc} */
function removed(doc, index) {
  const { kind, id } = doc.frames[index];
  const next = { ...doc, frames: doc.frames.toSpliced(index, 1) };
  if (kind === 'tool') {
    if (doc.activeTool !== id) return next;
    return active({ ...next, robot: { ...doc.robot, tool: identityPose() } }, 'tool', undefined);
  }
  const letGo = doc.activeUser === id ? active(next, 'user', undefined) : next;
  if (targetsIn(doc, id).length === 0) return letGo;
  const targets = doc.targets.map((target) => {
    if (target.frame !== id) return target;
    const { id: name, configuration } = target;
    const pose = poseInUnits(targetPose(doc, target), doc.robot.units);
    return { id: name, ...pose, ...(configuration !== undefined && { configuration }) };
  });
  return { ...letGo, targets };
}

/** @param {Doc} doc @param {Extract<FrameCommand, { type: 'choose-tool' }>} command @returns {Doc} */
function toolChosen(doc, { index, posture }) {
  const chosen = index === null ? null : doc.frames[index];
  const tool = chosen ? poseOnly(chosen) : identityPose();
  const isSame = doc.activeTool === chosen?.id && isSamePose(doc.robot.tool, tool);
  const stays = posture === undefined || posture.every((value, i) => value === doc.posture[i]);
  if (isSame && stays) return doc;
  const frames = hasUnlistedTool(doc) ? [...doc.frames, newFrame(doc.frames, 'tool', doc.robot.tool)] : doc.frames;
  const robot = isSamePose(doc.robot.tool, tool) ? doc.robot : { ...doc.robot, tool };
  return active(
    { ...doc, robot, frames, posture: posture === undefined || stays ? doc.posture : [...posture] },
    'tool',
    chosen?.id,
  );
}
