/**
 * What a person should know about a document that is sound: values that are allowed and seldom meant. Warnings only.
 *
 * @import { Doc, JointDoc, RobotDoc } from './document.js'
 * @import { Issue } from './issues.js'
 * @import { Issues } from './validateValues.js'
 */
import { isSliding } from './document.js';
import { documentIssue } from './issues.js';
import { toKernel } from './units.js';
import { jointName } from './validateJoints.js';
import { shownValue } from './validateValues.js';

/** No arm on sale is so small; one typed in metres and declared in millimetres is. */
const SMALL_METRES = 0.01;

/**
 * Double precision resolves a nanometre up to here (2⁻⁵² · 10⁶ m = 0.2 nm). The exact tables of real arms with nearly
 * parallel axes stay below: they have offsets of tens of kilometres.
 */
const LARGE_METRES = 1e6;

/**
 * @param {Doc} doc  sound, see validate.js
 * @returns {Issue[]}
 */
export const reviewDocument = (doc) => [
  ...extentIssues(doc.robot),
  ...doc.robot.joints.flatMap((joint, i) => [...limitIssues(joint, `robot.joints.${i}`)]),
  ...couplingKinds(doc.robot),
  ...outsideLimits(doc.robot, doc.posture, 'The present posture', 'posture'),
  ...doc.postures.flatMap(({ id, q }, i) => [
    ...outsideLimits(doc.robot, q, `Posture ${shownValue(id)}`, `postures.${i}.q`),
  ]),
];

/** @param {RobotDoc} robot @returns {Issues} */
function* extentIssues({ joints, units }) {
  const metres = (/** @type {number} */ length) => toKernel('length', Math.abs(length), units);
  const travel = (/** @type {JointDoc} */ { lower = 0, upper = 0 }) => Math.max(metres(lower), metres(upper));
  const lengths = joints.flatMap((joint) => [metres(joint.a), metres(joint.d), isSliding(joint) ? travel(joint) : 0]);
  const total = lengths.reduce((sum, length) => sum + length, 0);
  const doubt = `so its length unit "${units.length}" may be wrong`;
  const longest = Math.max(...lengths);
  if (total === 0) {
    const message = 'All link lengths and offsets of the robot are 0, so all its joints are in one place.';
    yield documentIssue('no-extent', 'robot.joints', message);
  } else if (total < SMALL_METRES) {
    const message = `All links of the robot together are ${Number(total.toPrecision(3))} m long, ${doubt}.`;
    yield documentIssue('very-small', 'robot.units.length', message);
  } else if (longest > LARGE_METRES) {
    const message = `A link of the robot is ${longest} m long, ${doubt}, and positions are not exact to a nanometre.`;
    yield documentIssue('very-large', 'robot.units.length', message);
  }
}

/** @param {JointDoc} joint @param {string} path @returns {Issues} */
function* limitIssues(joint, path) {
  const owner = jointName(joint);
  const { type, lower, upper, home } = joint;
  if (type === 'continuous') {
    if (lower === undefined && upper === undefined) return;
    const message = `${owner} is continuous, so its limits are not used.`;
    yield documentIssue('limits-unused', `${path}.${lower === undefined ? 'upper' : 'lower'}`, message);
    return;
  }
  if (lower !== undefined && lower === upper) {
    const message = `${owner} has equal limits, ${lower}, so it cannot move.`;
    yield documentIssue('joint-locked', `${path}.lower`, message);
  }
  if (home !== undefined && !isWithin(joint, home)) {
    const message = `${owner} has its home value ${home} outside its limits, ${range(joint)}.`;
    yield documentIssue('home-outside-limits', `${path}.home`, message);
  }
}

/**
 * A pendant adds the numbers of coupled joints. A new coupling between kinds is refused (controllerCommand.js); a link or a file
 * that has one opens, as all of its version do.
 * @param {RobotDoc} robot
 * @returns {Issues}
 */
function* couplingKinds({ joints }) {
  for (const [i, joint] of joints.entries()) {
    const { coupledTo, coupling } = joint.controller;
    const other = joints.find(({ id }) => id === coupledTo);
    if (!other || coupling === 0 || isSliding(other) === isSliding(joint)) continue;
    const [own, others] = isSliding(joint) ? ['slides', 'turns'] : ['turns', 'slides'];
    const message = `${jointName(joint)} ${own} and is coupled to ${shownValue(coupledTo)}, which ${others}: an angle and a length have no sum, so its pendant number means nothing.`;
    yield documentIssue('coupling-kinds', `robot.joints.${i}.controller.coupledTo`, message);
  }
}

/** @param {RobotDoc} robot @param {readonly number[]} q @param {string} owner @param {string} path @returns {Issues} */
function* outsideLimits({ joints }, q, owner, path) {
  const outside = joints.findIndex((joint, i) => joint.type !== 'continuous' && !isWithin(joint, q[i]));
  if (outside === -1) return;
  const joint = joints[outside];
  const message = `${owner} has ${q[outside]} for joint ${shownValue(joint.id)}, outside its limits, ${range(joint)}.`;
  yield documentIssue('posture-outside-limits', path, message);
}

/** @param {JointDoc} joint @param {number} value */
const isWithin = ({ lower = -Infinity, upper = Infinity }, value) => value >= lower && value <= upper;

/** @param {JointDoc} joint */
const range = ({ lower = -Infinity, upper = Infinity }) => `${lower} to ${upper}`.replaceAll('Infinity', '∞');
