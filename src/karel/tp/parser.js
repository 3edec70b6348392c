/**
 * `.LS` text → a listing that keeps every byte. Reading never throws: what is not understood is a part with its text and a
 * diagnostic.
 *
 * @import { Diagnostic } from '../parse/cursor.js'
 * @import { Span } from '../tree.js'
 * @import { TpInstruction, TpListing, TpPart } from './tree.js'
 */
import { finished, PIECE } from '../slices.js';
import { createTpCursor, TpFault } from './cursor.js';
import { readInstruction } from './instructions.js';
import { POSITION, readPosition } from './positions.js';

const SECTION = /^\s*\/(PROG|ATTR|APPL|MN|POS|END)\b[ \t]*(.*)$/;
const NUMBERED = /^[ \t]*(\d+):/;
const CONTINUED = /^[ \t]*:/;
const ATTRIBUTE = /^\s*(?:TCD:\s*)?([A-Z_]+)\s*=\s*(.*?)\s*[;,]?\s*$/;

/** So many faults are told of a file. */
const MAX_DIAGNOSTICS = 500;

/**
 * @param {string} text
 * @returns {{ tree: TpListing, diagnostics: Diagnostic[] }}
 */
export const parseTp = (text) => finished(parseTpInSlices(text));

/** The same, some lines at a time. @param {string} text @returns {Generator<null, { tree: TpListing, diagnostics: Diagnostic[] }>} */
export function* parseTpInSlices(text) {
  /** @type {Diagnostic[]} */
  const diagnostics = [];
  /** @type {TpPart[]} */
  const parts = [];
  const lines = text.match(/[^\r\n]*(?:\r\n|\r|\n)|[^\r\n]+$/g) ?? [];
  let section = '';
  let start = 0;

  /** @type {(severity: Diagnostic['severity'], code: string, message: string, span: Span) => void} */
  const report = (severity, code, message, span) =>
    void (diagnostics.length < MAX_DIAGNOSTICS && diagnostics.push({ severity, code, message, span }));

  for (let i = 0; i < lines.length;) {
    const first = i;
    const isMore = continuation(section, lines[i]);
    i++;
    while (isMore && i < lines.length && isMore(lines[i - 1], lines[i])) i++;
    const raw = lines.slice(first, i).join('');
    const bare = raw.replace(/[\r\n]+$/, '');
    const span = { start, end: start + bare.length, line: first + 1, column: 1 };
    const head = SECTION.exec(bare);
    if (head) [, section] = head;
    parts.push({ ...(head ? sectionPart(head) : partOf(section, bare, span, report)), raw, span });
    start += raw.length;
    if (parts.length % PIECE === 0) yield null;
  }
  checkSections(parts, text, report);
  return { tree: { kind: 'tp-listing', parts, lineEnd: text.includes('\r\n') ? '\r\n' : '\n' }, diagnostics };
}

/** @param {RegExpExecArray} head @returns {TpPart} */
const sectionPart = ([, name, text]) => ({ kind: 'section', name, text });

/** Whether a line belongs to the part that the one before is of. @param {string} section @param {string} line */
function continuation(section, line) {
  if (section === 'MN' && NUMBERED.test(line))
    return (/** @type {string} */ _, /** @type {string} */ next) => CONTINUED.test(next);
  if (section === 'POS' && POSITION.test(line))
    return (/** @type {string} */ before, /** @type {string} */ next) =>
      !/\}\s*;?\s*$/.test(before) && !SECTION.test(next) && !POSITION.test(next);
  return null;
}

/**
 * @typedef {(severity: Diagnostic['severity'], code: string, message: string, span: Span) => void} Report
 * @param {string} section
 * @param {string} bare
 * @param {Span} span
 * @param {Report} report
 * @returns {TpPart}
 */
function partOf(section, bare, span, report) {
  const text = /** @type {const} */ ({ kind: 'text', text: bare });
  if (section === 'ATTR') {
    const match = ATTRIBUTE.exec(bare);
    return match ? { kind: 'attribute', name: match[1], value: match[2] } : text;
  }
  if (section === 'MN' && NUMBERED.test(bare)) return linePart(bare, span, report);
  if (section === 'POS' && POSITION.test(bare)) {
    const { position, at } = readPosition(bare);
    if (position && /\}\s*;?\s*$/.test(bare)) return position;
    const place = placeIn(bare, position ? bare.length : at, span);
    report(
      'error',
      'position',
      `Expected ${position ? '"};"' : 'UF, UT, CONFIG or a value with its unit'} in this position.`,
      place,
    );
    return text;
  }
  if (bare.trim() !== '' && (section === 'MN' || section === 'POS')) {
    const expected = section === 'MN' ? 'a numbered line, as "  1:  …;"' : 'a position, as "P[1]{ … };"';
    report('warning', 'text', `Expected ${expected}, got a text that is kept as it is.`, span);
  }
  return text;
}

/** @param {string} bare @param {Span} span @param {Report} report @returns {TpPart} */
function linePart(bare, span, report) {
  // Line numbers, line ends and the last semicolon are blanked, so that every place stays where it is.
  let content = bare.replace(/^[ \t]*\d+:/, blanks).replace(/[\r\n]+[ \t]*:/g, blanks);
  const end = /;\s*$/.exec(content);
  if (end) content = content.slice(0, end.index);
  else report('warning', 'semicolon', 'Expected ";" at the end of the line.', placeIn(bare, bare.length, span));
  const number = Number(/** @type {RegExpExecArray} */ (NUMBERED.exec(bare))[1]);
  /** @type {TpInstruction} */
  let instruction;
  try {
    const cursor = createTpCursor(content);
    instruction = readInstruction(cursor);
    if (!cursor.isAtEnd()) cursor.fail('the end of the instruction');
    if (instruction.kind === 'unknown')
      report(
        'warning',
        'unknown-instruction',
        `"${shortened(instruction.text)}" is not known here: it is kept, and passed over when it runs.`,
        placeIn(bare, content.length - content.trimStart().length, span),
      );
  } catch (fault) {
    if (!(fault instanceof TpFault)) throw fault;
    report('error', 'syntax', fault.message, placeIn(bare, fault.at, span));
    instruction = { kind: 'unknown', text: content.trim() };
  }
  return { kind: 'line', number, instruction };
}

const blanks = (/** @type {string} */ text) => ' '.repeat(text.length);
const shortened = (/** @type {string} */ text) => (text.length > 24 ? `${text.slice(0, 24)}…` : text);

/** @param {string} text  of a part @param {number} at @param {Span} span  of the part @returns {Span} */
function placeIn(text, at, span) {
  const before = text.slice(0, at).split(/\r\n|\r|\n/);
  const rest = text.slice(at).split(/[\r\n]/)[0];
  return {
    start: span.start + at,
    end: span.start + at + Math.max(1, rest.length),
    line: span.line + before.length - 1,
    column: /** @type {string} */ (before.at(-1)).length + 1,
  };
}

/** @param {readonly TpPart[]} parts @param {string} text @param {Report} report */
function checkSections(parts, text, report) {
  const names = parts.flatMap((part) => (part.kind === 'section' ? [part.name] : []));
  const end = { start: text.length, end: text.length, line: text.split('\n').length, column: 1 };
  for (const name of ['PROG', 'MN', 'POS', 'END'])
    if (!names.includes(name)) report('error', 'section', `Expected /${name}, which this text does not have.`, end);
}
