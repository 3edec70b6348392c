/**
 * What `ktransw` adds to KAREL, expanded: `%define` with and without parameters, `%defeval`, `%undef`, `%ifdef`, `%ifndef`,
 * `%ifeq`, `%ifneq`, `%if` of a comparison, `%else`, `%endif`, and `%include` of files that are at hand and are not plain
 * KAREL. The rest is refused by name (`%class`, `%from` …) and left out. A text that uses none of it passes unchanged.
 *
 * The expanded text remembers, piece by piece, where it came from, so that a fault is shown in the text that was typed.
 *
 * @import { Diagnostic, Locate } from '../parse/cursor.js'
 * @import { Macro } from './macros.js'
 *
 * @typedef {{ name: string | undefined, starts: readonly number[] }} Source
 * @typedef {{ at: number, length: number, source: Source, start: number, end: number }} Mapped
 */
import { expandLine, expandText } from './macros.js';
import { lineStarts, placeOf } from './places.js';

const CONDITIONALS = new Set(['IFDEF', 'IFNDEF', 'IFEQ', 'IFNEQ', 'IF', 'ELSE', 'ENDIF']);
const REFUSED = new Set(`CLASS FROM IMPORT MODE EVAL EXEC FOREACH ERROR WARNING DATE INTERFACE ABSTRACT`.split(' '));
const KNOWN = new Set([...CONDITIONALS, ...REFUSED, 'DEFINE', 'DEFEVAL', 'UNDEF']);
const LINE = /^[ \t]*%[ \t]*([A-Za-z]+)\b[ \t]*(.*)$/;
const USES_IT = new RegExp(`^[ \\t]*%[ \\t]*(?:${[...KNOWN].join('|')}|include[ \\t]+\\S+\\.(?:klh|klt|klc))\\b`, 'im');
const MAX_INCLUDES = 16;

/**
 * @param {string} text
 * @param {Readonly<Record<string, string>>} files
 * @param {Diagnostic[]} diagnostics
 * @returns {{ text: string, macros: boolean, locate: Locate }}
 */
export function preprocess(text, files, diagnostics) {
  const whole = { name: undefined, starts: lineStarts(text) };
  if (!USES_IT.test(text)) {
    return { text, macros: false, locate: (start, end) => ({ start, end, ...placeOf(whole.starts, start) }) };
  }
  const state = {
    files,
    diagnostics,
    macros: new Map(),
    out: /** @type {string[]} */ ([]),
    length: 0,
    map: /** @type {Mapped[]} */ ([]),
  };
  includeText(text, whole, state, 0);
  return { text: state.out.join(''), macros: true, locate: locator(state.map, whole) };
}

/** @typedef {{ files: Readonly<Record<string, string>>, diagnostics: Diagnostic[], macros: Map<string, Macro>, out: string[], length: number, map: Mapped[] }} State */

