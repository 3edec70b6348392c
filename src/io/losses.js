/**
 * What a format of robot files will not hold of a document: one sentence each, with the names and numbers of this document.
 * What every format must answer for is here; what is a matter of one of them (names, limits, placeholders) is told beside its
 * writer.
 *
 * @import { Doc, JointDoc, RobotDoc, RobotInfo } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 *
 * @typedef {'velocity' | 'acceleration' | 'jerk' | 'effort'} Rate
 *
 * @typedef {object} Room   what a format has a place for
 * @property {string} format    as messages call it
 * @property {boolean} table    whether it keeps Denavit–Hartenberg rows; else it keeps frames
 * @property {readonly (keyof RobotInfo)[]} info
 * @property {readonly Rate[]} rates
 */
import { homePosture, limitsOf } from '../model/document.js';
import { shownText } from '../model/shownText.js';
import { fileIssue } from './fileIssues.js';
import { FAR, PLACEHOLDERS } from './placeholders.js';
import { forbiddenCharacterAt } from './xmlText.js';

/** How many names a sentence lists before it counts. */
const MOST_NAMES = 6;

/** @type {readonly Rate[]} */
const RATES = ['velocity', 'acceleration', 'jerk', 'effort'];
/** @type {readonly (keyof RobotInfo)[]} */
const INFO = ['manufacturer', 'author', 'licence', 'source', 'description'];

/**
 * @example
 * listed(['a', 'b']) // → 'a, b'
 * @param {readonly string[]} names
 */
export function listed(names) {
  const shown = names.slice(0, MOST_NAMES).map(shownText).join(', ');
  return names.length > MOST_NAMES ? `${shown} and ${names.length - MOST_NAMES} more` : shown;
}

/** @param {number} count @param {string} noun  that takes an s */
const counted = (count, noun) => `${count} ${noun}${count === 1 ? '' : 's'}`;

/** @param {readonly { readonly id: string }[]} items @param {string} noun */
const named = (items, noun) => `${counted(items.length, noun)} (${listed(items.map(({ id }) => id))})`;

/**
 * @param {Room} room
 * @param {Doc} doc
 * @returns {Issue[]} warnings; empty if all of it is kept
 */
export const lossesIn = (room, doc) => [
  ...tableLosses(room, doc),
  ...contentLosses(room, doc),
  ...jointLosses(room, doc.robot.joints),
];

/** @param {Room} room @param {Doc} doc @returns {Issue[]} */
function tableLosses({ format, table }, { robot: { joints, convention, units } }) {
  const kept = { length: 'm', angle: table ? 'deg' : 'rad' };
  const isOther = units.length !== kept.length || units.angle !== kept.angle;
  const inUnits = `${kept.length} and ${kept.angle}`;
  const given = `${units.length} and ${units.angle}`;
  if (!table) {
    const message = `${format} has frames in ${inUnits} and no table; the ${joints.length} rows (${convention}, in ${given}) can be read back only as a table of the same arm, which may be another.`;
    return [fileIssue('not-kept', message, { path: 'robot.joints' })];
  }
  const issues = [];
  if (convention === 'modified') {
    const message = `${format} has standard tables only; the ${joints.length} rows of the modified one are converted, with base and tool.`;
    issues.push(fileIssue('not-kept', message, { path: 'robot.convention' }));
  }
  if (isOther) {
    const message = `${format} is in ${inUnits}; the numbers, typed in ${given}, are converted.`;
    issues.push(fileIssue('not-kept', message, { path: 'robot.units' }));
  }
  return issues;
}

/** What stands beside the robot. @param {Room} room @param {Doc} doc @returns {Issue[]} */
function contentLosses({ format, info }, doc) {
  const { robot, posture, postures, frames, activeTool, targets, obstacles, ...more } = doc;
  const { motionPrograms, programs, codeOptions, extensions } = more;
  const noPlace = (/** @type {string} */ what, /** @type {string} */ path) =>
    fileIssue('not-kept', `${format} has no place for ${what}.`, { path });
  const home = homePosture({ ...robot, joints: robot.joints.map((joint) => ({ ...joint, home: undefined })) });
  const issues = [];
  if (posture.some((value, i) => value !== home[i])) {
    issues.push(noPlace(`the posture that the arm stands in, ${posture.map(briefly).join(', ')}`, 'posture'));
  }
  if (postures.length > 0) issues.push(noPlace(named(postures, 'recorded posture'), 'postures'));
  const users = frames.filter(({ kind }) => kind === 'user');
  if (users.length > 0) issues.push(noPlace(named(users, 'user frame'), 'frames'));
  const tools = frames.filter(({ kind, id }) => kind === 'tool' && id !== activeTool);
  if (tools.length > 0)
    issues.push(noPlace(`${named(tools, 'tool')} that ${tools.length === 1 ? 'is' : 'are'} not active`, 'frames'));
  if (activeTool !== undefined) {
    issues.push(noPlace(`the name of the active tool, ${shownText(activeTool)}; its pose is kept`, 'activeTool'));
  }
  if (targets.length > 0) issues.push(noPlace(named(targets, 'target'), 'targets'));
  if (obstacles.length > 0) issues.push(noPlace(named(obstacles, 'obstacle'), 'obstacles'));
  if (motionPrograms.length > 0) {
    const names = motionPrograms.map(({ name }) => ({ id: name }));
    issues.push(noPlace(named(names, 'motion program'), 'motionPrograms'));
  }
  if (programs.length > 0) issues.push(noPlace(named(programs, 'program'), 'programs'));
  if (codeOptions) issues.push(noPlace('how code is to be written', 'codeOptions'));
  if (extensions.length > 0) {
    issues.push(noPlace(`${counted(extensions.length, 'element')} of other programs`, 'extensions'));
  }
  const facts = INFO.filter((field) => robot.info[field] !== undefined && !info.includes(field));
  if (facts.length > 0) issues.push(noPlace(`what is said of the robot: ${facts.join(', ')}`, 'robot.info'));
  return issues;
}

