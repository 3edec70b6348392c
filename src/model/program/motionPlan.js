/**
 * A motion program of the document → moves for the kernel, in metres, radians and seconds. What neither the robot nor the
 * program says is assumed, and named; what cannot be a move is an issue that names its step. Everything is planned from where
 * the arm stands at first.
 *
 * Outputs, labels and remarks take no time; an input is taken to be there at once; a call of a program that only the controller
 * has is passed over. A joint move to a pose goes to the posture of the configuration that is asked for, or else to the one
 * nearest to where the arm comes from.
 *
 * @import { Doc, MotionProgramDoc, MoveStep, StepDoc, StepTarget, TargetDoc } from '../document.js'
 * @import { Issue } from '../issues.js'
 * @import { Assumption } from './motionLimits.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Ending, JointLimits, JointMove, Move, PlanLaw, ToolMoveBase, ViaMove } from '../../motion/moves.js'
 *
 * @typedef {Issue & { readonly step: number }} StepIssue   step: its index in the program
 *
 * @typedef {object} KernelMoves
 * @property {readonly Move[]} moves   none where there is an issue
 * @property {readonly number[]} steps   of each move: the index of its step in the program; of a called program's: of the call
 * @property {JointLimits} limits
 * @property {readonly Assumption[]} assumptions
 * @property {readonly StepIssue[]} issues
 */
import { allInverseKinematics } from '../../kinematics/allInverse.js';
import { tcpPose } from '../../kinematics/forward.js';
import { inverseKinematics } from '../../kinematics/inverse.js';
import { compose } from '../../kinematics/pose.js';
import { compilePose, compilePosture, compileRobot, postureFromKernel } from '../compile.js';
import { framePose, poseOnly, targetPose } from '../frames/frames.js';
import { atOnce } from '../inSlices.js';
import { limitsOf } from './motionLimits.js';
import { isMove } from './motionProgram.js';
import { issue, shown } from '../refusalParts.js';
import { configurationAt } from '../aim/solutions.js';
import { toKernel } from '../units.js';

/** Of the tool, which no robot file states: m/s where only its turn has a speed, rad/s where only its way has one, m/s². */
export const ASSUMED_TOOL_SPEED = 1;
export const ASSUMED_TOOL_TURN = Math.PI;
export const ASSUMED_TOOL_ACCELERATION = 4;

/**
 * @param {Doc} doc
 * @param {MotionProgramDoc} program  of the document
 * @param {readonly number[]} [start]  where the arm stands at first, in document units
 * @returns {KernelMoves}
 */
export const motionMoves = (doc, program, start = doc.posture) => atOnce(movesInSlices(doc, program, start));

/**
 * The same, posture by posture.
 * @param {Doc} doc
 * @param {MotionProgramDoc} program
 * @param {readonly number[]} start
 * @returns {Generator<number, KernelMoves>} yields the share of the steps that is done
 */
export function* movesInSlices(doc, program, start) {
  const run = createRun(doc, start);
  yield* run.through(program, null, []);
  const { limits, assumed } = limitsOf(doc.robot.joints, doc.robot.units);
  return {
    moves: run.issues.length > 0 ? [] : run.moves,
    steps: run.issues.length > 0 ? [] : run.steps,
    limits,
    assumptions: [...assumed, ...run.assumptions()],
    issues: run.issues,
  };
}

/**
 * Where the arm stands at the end of a move: of a joint move, or of the same place gone to by its joints.
 * @param {Doc} doc
 * @param {MoveStep} step
 * @param {readonly number[]} [from]
 * @returns {{ posture: number[] } | { message: string }}
 */
export function postureAt(doc, step, from = doc.posture) {
  const found = atOnce(createRun(doc, from).postureOf(step));
  return 'message' in found ? found : { posture: postureFromKernel(doc.robot, found.posture) };
}

/**
 * What a program comes to, step by step.
 * @param {Doc} doc
 * @param {readonly number[]} start
 */
