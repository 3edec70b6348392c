/**
 * The kinds of value that an attribute or a text of a robot file can have: how each is read, written and called in a
 * message, and what the schema says of it. Numbers are read by their spelling, never by `Number` alone: Number('') is 0
 * and Number('0x10') is 16.
 *
 * @typedef {object} Facets  the same type as XML Schema sees it
 * @property {string} base   built-in type
 * @property {string} [pattern]
 * @property {readonly string[]} [enumeration]
 * @property {number} [maxLength]
 * @property {number} [minInclusive]
 * @property {number} [minExclusive]
 * @property {number} [maxInclusive]
 * @property {{ readonly min: number, readonly max: number }} [list]  how many of them
 *
 * @typedef {{ readonly value: unknown } | { readonly code: FileIssueCode, readonly expected: string }} Reading
 *
 * @typedef {object} ValueType
 * @property {string} example
 * @property {(text: string) => Reading} read
 * @property {(value: unknown) => string} write  what `read` gives back; throws RangeError for what no `read` could give
 * @property {Facets} facets
 *
 * @import { FileIssueCode } from './fileIssues.js'
 */
import { characterCount, COLOUR_PATTERN, ID_PATTERN, LARGEST_NUMBER } from '../model/documentRules.js';

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;
const INTEGER = /^[+-]?\d+$/;
/** What XML calls white space; JavaScript's trim takes more. */
const BLANKS = /[ \t\n\r]+/g;

/** `whiteSpace="collapse"` of XML Schema. @param {string} text */
export const collapse = (text) => text.replace(BLANKS, ' ').replace(/^ | $/g, '');

/** The shortest text that reads back as the same number; a negative zero keeps its sign. @param {unknown} value */
function writeNumber(value) {
  if (typeof value !== 'number' || !Number.isFinite(value)) {
    throw new RangeError(`Expected a finite number to write, got ${value}.`);
  }
  return Object.is(value, -0) ? '-0' : String(value);
}

/** @param {unknown} values */
function writeNumbers(values) {
  if (!Array.isArray(values)) throw new RangeError(`Expected numbers to write, got ${values}.`);
  return values.map(writeNumber).join(' ');
}

/** @param {unknown} value */
function writeText(value) {
  if (typeof value !== 'string') throw new RangeError(`Expected a text to write, got ${value}.`);
  return value;
}

/** @param {string} text @param {'finite' | 'positive'} kind @returns {{ value: number } | { code: 'number', expected: string }} */
function readNumber(text, kind) {
  const spelling = collapse(text);
  if (!NUMBER.test(spelling))
    return { code: 'number', expected: `a number such as ${kind === 'finite' ? '12.5' : '2.5'}` };
  const value = Number(spelling);
  if (kind === 'positive' && !(value > 0 && value <= LARGEST_NUMBER)) {
    return { code: 'number', expected: `a number above 0 and up to ${LARGEST_NUMBER}` };
  }
  if (Math.abs(value) <= LARGEST_NUMBER) return { value };
  return { code: 'number', expected: `a number from ${-LARGEST_NUMBER} to ${LARGEST_NUMBER}` };
}

/** @type {ValueType} */
export const FINITE = {
  example: '12.5',
  read: (text) => readNumber(text, 'finite'),
  write: writeNumber,
  facets: { base: 'double', minInclusive: -LARGEST_NUMBER, maxInclusive: LARGEST_NUMBER },
};

/** @type {ValueType} */
export const POSITIVE = {
  example: '2.5',
  read: (text) => readNumber(text, 'positive'),
  write: writeNumber,
  facets: { base: 'double', minExclusive: 0, maxInclusive: LARGEST_NUMBER },
};

/** @type {ValueType} */
export const NOT_NEGATIVE = {
  ...FINITE,
  example: '2.5',
  read(text) {
    const reading = readNumber(text, 'finite');
    if (!('value' in reading) || reading.value >= 0) return reading;
    return { code: 'number', expected: `a number from 0 to ${LARGEST_NUMBER}` };
  },
  facets: { base: 'double', minInclusive: 0, maxInclusive: LARGEST_NUMBER },
};

