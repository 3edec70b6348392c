/**
 * Why a command cannot be carried out on a document, as an issue with one sentence, or null when it can.
 *
 * @import { Command } from './commands.js'
 * @import { Doc, JointField } from './document.js'
 * @import { Issue } from './issues.js'
 */
import { MAX_POSTURES } from './document.js';
import { CONVENTIONS } from './documentRules.js';
import { codeRefusal } from './code/codeCommands.js';
import { controllerRefusal } from './controller/controllerCommand.js';
import { frameRefusal } from './frames/frameRefusals.js';
import { motionRefusal } from './program/motionRefusals.js';
import { obstacleRefusal } from './workcell/obstacleFaults.js';
import { tableRefusal } from './robot/tableCommand.js';
import { targetRefusal } from './aim/targetRefusals.js';
import { POSTURE_NAME, isPostureName, postureRefusal } from './program/postureCommand.js';
import { badText } from './textRefusals.js';
import { jointRefusal } from './robot/jointRefusals.js';
import { badChoice, badIndex, badNumber, badPosture, issue, shown } from './refusalParts.js';
import { robotRefusal } from './robot/robotRefusals.js';
import { unitsRefusal, baseAndToolRefusal } from './robot/convertRefusals.js';

/** @type {Record<JointField, string>} */
const FIELD_NAMES = {
  theta: 'joint angle',
  d: 'link offset',
  a: 'link length',
  alpha: 'link twist',
  lower: 'lower limit',
  upper: 'upper limit',
  home: 'home value',
};

/**
 * @param {Doc} doc
 * @param {Command} command
 * @returns {Issue | null}
 */
export function refusal(doc, command) {
  const { robot, posture, postures } = doc;
  switch (command.type) {
    case 'set-joint-field':
      return (
        badIndex('joint', command.joint, robot.joints.length) ??
        badField(command.field) ??
        badNumber(FIELD_NAMES[command.field], command.value, command.field === 'lower' || command.field === 'upper') ??
        crossedLimits(doc, command) ??
        badText(FIELD_NAMES[command.field], command)
      );
    case 'set-joint-value':
      return badIndex('joint', command.joint, posture.length) ?? badNumber('joint value', command.value);
    case 'set-posture':
      return badPosture(command.posture, posture.length);
    case 'record-posture':
      if (postures.length < MAX_POSTURES) return null;
      return issue('too-many-postures', 'postures', `A model keeps at most ${MAX_POSTURES} recorded postures.`);
    case 'rename-posture':
      return badIndex('posture', command.index, postures.length) ?? badPostureId(doc, command);
    case 'remove-posture':
      return badIndex('posture', command.index, postures.length);
    case 'convert-units':
      return unitsRefusal(doc, command.units);
    case 'convert-convention':
      return badConvention(command.convention) ?? baseAndToolRefusal(doc, command.convention);
    case 'reinterpret-convention':
      return badConvention(command.convention);
    case 'set-postures':
      return postureRefusal(doc, command);
    case 'set-table':
      return tableRefusal(command);
    case 'add-joint':
    case 'remove-joint':
    case 'duplicate-joint':
    case 'move-joint':
    case 'set-joint-type':
      return jointRefusal(robot.joints, command);
    case 'add-target':
    case 'rename-target':
    case 'edit-target':
    case 'move-target':
    case 'remove-target':
      return targetRefusal(doc, command);
    case 'add-frame':
    case 'rename-frame':
    case 'number-frame':
    case 'edit-frame':
    case 'remove-frame':
    case 'choose-tool':
    case 'choose-user':
      return frameRefusal(doc, command);
    case 'add-motion-program':
    case 'rename-motion-program':
    case 'remove-motion-program':
    case 'insert-steps':
    case 'edit-step':
    case 'edit-steps':
    case 'move-step':
    case 'remove-steps':
      return motionRefusal(doc, command);
    case 'set-controller':
      return controllerRefusal(doc, command);
    case 'set-code':
    case 'edit-code':
    case 'rename-code':
    case 'remove-code':
    case 'set-code-options':
      return codeRefusal(doc, command);
    case 'add-obstacle':
    case 'rename-obstacle':
    case 'edit-obstacle':
    case 'remove-obstacle':
      return obstacleRefusal(doc, command);
    case 'set-base':
    case 'set-tool':
    case 'set-link':
    case 'set-joint-rate':
    case 'rename-robot':
    case 'set-robot-info':
      return robotRefusal(doc, command);
    default:
      return null;
  }
}

/** @param {string} convention */
const badConvention = (convention) => badChoice('the convention', 'robot.convention', convention, CONVENTIONS);

/** @param {string} field */
function badField(field) {
  if (Object.hasOwn(FIELD_NAMES, field)) return null;
  return issue('field', 'robot.joints', `Expected one of ${Object.keys(FIELD_NAMES).join(', ')}, got ${shown(field)}.`);
}

/** @param {Doc} doc @param {Extract<Command, { type: 'set-joint-field' }>} command */
function crossedLimits({ robot }, { joint, field, value }) {
  const old = robot.joints[joint];
  const { lower = -Infinity, upper = Infinity } = {
    lower: field === 'lower' ? value : old.lower,
    upper: field === 'upper' ? value : old.upper,
  };
  if (lower <= upper) return null;
  const message =
    field === 'lower'
      ? `The lower limit must not be above the upper one, ${shown(upper)}.`
      : `The upper limit must not be below the lower one, ${shown(lower)}.`;
  return issue('limits-crossed', `robot.joints.${joint}.${field}`, message);
}

/** @param {Doc} doc @param {Extract<Command, { type: 'rename-posture' }>} command */
function badPostureId({ postures }, { index, id }) {
  const path = `postures.${index}.id`;
  if (!isPostureName(id)) return issue('id', path, POSTURE_NAME);
  if (postures.some((other, i) => i !== index && other.id === id)) {
    return issue('id-taken', path, `Another posture is called "${id}" already.`);
  }
  return null;
}
