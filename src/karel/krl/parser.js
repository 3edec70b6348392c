/**
 * KRL as this page writes it → module. Anything else is a diagnostic with its place: this is no reader of KRL at large.
 *
 * @import { Diagnostic } from '../parse/cursor.js'
 * @import { Span } from '../tree.js'
 * @import { KrlDatum, KrlModule, KrlStatement } from './tree.js'
 */
import { INI_FOLD, INTERRUPTS } from './tree.js';

const DEF = /^(?:GLOBAL\s+)?DEF\s+(\w+)\s*\(\s*\)$/i;
const DEFDAT = /^DEFDAT\s+(\w+)(?:\s+PUBLIC)?$/i;
const DATUM = /^DECL\s+(POS|AXIS|E6POS|E6AXIS|FRAME)\s+(\w+)\s*=\s*\{(.*)\}$/i;
const MEMBER = /^\s*(\w+)\s+(?:'B([01]+)'|'H([0-9A-F]+)'|([+-]?\d*\.?\d+(?:E[+-]?\d+)?|\d+\.))\s*$/i;
const MOTION = /^(PTP|LIN|CIRC)\s+(\w+|\{[^{}]*\})(?:\s*,\s*(\w+|\{[^{}]*\}))?((?:\s+C_(?:PTP|DIS|VEL|ORI))*)$/i;
/** A position where it is needed: {X 1,Y 2,…}, {E6AXIS: A1 0,…}. */
const IN_PLACE = /^\{(?:\s*\w+\s*:)?([^{}:]*)\}$/;
const BAS = /^BAS\s*\(\s*#(\w+)\s*,\s*(-?[\d.]+)\s*\)$/i;
const WAIT = /^WAIT\s+SEC\s+([\d.]+)$/i;
const WAIT_FOR = /^WAIT\s+FOR\s+\$IN\[(\d+)\](?:\s*==\s*(TRUE|FALSE))?$/i;
const ASSIGN = /^(\$\w+(?:\[\d+\])?(?:\.\w+)?)\s*=\s*(TRUE|FALSE|-?\d*\.?\d+(?:E[+-]?\d+)?)$/i;
const CALL = /^(\w+)\s*\(\s*\)$/;

/** Whether a text is a data list (.dat). @param {string} text */
export const isKrlData = (text) =>
  /^\s*DEFDAT\b/i.test(text.split('\n').find((line) => !/^\s*([&;]|$)/.test(line)) ?? '');

/**
 * @param {string} src
 * @param {string} [dat]
 * @returns {{ tree: KrlModule, diagnostics: Diagnostic[], datDiagnostics: Diagnostic[] }}
 */
export function parseKrl(src, dat = '') {
  /** @type {{ name: string, statements: KrlStatement[] }} */
  const found = { name: '', statements: [] };
  const comments = /** @type {string[]} */ ([]);
  let isOver = false;
  const diagnostics = eachLine(src, (text, span) => {
    if (text.startsWith('&')) return null;
    const head = DEF.exec(text);
    if (head && found.name === '') {
      found.name = head[1];
      return null;
    }
    if (found.name === '') return 'DEF and the name of a program';
    if (/^END$/i.test(text)) {
      isOver = true;
      return null;
    }
    if (isOver) return 'nothing behind END';
    if (text.startsWith(';')) {
      const comment = text.slice(1).trim();
      if (found.statements.length === 0 && !INI_FOLD.includes(comment)) comments.push(comment);
      else found.statements.push({ kind: 'comment', text: comment, span });
      return null;
    }
    const statement = statementOf(text);
    if (statement) found.statements.push({ ...statement, span });
    return statement
      ? null
      : 'a statement that is known here (PTP, LIN, CIRC with a position, BAS, WAIT, a call, an assignment of a number; no IF, loops or declarations)';
  });
  if (!isOver) diagnostics.push(missing('END', src));

  /** @type {KrlDatum[]} */
  const data = [];
  let isData = false;
  const datDiagnostics = eachLine(dat, (text, span) => {
    if (text.startsWith('&') || text.startsWith(';')) return null;
    if (DEFDAT.test(text)) {
      isData = true;
      return null;
    }
    if (/^ENDDAT$/i.test(text)) return null;
    const datum = isData ? datumOf(text) : null;
    if (datum) data.push({ ...datum, span });
    return datum ? null : 'a position, as DECL POS XP1={X 1.0,…}';
  });
  return { tree: { kind: 'krl', ...found, comments, data }, diagnostics, datDiagnostics };
}

/** @param {string} text @param {(line: string, span: Span) => string | null} read  null, or what was expected @returns {Diagnostic[]} */
function eachLine(text, read) {
  /** @type {Diagnostic[]} */
  const diagnostics = [];
  let start = 0;
  text.split('\n').forEach((line, i) => {
    const bare = line.trim();
    const column = line.length - line.trimStart().length + 1;
    const span = { start: start + column - 1, end: start + column - 1 + bare.length, line: i + 1, column };
    start += line.length + 1;
    const expected = bare === '' ? null : read(bare, span);
    if (expected !== null)
      diagnostics.push({
        severity: 'error',
        code: 'syntax',
        message: `Expected ${expected}, got "${bare.slice(0, 40)}".`,
        span,
      });
  });
  return diagnostics;
}

/** @param {string} what @param {string} text @returns {Diagnostic} */
const missing = (what, text) => ({
  ...{ severity: 'error', code: 'syntax', message: `Expected ${what}, got the end of the text.` },
  span: { start: text.length, end: text.length, line: text.split('\n').length, column: 1 },
});

/** @param {string} text @returns {KrlStatement | null} */
function statementOf(text) {
  const motion = MOTION.exec(text);
  if (motion) {
    const [, kind, first, second, ways] = motion;
    const type = /** @type {'PTP' | 'LIN' | 'CIRC'} */ (kind.toUpperCase());
    if ((type === 'CIRC') !== (second !== undefined)) return null;
    /** @type {KrlDatum[]} */
    const places = [];
    /** A place in braces is called after its number. @param {string} name */
    const named = (name) => {
      const members = name.startsWith('{') && membersOf(IN_PLACE.exec(name)?.[1] ?? '');
      if (members === false) return name;
      if (members === null) return null;
      return `{${places.push({ name: `{${places.length}}`, type: 'A1' in members ? 'E6AXIS' : 'E6POS', members }) - 1}}`;
    };
    const [one, other] = [named(first), second === undefined ? '' : named(second)];
    if (one === null || other === null) return null;
    const approximation = ways.trim() === '' ? [] : ways.trim().toUpperCase().split(/\s+/);
    return {
      kind: 'motion',
      motion: type,
      ...(other ? { via: one, target: other } : { target: one }),
      approximation,
      ...(places.length > 0 && { places }),
    };
  }
  const bas = BAS.exec(text);
  if (bas) return { kind: 'bas', what: bas[1].toUpperCase(), value: Number(bas[2]) };
  const wait = WAIT.exec(text);
  if (wait) return { kind: 'wait', seconds: Number(wait[1]) };
  const input = WAIT_FOR.exec(text);
  if (input) return { kind: 'wait-for', input: Number(input[1]), value: input[2]?.toUpperCase() !== 'FALSE' };
  const assign = ASSIGN.exec(text);
  if (assign) {
    const word = assign[2].toUpperCase();
    return {
      kind: 'assign',
      target: assign[1].toUpperCase(),
      value: /^[TF]/.test(word) ? word === 'TRUE' : Number(word),
    };
  }
  if (INTERRUPTS.includes(text)) return { kind: 'interrupt', text };
  const call = CALL.exec(text);
  return call && { kind: 'call', program: call[1] };
}

/** @param {string} text @returns {KrlDatum | null} */
function datumOf(text) {
  const match = DATUM.exec(text);
  if (!match) return null;
  const members = membersOf(match[3]);
  return members && { name: match[2], type: /** @type {'POS'} */ (match[1].toUpperCase()), members };
}

/** @param {string} text  between the braces @returns {Record<string, number> | null} */
function membersOf(text) {
  /** @type {Record<string, number>} */
  const members = {};
  for (const part of text.split(',')) {
    const member = MEMBER.exec(part);
    if (!member) return null;
    const [, name, binary, hexadecimal, decimal] = member;
    members[name.toUpperCase()] = binary
      ? parseInt(binary, 2)
      : hexadecimal
        ? parseInt(hexadecimal, 16)
        : Number(decimal);
  }
  return members;
}
