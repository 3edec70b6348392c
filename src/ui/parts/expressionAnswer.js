/**
 * An expression that was typed into a field → what the field answers: the number with the text to keep, the question which
 * angle was meant, or the reason against it with ways out.
 *
 * @import { Answer, Measure, Way } from './numberText.js'
 */
import { shownText } from '../../model/shownText.js';
import { convertAngle } from '../../model/units.js';
import { evaluate } from './expression.js';
import { compact, withUnit } from './format.js';
import { readNumber } from './numberText.js';
import { tidy } from './expressionNumbers.js';
import { EXPRESSION } from '../words/expression.js';

/** Digits of a number on a button. */
const BRIEF = 7;

/**
 * @param {string} text  no plain number
 * @param {Measure} measure
 * @returns {Answer<number>}
 */
export function answerExpression(text, { quantity, units }) {
  const typed = text.trim();
  const { found, reason } = evaluate(typed, quantity, units);
  if (reason !== null) return against(typed, reason);
  if (found.isUnclear) return question(typed, found.value);
  const note = found.hasBareTurns ? EXPRESSION.bareTurns[units.angle] : undefined;
  return { value: found.value, reason: null, text: typed.replace(/\s+/g, ' '), ...(note && { note }) };
}

/** @param {string} typed @param {string} why @returns {Answer<number>} */
function against(typed, why) {
  const mended = CONFUSED.map(({ from, to }) => ({ from, to, text: typed.replaceAll(from, to) })).find(
    ({ text }) => text !== typed && readNumber(text).reason === null,
  );
  const decimal = typed.replace(',', '.');
  /** @type {readonly Way[]} */
  const ways = [mended?.text, decimal].flatMap((text) =>
    text !== undefined && text !== typed && readNumber(text).reason === null
      ? [{ label: EXPRESSION.use(text), text }]
      : [],
  );
  const hint = mended ? EXPRESSION.confused(mended.from, mended.to) : why;
  const title = EXPRESSION.notANumber(shownText(typed));
  return { value: null, reason: `${title}. ${hint}`, title, hint, ways };
}

/** Letters that look like digits. */
const CONFUSED = [
  { from: 'l', to: '1' },
  { from: 'I', to: '1' },
  { from: '|', to: '1' },
  { from: 'O', to: '0' },
  { from: 'o', to: '0' },
];

/**
 * A number with π in it, in a column of degrees: radians as in a book, or degrees as the column says.
 * @param {string} typed
 * @param {number} value
 * @returns {Answer<number>}
 */
function question(typed, value) {
  const whole = /[+−–-]/.test(typed.slice(1)) ? `(${typed})` : typed; // a unit belongs to the product before it
  const brief = (/** @type {number} */ degrees) => withUnit(compact(degrees, BRIEF).text, 'deg');
  const shown = shownText(typed);
  const title = EXPRESSION.ask(shown);
  const ways = [
    {
      label: EXPRESSION.radians(shownText(whole.replace(/pi/gi, 'π')), brief(tidy(convertAngle(value, 'rad', 'deg')))),
      text: `${whole} rad`,
    },
    { label: brief(value), text: `${whole} deg` },
  ];
  return { value: null, reason: title, title, ways, isQuestion: true };
}

/** How far rounding may take a number from its text. */
const ROUNDING = 1e-9;

/** Whether a text comes to a number, in one of its readings. @param {string} text @param {number} value @param {Measure} measure */
export function agrees(text, value, { quantity, units }) {
  const { found } = evaluate(text, quantity, units);
  if (found === null) return readNumber(text).value === value;
  const readings = found.isUnclear ? [found.value, convertAngle(found.value, 'rad', 'deg')] : [found.value];
  return readings.some((reading) => Math.abs(reading - value) <= ROUNDING * Math.max(1, Math.abs(value)));
}