function createRun(doc, start) {
  const { robot } = doc;
  const { units } = robot;
  /** @type {Move[]} */
  const moves = [];
  /** @type {number[]} */
  const steps = [];
  /** @type {StepIssue[]} */
  const issues = [];
  /** @type {Map<Assumption['what'], Set<number>>} */
  const assumed = new Map();
  /** @type {Map<string | undefined, Chain>} */
  const chains = new Map([[undefined, compileRobot(robot)]]);
  /** Where the arm is after the last move: a posture, and then poses that are solved for only if somebody asks. */
  let /** @type {Float64Array} */ seed = compilePosture(robot, start);
  /** @type {{ chain: Chain, T: Float64Array }[]} */
  const passed = [];
  let share = 0;

  /** @param {Assumption['what']} what @param {number} step */
  const assume = (what, step) => assumed.set(what, (assumed.get(what) ?? new Set()).add(step));

  /** @param {MoveStep} step @returns {Chain} the arm with the step's tool */
  function chainOf({ tool }) {
    const id = tool === doc.activeTool ? undefined : tool;
    const known = chains.get(id);
    if (known) return known;
    const frame = doc.frames.find((one) => one.kind === 'tool' && one.id === id);
    const chain = compileRobot(frame ? { ...robot, tool: poseOnly(frame) } : robot);
    chains.set(id, chain);
    return chain;
  }

  /** Of a move with another tool than the active one. @param {MoveStep} step */
  function ownChain(step) {
    const chain = chainOf(step);
    return chain === chains.get(undefined) ? {} : { chain };
  }

  /** @returns {Generator<number, Float64Array>} */
  function* whereFrom() {
    for (const { chain, T } of passed.splice(0)) {
      yield share;
      const found = inverseKinematics(chain, T, { seed });
      if (found.status === 'converged' || found.status === 'subspace') seed = found.q;
    }
    return seed;
  }

  /** @param {MoveStep} step @param {StepTarget} target @returns {Float64Array} seen from the world */
  function poseOf(step, target) {
    if (target.kind === 'posture') return tcpPose(chainOf(step), compilePosture(robot, target.values));
    if (target.kind === 'target') return targetPose(doc, namedTarget(doc, target.id));
    const frame = doc.frames.find((one) => one.kind === 'user' && one.id === step.frame) ?? null;
    return compose(framePose(frame, units), compilePose(target, units));
  }

  /** @param {MoveStep} step @returns {Generator<number, { posture: Float64Array } | { message: string }>} */
  function* postureOf(step) {
    const { target } = step;
    if (target.kind === 'posture') return { posture: compilePosture(robot, target.values) };
    const asked = target.kind === 'target' ? namedTarget(doc, target.id).configuration : target.configuration;
    const chain = chainOf(step);
    const T = poseOf(step, target);
    const from = yield* whereFrom();
    const near = inverseKinematics(chain, T, { seed: from });
    const isMet = near.status === 'converged' || near.status === 'subspace';
    if (!isMet) return { message: UNREACHED[near.reason ?? 'distance'] };
    const has = (/** @type {Float64Array} */ q) =>
      isIn(asked ?? '', configurationAt(robot, chain, postureFromKernel(robot, q)).fanuc.text);
    if (asked === undefined || has(near.q)) return { posture: near.q };
    const other = allInverseKinematics(chain, T, { seed: from, onlyWithinLimits: true }).solutions.find(({ q }) =>
      has(q),
    );
    return other
      ? { posture: other.q }
      : { message: `The arm has no posture there in the configuration ${shown(asked)}.` };
  }

  /** @param {MoveStep} step @param {number} index @returns {Generator<number, string | null>} why not */
  function* move(step, index) {
    const ending = endingOf(step.ending, units);
    // only joint moves have the laws that go on through their targets (motionFaults.js)
    const law = step.law === undefined ? {} : { law: /** @type {PlanLaw} */ (step.law) };
    if (step.kind === 'joint') {
      const found = yield* postureOf(step);
      if ('message' in found) return found.message;
      const share = { speed: step.speed / 100, acceleration: step.acceleration / 100 };
      add(
        /** @type {JointMove | ViaMove} */ ({
          ...{ kind: 'joint', posture: found.posture, ending },
          ...{ ...share, ...law, ...ownChain(step) },
        }),
        index,
      );
      seed = found.posture;
      passed.length = 0;
      return null;
    }
    const chain = chainOf(step);
    const T = poseOf(step, step.target);
    const isTurn = step.speedUnit === 'angle/s';
    assume(isTurn ? 'tool-speed' : 'tool-turn', index);
    assume('tool-acceleration', index);
    /** @type {ToolMoveBase} */
    const tool = {
      T_base_tcp: T,
      speed: isTurn ? ASSUMED_TOOL_SPEED : toKernel('length', step.speed, units),
      turnSpeed: isTurn ? toKernel('angle', step.speed, units) : ASSUMED_TOOL_TURN,
      acceleration: (ASSUMED_TOOL_ACCELERATION * step.acceleration) / 100,
      ...law,
      ending,
      ...ownChain(step),
    };
    add(step.via ? { kind: 'circular', via: poseOf(step, step.via), ...tool } : { kind: 'linear', ...tool }, index);
    passed.push({ chain, T });
    return null;
  }

  /** @param {Move} one @param {number} index */
  function add(one, index) {
    moves.push(one);
    steps.push(index);
  }

  /**
   * @param {MotionProgramDoc} program
   * @param {number | null} calledBy  the step of the program that is planned
   * @param {readonly string[]} under  way
   * @returns {Generator<number, void>}
   */
  function* through({ id, name, steps: list }, calledBy, under) {
    for (const [i, step] of list.entries()) {
      if (step.disabled) continue;
      const index = calledBy ?? i;
      if (calledBy === null) share = i / list.length;
      yield share;
      const reason = yield* one(step, index, [...under, id]);
      if (reason === null) continue;
      const where = calledBy === null ? `Step ${i + 1}` : `Step ${i + 1} of ${shown(name)}`;
      issues.push({ ...issue('step-impossible', `steps.${index}`, `${where}: ${reason}`), step: index });
      return;
    }
  }

  /** @param {StepDoc} step @param {number} index @param {readonly string[]} under @returns {Generator<number, string | null>} why not */
  function* one(step, index, under) {
    if (isMove(step)) return yield* move(step, index);
    if (step.kind === 'wait') add({ kind: 'wait', seconds: step.seconds }, index);
    if (step.kind === 'wait-input') assume('input', index);
    if (step.kind !== 'call') return null;
    if (under.includes(step.program)) return 'The program would call itself.';
    const called = doc.motionPrograms.find(({ id }) => id === step.program);
    if (called) yield* through(called, index, under);
    else assume('call', index);
    return null;
  }

  return {
    ...{ moves, steps, issues, through, postureOf },
    /** @returns {Assumption[]} */
    assumptions: () => [...assumed].map(([what, indices]) => ({ what, steps: [...indices] })),
  };
}

export const UNREACHED = {
  distance: 'The arm does not reach this pose.',
  orientation: 'The arm reaches this place, but not so turned.',
  limits: 'The arm reaches this pose only past a limit of its joints.',
  joints: 'The arm has too few joints for this pose.',
};

/** @param {Doc} doc @param {string} id  that there is @returns {TargetDoc} */
const namedTarget = ({ targets }, id) => /** @type {TargetDoc} */ (targets.find((target) => target.id === id));

/**
 * Whether an arm stands in the configuration asked for: in the letters, and in the turns if they are asked for, too.
 * @param {string} asked
 * @param {string | null} text
 */
function isIn(asked, text) {
  const bare = (/** @type {string} */ words) => words.replace(/\s/g, '').toUpperCase();
  return text !== null && (bare(text) === bare(asked) || bare(text).split(',')[0] === bare(asked));
}

/** @param {MoveStep['ending']} ending @param {Doc['robot']['units']} units @returns {Ending} */
function endingOf(ending, units) {
  if (ending.kind === 'fine') return { kind: 'fine' };
  if (ending.kind === 'percent') return { kind: 'share', share: ending.value / 100 };
  return { kind: 'distance', distance: toKernel('length', ending.value, units) };
}
