/**
 * Points as text, typed, pasted or from a CSV file, one a line: three numbers, and a name before or after them if there is one. A first line without
 * numbers is a head; one that names x says where the numbers stand, whatever else a line has in it, as in the table that is saved. Whatever the text is, reading does not throw; what is not understood is said by its line, and nothing is taken.
 *
 * @typedef {{ readonly name: string, readonly at: readonly number[] }} NamedPoint  in the units of the text
 * @typedef {{ code: 'too-long' | 'too-many' | 'none' } | { code: 'not-three' | 'too-far', line: number }} PointsFault
 * @typedef {{ points: NamedPoint[], fault: null } | { points: null, fault: PointsFault }} PointsReading
 */
import { shownText } from '../model/shownText.js';
import { readCsv } from './csv.js';

export const MAX_POINTS_TEXT = 100_000;
export const MAX_POINTS = 500;

const LONGEST_NAME = 40;

const NUMBER = /^[+\-−]?(?:\d+\.?\d*|\.\d+)(?:e[+\-−]?\d{1,3})?$/i;

/** @param {string} cell @param {boolean} hasDecimalComma @returns {number | null} */
function numberIn(cell, hasDecimalComma) {
  const text = hasDecimalComma ? cell.replace(',', '.') : cell;
  return NUMBER.test(text) ? Number(text.replace(/−/g, '-')) : null;
}

/** @param {string} line @returns {{ cells: string[], hasDecimalComma: boolean }} */
function cellsOf(line) {
  if (/"/.test(line) && /[\t;,]/.test(line.replace(/"[^"]*"/g, ''))) {
    const { separator, rows } = readCsv(line);
    return { cells: rows[0]?.cells ?? [], hasDecimalComma: separator !== ',' };
  }
  const sign = ['\t', ';'].find((each) => line.includes(each));
  const cells = sign
    ? line.split(sign)
    : line.includes(',')
      ? line.split(',')
      : line
          .trim()
          .replace(/^[[(]|[\])]$/g, '')
          .split(/\s+/);
  const plain = cells.map((cell) =>
    cell
      .trim()
      .replace(/^"(.*)"$/, '$1')
      .trim(),
  );
  return { cells: plain, hasDecimalComma: sign !== undefined };
}

/**
 * @param {string} text
 * @param {number} farthest  no coordinate may be larger
 * @returns {PointsReading}
 */
export function readPoints(text, farthest) {
  if (text.length > MAX_POINTS_TEXT) return { points: null, fault: { code: 'too-long' } };
  /** @type {NamedPoint[]} */
  const points = [];
  let isFirst = true;
  /** Where the head says that x stands. */
  let ofHead = -1;
  for (const [index, line] of text
    .replace(/^\uFEFF/, '')
    .split(/\r\n?|\n/)
    .entries()) {
    if (line.trim() === '' || line.trimStart().startsWith('#')) continue;
    const { cells: all, hasDecimalComma } = cellsOf(line);
    // what was added to a table by hand or by picking is a line like any other
    const isInTable = ofHead >= 0 && all.length >= ofHead + 3;
    const cells = isInTable
      ? [...(ofHead > 0 ? all.slice(0, 1) : []), ...all.slice(ofHead, ofHead + 3)]
      : all.filter((cell) => cell !== '');
    const numbers = cells.map((cell) => numberIn(cell, hasDecimalComma));
    const isHead = isFirst && numbers.every((value) => value === null);
    isFirst = false;
    if (isHead) {
      ofHead = all.findIndex((cell) => /^x(?![a-z])/i.test(cell));
      continue;
    }
    // a name stands before the numbers or behind them; a number of the line before them is a name as well
    const isNamed = numbers[0] === null || (cells.length === 4 && numbers[3] !== null);
    const from = Number(isInTable ? ofHead > 0 : isNamed);
    const at = numbers.slice(from, from + 3);
    const rest = [...cells.slice(0, from), ...cells.slice(from + 3)];
    if (at.length < 3 || at.some((value) => value === null) || rest.length > 1)
      return { points: null, fault: { code: 'not-three', line: index + 1 } };
    const place = /** @type {number[]} */ (at);
    if (place.some((value) => !(Math.abs(value) <= farthest)))
      return { points: null, fault: { code: 'too-far', line: index + 1 } };
    if (points.length === MAX_POINTS) return { points: null, fault: { code: 'too-many' } };
    points.push({ name: shownText(rest[0] ?? '').slice(0, LONGEST_NAME), at: place });
  }
  return points.length === 0 ? { points: null, fault: { code: 'none' } } : { points, fault: null };
}
