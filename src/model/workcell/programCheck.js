/**
 * Whether a motion program keeps clear: the question, and the answer as far as it has come. An answer to another question than
 * the present one is stale.
 *
 * @import { ProgramCheck, StepTouch } from './checked.js'
 * @import { Doc, MoveStep } from '../document.js'
 * @import { NewStep } from '../program/motionCommands.js'
 * @import { Planned } from '../program/planned.js'
 * @import { AppState } from '../session.js'
 * @import { PlanTouch } from '../../motion/clearance/checkPlan.js'
 * @import { Workcells } from './workcell.js'
 * @import { Chain, ChainDescription } from '../../kinematics/chain.js'
 */
import { planMomentAt } from '../../motion/planMoment.js';
import { planNow } from '../program/planning.js';
import { chainOfMove } from '../program/planSeries.js';
import { postureFromKernel } from '../compile.js';
import { named } from './workcell.js';
import { marginNow } from './workcellView.js';

/**
 * What is to be known of the program as it is now; null where there is nothing to check.
 * @param {AppState} state
 * @returns {Pick<ProgramCheck, 'planned' | 'obstacles' | 'margin'> | null}
 */
export function checkWanted(state) {
  const planned = planNow(state);
  if (!planned || planned.plan.parts.length === 0) return null;
  return { planned, obstacles: state.doc.obstacles, margin: state.session.workcell.margin };
}

/** Whether both have the same answer. @param {ReturnType<typeof checkWanted>} one @param {ReturnType<typeof checkWanted>} other */
export const isSameCheck = (one, other) =>
  one === other ||
  (one !== null &&
    other !== null &&
    one.planned === other.planned &&
    one.obstacles === other.obstacles &&
    one.margin === other.margin);

/** What is known of the program as it is now. @param {AppState} state @returns {ProgramCheck | null} */
export function checkNow(state) {
  const { check } = state.session;
  return check && isSameCheck(check, checkWanted(state)) ? check : null;
}

/** @param {Chain} chain @returns {ChainDescription} */
const describe = ({ convention, base, tool, joints }) => ({ convention, base, tool, joints });

/**
 * The question for the worker.
 * @param {AppState} state
 * @param {Chain} chain
 * @param {Workcells} cells
 * @param {Planned} planned
 */
export function checkRequest({ doc, session }, chain, cells, { plan, moves }) {
  const ofMoves = moves.map((_, index) => chainOfMove(moves, index) ?? chain);
  const chains = [...new Set(ofMoves)];
  return {
    chains: chains.map(describe),
    chainOf: ofMoves.map((one) => chains.indexOf(one)),
    radii: cells.radii(doc),
    obstacles: cells.obstacles(doc),
    parts: plan.parts,
    margin: marginNow(session.workcell, chain),
  };
}

/**
 * The answer, by the steps of the program, in their order.
 * @param {readonly PlanTouch[]} found
 * @param {Planned} planned
 * @param {Pick<Doc, 'robot' | 'obstacles'>} doc
 * @returns {StepTouch[]}
 */
export function stepTouches(found, { steps }, doc) {
  /** @type {Map<number, StepTouch>} a called program has several moves in one step */
  const bySteps = new Map();
  for (const { move, near, ...rest } of found) {
    const step = steps[move];
    const known = bySteps.get(step);
    if (!known || (rest.isTouch && !known.isTouch)) bySteps.set(step, { ...named(doc, near), ...rest, step });
  }
  return [...bySteps.values()].sort((one, other) => one.step - other.step);
}

/**
 * Where a joint move begins and ends: what a way around has to join.
 * @param {Planned} planned
 * @param {number} step   its index
 * @returns {{ from: Float64Array, to: Float64Array, chain?: Chain } | null}  null: the step is no joint move. chain: with another
 *   tool than the active one
 */
export function endsOfMove({ plan, moves, steps }, step) {
  const at = steps.indexOf(step);
  const move = moves[at];
  if (move?.kind !== 'joint' || steps.lastIndexOf(step) !== at) return null;
  const from = postureBefore(plan, moves, at);
  return from && { from, to: move.posture, ...(move.chain && { chain: move.chain }) };
}

/** Where the arm is asked to be before a move; null where it does not get there. @param {Planned['plan']} plan @param {Planned['moves']} moves @param {number} at */
function postureBefore(plan, moves, at) {
  if (at === 0) return plan.start;
  const last = moves[at - 1];
  if (last.kind === 'joint') return last.posture;
  const part = plan.parts.findLast((one) => one.move === at - 1);
  return part ? planMomentAt(plan, part.end).posture : null;
}

/**
 * The question for the planner.
 * @param {AppState} state
 * @param {Chain} chain
 * @param {Workcells} cells
 * @param {NonNullable<ReturnType<typeof endsOfMove>>} ends
 * @param {{ seed: number, iterations: number }} options
 */
export const aroundRequest = ({ doc, session }, chain, cells, { from, to, chain: own = chain }, options) => ({
  chain: describe(own),
  radii: Float64Array.from(cells.radii(doc)),
  obstacles: cells.obstacles(doc),
  ...{ from, to },
  options: { ...options, margin: marginNow(session.workcell, chain) },
});

/** So many digits of a value are kept: a thousandth of a degree is far finer than the margin. */
const DIGITS = 9;

/**
 * The postures between both ends of a way as moves like the one that they lead to; each stops, so that the arm goes just where
 * it was proven to be clear.
 * @param {Doc} doc
 * @param {number} program  its index
 * @param {number} step     of the joint move that the way takes the place of
 * @param {readonly ArrayLike<number>[]} way
 */
export function waySteps(doc, program, step, way) {
  const move = /** @type {MoveStep} */ (doc.motionPrograms[program].steps[step]);
  return way.slice(1, -1).map(
    (q) =>
      /** @type {NewStep} */ ({
        ...move,
        ...{ id: undefined, comment: undefined },
        target: {
          kind: 'posture',
          values: postureFromKernel(doc.robot, q).map((value) => Number(value.toPrecision(DIGITS))),
        },
        ending: { kind: 'fine' },
      }),
  );
}
