/**
 * Steps that are not in a program yet: recorded where the arm stands, or with the values that one begins with.
 *
 * @import { Doc, MotionProgramDoc, MoveStep, PoseTarget, StepKind, StepTarget } from '../document.js'
 * @import { NewStep } from './motionCommands.js'
 * @import { Recording } from './recording.js'
 * @import { Chain } from '../../kinematics/chain.js'
 */
import { tcpPose } from '../../kinematics/forward.js';
import { compilePosture } from '../compile.js';
import { seenFromUser } from '../frames/frames.js';
import { poseInUnits } from '../numbers/poseNumbers.js';
import { configurationAt } from '../aim/solutions.js';
import { fromKernel } from '../units.js';

/** % of the joint rates; m/s of the tool. */
const FIRST_JOINT_SPEED = 50;
const FIRST_TOOL_SPEED = 0.25;
const FIRST_WAIT = 0.5;

/**
 * Where the tool is, as a move keeps it: in the active user frame, with the configuration of the arm.
 * @param {Doc} doc
 * @param {Chain} chain  compiled from its robot
 * @returns {PoseTarget}
 */
export function poseHere(doc, chain) {
  const { robot, posture, activeUser } = doc;
  const T = tcpPose(chain, compilePosture(robot, posture));
  const seen = activeUser === undefined ? T : seenFromUser(doc, activeUser, T);
  const { text } = configurationAt(robot, chain, posture).fanuc;
  return { kind: 'pose', ...poseInUnits(seen, robot.units), ...(text !== null && { configuration: text }) };
}

/**
 * The move that takes the arm to where it stands. Speed and ending are those of the last move of its kind before it.
 * @param {Doc} doc
 * @param {Chain} chain
 * @param {Recording} recording
 * @param {MotionProgramDoc['steps']} before  the steps before it
 * @returns {NewStep}
 */
export function recordedStep(doc, chain, { kind, via }, before) {
  const target = kind === 'joint' ? postureHere(doc) : poseHere(doc, chain);
  return withTarget(doc, kind, target, before, kind === 'circular' ? via : null);
}

/** @param {Doc} doc @returns {StepTarget} */
export const postureHere = ({ posture }) => ({ kind: 'posture', values: [...posture] });

/**
 * @param {Doc} doc
 * @param {MoveStep['kind']} kind
 * @param {StepTarget} target
 * @param {MotionProgramDoc['steps']} before
 * @param {StepTarget | null} [via]
 * @returns {NewStep}
 */
export function withTarget(doc, kind, target, before, via = null) {
  const last = /** @type {MoveStep | undefined} */ (before.findLast((step) => step.kind === kind));
  const { speed, speedUnit, acceleration, ending, law } = last ?? firstManner(doc, kind);
  const { activeTool, activeUser } = doc;
  return {
    kind,
    ...(via && { via }),
    target,
    ...{ speed, speedUnit, acceleration, ending },
    ...(law !== undefined && { law }),
    ...(activeTool !== undefined && { tool: activeTool }),
    ...(activeUser !== undefined && target.kind === 'pose' && { frame: activeUser }),
  };
}

/**
 * How a move of a kind goes where nobody has said it.
 * @param {Doc} doc
 * @param {MoveStep['kind']} kind
 * @returns {Pick<MoveStep, 'speed' | 'speedUnit' | 'acceleration' | 'ending' | 'law'>}
 */
export function firstManner({ robot: { units } }, kind) {
  const speed = kind === 'joint' ? FIRST_JOINT_SPEED : fromKernel('length', FIRST_TOOL_SPEED, units);
  return { speed, speedUnit: kind === 'joint' ? '%' : 'length/s', acceleration: 100, ending: { kind: 'fine' } };
}

/**
 * What is done between moves.
 * @param {Exclude<StepKind, MoveStep['kind']>} kind
 * @param {Doc} doc
 * @param {MotionProgramDoc | null} program  that it is for
 * @returns {NewStep}
 */
export function newStep(kind, { motionPrograms }, program) {
  switch (kind) {
    case 'wait':
      return { kind, seconds: FIRST_WAIT };
    case 'set-output':
      return { kind, output: 1, value: 'on' };
    case 'wait-input':
      return { kind, input: 1, value: 'on' };
    case 'call':
      return { kind, program: motionPrograms.find(({ id }) => id !== program?.id)?.id ?? 'PROGRAM' };
    case 'label':
      return { kind, label: '1' };
    case 'comment':
      return { kind, text: '' };
    default: {
      /** @type {never} */
      const unknown = kind;
      throw new TypeError(`Unknown step: ${JSON.stringify(unknown)}`);
    }
  }
}
