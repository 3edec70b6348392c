/**
 * Declarations: sections of constants, types and variables, routines, directives. What is none is left out, up to the next
 * line.
 *
 * @import { Comment, Constant, Declaration, Declared, Directive, Routine } from '../tree.js'
 * @import { Cursor } from './cursor.js'
 */
import { skipLine } from './blocks.js';
import { FAULT, shownToken } from './cursor.js';
import { readDirective } from './directives.js';
import { readExpression } from './expressions.js';
import { readStatements } from './statements.js';
import { readDeclared, readType, readTypeDefinition } from './types.js';

const SECTIONS = new Set(['CONST', 'TYPE', 'VAR']);

/** Declarations, up to BEGIN, END, the end, or what cannot be one. @param {Cursor} cursor @param {{ lenient?: boolean, inRoutine?: boolean }} [options] @returns {Declaration[]} */
export function readDeclarations(cursor, { lenient = false, inRoutine = false } = {}) {
  /** @type {Declaration[]} */
  const declarations = [];
  while (true) {
    declarations.push(...cursor.commentsHere());
    if (cursor.takeSign(';')) continue;
    const token = cursor.peek();
    if (cursor.atEnd() || cursor.isWord('BEGIN') || cursor.isWord('END')) return declarations;
    const isDeclaration =
      token.type === 'directive' || (token.type === 'word' && (SECTIONS.has(token.upper) || token.upper === 'ROUTINE'));
    if (!isDeclaration && lenient && !cursor.isMacroUse()) return declarations;
    if (cursor.isMacroUse()) {
      cursor.skipMacroUse();
      continue;
    }
    if (inRoutine && cursor.isWord('ROUTINE')) return declarations;
    const from = cursor.position();
    try {
      if (!isDeclaration) cursor.fail('a declaration (CONST, TYPE, VAR, ROUTINE) or BEGIN');
      declarations.push(readDeclaration(cursor));
    } catch (fault) {
      if (fault !== FAULT) throw fault;
      cursor.outside();
      skipLine(cursor, from);
    }
  }
}

/** @param {Cursor} cursor @returns {Declaration} */
function readDeclaration(cursor) {
  if (cursor.peek().type === 'directive') return readDirective(cursor);
  if (cursor.isWord('ROUTINE')) return readRoutine(cursor);
  const from = cursor.position();
  const title = cursor.advance().upper;
  if (title === 'CONST') return cursor.node(from, { kind: 'constants', entries: readEntries(cursor, readConstant) });
  if (title === 'TYPE') return cursor.node(from, { kind: 'types', entries: readEntries(cursor, readTypeDefinition) });
  return cursor.node(from, { kind: 'variables', entries: readEntries(cursor, readDeclared) });
}

/** @param {Cursor} cursor @returns {Constant} */
export function readConstant(cursor) {
  const from = cursor.position();
  const name = cursor.needName('the name of a constant').text;
  cursor.needSign('=');
  return cursor.node(from, { name, value: readExpression(cursor) });
}

/**
 * Entries of a section, with the comments and directives between them.
 * @template {object} T @param {Cursor} cursor @param {(cursor: Cursor) => T} readEntry
 */
export function readEntries(cursor, readEntry) {
  /** @type {(T | Comment | Directive)[]} */
  const entries = [];
  while (true) {
    const ahead = directivesAhead(cursor);
    const next = cursor.peek(ahead);
    if (cursor.isSign(';')) cursor.advance();
    else if (next.type !== 'word' || endsSection(next.upper)) return entries;
    else if (cursor.isMacroUse(ahead)) return entries;
    else {
      entries.push(...cursor.commentsHere());
      const from = cursor.position();
      try {
        if (ahead > 0) entries.push(readDirective(cursor));
        else {
          const entry = readEntry(cursor);
          entries.push(...cursor.swallowedComments(), entry);
          if (cursor.continues() && !cursor.isSign(';') && !endsSection(cursor.peek().upper) && !cursor.atEnd())
            cursor.fail('";" or a new line');
        }
      } catch (fault) {
        if (fault !== FAULT) throw fault;
        cursor.outside();
        skipLine(cursor, from);
      }
    }
  }
}

/** @param {string} upper */
const endsSection = (upper) => SECTIONS.has(upper) || /^(ROUTINE|BEGIN|END|PROGRAM)$/.test(upper);

/** How many directives stand here. @param {Cursor} cursor */
function directivesAhead(cursor) {
  let ahead = 0;
  while (cursor.peek(ahead).type === 'directive') ahead++;
  return ahead;
}

/** @param {Cursor} cursor @returns {Routine} */
function readRoutine(cursor) {
  const from = cursor.position();
  cursor.advance();
  const { text: name } = cursor.needName('the name of a routine');
  const parameters = cursor.isSign('(') ? readParameters(cursor) : [];
  const returns = cursor.takeSign(':') ? { returns: readType(cursor) } : {};
  if (cursor.takeWord('FROM')) {
    return cursor.node(from, {
      kind: 'routine',
      name,
      parameters,
      ...returns,
      from: cursor.needName('the name of a program').text,
    });
  }
  const header = cursor.position();
  /** @type {Routine['declarations']} */
  const declarations = /** @type {Routine['declarations']} */ (
    readDeclarations(cursor, { lenient: true, inRoutine: true })
  );
  if (!cursor.isWord('BEGIN')) {
    if (header === cursor.position()) cursor.fail('FROM, VAR, CONST or BEGIN');
    cursor.fail('BEGIN');
  }
  cursor.advance();
  const body = readStatements(cursor, ['END']);
  readEnd(cursor, name);
  const own = declarations?.length ? { declarations } : {};
  return cursor.node(from, { kind: 'routine', name, parameters, ...returns, ...own, body });
}

/** `END name` @param {Cursor} cursor @param {string} name */
export function readEnd(cursor, name) {
  cursor.needWord('END');
  const token = cursor.peek();
  if (token.type !== 'word' || !cursor.continues()) {
    cursor.report(
      'error',
      'end-name',
      `Expected "${name}" after END, got ${token.fresh ? 'a new line' : shownToken(token)}.`,
      token.start,
      token.end,
    );
    return;
  }
  cursor.advance();
  if (token.upper === name.toUpperCase()) return;
  cursor.report('error', 'end-name', `Expected "${name}" after END, got "${token.text}".`, token.start, token.end);
}

/** @param {Cursor} cursor @returns {Declared[]} */
function readParameters(cursor) {
  return cursor.bracketed(
    '(',
    () => {
      /** @type {Declared[]} */
      const list = [];
      while (!cursor.isSign(')')) {
        list.push(readDeclared(cursor));
        if (!cursor.takeSign(';')) break;
      }
      return list;
    },
    ')',
  );
}
