/**
 * A motion program of the document as controllers want it: what `src/karel/write` makes code of. Programs that it calls are put
 * in its place, calls of what only the controller has stay.
 *
 * @import { Doc, MotionProgramDoc, MoveStep, RobotDoc, StepDoc, StepTarget } from '../document.js'
 * @import { Issue } from '../issues.js'
 * @import { Brand, ControllerFrames } from './frameNumbers.js'
 * @import { FollowedMove } from './followMoves.js'
 * @import { NeutralMove, NeutralProgram, NeutralStep, NeutralTarget } from '../../karel/write/neutral.js'
 * @import { Lost } from './lostLaws.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Move } from '../../motion/moves.js'
 *
 * @typedef {object} MadeMove
 * @property {NeutralMove} move
 * @property {Exclude<Move, { kind: 'wait' }>} kernel
 * @property {FollowedMove} followed
 * @property {Float64Array} from
 * @property {Lost | null} lost   what of it no controller's language holds
 *
 * @typedef {object} NeutralOptions
 * @property {Brand} brand
 * @property {string} version
 * @property {string} generatedAt
 * @property {readonly number[]} [start]   where the arm stands at first
 * @property {string} [userFrame]          in which all positions are; '' for the world; absent: as the steps have it
 * @property {Readonly<Record<string, number>>} [numbers]  of frames (frameNumbers.js)
 *
 * @typedef {object} MadeProgram
 * @property {NeutralProgram} program
 * @property {readonly MadeMove[]} moves   of the program, with where the arm goes
 * @property {ControllerFrames} frames
 * @typedef {{ made: MadeProgram, issues: readonly [] } | { made: null, issues: readonly Issue[] }} Made
 */
import { dexterity } from '../../kinematics/dexterity.js';
import { tcpPose } from '../../kinematics/forward.js';
import { rollPitchYawOf } from '../../kinematics/orientation.js';
import { compose, invert } from '../../kinematics/pose.js';
import { compilePose, compilePosture, compileRobot, postureFromKernel } from '../compile.js';
import { isSliding } from '../document.js';
import { configurationAt } from '../aim/solutions.js';
import { atOnce, within } from '../inSlices.js';
import { movesInSlices } from '../program/motionPlan.js';
import { isMove } from '../program/motionProgram.js';
import { issue } from '../refusalParts.js';
import { convertAngle, convertLength, fromKernel } from '../units.js';
import { conventionLines } from './controllerConvention.js';
import { followMove, postureAlong } from './followMoves.js';
import { controllerFrames } from './frameNumbers.js';
import { valuesInside } from './insideLimits.js';
import { lawNotes, lostOf, viaWays } from './lostLaws.js';

const CONTROLLER_UNITS = /** @type {const} */ ({ length: 'mm', angle: 'deg' });

/** % of the way to where the program begins. */
const START_SPEED = 10;

/** One over the condition number, below which the decimals of a position leave open where the axes are that it depends on. */
const SINGULAR = 1e-3;

/** Degrees: an axis nearer than this to where its turn gets another number may be on either side of it, by the decimals of a position. */
const BORDER = 0.05;
const FANUC_TURN_AXES = [0, 3, 5];

const REASONS = {
  border: 'an axis is there where its turn gets another number, and decimals leave open on which side',
  singular: 'the posture there is singular, and its configuration does not tell it from others',
  'not-six-axes': 'configurations are for arms with six axes',
  prismatic: 'configurations are for arms whose axes all turn',
  'no-spherical-wrist': 'configurations are for arms whose last three axes meet',
  'no-shoulder': 'the first two axes are parallel, and the arm has no shoulder that a configuration could name',
  'no-elbow': 'the arm has no elbow that a configuration could name',
};

/**
 * @param {Doc} doc
 * @param {MotionProgramDoc} program
 * @param {NeutralOptions} options
 * @returns {Made}
 */
export const neutralProgram = (doc, program, options) => atOnce(neutralInSlices(doc, program, options));

/**
 * The same, move by move.
 * @param {Doc} doc
 * @param {MotionProgramDoc} program
 * @param {NeutralOptions} options
 * @returns {Generator<number, Made>}
 */
