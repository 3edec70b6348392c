/**
 * KAREL text → syntax tree. Syntax only: whether names are declared and types agree is the checker's business. Always gives
 * a tree, of what could be read, and says of everything else what was expected and what came. Text of a file that is
 * included, which has no PROGRAM, becomes a fragment.
 *
 * What `ktransw` adds to the language is expanded before, as far as it is known here (`preprocess/preprocessor.js`).
 *
 * @import { Declaration, Directive, Fragment, Program, Statement } from './tree.js'
 * @import { Cursor, Diagnostic } from './parse/cursor.js'
 * @import { Preprocessed } from './preprocess/preprocessor.js'
 */
import { bodyInSlices, readBody, withoutTrailing } from './parse/blocks.js';
import { createCursor, FAULT, shownToken } from './parse/cursor.js';
import { readDeclarations, readEnd, readConstant, readEntries } from './parse/declarations.js';
import { readStatement } from './parse/statements.js';
import { readDeclared, readTypeDefinition } from './parse/types.js';
import { preprocess } from './preprocess/preprocessor.js';
import { scanInSlices } from './scan/scanner.js';
import { finished } from './slices.js';

/** @typedef {Readonly<Record<string, string>>} Files  by their names */

/**
 * @param {string} text
 * @param {{ files?: Files }} [options]  what the preprocessor may include
 * @returns {{ tree: Program | Fragment, diagnostics: Diagnostic[], hasGaps: boolean, programs: Program[] }}  whether something
 *   that the preprocessor was to bring is missing; the programs that the text makes of templates, which are checked and run
 *   like others. Diagnostics are those of all of them
 */
export const parseKarel = (text, options) => finished(parseInSlices(text, options));

/**
 * The same, some statements at a time.
 * @param {string} text
 * @param {{ files?: Files }} [options]
 * @returns {Generator<null, { tree: Program | Fragment, diagnostics: Diagnostic[], hasGaps: boolean, programs: Program[] }>}
 */
export function* parseInSlices(text, { files = {} } = {}) {
  /** @type {Diagnostic[]} */
  const diagnostics = [];
  const expanded = preprocess(text, files, diagnostics);
  yield null;
  const cursor = yield* cursorOf(expanded, diagnostics);
  const tree = isProgram(cursor) ? yield* readProgram(cursor) : readFragment(cursor);
  const programs = expanded.generated.map((one) => finished(readProgram(finished(cursorOf(one, diagnostics)))));
  return { tree, diagnostics: inOrder(diagnostics), hasGaps: expanded.hasGaps, programs };
}

/**
 * The text of an included file, as what it is included into.
 * @param {string} text
 * @param {'constants' | 'types' | 'variables' | 'fields' | 'declarations' | 'statements'} where
 * @param {{ files?: Files, name?: string }} [options]  name: of the file, by which it is included
 */
export function parseIncluded(text, where, { files = {}, name } = {}) {
  /** @type {Diagnostic[]} */
  const diagnostics = [];
  const cursor = finished(cursorOf(preprocess(text, files, diagnostics, name), diagnostics));
  const bare = /** @type {const} */ (true);
  /** @type {(Declaration | Statement)[]} */
  const parts = [];
  if (where === 'constants') parts.push({ kind: 'constants', bare, entries: readEntries(cursor, readConstant) });
  if (where === 'types') parts.push({ kind: 'types', bare, entries: readEntries(cursor, readTypeDefinition) });
  if (where === 'variables' || where === 'fields') {
    parts.push({ kind: 'variables', bare, entries: readEntries(cursor, readDeclared) });
  }
  parts.push(...readFragment(cursor).parts);
  return { tree: { kind: /** @type {const} */ ('fragment'), parts }, diagnostics: inOrder(diagnostics) };
}

