/**
 * What can be said against a command about the robot beside its table.
 *
 * @import { Doc, LinkDoc, PoseDoc } from '../document.js'
 * @import { Issue } from '../issues.js'
 * @import { RobotCommand } from './robotCommands.js'
 */
import {
  COLOUR_PATTERN,
  LARGEST_NUMBER,
  LINK_KINDS,
  MAX_DESCRIPTION_LENGTH,
  MAX_LABEL_LENGTH,
  QUATERNION_TOLERANCE,
  characterCount,
} from '../documentRules.js';
import { badChoice, badIndex, badNumber, issue, shown } from '../refusalParts.js';

const INFO = ['manufacturer', 'author', 'licence', 'source', 'description'];
const RATES = ['velocity', 'acceleration', 'jerk', 'effort'];
const SIZES = /** @type {const} */ (['radius', 'width', 'height']);

/**
 * @param {Doc} doc
 * @param {RobotCommand} command
 * @returns {Issue | null}
 */
export function robotRefusal({ robot: { joints } }, command) {
  switch (command.type) {
    case 'set-base':
      return badPose('robot.base', command.pose);
    case 'set-tool':
      return badPose('robot.tool', command.pose);
    case 'set-link':
      return badIndex('joint', command.joint, joints.length) ?? badLink(command.joint, command.link);
    case 'set-joint-rate':
      return (
        badIndex('joint', command.joint, joints.length) ??
        badChoice('the rate', 'robot.joints', command.rate, RATES) ??
        badSize(`${command.rate} limit`, `robot.joints.${command.joint}.${command.rate}`, command.value)
      );
    case 'rename-robot':
      return badText('The name', 'robot.name', command.name, MAX_LABEL_LENGTH);
    case 'set-robot-info':
      return (
        badChoice('the field', 'robot.info', command.field, INFO) ??
        badText(
          `The ${command.field}`,
          `robot.info.${command.field}`,
          command.text,
          command.field === 'description' ? MAX_DESCRIPTION_LENGTH : MAX_LABEL_LENGTH,
        )
      );
    default:
      return null;
  }
}

/** @param {string} path @param {PoseDoc} pose @returns {Issue | null} */
export function badPose(path, pose) {
  const { xyz, rpy, quaternion } = Object(pose);
  if (rpy && quaternion)
    return issue('orientation-twice', path, 'An orientation is given as rpy or as a quaternion, not both.');
  return (
    badVector('position', `${path}.xyz`, xyz, 3) ??
    (rpy && badVector('orientation', `${path}.rpy`, rpy, 3)) ??
    (quaternion && badQuaternion(`${path}.quaternion`, quaternion)) ??
    null
  );
}

/** @param {string} path @param {readonly number[]} quaternion */
function badQuaternion(path, quaternion) {
  const bad = badVector('quaternion', path, quaternion, 4);
  const length = Math.hypot(...(bad ? [] : quaternion));
  if (bad || Math.abs(length - 1) <= QUATERNION_TOLERANCE) return bad;
  return issue(
    'quaternion-length',
    path,
    `A quaternion has the length 1; this one has ${Number(length.toPrecision(7))}.`,
  );
}

/** @param {string} what @param {string} path @param {readonly number[]} values @param {number} count @returns {Issue | null} */
function badVector(what, path, values, count) {
  if (!Array.isArray(values) || values.length !== count) {
    const came = Array.isArray(values) ? values.length : shown(values);
    return issue('vector-length', path, `Expected ${count} numbers as ${what}, got ${came}.`);
  }
  return values.reduce((found, value) => found ?? badNumber(`number of the ${what}`, value), null);
}

/** @param {number} joint @param {LinkDoc} link */
function badLink(joint, link) {
  const path = `robot.joints.${joint}.link`;
  const { kind, color, ...sizes } = Object(link);
  const bad = badChoice('the kind of a link', `${path}.kind`, kind, LINK_KINDS);
  if (bad) return bad;
  for (const field of SIZES) {
    const found = badSize(field, `${path}.${field}`, sizes[field]);
    if (found) return found;
  }
  if (color === undefined || (typeof color === 'string' && COLOUR_PATTERN.test(color))) return null;
  return issue(
    'colour',
    `${path}.color`,
    `A colour is # and six digits from 0 to f, such as #ffcc00; got ${shown(color)}.`,
  );
}

/** @param {string} what @param {string} path @param {number | undefined} value  absent where nothing is said */
function badSize(what, path, value) {
  if (value === undefined || (typeof value === 'number' && value > 0 && value <= LARGEST_NUMBER)) return null;
  return issue('number', path, `A ${what} is a number above 0, up to 10⁹; got ${shown(value)}.`);
}

/** @param {string} what @param {string} path @param {string} text @param {number} longest */
export function badText(what, path, text, longest) {
  const length = typeof text === 'string' ? characterCount(text) : NaN;
  if (length <= longest) return null;
  const came = typeof text === 'string' ? `this one has ${length}` : `got ${shown(text)}`;
  return issue('text-length', path, `${what} has at most ${longest} characters; ${came}.`);
}
