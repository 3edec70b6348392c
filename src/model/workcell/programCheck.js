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
 * @import { Workcells, Clearance } from './workcell.js'
 * @import { Chain, ChainDescription } from '../../kinematics/chain.js'
 */
import { planMomentAt } from '../../motion/planMoment.js';
import { planNow } from '../program/planning.js';
import { postureFromKernel } from '../compile.js';
import { marginNow } from './workcellView.js';

/**
 * What is to be known of the program as it is now; null where there is nothing to check, or nothing to keep clear of.
 * @param {AppState} state
 * @returns {Pick<ProgramCheck, 'planned' | 'obstacles' | 'margin'> | null}
 */
export function checkWanted(state) {
  const planned = planNow(state);
  const { obstacles } = state.doc;
  if (!planned || planned.plan.parts.length === 0 || obstacles.length === 0) return null;
  return { planned, obstacles, margin: state.session.workcell.margin };
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
export const checkRequest = ({ doc, session }, chain, cells, { plan }) => ({
  chain: describe(chain),
  radii: cells.radii(doc),
  obstacles: cells.obstacles(doc),
  parts: plan.parts,
  margin: marginNow(session.workcell, chain),
});

/**
 * The answer, by the steps of the program, in their order.
 * @param {readonly PlanTouch[]} found
 * @param {Planned} planned
 * @param {(near: PlanTouch['near']) => Clearance} named
 * @returns {StepTouch[]}
 */
export function stepTouches(found, { steps }, named) {
  /** @type {Map<number, StepTouch>} a called program has several moves in one step */
  const bySteps = new Map();
  for (const { move, near, ...rest } of found) {
    const step = steps[move];
    const known = bySteps.get(step);
    if (!known || (rest.isTouch && !known.isTouch)) bySteps.set(step, { ...named(near), ...rest, step });
  }
  return [...bySteps.values()].sort((one, other) => one.step - other.step);
}

/**
 * Where a joint move begins and ends: what a way around has to join.
 * @param {Planned} planned
 * @param {number} step   its index
 * @returns {{ from: Float64Array, to: Float64Array } | null}  null: the step is no joint move
 */
export function endsOfMove({ plan, moves, steps }, step) {
  const at = steps.indexOf(step);
  const move = moves[at];
  if (move?.kind !== 'joint' || steps.lastIndexOf(step) !== at) return null;
  if (at === 0) return { from: plan.start, to: move.posture };
  const last = moves[at - 1];
  if (last.kind === 'joint') return { from: last.posture, to: move.posture };
  const part = plan.parts.findLast((one) => one.move === at - 1);
  return part ? { from: planMomentAt(plan, part.end).posture, to: move.posture } : null;
}

/**
 * The question for the planner.
 * @param {AppState} state
 * @param {Chain} chain
 * @param {Workcells} cells
 * @param {{ from: Float64Array, to: Float64Array }} ends
 * @param {{ seed: number, iterations: number }} options
 */
export const aroundRequest = ({ doc, session }, chain, cells, { from, to }, options) => ({
  chain: describe(chain),
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