/** @param {Preprocessed} expanded @param {Diagnostic[]} diagnostics @returns {Generator<null, Cursor>} */
function* cursorOf({ text, macros, locate }, diagnostics) {
  const report = (
    /** @type {string} */ code,
    /** @type {string} */ message,
    /** @type {number} */ start,
    /** @type {number} */ end,
  ) => void diagnostics.push({ severity: 'error', code, message, span: locate(start, end) });
  return createCursor(yield* scanInSlices(text, report), locate, diagnostics, macros);
}

/** @param {Diagnostic[]} diagnostics */
const inOrder = (diagnostics) => diagnostics.sort((a, b) => a.span.start - b.span.start);

/** @param {Cursor} cursor */
function isProgram(cursor) {
  let ahead = 0;
  while (cursor.peek(ahead).type === 'directive') ahead++;
  return cursor.isWord('PROGRAM', ahead) || cursor.isWord('BEGIN', ahead);
}

/** @param {Cursor} cursor @returns {Generator<null, Program>} */
function* readProgram(cursor) {
  const from = cursor.position();
  const comments = cursor.commentsHere().map(withoutTrailing);
  const early = cursor.peek().type === 'directive' ? readDeclarations(cursor, { lenient: true }) : [];
  let name = 'unnamed';
  try {
    cursor.needWord('PROGRAM');
    name = cursor.needName('the name of the program').text;
  } catch (fault) {
    if (fault !== FAULT) throw fault;
  }
  const declarations = [...early, ...readDeclarations(cursor)];
  /** @type {Statement[]} */
  let body = [];
  /** @type {Declaration[]} */
  let after = [];
  try {
    cursor.needWord('BEGIN');
    body = yield* bodyInSlices(cursor, ['END'], readStatement);
    readEnd(cursor, name);
    after = readDeclarations(cursor);
    const token = cursor.peek();
    if (!cursor.atEnd()) {
      const message = `Expected the end of the text, or a routine, after END, got ${shownToken(token)}.`;
      cursor.report('error', 'syntax', message, token.start, token.end);
    }
  } catch (fault) {
    if (fault !== FAULT) throw fault;
  }
  return cursor.node(from, { kind: 'program', comments, name, declarations, body, ...(after.length && { after }) });
}

/** @param {Cursor} cursor @returns {Fragment} */
function readFragment(cursor) {
  const from = cursor.position();
  /** @type {(Declaration | Statement)[]} */
  const parts = [];
  const bare = /** @type {const} */ (true);
  while (true) {
    const before = cursor.position();
    parts.push(...readDeclarations(cursor, { lenient: true }));
    if (isDeclared(cursor)) parts.push({ kind: 'variables', bare, entries: readEntries(cursor, readDeclared) });
    else if (isTypeDefinition(cursor))
      parts.push({ kind: 'types', bare, entries: readEntries(cursor, readTypeDefinition) });
    else parts.push(...readBody(cursor, [], readStatement, () => isDeclared(cursor) || isTypeDefinition(cursor)));
    if (cursor.atEnd()) return cursor.node(from, { kind: 'fragment', parts });
    if (cursor.position() === before) {
      const token = cursor.advance();
      cursor.report(
        'error',
        'syntax',
        `Expected a declaration or a statement, got ${shownToken(token)}.`,
        token.start,
        token.end,
      );
    }
  }
}

/** @param {Cursor} cursor */
const isDeclared = (cursor) =>
  cursor.peek().type === 'word' &&
  (cursor.isSign(':', 1) ||
    cursor.isSign(',', 1) ||
    ((cursor.isWord('IN', 1) || cursor.isWord('FROM', 1)) && !cursor.isSign('=', 3)));

/** @param {Cursor} cursor */
const isTypeDefinition = (cursor) =>
  cursor.peek().type === 'word' &&
  ((cursor.isSign('=', 1) && (cursor.isWord('STRUCTURE', 2) || cursor.isWord('PATH', 2))) ||
    (cursor.isWord('FROM', 1) && cursor.isSign('=', 3)));
