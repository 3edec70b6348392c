/**
 * What a file of code says to the person who opens it: what it does, in which units and frames, and what nobody has checked.
 *
 * @import { NeutralProgram, WriteNote } from './neutral.js'
 */
import { plainText, wrapped } from '../plainText.js';
import { movesOf, ROUNDING } from './neutral.js';

const WIDTH = 76;
const LONGEST_NAME = 64;

/** FANUC HandlingTool operator's manual: remark instruction, program comment. */
export const MAX_REMARK_LENGTH = 32;
const MAX_COMMENT_LENGTH = 16;

/** @param {Pick<NeutralProgram, 'name' | 'robotName'>} program */
export const titleOf = ({ name, robotName }) => `${nameOr(robotName, 'Robot')}: ${nameOr(name, 'program')}`;

/** A name, as far as controllers can show it; of one in another script nothing may be left. @param {string} text @param {string} otherwise */
function nameOr(text, otherwise) {
  const plain = plainText(text, LONGEST_NAME);
  return /[A-Za-z0-9]/.test(plain) ? plain : otherwise;
}

/** What FANUC's user frame 0 is. @param {Pick<NeutralProgram, 'zero'>} program */
export const zeroOf = ({ zero = 'the world of the controller, on axis 1 at the height of axis 2' }) => zero;

/**
 * Lines for a comment, without its signs.
 * @param {NeutralProgram} program
 * @param {object} about
 * @param {string} about.does         what this file does, and with which others
 * @param {string} about.world        what frame 0 is on this controller
 * @param {readonly WriteNote[]} about.notes
 * @param {string} [about.axis]       what axes are called, with their numbers
 * @returns {string[]}
 */
export function headerLines(program, { does, world, notes, axis = 'J' }) {
  const { version, generatedAt, convention, slides, frames, check = [] } = program;
  const paragraph = (/** @type {string} */ text) => wrapped(plainText(text), WIDTH);
  const named = (/** @type {string} */ text) => text.replace(/\bJ(?=\d)/g, axis);
  const moves = movesOf(program);
  return [
    titleOf(program),
    `Written by Denavit ${plainText(version)}, ${plainText(generatedAt)}`,
    '',
    ...paragraph(
      'CAUTION. No controller has run this code. Read it, compare the numbers with the teach pendant, and check it at low ' +
        'speed before running it.',
    ),
    '',
    ...paragraph(does),
    '',
    ...paragraph(
      `${moves.length} moves. Positions in mm and degrees: x y z, then turns about the fixed x, y, z. ${world}`,
    ),
    ...frames.map(frameText),
    ...paragraph(
      `Joint values, ${named(axisUnits(slides))}, as the teach pendant shows them${convention.length ? ':' : '.'}`,
    ),
    ...convention.flatMap((line) => wrapped(plainText(named(line)), WIDTH - 2).map((text) => `  ${text}`)),
    ...paragraph(
      `All are rounded to 3 decimals, by at most ${ROUNDING}; joint values at a limit or next to a singular posture by one of the last decimal more, to stay on their side of it.`,
    ),
    ...(notes.length > 0 ? ['', ...notes.flatMap(({ message }) => paragraph(`Note: ${message}`))] : []),
    ...(check.length > 0 ? ['', ...check] : []),
  ];
}

/** @param {NeutralProgram['frames'][number]} frame */
function frameText({ kind, number, name, position }) {
  const what = kind === 'user' ? 'User frame' : 'Tool';
  const values = position.map((value) => String(Number(value.toFixed(3)) + 0)).join(', ');
  return `  ${what} ${number}, "${plainText(name, 20)}": ${values}`;
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
