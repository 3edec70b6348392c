/**
 * A motion that running code asks for, as a plan for the arm. The controller counts in millimetres and degrees, in its own way of
 * counting joints, and in the active user frame unless the code says another.
 *
 * Approximations: every motion stops at its end; a joint motion goes at the joints' full rates; NEAR, AWAY, BY, RELATIVE and AXIS are not
 * simulated, since nothing published says exactly what they do.
 *
 * @import { Doc, MoveStep, PoseTarget, StepTarget } from '../document.js'
 * @import { Effect, State } from '../../karel/run/machine.js'
 * @import { MotionPlan } from '../../motion/plan.js'
 */
import { configText } from '../../karel/run/positions.js';
import { planMotion } from '../../motion/plan.js';
import { compilePosture, compileRobot } from '../compile.js';
import { postureFromPendant } from '../controller/pendantNumbers.js';
import { motionMoves } from '../program/motionPlan.js';
import { fromKernel, toKernel } from '../units.js';

const PENDANT = /** @type {const} */ ({ length: 'mm', angle: 'deg' });
const LINEAR = 7;
const CIRCULAR = 8;
/** mm/s, where the code says nothing. */
const FIRST_SPEED = 300;

/**
 * @param {Doc} doc
 * @param {readonly number[]} posture  where the arm stands, in document units
 * @param {Effect} effect              of kind 'move'
 * @param {State['system']} system     variables of the controller
 * @returns {{ plan: MotionPlan } | { message: string }}
 */
export function planOfMove(doc, posture, effect, system) {
  const steps = stepsOf(doc, effect, system);
  if ('message' in steps) return steps;
  const program = { id: 'code', name: 'code', steps };
  const { moves, limits, issues } = motionMoves({ ...doc, motionPrograms: [program] }, program, posture);
  if (issues.length > 0) return { message: issues[0].message.replace(/^Step \d+: /, '') };
  return { plan: planMotion(compileRobot(doc.robot), compilePosture(doc.robot, posture), moves, limits) };
}

/** @param {Doc} doc @param {Effect} effect @param {State['system']} system @returns {MoveStep[] | { message: string }} */
function stepsOf(doc, effect, system) {
  const { to, isJoint } = effect;
  const settings = /** @type {Record<string, unknown>} */ (effect.settings ?? {});
  const set = (/** @type {string} */ name) => settings[`$${name}`] ?? system[name];
  const places = to === 'ALONG' ? nodesOf(effect.nodes) : to === 'TO' ? [effect.position] : null;
  if (!places) return { message: `MOVE ${String(to)} is not simulated here; MOVE TO and MOVE ALONG are.` };
  const kind = isJoint ? 'joint' : (KINDS[Number(set('MOTYPE'))] ?? 'joint');
  const speed = Number(set('SPEED') ?? FIRST_SPEED);
  if (!(speed > 0)) return { message: `Expected $SPEED above 0, got ${speed}.` };
  /** @type {MoveStep[]} */
  const steps = [];
  for (const [i, place] of places.entries()) {
    const target = targetOf(doc, place, Boolean(isJoint));
    const via = kind === 'circular' ? targetOf(doc, effect.via, false) : null;
    if (!target || (kind === 'circular' && !via)) return { message: 'A position that is moved to is uninitialised.' };
    const { units } = doc.robot;
    steps.push({
      ...{ id: `move_${i}`, kind, target },
      ...(via && { via }),
      ...(kind === 'joint'
        ? { speed: 100, speedUnit: '%' }
        : { speed: fromKernel('length', toKernel('length', speed, PENDANT), units), speedUnit: 'length/s' }),
      ...{ acceleration: 100, ending: { kind: 'fine' } },
      ...(target.kind === 'pose' && doc.activeUser !== undefined && { frame: doc.activeUser }),
    });
  }
  return steps;
}

/** By $MOTYPE. @type {Readonly<Record<number, MoveStep['kind']>>} */
const KINDS = { [LINEAR]: 'linear', [CIRCULAR]: 'circular' };

/** The positions of a path: its nodes are positions, or structures that begin with one. @param {unknown} nodes @returns {unknown[]} */
const nodesOf = (nodes) =>
  /** @type {unknown[]} */ (nodes).map((node) =>
    Array.isArray(node) ? node : Object.values(/** @type {object} */ (node ?? {})).find(Array.isArray),
  );

/** @param {Doc} doc @param {unknown} place @param {boolean} isJoint @returns {StepTarget | null} null: something of it was never set */
function targetOf({ robot }, place, isJoint) {
  if (!Array.isArray(place)) return null;
  const values = isJoint ? place.slice(0, robot.joints.length) : place.slice(0, 6);
  if (values.length < (isJoint ? robot.joints.length : 6) || values.some((value) => typeof value !== 'number'))
    return null;
  if (isJoint) return { kind: 'posture', values: postureFromPendant(robot, values) };
  const convert = (/** @type {'length' | 'angle'} */ quantity) => (/** @type {number} */ value) =>
    fromKernel(quantity, toKernel(quantity, value, PENDANT), robot.units);
  const word = Number(place[6] ?? 0);
  /** @type {PoseTarget} */
  const target = {
    kind: 'pose',
    xyz: values.slice(0, 3).map(convert('length')),
    rpy: values.slice(3).map(convert('angle')),
  };
  return word === 0 ? target : { ...target, configuration: configText(word) };
}
