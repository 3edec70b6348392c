/**
 * What can be said against a command about the named targets.
 *
 * @import { Doc } from '../document.js'
 * @import { Issue } from '../issues.js'
 * @import { TargetCommand } from './targets.js'
 */
import { ID_PATTERN, MAX_LABEL_LENGTH, MAX_TARGETS } from '../documentRules.js';
import { goesTo, inUse, usersIn } from '../program/motionProgram.js';
import { badIndex, issue, shown } from '../refusalParts.js';
import { badPose, badText } from '../robot/robotRefusals.js';

/**
 * @param {Doc} doc
 * @param {TargetCommand} command
 * @returns {Issue | null}
 */
export function targetRefusal(doc, command) {
  const { targets, frames } = doc;
  switch (command.type) {
    case 'add-target':
      if (targets.length >= MAX_TARGETS) {
        return issue('too-many-targets', 'targets', `A model keeps at most ${MAX_TARGETS} named targets.`);
      }
      return (
        badPose('targets', command.pose) ?? badFrame(frames, command.frame) ?? badConfiguration(command.configuration)
      );
    case 'rename-target':
      return badIndex('target', command.index, targets.length) ?? badTargetId(targets, command);
    case 'edit-target':
      return (
        badIndex('target', command.index, targets.length) ??
        badPose(`targets.${command.index}`, command.pose) ??
        badFrame(frames, command.frame) ??
        badConfiguration(command.configuration)
      );
    case 'move-target':
      return badIndex('target', command.index, targets.length) ?? badIndex('target', command.to, targets.length);
    case 'remove-target':
      return badIndex('target', command.index, targets.length) ?? stillUsed(doc, command.index);
    default:
      return null;
  }
}

/** @param {Doc} doc @param {number} index */
function stillUsed(doc, index) {
  const { id } = doc.targets[index];
  const users = usersIn(doc, goesTo(id));
  return users === null ? null : inUse(`targets.${index}`, `Target ${id}`, users);
}

/** @param {Doc['frames']} frames @param {string | undefined} id */
function badFrame(frames, id) {
  if (id === undefined || frames.some((frame) => frame.kind === 'user' && frame.id === id)) return null;
  return issue('frame-unknown', 'targets.frame', `There is no user frame ${shown(id)}.`);
}

/** @param {string | undefined} configuration */
const badConfiguration = (configuration) =>
  configuration === undefined
    ? null
    : badText('The configuration', 'targets.configuration', configuration, MAX_LABEL_LENGTH);

/** @param {Doc['targets']} targets @param {{ index: number, id: string }} command */
function badTargetId(targets, { index, id }) {
  const path = `targets.${index}.id`;
  if (typeof id !== 'string' || !ID_PATTERN.test(id)) {
    return issue('id', path, 'A name is a letter or _, then at most 63 letters, digits or _.');
  }
  if (targets.some((other, i) => i !== index && other.id === id)) {
    return issue('id-taken', path, `Another target is called "${id}" already.`);
  }
  return null;
}