export function* neutralInSlices(doc, program, options) {
  const { brand, version, generatedAt, start = doc.posture } = options;
  const { robot } = doc;
  const planned = yield* within(movesInSlices(doc, program, start), 0);
  if (planned.issues.length > 0) return { made: null, issues: planned.issues };
  const frames = controllerFrames(doc, brand, options.numbers);
  const ways = viaWays(compileRobot(robot), planned.moves, planned.limits);
  /** @type {NeutralStep[]} */
  const steps = [];
  /** @type {MadeMove[]} */
  const moves = [];
  let /** @type {Float64Array} */ from = compilePosture(robot, start);
  let next = 0;

  /** @param {MoveStep} step @param {number} index @param {Exclude<Move, { kind: 'wait' }>} kernel @param {number} [planIndex]  of the move in the plan @returns {string | null} why not */
  function add(step, index, kernel, planIndex = -1) {
    const tool = frames.toolOf(step);
    const chain = /** @type {Chain} */ (frames.chainOf(tool));
    const userId = options.userFrame ?? step.frame ?? frameOf(doc, step.target);
    const userFrame = frames.userOf(userId);
    const T_user_world = invert(/** @type {Float64Array} */ (frames.userPose(userFrame)));
    const followed = followMove(chain, from, kernel);
    if ('message' in followed) return followed.message;
    const targetOf = (/** @type {StepTarget} */ target, /** @type {Float64Array} */ q, /** @type {Float64Array} */ T) =>
      neutralTarget(robot, chain, target, q, compose(T_user_world, T), step.kind === 'joint');
    const via =
      kernel.kind === 'circular' && step.via
        ? targetOf(step.via, postureNear(followed, kernel.via), kernel.via)
        : undefined;
    const T_end = kernel.kind === 'joint' ? tcpPose(chain, followed.end) : kernel.T_base_tcp;
    const way = ways.of(planIndex, from);
    const lost = lostOf(step, way, followed);
    /** @type {NeutralMove} */
    const move = {
      ...{ kind: 'move', motion: step.kind, target: targetOf(step.target, followed.end, T_end), ...(via && { via }) },
      ...{ speed: speedOf(robot, step), acceleration: step.acceleration },
      ending: lost && step.ending.kind !== 'fine' ? { kind: 'percent', value: 100 } : endingOf(robot, step),
      ...{ userFrame, tool, step: index, ...(step.comment && { comment: step.comment }) },
    };
    steps.push(move);
    moves.push({ move, kernel, followed, from, lost });
    from = followed.end;
    return null;
  }

  /** @param {MotionProgramDoc} one @param {number | null} calledBy @returns {Generator<number, Issue | null>} */
  function* through(one, calledBy) {
    for (const [i, step] of one.steps.entries()) {
      if (step.disabled) continue;
      const index = calledBy ?? i;
      const called = step.kind === 'call' && doc.motionPrograms.find(({ id }) => id === step.program);
      if (called) {
        const inner = yield* through(called, index);
        if (inner) return inner;
      } else if (isMove(step)) {
        const at = next++;
        const kernel = /** @type {Exclude<Move, { kind: 'wait' }>} */ (planned.moves[at]);
        if (moves.length === 0 && kernel.kind !== 'joint') add(startStep(start), -1, startMove(robot, start));
        const reason = add(step, index, kernel, at);
        yield next / planned.moves.length;
        if (reason) return issue('step-impossible', `steps.${index}`, `Step ${index + 1}: ${reason}.`);
      } else {
        if (step.kind === 'wait') next++;
        steps.push(...otherStep(step));
      }
    }
    return null;
  }

  const fault = yield* through(program, null);
  if (fault) return { made: null, issues: [fault] };
  if (moves.length === 0)
    return {
      made: null,
      issues: [issue('no-moves', 'steps', 'The program has no moves that code could be written of.')],
    };
  const used = frames.numbered.filter(({ kind, number }) =>
    moves.some(({ move }) => (kind === 'user' ? move.userFrame : move.tool) === number),
  );
  return {
    made: {
      program: {
        ...{ name: program.name, robotName: robot.name, version, generatedAt, steps },
        ...{ convention: conventionLines(robot), slides: robot.joints.map(isSliding), notes: lawNotes(moves) },
        frames: used.map(({ kind, number, name, pose }) => ({
          ...{ kind, number, name: name || 'in use' },
          position: controllerPosition(
            kind === 'user'
              ? compose(invert(frames.T_world_zero), compilePose(pose, robot.units))
              : compilePose(pose, robot.units),
          ),
        })),
      },
      ...{ moves, frames },
    },
    issues: [],
  };
}

/** The first way is by the joints: from wherever the arm stands. @param {readonly number[]} values @returns {MoveStep} */
const startStep = (values) => ({
  ...{ id: 'start', kind: 'joint', target: { kind: 'posture', values }, speed: START_SPEED, speedUnit: '%' },
  ...{ acceleration: 100, ending: { kind: 'fine' }, comment: 'to where the program begins' },
});

