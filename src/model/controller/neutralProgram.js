/**
 * A motion program of the document as controllers want it: what `src/karel/write` makes code of. Programs that it calls are put
 * in its place, calls of what only the controller has stay.
 *
 * @import { Doc, MotionProgramDoc, MoveStep, RobotDoc, StepDoc, StepTarget } from '../document.js'
 * @import { Issue } from '../issues.js'
 * @import { Brand, ControllerFrames } from './frameNumbers.js'
 * @import { FollowedMove } from './followMoves.js'
 * @import { NeutralMove, NeutralProgram, NeutralStep } from '../../karel/write/neutral.js'
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
import { tcpPose } from '../../kinematics/forward.js';
import { compose, invert } from '../../kinematics/pose.js';
import { compilePose, compilePosture, compileRobot } from '../compile.js';
import { isSliding } from '../document.js';
import { atOnce, within } from '../inSlices.js';
import { movesInSlices } from '../program/motionPlan.js';
import { isMove } from '../program/motionProgram.js';
import { issue } from '../refusalParts.js';
import { convertAngle, convertLength } from '../units.js';
import { conventionLines } from './controllerConvention.js';
import { followMove } from './followMoves.js';
import { controllerFrames } from './frameNumbers.js';
import { lawNotes, lostOf, viaWays } from './lostLaws.js';
import { controllerPosition, targetAt, taughtValues, viaAt } from './neutralTarget.js';

/** % of the way to where the program begins. */
const START_SPEED = 10;

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
    const around = { robot, chain, T_user_world, brand };
    const T_end = kernel.kind === 'joint' ? tcpPose(chain, followed.end) : kernel.T_base_tcp;
    const target = targetAt(around, followed.end, T_end, {
      taught: taughtValues(step.target),
      isByJoints: step.kind === 'joint',
    });
    const via =
      kernel.kind === 'circular' && step.via ? viaAt(around, followed, kernel.via, taughtValues(step.via)) : undefined;
    const way = ways.of(planIndex, from);
    const lost = lostOf(step, way, followed);
    /** @type {NeutralMove} */
    const move = {
      ...{ kind: 'move', motion: step.kind, target, ...(via && { via }) },
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
        ...(frames.zero && { zero: frames.zero }),
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
