/**
 * What the files of a FANUC pair say to the person who opens them: what they do, to which registers, in which units, and
 * what nobody has checked.
 *
 * @import { PairPlan } from './fanucPlan.js'
 */
import { plainText, wrapped } from './plainText.js';
import { MAX_COMMENT_LENGTH, MAX_REMARK_LENGTH } from './tpTree.js';

const WIDTH = 76;
const LONGEST_ROBOT_NAME = 64;

/** Lines of the comment above the KAREL program. @param {PairPlan} plan @returns {string[]} */
export function headerLines(plan) {
  const { names, moves, slides, convention, speedPercent } = plan;
  const rounding = slides.some(Boolean) ? '0.0005 degrees or mm' : '0.0005 degrees';
  return [
    title(plan),
    `Written by Denavit ${plainText(plan.version)}, ${timeText(plan)}`,
    '',
    ...paragraph(
      'CAUTION. No controller has run this code and no FANUC translator has seen it. Read it, compare the numbers with the ' +
        'teach pendant, and check it at low speed before running it.',
    ),
    '',
    ...paragraph(
      `${names.karel}.kl fills ${registersText(moves)} of motion group 1, whatever they hold, and then calls ${names.tp} ` +
        `(${names.tp.toLowerCase()}.ls), which moves through them at ${speedPercent}% of joint speed. Load ` +
        `${names.tp} first. Never run it alone: it ` +
        'goes wherever the registers say. Some application tools keep PR[1] for themselves.',
    ),
    '',
    ...paragraph(
      `Joint values, ${axisUnits(slides)}, are meant as the teach pendant shows them${convention.length ? ':' : '.'}`,
    ),
    ...convention.flatMap((line) => wrapped(plainText(line), WIDTH - 2).map((text) => `  ${text}`)),
    ...paragraph(
      `They are rounded to 3 decimals, by at most ${rounding}: for a turning axis, 0.009 mm at one metre from it.`,
    ),
    '',
    ...paragraph(
      'Not verified: that HOLD and alarms stop the motion. The KAREL part is told to go on (%NOPAUSE), the TP part to pause ' +
        '(PAUSE_REQUEST = 0).',
    ),
    ...(slides.length === 6
      ? []
      : paragraph(
          `Not verified: that CNV_REL_JPOS takes an array of ${slides.length} for an arm with ${slides.length} axes. It is ` +
            'known for 6; if the controller refuses, the program stops before moving.',
        )),
  ];
}

/** Remarks at the head of the TP program. @param {PairPlan} plan @returns {string[]} */
export function moverRemarks(plan) {
  const { names, moves, slides } = plan;
  return [
    title(plan),
    `Written by Denavit ${plainText(plan.version)}.`,
    'CAUTION: no controller has run this. Check it at low speed first.',
    `Run ${names.karel.toUpperCase()}, not this: it fills ${registersText(moves)} and calls this.`,
    `Pendant joint values, ${axisUnits(slides)}.`,
  ].flatMap((text) => wrapped(text, MAX_REMARK_LENGTH));
}

/** What the list of programs shows beside the name: few kinds of characters are allowed. @param {string} robotName */
export function programComment(robotName) {
  const text = plainText(robotName).replace(/[^A-Za-z0-9 _.:()*@-]/g, '');
  return text.trim().slice(0, MAX_COMMENT_LENGTH).trimEnd() || 'Denavit';
}

/**
 * @example
 * axisUnits([false, false, false]) // → 'J1 to J3 in degrees'
 * axisUnits([false, false, true, false]) // → 'J1, J2, J4 in degrees, J3 in mm'
 * @param {readonly boolean[]} slides
 */
export function axisUnits(slides) {
  const axes = (/** @type {boolean} */ sliding) =>
    slides.flatMap((slide, i) => (slide === sliding ? [`J${i + 1}`] : []));
  const list = (/** @type {string[]} */ names) =>
    names.length === slides.length && names.length > 1 ? `${names[0]} to ${names[names.length - 1]}` : names.join(', ');
  return [
    ...(slides.includes(false) ? [`${list(axes(false))} in degrees`] : []),
    ...(slides.includes(true) ? [`${list(axes(true))} in mm`] : []),
  ].join(', ');
}

const paragraph = (/** @type {string} */ text) => wrapped(text, WIDTH);

/** @param {PairPlan} plan */
const title = ({ robotName, moves }) =>
  `${plainText(robotName, LONGEST_ROBOT_NAME) || 'Robot'}: ${moves.length} recorded ${moves.length === 1 ? 'posture' : 'postures'}`;

/** @param {PairPlan['moves']} moves */
function registersText(moves) {
  const [first, last] = [moves[0].register, moves[moves.length - 1].register];
  return first === last ? `PR[${first}]` : `PR[${first}] to PR[${last}]`;
}

/** @param {PairPlan} plan */
function timeText({ time }) {
  const two = (/** @type {number} */ value) => String(value).padStart(2, '0');
  return `${time.year}-${two(time.month)}-${two(time.day)} ${two(time.hour)}:${two(time.minute)}:${two(time.second)}`;
}
