/**
 * How a controller counts one joint: its sign, its zero, and the joint that its number follows (controllerValues.js).
 *
 * @import { ControllerDoc, Doc } from '../document.js'
 * @import { Issue } from '../issues.js'
 *
 * @typedef {{ type: 'set-controller', joint: number, controller: ControllerDoc }} ControllerCommand
 */
import { isSliding } from '../document.js';
import { badIndex, badNumber, issue, shown } from '../refusalParts.js';

/**
 * @param {Doc} doc
 * @param {ControllerCommand} command  that nothing is against
 * @returns {Doc} the same object when nothing changed
 */
export function applyControllerCommand(doc, { joint, controller: { sign, offset, coupling, coupledTo } }) {
  const { robot } = doc;
  const old = robot.joints[joint];
  const { controller: was } = old;
  const isSame = was.sign === sign && was.offset === offset && was.coupling === coupling && was.coupledTo === coupledTo;
  if (isSame) return doc;
  // + 0: no file tells −0 from 0
  const controller = {
    sign,
    offset: offset + 0,
    coupling: coupling + 0,
    ...(coupledTo !== undefined && { coupledTo }),
  };
  return { ...doc, robot: { ...robot, joints: robot.joints.with(joint, { ...old, controller }) } };
}

/**
 * @param {Doc} doc
 * @param {ControllerCommand} command
 * @returns {Issue | null}
 */
export function controllerRefusal({ robot: { joints } }, { joint, controller }) {
  const bad = badIndex('joint', joint, joints.length);
  if (bad) return bad;
  const path = `robot.joints.${joint}.controller`;
  const { sign, offset, coupling, coupledTo } = Object(controller);
  if (sign !== 1 && sign !== -1) {
    return issue('choice', `${path}.sign`, `A sign is 1 or −1; got ${shown(sign)}.`);
  }
  const what = 'number on the pendant';
  return badNumber(what, offset) ?? badNumber(what, coupling) ?? badCoupling(joints, joint, path, coupling, coupledTo);
}

/**
 * @param {Doc['robot']['joints']} joints
 * @param {number} index
 * @param {string} path
 * @param {number} coupling
 * @param {string | undefined} coupledTo
 */
function badCoupling(joints, index, path, coupling, coupledTo) {
  const at = `${path}.coupledTo`;
  if (coupledTo === undefined) {
    return coupling === 0 ? null : issue('coupling-without-joint', at, 'A coupling is to a joint.');
  }
  const nameOf = (/** @type {number} */ i) => `J${i + 1}`;
  const chain = [index];
  let next = /** @type {string | undefined} */ (coupledTo);
  while (next !== undefined) {
    const id = next;
    const i = joints.findIndex((joint) => joint.id === id);
    if (i < 0) return issue('coupling-unknown', at, `There is no joint ${shown(id)}.`);
    if (i === index) {
      const circle = [...chain, index].map(nameOf).join(', ');
      return issue('coupling-circle', at, `A circle of couplings: ${circle}.`);
    }
    chain.push(i);
    next = joints[i].controller.coupledTo;
  }
  const [, other] = chain;
  if (isSliding(joints[other]) === isSliding(joints[index])) return null;
  const [turns, slides] = (isSliding(joints[other]) ? [index, other] : [other, index]).map(nameOf);
  return issue('coupling-kinds', at, `${turns} turns and ${slides} slides; a coupling adds numbers of one kind.`);
}
