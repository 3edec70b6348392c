/**
 * Every way the document can change, as plain data and one pure function. What can be said against a command is in
 * refusals.js, which the session asks before it comes here, so that the document in the store is always valid.
 *
 * A value that is undefined takes a limit away. A text is what was typed for the value, where that was an expression.
 *
 * @import { Convention, Doc, JointField, Units } from './document.js'
 * @import { CodeCommand } from './code/codeCommands.js'
 * @import { ControllerCommand } from './controller/controllerCommand.js'
 * @import { FrameCommand } from './frames/frameCommands.js'
 * @import { JointCommand } from './robot/jointCommands.js'
 * @import { MotionCommand } from './program/motionCommands.js'
 * @import { ObstacleCommand } from './workcell/obstacles.js'
 * @import { PostureCommand } from './program/postureCommand.js'
 * @import { RobotCommand } from './robot/robotCommands.js'
 * @import { TableCommand } from './robot/tableCommand.js'
 * @import { TargetCommand } from './aim/targets.js'
 *
 * @typedef {{ type: 'set-joint-field', joint: number, field: JointField, value: number | undefined, text?: string }
 *   | { type: 'set-joint-value', joint: number, value: number }
 *   | { type: 'set-posture', posture: readonly number[] }
 *   | { type: 'record-posture' }
 *   | { type: 'rename-posture', index: number, id: string }
 *   | { type: 'remove-posture', index: number }
 *   | { type: 'replace-document', doc: Doc }
 *   | { type: 'convert-units', units: Units }
 *   | { type: 'convert-convention', convention: Convention }
 *   | { type: 'reinterpret-convention', convention: Convention }
 *   | PostureCommand
 *   | TableCommand
 *   | JointCommand
 *   | TargetCommand
 *   | FrameCommand
 *   | MotionCommand
 *   | ControllerCommand
 *   | CodeCommand
 *   | ObstacleCommand
 *   | RobotCommand} Command
 *
 * Converting keeps the robot and changes the numbers; reinterpreting keeps the numbers and changes the robot.
 */
import { applyCodeCommand } from './code/codeCommands.js';
import { applyControllerCommand } from './controller/controllerCommand.js';
import { convertConvention } from './robot/convertConvention.js';
import { convertUnits } from './robot/convertUnits.js';
import { applyFrameCommand } from './frames/frameCommands.js';
import { applyJointCommand } from './robot/jointCommands.js';
import { applyMotionCommand } from './program/motionCommands.js';
import { applyObstacleCommand } from './workcell/obstacles.js';
import { applyPostureCommand } from './program/postureCommand.js';
import { applyRobotCommand } from './robot/robotCommands.js';
import { textOf, withField } from './robot/jointFields.js';
import { applyTableCommand } from './robot/tableCommand.js';
import { applyTargetCommand } from './aim/targets.js';

/**
 * @param {Doc} doc
 * @param {Command} command  that `refusal` has nothing against
 * @returns {Doc} the same object when nothing changed
 */
export function applyCommand(doc, command) {
  const { robot, posture, postures } = doc;
  switch (command.type) {
    case 'set-joint-field': {
      const { joint, field, value, text } = command;
      const old = robot.joints[joint];
      if (Object.is(old[field], value) && textOf(old, field) === text) return doc;
      return { ...doc, robot: { ...robot, joints: robot.joints.with(joint, withField(old, field, value, text)) } };
    }
    case 'set-joint-value':
      return posture[command.joint] === command.value
        ? doc
        : { ...doc, posture: posture.with(command.joint, command.value) };
    case 'set-posture':
      return posture.every((value, i) => value === command.posture[i])
        ? doc
        : { ...doc, posture: [...command.posture] };
    case 'record-posture':
      return { ...doc, postures: [...postures, { id: freePostureId(doc), q: posture }] };
    case 'rename-posture': {
      const old = postures[command.index];
      return old.id === command.id
        ? doc
        : { ...doc, postures: postures.with(command.index, { ...old, id: command.id }) };
    }
    case 'remove-posture':
      return { ...doc, postures: postures.toSpliced(command.index, 1) };
    case 'replace-document':
      return command.doc;
    case 'convert-units':
      return convertUnits(doc, command.units);
    case 'convert-convention':
      return convertConvention(doc, command.convention);
    case 'reinterpret-convention':
      return robot.convention === command.convention
        ? doc
        : { ...doc, robot: { ...robot, convention: command.convention } };
    case 'set-postures':
      return applyPostureCommand(doc, command);
    case 'set-table':
      return applyTableCommand(doc, command);
    case 'add-joint':
    case 'remove-joint':
    case 'duplicate-joint':
    case 'move-joint':
    case 'set-joint-type':
      return applyJointCommand(doc, command);
    case 'add-target':
    case 'rename-target':
    case 'edit-target':
    case 'move-target':
    case 'remove-target':
      return applyTargetCommand(doc, command);
    case 'add-frame':
    case 'rename-frame':
    case 'number-frame':
    case 'edit-frame':
    case 'remove-frame':
    case 'choose-tool':
    case 'choose-user':
      return applyFrameCommand(doc, command);
    case 'add-motion-program':
    case 'rename-motion-program':
    case 'remove-motion-program':
    case 'insert-steps':
    case 'edit-step':
    case 'edit-steps':
    case 'move-step':
    case 'remove-steps':
      return applyMotionCommand(doc, command);
    case 'set-controller':
      return applyControllerCommand(doc, command);
    case 'set-code':
    case 'edit-code':
    case 'rename-code':
    case 'remove-code':
    case 'set-code-options':
      return applyCodeCommand(doc, command);
    case 'add-obstacle':
    case 'rename-obstacle':
    case 'edit-obstacle':
    case 'remove-obstacle':
      return applyObstacleCommand(doc, command);
    case 'set-base':
    case 'set-tool':
    case 'set-link':
    case 'set-joint-rate':
    case 'rename-robot':
    case 'set-robot-info':
      return applyRobotCommand(doc, command);
    default:
      return assertNever(command);
  }
}

/** The first of p1, p2, … that no recorded posture has. @param {Doc} doc */
function freePostureId({ postures }) {
  const taken = new Set(postures.map(({ id }) => id));
  let number = 1;
  while (taken.has(`p${number}`)) number++;
  return `p${number}`;
}

/** @param {never} value @returns {never} */
function assertNever(value) {
  throw new TypeError(`Unknown command: ${JSON.stringify(value)}`);
}
