/**
 * Steps of a motion program in words and signs, and the pictures of their kinds.
 *
 * @import { Doc, Ending, MoveStep, SpeedUnit, StepDoc, StepTarget, Units } from '../../model/document.js'
 */
import { homePosture } from '../../model/document.js';
import { isMove } from '../../model/program/motionProgram.js';
import { compact, unitSign } from '../parts/format.js';
import { TEXT } from '../strings.js';
import { svg } from '../parts/svg.js';
import { PROGRAM } from '../words/program.js';

const WIDEST_JOINT = 4;
const WIDEST_PLACE = 4;
const WIDEST_END = 5;
/** What is smaller is the noise of rounding. */
const DECIMALS = 6;

/** What a step does, in the table. @param {Doc} doc @param {StepDoc} step @returns {string} */
export function stepText(doc, step) {
  switch (step.kind) {
    case 'joint':
    case 'linear':
    case 'circular': {
      const target = targetText(doc, step.target);
      if (!step.via) return target;
      return PROGRAM.via(step.via.kind === 'target' ? step.via.id : PROGRAM.viaShort, target);
    }
    case 'wait':
      return PROGRAM.wait;
    case 'set-output':
      return PROGRAM.output(step.output, PROGRAM.on[step.value]);
    case 'wait-input':
      return PROGRAM.input(step.input, PROGRAM.on[step.value]);
    case 'call':
      return PROGRAM.call(doc.motionPrograms.find(({ id }) => id === step.program)?.name ?? step.program);
    case 'label':
      return PROGRAM.label(step.label);
    case 'comment':
      return step.text || PROGRAM.noText;
    default: {
      /** @type {never} */
      const unknown = step;
      throw new TypeError(`Unknown step: ${JSON.stringify(unknown)}`);
    }
  }
}

/** By its name, where it has one: a recorded posture has that of the list. @param {Doc} doc @param {StepTarget} target */
export function targetText({ robot, postures }, target) {
  if (target.kind === 'target') return target.id;
  const numbers = (/** @type {readonly number[]} */ values, /** @type {number} */ widest) =>
    values.map((value) => compact(Number(Number(value.toFixed(DECIMALS)).toPrecision(widest)), widest).text);
  if (target.kind === 'pose') return numbers(target.xyz, WIDEST_PLACE).join(', ');
  const isHere = (/** @type {readonly number[]} */ q) => q.every((value, i) => value === target.values[i]);
  const named = postures.find(({ q }) => isHere(q));
  if (named) return named.id;
  return isHere(homePosture(robot)) ? PROGRAM.home : numbers(target.values, WIDEST_JOINT).join(' ');
}

/** @param {SpeedUnit} unit @param {Units} units */
export const speedUnitText = (unit, units) =>
  unit === '%' ? '%' : PROGRAM.perSecond(unitSign(unit === 'angle/s' ? units.angle : units.length));

/** As it is read aloud. @param {SpeedUnit} unit @param {Units} units */
export const speedUnitInWords = (unit, units) =>
  unit === '%'
    ? PROGRAM.perCent
    : PROGRAM.perSecondInWords(TEXT.table.unitName[unit === 'angle/s' ? units.angle : units.length]);

/** FINE, CNT 50, 10 mm. @param {Ending} ending @param {Units} units */
export function endText(ending, units) {
  if (ending.kind === 'fine') return PROGRAM.fine;
  const { text } = compact(ending.value, WIDEST_END);
  return ending.kind === 'percent' ? PROGRAM.share(text) : `${text} ${unitSign(units.length)}`;
}

/** Ways and dots, in a box of 16; a dash array of `2 2` where the way of the tool is the joints' business. */
const PICTURE = {
  joint: ['M3 12C4 6 8 4 13 4', true],
  linear: ['M3 12 13 4', false],
  circular: ['M3 12A10 10 0 0 1 13 4', false],
  wait: ['M8 4.5V8l2.4 1.6M8 1.8a6.2 6.2 0 1 1-.01 0', false],
  'set-output': ['M9 1.5 4 9h4l-1 5.5L12 7H8z', false],
  'wait-input': ['M2 8h7M6.5 5 9.5 8l-3 3M12.5 3v10', false],
  call: ['M3 3v5a2 2 0 0 0 2 2h7M9 7l3.2 3L9 13', false],
  label: ['M2.5 4.5h7L13.5 8l-4 3.5h-7z', false],
  comment: ['M2.5 3h11v7.5H8L5 13.5v-3H2.5z', false],
};

/** @param {StepDoc['kind']} kind @returns {SVGElement} hidden: the control beside it says the same */
export function stepIcon(kind) {
  const [d, isDashed] = /** @type {[string, boolean]} */ (PICTURE[kind]);
  const line = { fill: 'none', stroke: 'currentColor', 'stroke-width': 1.4, 'stroke-linecap': 'round' };
  const path = svg('path', { d, ...line, 'stroke-linejoin': 'round', 'stroke-dasharray': isDashed ? '1.6 2.6' : null });
  const dots = ['joint', 'linear', 'circular'].includes(kind)
    ? [
        [3, 12],
        [13, 4],
      ].map(([cx, cy]) => svg('circle', { cx, cy, r: 1.9, fill: 'currentColor' }))
    : [];
  return svg('svg', { class: 'i', viewBox: '0 0 16 16', 'aria-hidden': 'true' }, path, ...dots);
}

/** A way past points that are yet to be recorded. @returns {SVGElement} */
export function emptyPicture() {
  const ring = { fill: 'var(--panel)', stroke: 'currentColor', 'stroke-width': 2 };
  return svg(
    'svg',
    { viewBox: '0 0 96 44', 'aria-hidden': 'true' },
    svg('path', {
      ...{ d: 'M8 36C20 12 38 8 52 20S74 36 88 8', fill: 'none', stroke: 'currentColor' },
      ...{ 'stroke-width': 2, 'stroke-dasharray': '3 4', 'stroke-linecap': 'round' },
    }),
    svg('circle', { cx: 8, cy: 36, r: 5, ...ring }),
    svg('circle', { cx: 52, cy: 20, r: 5, ...ring }),
    svg('circle', { cx: 88, cy: 8, r: 6, fill: 'var(--accent)' }),
  );
}

/** The steps whose second column is a number that can be typed. @param {StepDoc} step @returns {step is MoveStep | Extract<StepDoc, { kind: 'wait' }>} */
export const hasNumber = (step) => isMove(step) || step.kind === 'wait';
