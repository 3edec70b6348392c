/**
 * Listing → `.LS` text. A part that was read is written as it was read; every other anew, in the form of listings that
 * controllers export. A tree that has no text is a RangeError: no name or comment can end a line or become an instruction.
 *
 * @import { TpGroup, TpInstruction, TpListing, TpPart, TpPositionPart } from './tree.js'
 */
import { finished, inPieces } from '../slices.js';
import { fitting, instructionText, wholeNumber } from './instructionText.js';

const PROGRAM_NAME = /^[A-Z][A-Z0-9_]{0,35}(\t[A-Za-z]+)?$/;
const ATTRIBUTE_VALUE = /^[ -:<-~]*$/;
const PLAIN = /^[ -~\t]*$/;
const QUOTED = /^[ !#-~]*$/;

/** The column that values of attributes stand in, with tabs of eight. */
const VALUE_COLUMN = 16;

/** Attributes of the task: one block, with commas between them. */
const TASK = ['STACK_SIZE', 'TASK_PRIORITY', 'TIME_SLICE', 'BUSY_LAMP_OFF', 'ABORT_REQUEST', 'PAUSE_REQUEST'];

/** @param {TpListing} listing @returns {string} */
export const printTp = (listing) => finished(printTpInSlices(listing));

/** The same, some parts at a time. @param {TpListing} listing @returns {Generator<null, string>} */
export function* printTpInSlices({ parts, lineEnd }) {
  let text = '';
  yield* inPieces(parts, (piece) => {
    for (const part of piece) text += part.raw ?? `${partText(part).split('\n').join(lineEnd)}${lineEnd}`;
  });
  return text;
}

/** Its lines, with "\n" between them. @param {TpPart} part @returns {string} */
function partText(part) {
  switch (part.kind) {
    case 'section': {
      if (part.name !== 'PROG') return `/${part.name}`;
      return `/PROG  ${fitting('a program name (capital letters, digits, _; at most 36)', part.text, PROGRAM_NAME)}`;
    }
    case 'attribute': {
      const name = fitting('the name of an attribute', part.name, /^[A-Z_]+$/);
      const value = fitting('the value of an attribute', part.value, ATTRIBUTE_VALUE);
      const task = TASK.indexOf(name);
      if (task >= 0)
        return `${task === 0 ? 'TCD:  ' : '      '}${name}\t= ${value}${task < TASK.length - 1 ? ',' : ';'}`;
      const tabs = Math.max(1, Math.ceil((VALUE_COLUMN - name.length) / 8));
      return `${name}${'\t'.repeat(tabs)}= ${value};`;
    }
    case 'line':
      return lineText(part.number, part.instruction);
    case 'position':
      return positionText(part);
    case 'text':
      return fitting('a line of text', part.text, PLAIN);
  }
}

/** A motion begins right after the line number, everything else two places further. @param {number} number @param {TpInstruction} instruction */
function lineText(number, instruction) {
  const { kind } = instruction;
  const text = instructionText(instruction);
  const before = kind === 'motion' || text === '' ? '' : '  ';
  const behind = kind === 'motion' || kind === 'call' || kind === 'run' ? '    ' : ' ';
  const label = String(wholeNumber('a line number', number, 1, 99999)).padStart(4);
  // The points of a circle stand in two lines.
  const [first, second] = text.split('\n');
  return `${label}:${before}${first}${second === undefined ? '' : `    \n    :  ${second}`}${behind};`;
}

/** @param {TpPositionPart} position */
function positionText({ number, label, groups }) {
  const name = label === undefined ? '' : `:"${fitting('a label', label, QUOTED)}"`;
  return [
    `P[${wholeNumber('the number of a position', number, 1, 32767)}${name}]{`,
    ...groups.flatMap(groupLines),
    '};',
  ].join('\n');
}

/** @param {TpGroup} group @returns {string[]} */
function groupLines({ group, userFrame, toolFrame, configuration, values }) {
  const frame = (/** @type {number | 'F'} */ value) => (value === 'F' ? 'F' : wholeNumber('a frame', value, 0, 99));
  const config =
    configuration === undefined
      ? ','
      : `,\t\tCONFIG : '${fitting('a configuration', configuration, /^[A-Z0-9, -]+$/)}',`;
  const texts = values.map(({ name, value, unit }) => {
    const digits = value === null ? '********' : valueText(value);
    return `${fitting('the name of a value', name, /^([XYZWPR]|[JE]\d)$/)}${name.length === 1 ? ' ' : ''}= ${digits.padStart(9)} ${unit === 'mm' ? ' mm' : 'deg'}`;
  });
  const rows = [];
  for (let i = 0; i < texts.length; i += 3) rows.push(`\t${texts.slice(i, i + 3).join(',\t')}`);
  return [
    `   GP${wholeNumber('a motion group', group, 1, 9)}:`,
    `\tUF : ${frame(userFrame)}, UT : ${frame(toolFrame)}${config}`,
    ...rows.map((row, i) => (i < rows.length - 1 ? `${row},` : row)),
  ];
}

/** So many decimals a listing has. */
export const POSITION_DECIMALS = 3;

/** The largest number that a listing has room for. */
export const LARGEST_VALUE = 99999.999;

/** @param {number} value */
function valueText(value) {
  if (!(Math.abs(value) <= LARGEST_VALUE))
    throw new RangeError(`Expected a value within ±${LARGEST_VALUE}, got ${value}.`);
  const text = value.toFixed(POSITION_DECIMALS);
  return Number(text) === 0 ? text.replace('-', '') : text;
}