/** @param {string} text @param {Source} source @param {State} state @param {number} depth */
function includeText(text, source, state, depth) {
  /** @type {boolean[]} whether the branch that is open now counts, innermost last */
  const branches = [];
  const { starts } = source;
  const emit = (/** @type {string} */ piece, /** @type {number} */ start, /** @type {number} */ end) => {
    state.map.push({ at: state.length, length: piece.length, source, start, end });
    state.out.push(piece);
    state.length += piece.length;
  };
  for (let i = 0; i < starts.length; i++) {
    const from = starts[i];
    const to = starts[i + 1] ?? text.length;
    const raw = text.slice(from, to);
    const line = raw.replace(/[\r\n]+$/, '');
    const lineEnd = raw.slice(line.length);
    const warn = (/** @type {string} */ code, /** @type {string} */ message) => {
      const place = {
        start: from,
        end: from + line.length,
        ...placeOf(starts, from),
        ...(source.name && { file: source.name }),
      };
      state.diagnostics.push({ severity: 'warning', code, message, span: place });
    };
    const match = LINE.exec(line);
    const word = match?.[1].toUpperCase() ?? '';
    const rest = (match?.[2] ?? '').replace(/--.*$/, '').trim();
    const active = branches.every(Boolean);

    if (match && CONDITIONALS.has(word)) {
      if (word === 'ENDIF') branches.pop();
      else if (word === 'ELSE') branches.push(!branches.pop());
      else branches.push(active && isMet(word, rest, state.macros, warn));
      emit(lineEnd, from + line.length, to);
    } else if (!active) emit(lineEnd, from + line.length, to);
    else if (match && (word === 'DEFINE' || word === 'DEFEVAL')) {
      let body = match[2];
      // A body in backquotes goes on until they close.
      while (isOpen(body) && i + 1 < starts.length) {
        i++;
        body += `\n${text.slice(starts[i], starts[i + 1] ?? text.length).replace(/[\r\n]+$/, '')}`;
      }
      define(word, body, state.macros);
      emit(lineEnd, from + line.length, to);
    } else if (word === 'UNDEF') {
      state.macros.delete(rest);
      emit(lineEnd, from + line.length, to);
    } else if (match && REFUSED.has(word)) {
      if (word !== 'MODE')
        warn('preprocessor', `%${match[1]} of the preprocessor is not expanded here; what it would bring is missing.`);
      emit(lineEnd, from + line.length, to);
    } else if (word === 'INCLUDE' && !/\.kl$|^[^.]*$/i.test(rest)) {
      const name = expandText(rest, state.macros).replace(/^['"]|['"]$/g, '');
      const found = fileNamed(state.files, name);
      if (found === undefined) {
        warn('include', `%INCLUDE of "${name}": no such file is at hand; what it would bring is missing.`);
        emit(lineEnd, from + line.length, to);
      } else if (depth >= MAX_INCLUDES)
        warn('include', `%INCLUDE of "${name}": more than ${MAX_INCLUDES} files inside each other.`);
      else includeText(`${found}\n`, { name, starts: lineStarts(`${found}\n`) }, state, depth + 1);
    } else {
      for (const piece of expandLine(line, state.macros)) emit(piece.text, from + piece.start, from + piece.end);
      emit(lineEnd, from + line.length, to);
    }
  }
}

const isOpen = (/** @type {string} */ body) => (body.match(/`/g)?.length ?? 0) % 2 === 1;

/** A file by its name, or by the end of its path; \ and / are the same. @param {Readonly<Record<string, string>>} files @param {string} name */
export function fileNamed(files, name) {
  const wanted = name.replaceAll('\\', '/').toLowerCase();
  const isIt = (/** @type {string} */ key) => {
    const path = key.replaceAll('\\', '/').toLowerCase();
    return (
      path === wanted ||
      path === `${wanted}.kl` ||
      path.endsWith(`/${wanted}`) ||
      wanted.endsWith(`/${path}`) ||
      wanted.endsWith(`/${path.replace(/\.kl$/, '')}`)
    );
  };
  const key = Object.keys(files).find(isIt);
  return key === undefined ? undefined : files[key];
}

/** @param {string} word @param {string} text @param {Map<string, Macro>} macros */
function define(word, text, macros) {
  const match = /^([A-Za-z_][A-Za-z0-9_]*)(\(([^()]*)\))?([^]*)$/.exec(text);
  if (!match) return;
  const [, name, list, parameters, rest] = match;
  const bare = rest.replaceAll('`', '').replace(/--.*$/gm, '').trim();
  const body = word === 'DEFEVAL' ? expandText(bare, macros) : bare;
  macros.set(name, { parameters: list ? parameters.split(',').map((one) => one.trim()) : null, body });
}

/** @param {string} word @param {string} rest @param {Map<string, Macro>} macros @param {(code: string, message: string) => void} warn */
function isMet(word, rest, macros, warn) {
  if (word === 'IFDEF') return macros.has(rest);
  if (word === 'IFNDEF') return !macros.has(rest);
  if (word !== 'IF') {
    const [left, right] = rest.split(/\s+/).map((part) => expandText(part, macros));
    return (left === right) === (word === 'IFEQ');
  }
  const match = /^(.+?)\s*(==|!=|<=|>=|<|>|=)\s*(.+)$/.exec(expandText(rest, macros));
  if (!match) {
    if (/^\d+$/.test(expandText(rest, macros))) return Number(expandText(rest, macros)) !== 0;
    warn('preprocessor', `%if of the preprocessor knows comparisons here, not "${rest}", which is taken as false.`);
    return false;
  }
  const [, left, operator, right] = match;
  const [a, b] = [left, right].map((side) => (Number.isNaN(Number(side)) ? side : Number(side)));
  const answers = { '==': a === b, '=': a === b, '!=': a !== b, '<=': a <= b, '>=': a >= b, '<': a < b, '>': a > b };
  return answers[/** @type {keyof typeof answers} */ (operator)];
}

/** @param {readonly Mapped[]} map @param {Source} whole @returns {Locate} */
function locator(map, whole) {
  const pieceAt = (/** @type {number} */ offset) => {
    let low = 0;
    let high = map.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (map[middle].at <= offset) low = middle;
      else high = middle - 1;
    }
    return map[low];
  };
  /** @param {Mapped} piece @param {number} offset @param {boolean} isEnd */
  const sourceOffset = (piece, offset, isEnd) =>
    piece.length === piece.end - piece.start
      ? Math.min(piece.start + offset - piece.at, piece.end)
      : isEnd
        ? piece.end
        : piece.start;
  return (start, end) => {
    if (map.length === 0) return { start: 0, end: 0, ...placeOf(whole.starts, 0) };
    const first = pieceAt(start);
    const last = pieceAt(Math.max(start, end - 1));
    const from = sourceOffset(first, start, false);
    const to = last.source === first.source ? Math.max(from, sourceOffset(last, end, true)) : first.end;
    const file = first.source.name && { file: first.source.name };
    return { start: from, end: to, ...placeOf(first.source.starts, from), ...file };
  };
}
