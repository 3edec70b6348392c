/**
 * What the plan of a program assumes because nobody has said it, and where it does otherwise than was asked, in sentences.
 *
 * @import { Planned } from '../../model/program/planned.js'
 * @import { Doc } from '../../model/document.js'
 * @typedef {Planned['plan']['parts'][number]['notBlended']} NotBlended
 */
import { ASSUMED_SLIDE_RATE, ASSUMED_SPEED_UP, ASSUMED_TURN_RATE } from '../../model/program/motionLimits.js';
import { ASSUMED_TOOL_ACCELERATION, ASSUMED_TOOL_SPEED, ASSUMED_TOOL_TURN } from '../../model/program/motionPlan.js';
import { fromKernel } from '../../model/units.js';
import { compact, fixed, unitSign } from '../parts/format.js';
import { PLAN_NOTES } from '../words/planNotes.js';
import { PROGRAM } from '../words/program.js';

const WIDEST = 6;

/** @param {Planned} planned @param {Doc['robot']['units']} units @returns {string[]} */
export function planNotes({ plan, steps, assumptions }, units) {
  const { assumed } = PLAN_NOTES;
  /** @param {'length' | 'angle'} quantity @param {number} value @param {string} per */
  const shown = (quantity, value, per) =>
    `${compact(fromKernel(quantity, value, units), WIDEST).text} ${unitSign(units[quantity])}/${per}`;
  const notes = assumptions.map(({ what, joints = [], steps: at = [] }) => {
    const [whose, where] = [PLAN_NOTES.joints(joints.map(plusOne)), PLAN_NOTES.steps(at.map(plusOne))];
    switch (what) {
      case 'joint-rate':
        return assumed[what](whose, shown('angle', ASSUMED_TURN_RATE, 's'), shown('length', ASSUMED_SLIDE_RATE, 's'));
      case 'joint-acceleration':
        return assumed[what](whose, compact(ASSUMED_SPEED_UP, WIDEST).text);
      case 'tool-turn':
        return assumed[what](where, shown('angle', ASSUMED_TOOL_TURN, 's'));
      case 'tool-speed':
        return assumed[what](where, shown('length', ASSUMED_TOOL_SPEED, 's'));
      case 'tool-acceleration':
        return assumed[what](where, shown('length', ASSUMED_TOOL_ACCELERATION, 's²'));
      default:
        return assumed[what](where);
    }
  });
  for (const law of new Set(plan.parts.map(({ instead }) => instead))) {
    for (const timing of /** @type {const} */ (['trapezoid', 'doubleS'])) {
      const moves = plan.parts.filter((part) => part.instead === law && part.timing === timing);
      if (law === null || moves.length === 0) continue;
      const numbers = [...new Set(moves.map(({ move }) => plusOne(steps[move])))];
      notes.push(PLAN_NOTES.instead[timing](PLAN_NOTES.steps(numbers), PROGRAM.laws[law]));
    }
  }
  for (const { move, slowed, notBlended } of plan.parts) {
    const step = plusOne(steps[move]);
    for (const { from, to, joint } of slowed) {
      const why =
        joint === null ? PLAN_NOTES.because.bend : PLAN_NOTES.because.joint(PLAN_NOTES.joints([plusOne(joint)]));
      const [begin, end] = [percent(from), percent(to)];
      if (begin !== end) notes.push(PLAN_NOTES.slower(step, begin, end) + why);
    }
    if (isToldOf(notBlended)) notes.push(PLAN_NOTES.stops(step) + PLAN_NOTES.why[notBlended]);
  }
  return notes;
}

/** @param {number} index */
const plusOne = (index) => index + 1;

/** @param {number} share */
const percent = (share) => fixed(100 * share, 0);

/** That the last move stops is no news. @param {NotBlended} why @returns {why is Exclude<NonNullable<NotBlended>, 'last'>} */
const isToldOf = (why) => why !== null && why !== 'last';
