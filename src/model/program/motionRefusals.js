/**
 * What can be said against a command about motion programs: a place that is not there, a count that is too large, or anything
 * that would be wrong with the program afterwards.
 *
 * @import { Doc } from '../document.js'
 * @import { Issue } from '../issues.js'
 * @import { MotionCommand } from './motionCommands.js'
 */
import { applyMotionCommand } from './motionCommands.js';
import { motionCountFault, motionProgramFaults } from './motionFaults.js';
import { inUse, usersIn } from './motionProgram.js';
import { badIndex, issue, shown } from '../refusalParts.js';

/**
 * @param {Doc} doc
 * @param {MotionCommand} command
 * @returns {Issue | null}
 */
export function motionRefusal(doc, command) {
  const bad = badPlace(doc, command);
  if (bad) return bad;
  if (command.type === 'remove-motion-program') return stillCalled(doc, command.program);
  if (command.type === 'move-step' || command.type === 'remove-steps') return null;
  const next = applyMotionCommand(doc, command);
  const index = command.type === 'add-motion-program' ? doc.motionPrograms.length : command.program;
  const [fault = null] = motionProgramFaults(doc, next.motionPrograms[index], `motionPrograms.${index}`);
  return motionCountFault(next.motionPrograms) ?? fault;
}

/** @param {Doc} doc @param {MotionCommand} command @returns {Issue | null} */
function badPlace({ motionPrograms }, command) {
  if (command.type === 'add-motion-program') return badSteps(command.steps ?? []);
  const { program } = command;
  const bad = badIndex('program', program, motionPrograms.length);
  if (bad) return bad;
  const { length } = motionPrograms[program].steps;
  switch (command.type) {
    case 'insert-steps':
      return badIndex('step', command.at, length + 1) ?? badSteps(command.steps);
    case 'edit-step':
      return badIndex('step', command.step, length) ?? badSteps([command.to]);
    case 'edit-steps':
      return badSteps(command.to) ?? badRange(command.step, command.to.length, length);
    case 'move-step': {
      const { step, to, count = 1 } = command;
      return badRange(step, count, length) ?? badIndex('step', to, length - count + 1);
    }
    case 'remove-steps':
      return badRange(command.step, command.count, length);
    default:
      return null;
  }
}

/** @param {number} step @param {number} count  of steps from there on, at least one @param {number} length */
const badRange = (step, count, length) =>
  badIndex('step', step, length) ?? badIndex('step', step + count - 1, length, step);

/** Only plain data can be copied into a document. @param {readonly unknown[]} steps */
function badSteps(steps) {
  const isPlain = Array.isArray(steps) && steps.every((step) => typeof step === 'object' && step !== null);
  return isPlain ? null : issue('choice', 'steps', `Expected steps as objects, got ${shown(steps)}.`);
}

/** @param {Doc} doc @param {number} index */
function stillCalled(doc, index) {
  const { id, name } = doc.motionPrograms[index];
  const others = { motionPrograms: doc.motionPrograms.toSpliced(index, 1) };
  const users = usersIn(others, (step) => step.kind === 'call' && step.program === id);
  return users === null ? null : inUse(`motionPrograms.${index}`, `Program ${shown(name)}`, users);
}
