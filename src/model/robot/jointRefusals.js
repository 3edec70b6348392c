/**
 * What can be said against a command that changes which joints a robot has.
 *
 * @import { JointDoc } from '../document.js'
 * @import { Issue } from '../issues.js'
 * @import { JointCommand } from './jointCommands.js'
 */
import { MAX_JOINTS, MIN_JOINTS } from '../document.js';
import { JOINT_TYPES } from '../documentRules.js';
import { badChoice, badIndex, issue } from '../refusalParts.js';

/**
 * @param {readonly JointDoc[]} joints
 * @param {JointCommand} command
 * @returns {Issue | null}
 */
export function jointRefusal(joints, command) {
  const { length } = joints;
  switch (command.type) {
    case 'add-joint':
      return badIndex('joint', command.after, length, -1) ?? tooMany(length);
    case 'duplicate-joint':
      return badIndex('joint', command.joint, length) ?? tooMany(length);
    case 'remove-joint':
      return badIndex('joint', command.joint, length) ?? tooFew(length);
    case 'move-joint':
      return badIndex('joint', command.joint, length) ?? badIndex('joint', command.to, length);
    case 'set-joint-type':
      return (
        badIndex('joint', command.joint, length) ??
        badChoice('the type', `robot.joints.${command.joint}.type`, command.jointType, JOINT_TYPES)
      );
    default:
      return null;
  }
}

/** @param {number} count */
const tooMany = (count) =>
  count < MAX_JOINTS ? null : issue('joint-count', 'robot.joints', `A robot has at most ${WORDS[MAX_JOINTS]} joints.`);

/** @param {number} count */
const tooFew = (count) =>
  count > MIN_JOINTS ? null : issue('joint-count', 'robot.joints', `A robot has at least ${WORDS[MIN_JOINTS]} joints.`);

/** @type {Record<number, string>} */
const WORDS = { [MIN_JOINTS]: 'two', [MAX_JOINTS]: 'six' };
