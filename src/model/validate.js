/**
 * Whether a document may enter the store: the rules that hold for it however it was made. What comes back is empty, or
 * says of each fault where it is, what was found and what was expected. Worth knowing but no fault: review.js.
 *
 * @import { Doc } from './document.js'
 * @import { Issue } from './issues.js'
 * @import { Issues } from './validateValues.js'
 */
import { MAX_POSTURES } from './document.js';
import { documentIssue } from './issues.js';
import {
  ANGLE_UNITS,
  CONVENTIONS,
  LENGTH_UNITS,
  MAX_DESCRIPTION_LENGTH,
  MAX_FRAMES,
  MAX_LABEL_LENGTH,
  MAX_TARGETS,
  PRESENT_POSTURE_ID,
} from './documentRules.js';
import { codeFaults } from './code/codeCommands.js';
import { motionFaults } from './program/motionFaults.js';
import { obstacleFaults } from './workcell/obstacleFaults.js';
import { checkFrameId, framesIssues } from './validateFrames.js';
import { jointsIssues } from './validateJoints.js';
import {
  checkChoice,
  checkDifferentIds,
  checkId,
  checkNumber,
  checkPose,
  checkText,
  shownValue,
} from './validateValues.js';

const INFO = /** @type {const} */ (['manufacturer', 'author', 'licence', 'source', 'description']);

/**
 * @param {Doc} doc
 * @returns {Issue[]} errors only; empty when the document is sound
 */
export const validateDocument = (doc) => [
  ...robotIssues(doc),
  ...jointsIssues(doc.robot.joints),
  ...checkPosture('The present posture', 'posture', doc.posture, doc.robot.joints.length),
  ...posturesIssues(doc),
  ...checkCount('too-many-frames', 'frames', doc.frames.length, MAX_FRAMES),
  ...framesIssues(doc),
  ...targetsIssues(doc),
  ...obstacleFaults(doc),
  ...motionFaults(doc),
  ...codeFaults(doc),
];

/** @param {Doc} doc @returns {Issues} */
function* robotIssues({ robot }) {
  const { name, info, units, convention, base, tool } = robot;
  yield* checkText('The robot', 'a name', 'robot.name', name, MAX_LABEL_LENGTH);
  for (const field of INFO) {
    if (info[field] === undefined) continue;
    const longest = field === 'description' ? MAX_DESCRIPTION_LENGTH : MAX_LABEL_LENGTH;
    yield* checkText('The robot', `as ${field} a text`, `robot.info.${field}`, info[field], longest);
  }
  yield* checkChoice('The robot', 'the length unit', 'robot.units.length', units.length, LENGTH_UNITS);
  yield* checkChoice('The robot', 'the angle unit', 'robot.units.angle', units.angle, ANGLE_UNITS);
  yield* checkChoice('The robot', 'the convention', 'robot.convention', convention, CONVENTIONS);
  yield* checkPose('The base', 'robot.base', base);
  yield* checkPose('The tool', 'robot.tool', tool);
}

/** @param {string} owner @param {string} path @param {readonly number[]} q @param {number} count @returns {Issues} */
function* checkPosture(owner, path, q, count) {
  if (q.length !== count) {
    const values = `${q.length} joint ${q.length === 1 ? 'value' : 'values'}`;
    yield documentIssue('posture-length', path, `${owner} has ${values}; expected ${count}, one for each joint.`);
  }
  for (const value of q) yield* checkNumber(owner, 'the joint value', path, value);
}

/** @param {Doc} doc @returns {Issues} */
function* posturesIssues({ robot, postures }) {
  yield* checkCount('too-many-postures', 'postures', postures.length, MAX_POSTURES);
  for (const [i, { id, q }] of postures.entries()) {
    yield* checkId(`Posture ${i + 1}`, `postures.${i}.id`, id);
    yield* checkPosture(`Posture ${shownValue(id)}`, `postures.${i}.q`, q, robot.joints.length);
    if (id === PRESENT_POSTURE_ID) {
      const message = `A recorded posture has the id "${id}", which stands for where the arm is; expected another.`;
      yield documentIssue('id-reserved', `postures.${i}.id`, message);
    }
  }
  yield* checkDifferentIds('postures', 'postures', postures);
}

/** @param {Doc} doc @returns {Issues} */
function* targetsIssues({ targets, frames }) {
  yield* checkCount('too-many-targets', 'targets', targets.length, MAX_TARGETS);
  for (const [i, target] of targets.entries()) {
    const owner = `Target ${shownValue(target.id)}`;
    yield* checkId(`Target ${i + 1}`, `targets.${i}.id`, target.id);
    yield* checkPose(owner, `targets.${i}`, target);
    yield* checkFrameId(owner, `targets.${i}.frame`, target.frame, frames, 'user');
    if (target.configuration === undefined) continue;
    yield* checkText(
      owner,
      'as configuration a text',
      `targets.${i}.configuration`,
      target.configuration,
      MAX_LABEL_LENGTH,
    );
  }
  yield* checkDifferentIds('targets', 'targets', targets);
}

/**
 * @param {'too-many-postures' | 'too-many-frames' | 'too-many-targets'} code
 * @param {string} path @param {number} count @param {number} most
 * @returns {Issues}
 */
function* checkCount(code, path, count, most) {
  if (count > most) yield documentIssue(code, path, `The model has ${count} ${path}; expected at most ${most}.`);
}
