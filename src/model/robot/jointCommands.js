/**
 * The commands that change which joints a robot has, and in which order. Postures keep their meaning: each value goes where
 * its joint goes, a new joint stands at its home in all of them, and the value of a joint that is gone is gone.
 *
 * @import { Doc, JointDoc, JointType, RobotDoc } from '../document.js'
 *
 * @typedef {{ type: 'add-joint', after: number }
 *   | { type: 'remove-joint', joint: number }
 *   | { type: 'duplicate-joint', joint: number }
 *   | { type: 'move-joint', joint: number, to: number }
 *   | { type: 'set-joint-type', joint: number, jointType: JointType }} JointCommand  `after` is −1 for the first place
 */
import { homePosture, isSliding } from '../document.js';
import { withPostures } from '../program/motionProgram.js';

/**
 * @param {Doc} doc
 * @param {JointCommand} command  that nothing is against (refusals.js)
 * @returns {Doc} the same object when nothing changed
 */
export function applyJointCommand(doc, command) {
  const { joints } = doc.robot;
  switch (command.type) {
    case 'add-joint':
      return inserted(doc, command.after + 1, newJoint(joints));
    case 'duplicate-joint':
      return inserted(doc, command.joint + 1, { ...joints[command.joint], id: freeJointId(joints) });
    case 'remove-joint': {
      const { id } = joints[command.joint];
      const others = joints.toSpliced(command.joint, 1).map((joint) => uncoupledFrom(joint, id));
      return rearranged(doc, others, (q) => q.toSpliced(command.joint, 1));
    }
    case 'move-joint': {
      const { joint, to } = command;
      return joint === to ? doc : rearranged(doc, moved(joints, joint, to), (q) => moved(q, joint, to));
    }
    case 'set-joint-type':
      return joints[command.joint].type === command.jointType ? doc : retyped(doc, command.joint, command.jointType);
    default:
      throw new TypeError(`Unknown command: ${JSON.stringify(command)}`);
  }
}

/**
 * A joint that changes nothing yet: a row of zeros leaves every other axis and the tool where they are, in both
 * conventions.
 * @param {readonly JointDoc[]} joints
 * @returns {JointDoc}
 */
const newJoint = (joints) => ({
  id: freeJointId(joints),
  type: 'revolute',
  ...{ theta: 0, d: 0, a: 0, alpha: 0, home: 0 },
  link: { kind: 'auto' },
  controller: { sign: 1, offset: 0, coupling: 0 },
});

/** The first of joint_1, joint_2, … that no joint has. @param {readonly JointDoc[]} joints */
function freeJointId(joints) {
  const taken = new Set(joints.map(({ id }) => id));
  let number = 1;
  while (taken.has(`joint_${number}`)) number++;
  return `joint_${number}`;
}

/** @param {Doc} doc @param {number} place @param {JointDoc} joint */
function inserted(doc, place, joint) {
  const value = homeOf(doc.robot, joint);
  return rearranged(doc, doc.robot.joints.toSpliced(place, 0, joint), (q) => q.toSpliced(place, 0, value));
}

/**
 * A turn and a slide have no number in common but the row of the table. So when a joint becomes the other kind, its limits,
 * home, rates, effort, controller offset and all couplings from and to it go, and it stands at zero in every posture.
 * A joint that turns on without end loses its limits, and keeps the rest.
 * @param {Doc} doc
 * @param {number} index
 * @param {JointType} type
 */
function retyped(doc, index, type) {
  const { joints } = doc.robot;
  const old = joints[index];
  if (isSliding(old) === isSliding({ type })) {
    const same = type === 'continuous' ? without(old, ['lower', 'upper']) : old;
    return rearranged(doc, joints.with(index, { ...same, type }), (q) => q);
  }
  const { sign } = old.controller;
  const others = joints.map((joint) => uncoupledFrom(joint, old.id));
  const joint = { ...without(old, OF_ITS_KIND), type, controller: { sign, offset: 0, coupling: 0 } };
  return rearranged(doc, others.with(index, joint), (q) => q.with(index, 0));
}

const OF_ITS_KIND = /** @type {const} */ (['lower', 'upper', 'home', 'velocity', 'acceleration', 'jerk', 'effort']);

/** @param {JointDoc} joint @param {readonly (typeof OF_ITS_KIND)[number][]} fields @returns {JointDoc} */
function without(joint, fields) {
  const rest = { ...joint };
  for (const field of fields) delete rest[field];
  return rest;
}

/** @param {JointDoc} joint @param {string} id @returns {JointDoc} */
function uncoupledFrom(joint, id) {
  const { coupledTo, ...controller } = joint.controller;
  return coupledTo === id ? { ...joint, controller: { ...controller, coupling: 0 } } : joint;
}

/** @param {RobotDoc} robot @param {JointDoc} joint */
const homeOf = (robot, joint) => homePosture({ ...robot, joints: [joint] })[0];

/** @template Item @param {readonly Item[]} list @param {number} from @param {number} to */
const moved = (list, from, to) => list.toSpliced(from, 1).toSpliced(to, 0, list[from]);

/**
 * @param {Doc} doc
 * @param {readonly JointDoc[]} joints
 * @param {(q: readonly number[]) => readonly number[]} values  of a posture, for these joints
 * @returns {Doc}
 */
const rearranged = (doc, joints, values) => ({
  ...doc,
  robot: { ...doc.robot, joints },
  posture: values(doc.posture),
  postures: doc.postures.map((posture) => ({ ...posture, q: values(posture.q) })),
  motionPrograms: withPostures(doc.motionPrograms, values),
});
