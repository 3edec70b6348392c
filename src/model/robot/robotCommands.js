/**
 * The commands for what belongs to the robot beside the numbers of its table: where it stands and what it holds, how its
 * links are drawn, how fast its joints may be, what it is called and who says so. What can be said against them is in
 * robotRefusals.js. A rate that is undefined, and a text that is empty, takes the old one away.
 *
 * @import { Doc, JointDoc, LinkDoc, PoseDoc, RobotDoc, RobotInfo } from '../document.js'
 *
 * @typedef {'velocity' | 'acceleration' | 'jerk' | 'effort'} Rate
 *
 * @typedef {{ type: 'set-base', pose: PoseDoc }
 *   | { type: 'set-tool', pose: PoseDoc }
 *   | { type: 'set-link', joint: number, link: LinkDoc }
 *   | { type: 'set-joint-rate', joint: number, rate: Rate, value: number | undefined }
 *   | { type: 'rename-robot', name: string }
 *   | { type: 'set-robot-info', field: keyof RobotInfo, text: string }} RobotCommand
 */
import { withTool } from '../frames/frameCommands.js';
import { isSamePose } from '../samePose.js';

/**
 * @param {Doc} doc
 * @param {RobotCommand} command  that nothing is against
 * @returns {Doc} the same object when nothing changed
 */
export function applyRobotCommand(doc, command) {
  const { robot } = doc;
  const { joints } = robot;
  switch (command.type) {
    case 'set-base':
      return isSamePose(robot.base, command.pose) ? doc : withRobot(doc, { base: command.pose });
    case 'set-tool':
      return withTool(doc, command.pose);
    case 'set-link': {
      const { joint, link } = command;
      if (isSameRecord(joints[joint].link, link)) return doc;
      return withRobot(doc, { joints: joints.with(joint, { ...joints[joint], link: present(link) }) });
    }
    case 'set-joint-rate': {
      const { joint, rate, value } = command;
      if (joints[joint][rate] === value) return doc;
      const changed = /** @type {JointDoc} */ (present({ ...joints[joint], [rate]: value }));
      return withRobot(doc, { joints: joints.with(joint, changed) });
    }
    case 'rename-robot':
      return robot.name === command.name ? doc : withRobot(doc, { name: command.name });
    case 'set-robot-info': {
      const { field, text } = command;
      if ((robot.info[field] ?? '') === text) return doc;
      return withRobot(doc, { info: present({ ...robot.info, [field]: text === '' ? undefined : text }) });
    }
    default:
      throw new TypeError(`Unknown command: ${JSON.stringify(command)}`);
  }
}

/** @param {Doc} doc @param {Partial<RobotDoc>} change @returns {Doc} */
const withRobot = (doc, change) => ({ ...doc, robot: { ...doc.robot, ...change } });

/** Without the fields that are undefined. @template {object} Thing @param {Thing} thing */
const present = (thing) =>
  /** @type {Thing} */ (Object.fromEntries(Object.entries(thing).filter(([, value]) => value !== undefined)));

/** @param {LinkDoc} one @param {LinkDoc} other */
const isSameRecord = (one, other) =>
  /** @type {const} */ (['kind', 'radius', 'width', 'height', 'color']).every((field) => one[field] === other[field]);
