/**
 * What can be said against a command about user frames and tools.
 *
 * @import { Doc } from '../document.js'
 * @import { Issue } from '../issues.js'
 * @import { FrameCommand } from './frameCommands.js'
 */
import { ID_PATTERN, LARGEST_NUMBER, MAX_FRAMES } from '../documentRules.js';
import { hasUnlistedTool, targetPose, targetsIn } from './frames.js';
import { inUse, isIn, usersIn } from '../program/motionProgram.js';
import { poseInUnits } from '../numbers/poseNumbers.js';
import { badChoice, badIndex, badPosture, issue, shown } from '../refusalParts.js';
import { badPose } from '../robot/robotRefusals.js';

const KINDS = ['user', 'tool'];
const WORD = { user: 'user frame', tool: 'tool' };

/**
 * @param {Doc} doc
 * @param {FrameCommand} command
 * @returns {Issue | null}
 */
export function frameRefusal(doc, command) {
  const { frames } = doc;
  if (command.type === 'add-frame') {
    return badChoice('the kind', 'frames', command.kind, KINDS) ?? noRoom(frames) ?? badPose('frames', command.pose);
  }
  if (command.type === 'choose-tool' || command.type === 'choose-user') return badChoiceOf(doc, command);
  const bad = badIndex('frame', command.index, frames.length);
  if (bad) return bad;
  switch (command.type) {
    case 'rename-frame':
      return badFrameId(frames, command);
    case 'number-frame':
      return badFrameNumber(frames, command);
    case 'edit-frame':
      return badPose(`frames.${command.index}`, command.pose);
    case 'remove-frame':
      return stillUsed(doc, command.index) ?? targetsBeyond(doc, command.index);
    default:
      return null;
  }
}

/** @param {Doc['frames']} frames */
function noRoom({ length }) {
  if (length < MAX_FRAMES) return null;
  return issue('too-many-frames', 'frames', `A model keeps at most ${MAX_FRAMES} user frames and tools.`);
}

/** @param {Doc} doc @param {Extract<FrameCommand, { type: 'choose-tool' | 'choose-user' }>} command */
function badChoiceOf(doc, command) {
  const { frames, posture } = doc;
  const { index } = command;
  const kind = command.type === 'choose-tool' ? 'tool' : 'user';
  const bad = index === null ? null : badIndex('frame', index, frames.length);
  if (bad) return bad;
  if (index !== null && frames[index].kind !== kind) {
    return issue('choice', 'frames', `Frame ${shown(frames[index].id)} is no ${WORD[kind]}.`);
  }
  if (command.type === 'choose-user') return null;
  return (
    (command.posture === undefined ? null : badPosture(command.posture, posture.length)) ??
    (hasUnlistedTool(doc) ? noRoom(frames) : null)
  );
}

/** @param {Doc['frames']} frames @param {{ index: number, id: string }} command */
function badFrameId(frames, { index, id }) {
  const path = `frames.${index}.id`;
  if (typeof id !== 'string' || !ID_PATTERN.test(id)) {
    return issue('id', path, 'A name is a letter or _, then at most 63 letters, digits or _.');
  }
  const other = frames.find((frame, i) => i !== index && frame.id === id);
  return other ? issue('id-taken', path, `Another ${WORD[other.kind]} is called "${id}" already.`) : null;
}

/** @param {Doc['frames']} frames @param {{ index: number, number: number | undefined }} command */
function badFrameNumber(frames, { index, number }) {
  const path = `frames.${index}.number`;
  if (number === undefined) return null;
  if (!Number.isInteger(number) || number < 1 || number > LARGEST_NUMBER) {
    return issue('number', path, `The number of a frame is a whole number above 0; got ${shown(number)}.`);
  }
  const { kind } = frames[index];
  const other = frames.find((frame, i) => i !== index && frame.kind === kind && frame.number === number);
  return other ? issue('number-taken', path, `The ${WORD[kind]} ${other.id} has the number ${number} already.`) : null;
}

/** @param {Doc} doc @param {number} index */
function stillUsed(doc, index) {
  const { kind, id } = doc.frames[index];
  const users = usersIn(doc, isIn(id));
  return users === null ? null : inUse(`frames.${index}`, `The ${WORD[kind]} ${id}`, users);
}

/** Targets in a frame that goes are then seen from the world, where no number is beyond what a document holds. @param {Doc} doc @param {number} index */
function targetsBeyond(doc, index) {
  const { kind, id } = doc.frames[index];
  const isHeld = (/** @type {Doc['targets'][number]} */ target) =>
    poseInUnits(targetPose(doc, target), doc.robot.units).xyz.every((value) => Math.abs(value) <= LARGEST_NUMBER);
  if (kind === 'tool' || targetsIn(doc, id).every(isHeld)) return null;
  return issue('number', `frames.${index}`, 'Seen from the world, a target in this frame would be beyond 10⁹.');
}