/** What the joints have besides their motion. @param {Room} room @param {readonly JointDoc[]} joints @returns {Issue[]} */
function jointLosses({ format, rates }, joints) {
  /** @param {string} what @param {string} path @param {(joint: JointDoc) => boolean} has */
  const of = (what, path, has) =>
    ofJoints(joints, path, has, (those) => `${format} has no place for ${what} of ${those}.`);
  return [
    ...of('what was typed for numbers', 'text', ({ text }) => text !== undefined),
    ...of('the label', 'label', ({ label }) => label !== undefined),
    ...of('the home value', 'home', ({ home }) => home !== undefined),
    ...RATES.filter((rate) => !rates.includes(rate)).flatMap((rate) =>
      of(`the largest ${rate}`, rate, (joint) => joint[rate] !== undefined),
    ),
    ...of(
      "the controller's sign, offset or coupling",
      'controller',
      ({ controller: { sign, offset, coupledTo } }) => sign !== 1 || offset !== 0 || coupledTo !== undefined,
    ),
    ...of('the look of the link', 'link', ({ link }) => link.kind !== 'auto' || Object.keys(link).length > 1),
  ];
}

/**
 * One issue for all the joints that something is true of, or none.
 * @param {readonly JointDoc[]} joints
 * @param {string} path   of the matter in the first of them
 * @param {(joint: JointDoc) => boolean} has
 * @param {(those: string) => string} sentence   '2 joints (joint_1, joint_2)'
 * @param {'not-kept' | 'placeholder'} [code]
 * @returns {Issue[]}
 */
export function ofJoints(joints, path, has, sentence, code = 'not-kept') {
  const having = joints.filter(has);
  if (having.length === 0) return [];
  const where = { path: `robot.joints.${joints.indexOf(having[0])}.${path}` };
  return [fileIssue(code, sentence(named(having, 'joint')), where)];
}

/**
 * Names that are written otherwise than they are.
 * @param {string} format
 * @param {readonly (readonly [string, string])[]} names  as they are, as they are written
 * @param {string} path
 * @returns {Issue[]}
 */
export function renamed(format, names, path) {
  const others = names.filter(([is, written]) => is !== written);
  if (others.length === 0) return [];
  const pairs = others.map(([is, written]) => `"${shownText(is)}" as "${written}"`);
  const message = `${format} has other names: ${pairs.slice(0, MOST_NAMES).join(', ')}.`;
  return [fileIssue('not-kept', message, { path })];
}

/**
 * @param {string} format
 * @param {RobotDoc} robot
 * @param {{ robot: string, joints: readonly string[] }} written
 * @returns {Issue[]}
 */
export function nameLosses(format, { name, joints }, written) {
  const ofJoints = joints.map(({ id }, i) => /** @type {const} */ ([id, written.joints[i]]));
  return [
    ...renamed(format, name === '' ? [] : [[name, written.robot]], 'robot.name'),
    ...renamed(format, ofJoints, 'robot.joints'),
  ];
}

/**
 * Limits that a continuous joint has and nobody heeds.
 * @param {string} format
 * @param {readonly JointDoc[]} joints
 */
export const unusedLimits = (format, joints) =>
  ofJoints(
    joints,
    'lower',
    ({ type, lower, upper }) => type === 'continuous' && (lower !== undefined || upper !== undefined),
    (those) => `${format} has no place for the unused limits of ${those}.`,
  );

/**
 * One limit, where a format asks for both or none.
 * @param {string} format
 * @param {readonly JointDoc[]} joints
 * @param {(joint: JointDoc) => boolean} areWritten
 */
export const oneSided = (format, joints, areWritten) =>
  ofJoints(
    joints,
    'lower',
    (joint) => areWritten(joint) && Object.values(limitsOf(joint)).some((end) => !Number.isFinite(end)),
    (those) => `${format} asks for both limits; at least ${FAR} (rad or m) stands for what is missing of ${those}.`,
    'placeholder',
  );

/**
 * Masses, of which a kinematic model has none.
 * @param {string} format
 * @param {number} links
 * @returns {Issue}
 */
export function massPlaceholder(format, links) {
  const { mass, inertia } = PLACEHOLDERS;
  const message = `${format} asks for masses and inertias; ${mass} kg and ${inertia} kg m² stand for those of ${links} links.`;
  return fileIssue('placeholder', message, { path: 'robot.joints' });
}

/**
 * A character that no XML file can hold.
 * @param {string} text
 * @param {string} path
 * @returns {Issue[]}
 */
export function characterLosses(text, path) {
  const at = forbiddenCharacterAt(text);
  if (at === -1) return [];
  const code = text.codePointAt(at)?.toString(16).toUpperCase().padStart(4, '0');
  const message = `XML has no place for the character U+${code} in ${path}; the replacement character U+FFFD stands for it.`;
  return [fileIssue('not-kept', message, { path })];
}

/** Six digits are enough to know a number again. @param {number} value */
const briefly = (value) => String(Number(value.toPrecision(6)));
