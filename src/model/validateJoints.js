/**
 * What can be wrong with the joints of a robot.
 *
 * @import { JointDoc } from './document.js'
 * @import { Issues } from './validateValues.js'
 */
import { DH_FIELDS, MAX_JOINTS, MIN_JOINTS } from './document.js';
import { documentIssue } from './issues.js';
import { COLOUR_PATTERN, JOINT_TYPES, LINK_KINDS, MAX_LABEL_LENGTH } from './documentRules.js';
import {
  checkChoice,
  checkDifferentIds,
  checkId,
  checkNumber,
  checkPositive,
  checkText,
  shownValue,
} from './validateValues.js';

const RATES = /** @type {const} */ (['velocity', 'acceleration', 'jerk', 'effort']);
const SIZES = /** @type {const} */ (['radius', 'width', 'height']);

/** How messages call a joint. @param {JointDoc} joint */
export const jointName = ({ id }) => `Joint ${shownValue(id)}`;

/**
 * @param {readonly JointDoc[]} joints
 * @returns {Issues}
 */
export function* jointsIssues(joints) {
  if (joints.length < MIN_JOINTS || joints.length > MAX_JOINTS) {
    const count = `${joints.length} ${joints.length === 1 ? 'joint' : 'joints'}`;
    const message = `The robot has ${count}; expected ${MIN_JOINTS} to ${MAX_JOINTS}.`;
    yield documentIssue('joint-count', 'robot.joints', message);
  }
  for (const [i, joint] of joints.entries()) {
    yield* checkId(`Joint ${i + 1}`, `robot.joints.${i}.id`, joint.id);
    yield* jointIssues(joint, `robot.joints.${i}`);
    yield* linkIssues(joint, `robot.joints.${i}.link`);
    yield* controllerIssues(joint, `robot.joints.${i}.controller`, joints);
  }
  yield* checkDifferentIds('joints', 'robot.joints', joints);
  yield* couplingCircles(joints);
}

/** @param {JointDoc} joint @param {string} path @returns {Issues} */
function* jointIssues(joint, path) {
  const owner = jointName(joint);
  const { lower, upper, home, label, text = {} } = joint;
  yield* checkChoice(owner, 'the type', `${path}.type`, joint.type, JOINT_TYPES);
  if (label !== undefined) yield* checkText(owner, 'a label', `${path}.label`, label, MAX_LABEL_LENGTH);
  for (const field of DH_FIELDS) {
    yield* checkNumber(owner, field, `${path}.${field}`, joint[field]);
    const typed = text[field];
    if (typed !== undefined) {
      yield* checkText(owner, `as ${field} an expression`, `${path}.text.${field}`, typed, MAX_LABEL_LENGTH);
    }
  }
  if (lower !== undefined) yield* checkNumber(owner, 'the lower limit', `${path}.lower`, lower);
  if (upper !== undefined) yield* checkNumber(owner, 'the upper limit', `${path}.upper`, upper);
  if (home !== undefined) yield* checkNumber(owner, 'the home value', `${path}.home`, home);
  if (lower !== undefined && upper !== undefined && lower > upper) {
    const message = `${owner} has the lower limit ${lower} above its upper limit ${upper}; expected lower <= upper.`;
    yield documentIssue('limits-crossed', `${path}.lower`, message);
  }
  for (const field of RATES) {
    if (joint[field] !== undefined) yield* checkPositive(owner, field, `${path}.${field}`, joint[field]);
  }
}

/** @param {JointDoc} joint @param {string} path @returns {Issues} */
function* linkIssues(joint, path) {
  const owner = `The link of joint ${shownValue(joint.id)}`;
  const { link } = joint;
  yield* checkChoice(owner, 'the kind', `${path}.kind`, link.kind, LINK_KINDS);
  for (const field of SIZES) {
    if (link[field] !== undefined) yield* checkPositive(owner, field, `${path}.${field}`, link[field]);
  }
  if (link.color !== undefined && !COLOUR_PATTERN.test(link.color)) {
    const message = `${owner} has the colour ${shownValue(link.color)}; expected one such as #ffcc00.`;
    yield documentIssue('colour', `${path}.color`, message);
  }
}

/** @param {JointDoc} joint @param {string} path @param {readonly JointDoc[]} joints @returns {Issues} */
function* controllerIssues({ id, controller }, path, joints) {
  const owner = `The controller of joint ${shownValue(id)}`;
  const { sign, offset, coupling, coupledTo } = controller;
  yield* checkChoice(owner, 'the sign', `${path}.sign`, sign, [1, -1]);
  yield* checkNumber(owner, 'the offset', `${path}.offset`, offset);
  yield* checkNumber(owner, 'the coupling', `${path}.coupling`, coupling);
  if (coupledTo === undefined && coupling !== 0) {
    const message = `${owner} has the coupling ${shownValue(coupling)} to no joint; expected the id of one in coupledTo.`;
    yield documentIssue('coupling-without-joint', `${path}.coupling`, message);
  }
  if (coupledTo !== undefined && !joints.some((joint) => joint.id === coupledTo)) {
    const message = `${owner} is coupled to ${shownValue(coupledTo)}; expected the id of another joint.`;
    yield documentIssue('coupling-unknown', `${path}.coupledTo`, message);
  }
}

/**
 * A pendant value that follows from itself has no value. Each joint follows at most one other, so walking on from every
 * joint finds all circles; each is reported once, at its first joint.
 * @param {readonly JointDoc[]} joints
 * @returns {Issues}
 */
function* couplingCircles(joints) {
  const followed = new Map(joints.map(({ id, controller }) => [id, controller.coupledTo]));
  for (const [i, { id }] of joints.entries()) {
    const circle = [id];
    let next = followed.get(id);
    while (next !== undefined && !circle.includes(next)) {
      circle.push(next);
      next = followed.get(next);
    }
    const isFirst = circle.every((other) => joints.findIndex((joint) => joint.id === other) >= i);
    if (next !== id || !isFirst) continue;
    const names = circle.map((other) => shownValue(other)).join(', ');
    const message =
      circle.length === 1
        ? `The controller of joint ${names} is coupled to itself; expected another joint.`
        : `The controllers of joints ${names} are coupled in a circle; expected a coupling that ends.`;
    yield documentIssue('coupling-circle', `robot.joints.${i}.controller.coupledTo`, message);
  }
}