/** @type {ValueType} */
export const POSITIVE_INTEGER = {
  example: '1',
  read(text) {
    const value = INTEGER.test(collapse(text)) ? Number(collapse(text)) : NaN;
    if (value >= 1 && value <= LARGEST_NUMBER) return { value };
    return { code: 'number', expected: `a whole number from 1 to ${LARGEST_NUMBER}` };
  },
  write: writeNumber,
  facets: { base: 'positiveInteger' },
};

/** @type {ValueType} */
export const SIGN = {
  example: '1',
  read(text) {
    const value = INTEGER.test(collapse(text)) ? Number(collapse(text)) : NaN;
    return value === 1 || value === -1 ? { value } : { code: 'choice', expected: '1 or -1' };
  },
  write: writeNumber,
  facets: { base: 'integer', enumeration: ['1', '-1'] },
};

/** @type {ValueType} */
export const FLAG = {
  example: 'true',
  read(text) {
    const word = collapse(text);
    if (['true', '1', 'false', '0'].includes(word)) return { value: word === 'true' || word === '1' };
    return { code: 'choice', expected: 'true or false' };
  },
  write: String,
  facets: { base: 'boolean' },
};

/** @param {number} min @param {number} max how many numbers @returns {ValueType} */
export function numberList(min, max) {
  const count = min === max ? `${min}` : `${min} to ${max}`;
  return {
    example: Array(min).fill('0').join(' '),
    read(text) {
      const words = collapse(text).split(' ');
      const readings = words.map((word) => readNumber(word, 'finite'));
      if (collapse(text) === '' || words.length < min || words.length > max) {
        return { code: 'number', expected: `${count} numbers with blanks between them` };
      }
      const wrong = readings.findIndex((reading) => 'expected' in reading);
      if (wrong === -1) return { value: readings.map((reading) => ('value' in reading ? reading.value : NaN)) };
      const { expected } = /** @type {{ expected: string }} */ (readings[wrong]); // found by that very property
      return { code: 'number', expected: `${count} numbers with blanks between them, each ${expected}` };
    },
    write: writeNumbers,
    facets: { ...FINITE.facets, list: { min, max } },
  };
}

export const VECTOR_3 = numberList(3, 3);
export const QUATERNION = numberList(4, 4);
export const JOINT_VALUES = numberList(2, 6);

/** @param {RegExp} pattern @param {string} expected @param {string} example @returns {ValueType} */
function token(pattern, expected, example) {
  return {
    example,
    read: (text) => (pattern.test(collapse(text)) ? { value: collapse(text) } : { code: 'pattern', expected }),
    write: writeText,
    facets: { base: 'token', pattern: pattern.source.slice(1, -1) },
  };
}

export const ID = token(ID_PATTERN, 'a letter or _, then letters, digits or _, at most 64 characters', 'joint_1');
/** What XML calls a name without a colon. */
export const XML_NAME = token(
  /^[\p{L}_][\p{L}\p{N}\p{M}._-]*$/u,
  'a letter or _, then letters, digits, ".", "-" or _',
  'joint0',
);
export const COLOUR = token(COLOUR_PATTERN, 'a colour such as #ffcc00', '#ffcc00');
export const VERSION = token(/^1\.[0-9]{1,3}$/, 'a version such as 1.0', '1.0');

/** @param {readonly string[]} words @returns {ValueType} */
export function choice(words) {
  const expected = `${words.slice(0, -1).join(', ')} or ${words.at(-1)}`;
  return {
    example: words[0],
    read: (text) => (words.includes(collapse(text)) ? { value: collapse(text) } : { code: 'choice', expected }),
    write: writeText,
    facets: { base: 'token', enumeration: words },
  };
}

/** Text that keeps its blanks. @param {number} [maxLength] in characters @returns {ValueType} */
export function string(maxLength = Infinity) {
  const expected = `at most ${maxLength} characters`;
  return {
    example: 'some text',
    read: (text) => (characterCount(text) <= maxLength ? { value: text } : { code: 'text-length', expected }),
    write: writeText,
    facets: { base: 'string', ...(Number.isFinite(maxLength) && { maxLength }) },
  };
}