/** @param {RobotDoc} robot @param {readonly number[]} values @returns {Extract<Move, { kind: 'joint' }>} */
const startMove = (robot, values) => ({
  ...{ kind: 'joint', posture: compilePosture(robot, values), speed: START_SPEED / 100, acceleration: 1 },
  ending: { kind: 'fine' },
});

/** @param {Doc} doc @param {StepTarget} target */
const frameOf = (doc, target) =>
  target.kind === 'target' ? doc.targets.find(({ id }) => id === target.id)?.frame : undefined;

/** x y z w p r in mm and degrees. @param {Float64Array} T */
export const controllerPosition = (T) => [
  ...[T[12], T[13], T[14]].map((value) => fromKernel('length', value, CONTROLLER_UNITS)),
  ...rollPitchYawOf(T).map((value) => fromKernel('angle', value, CONTROLLER_UNITS)),
];

/**
 * @param {RobotDoc} robot
 * @param {Chain} chain
 * @param {StepTarget} target
 * @param {Float64Array} q
 * @param {Float64Array} T_user_tcp
 * @param {boolean} isByJoints  the move: which posture it ends in is not known from where it comes
 * @returns {NeutralTarget}
 */
function neutralTarget(robot, chain, target, q, T_user_tcp, isByJoints) {
  const posture = target.kind === 'posture' ? [...target.values] : postureFromKernel(robot, q);
  const { fanuc, kuka } = configurationAt(robot, chain, posture);
  const isSingular = isByJoints && 1 / dexterity(chain, q).conditionNumber < SINGULAR;
  if (isSingular && target.kind !== 'posture' && fanuc.text !== null) {
    const values = { joints: valuesInside(robot, posture), position: controllerPosition(T_user_tcp) };
    return { ...values, fanuc: null, kuka: null, isJoint: false, reason: REASONS.singular };
  }
  const joints = valuesInside(robot, posture);
  const onBorder = {
    fanuc: isByJoints && FANUC_TURN_AXES.some((axis) => isNear(joints[axis], 180)),
    kuka: isByJoints && joints.some((value) => isNear(value, 0)),
  };
  return {
    ...{ joints, position: controllerPosition(T_user_tcp) },
    fanuc: onBorder.fanuc ? null : fanuc.text,
    kuka: onBorder.kuka || kuka.status === null ? null : { status: kuka.status, turn: kuka.turn },
    isJoint: target.kind === 'posture',
    reason: REASONS[fanuc.reason ?? 'border'],
  };
}

/** Whole turns aside. @param {number} value  degrees @param {number} border */
const isNear = (value, border) => Math.abs(value - border - 360 * Math.round((value - border) / 360)) < BORDER;

/** How many postures of an arc are looked at for the one at its middle point. */
const ARC_SAMPLES = 64;

/** Of the postures along an arc, the one whose place is nearest. @param {FollowedMove} followed @param {Float64Array} T_base_via */
function postureNear({ chain, path }, T_base_via) {
  const away = (/** @type {Float64Array} */ q) => {
    const T = tcpPose(chain, q);
    return Math.hypot(T[12] - T_base_via[12], T[13] - T_base_via[13], T[14] - T_base_via[14]);
  };
  const all = Array.from({ length: ARC_SAMPLES + 1 }, (_, i) => postureAlong(path, i / ARC_SAMPLES));
  return all.reduce((best, q) => (away(q) < away(best) ? q : best));
}

/** @param {RobotDoc} robot @param {MoveStep} step @returns {NeutralMove['speed']} */
function speedOf({ units }, { speed, speedUnit }) {
  if (speedUnit === '%') return { value: speed, unit: '%' };
  if (speedUnit === 'length/s') return { value: convertLength(speed, units.length, 'mm'), unit: 'mm/s' };
  return { value: convertAngle(speed, units.angle, 'deg'), unit: 'deg/s' };
}

/** @param {RobotDoc} robot @param {MoveStep} step @returns {NeutralMove['ending']} */
function endingOf({ units }, { ending }) {
  return ending.kind === 'distance'
    ? { kind: 'distance', value: convertLength(ending.value, units.length, 'mm') }
    : ending;
}

/** @param {Exclude<StepDoc, MoveStep>} step @returns {NeutralStep[]} */
function otherStep(step) {
  switch (step.kind) {
    case 'wait':
      return [{ kind: 'wait', seconds: step.seconds }];
    case 'set-output':
      return [{ kind: 'output', port: step.output, value: step.value === 'on' }];
    case 'wait-input':
      return [{ kind: 'input', port: step.input, value: step.value === 'on' }];
    case 'call':
      return [{ kind: 'call', program: step.program }];
    case 'label':
      return [{ kind: 'comment', text: step.label }];
    case 'comment':
      return [{ kind: 'comment', text: step.text }];
  }
}
