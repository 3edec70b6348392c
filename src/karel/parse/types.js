/**
 * Types, and what is declared with them.
 *
 * @import { ArrayType, Comment, Declared, Directive, Expression, NamedType, PathType, StringType, Structure, TypeDefinition, TypeNode } from '../tree.js'
 * @import { Cursor } from './cursor.js'
 */
import { isReserved, isTypeWord } from '../words.js';
import { readExpression, readList } from './expressions.js';
import { readDirective } from './directives.js';

/** @param {Cursor} cursor @returns {TypeNode} */
export function readType(cursor) {
  const from = cursor.position();
  if (cursor.isWord('PATH') && (cursor.isWord('NODEDATA', 1) || cursor.isWord('PATHHEADER', 1)))
    return readPathType(cursor);
  if (!cursor.takeWord('ARRAY')) return readElementType(cursor);
  const sizes = cursor.isSign('[')
    ? cursor.bracketed('[', () => readList(cursor, () => (cursor.takeSign('*') ? '*' : readSize(cursor))), ']')
    : [];
  if (sizes.length > 3)
    cursor.report(
      'error',
      'dimensions',
      `Expected an array of 1 to 3 dimensions, got ${sizes.length}.`,
      cursor.peek().start,
      cursor.peek().end,
    );
  cursor.needWord('OF');
  /** @type {ArrayType} */
  const array = { kind: 'array-type', sizes: sizes.slice(0, 3), of: readElementType(cursor) };
  return cursor.node(from, array);
}

/** @param {Cursor} cursor @returns {number | Expression} */
function readSize(cursor) {
  const size = readExpression(cursor);
  return size.kind === 'integer' ? size.value : size;
}

/** @param {Cursor} cursor @returns {NamedType | StringType} */
function readElementType(cursor) {
  const from = cursor.position();
  const token = cursor.peek();
  if (token.type !== 'word') return cursor.fail('a type');
  if (cursor.takeWord('STRING')) {
    if (!cursor.isSign('[')) return cursor.node(from, { kind: 'string-type' });
    const length = cursor.bracketed('[', () => readSize(cursor), ']');
    return cursor.node(from, { kind: 'string-type', length });
  }
  if (isReserved(token.upper) && !isTypeWord(token.upper)) return cursor.fail('a type');
  if (cursor.isMacroUse()) cursor.skipMacroUse('a type');
  else cursor.advance();
  return cursor.node(from, { kind: 'type', name: token.text });
}

/** `a, b IN CMOS FROM prog : INTEGER IN GROUP[1]`. @param {Cursor} cursor @param {{ plain?: boolean }} [options] @returns {Declared} */
export function readDeclared(cursor, { plain = false } = {}) {
  const from = cursor.position();
  const tokens = readList(cursor, () => (plain ? readFieldName(cursor) : cursor.needName('the name of a variable')));
  /** @type {Declared} */
  const declared = { names: tokens.map(({ text }) => text), type: { kind: 'type', name: 'INTEGER' } };
  if (cursor.takeWord('IN')) {
    const token = cursor.peek();
    if (token.upper !== 'CMOS' && token.upper !== 'SHADOW' && token.upper !== 'DRAM')
      return cursor.fail('CMOS, SHADOW or DRAM');
    cursor.advance();
    declared.storage = token.upper;
  }
  if (cursor.takeWord('FROM')) declared.from = cursor.needName('the name of a program').text;
  if (cursor.isSign('::')) cursor.fail('":" and a type');
  cursor.needSign(':');
  declared.type = readType(cursor);
  const group = readGroup(cursor);
  if (group !== null) declared.group = group;
  declared.nameSpans = tokens.map(cursor.spanOf);
  return cursor.node(from, declared);
}

/** `IN GROUP[1]`, if it stands here: the motion group of a position. @param {Cursor} cursor @returns {number | null} */
function readGroup(cursor) {
  if (!cursor.isWord('IN') || !cursor.isWord('GROUP', 1)) return null;
  cursor.advance();
  cursor.advance();
  return cursor.bracketed('[', () => needInteger(cursor), ']');
}

/** Fields of structures may be called by words of the language. @param {Cursor} cursor */
function readFieldName(cursor) {
  if (cursor.peek().type !== 'word') cursor.fail('the name of a field');
  return cursor.advance();
}

/** @param {Cursor} cursor */
export function needInteger(cursor) {
  if (cursor.peek().type !== 'integer') cursor.fail('a whole number');
  return cursor.advance().value;
}

/** `t = STRUCTURE … ENDSTRUCTURE`, `t = PATH NODEDATA = n`, `t FROM p = XYZWPR IN GROUP[1]`. @param {Cursor} cursor @returns {TypeDefinition} */
export function readTypeDefinition(cursor) {
  const from = cursor.position();
  const name = cursor.needName('the name of a type').text;
  const program = cursor.takeWord('FROM') ? { from: cursor.needName('the name of a program').text } : {};
  cursor.needSign('=');
  const definition = readDefinition(cursor);
  const group = definition.kind === 'structure' ? null : readGroup(cursor);
  return cursor.node(from, { name, ...program, definition, ...(group === null ? {} : { group }) });
}

/** @param {Cursor} cursor @returns {Structure | TypeNode} */
function readDefinition(cursor) {
  if (cursor.isWord('PATH')) return readPathType(cursor);
  if (cursor.isWord('STRUCTURE')) return readStructure(cursor);
  if (cursor.peek().type !== 'word') cursor.fail('STRUCTURE, PATH or another type');
  return readType(cursor);
}

/** @param {Cursor} cursor @returns {PathType} */
function readPathType(cursor) {
  const from = cursor.position();
  cursor.advance();
  /** @type {PathType} */
  const type = { kind: 'path-type' };
  do {
    if (cursor.takeWord('NODEDATA')) {
      cursor.needSign('=');
      type.node = needTypeName(cursor);
    } else if (cursor.takeWord('PATHHEADER')) {
      cursor.needSign('=');
      type.header = needTypeName(cursor);
    } else if (type.node ?? type.header) cursor.fail('NODEDATA or PATHHEADER');
  } while (cursor.takeSign(','));
  return cursor.node(from, type);
}

/** @param {Cursor} cursor */
function needTypeName(cursor) {
  const token = cursor.peek();
  if (token.type !== 'word' || (isReserved(token.upper) && !isTypeWord(token.upper))) cursor.fail('a type');
  return cursor.advance().text;
}

/** @param {Cursor} cursor @returns {Structure} */
function readStructure(cursor) {
  const from = cursor.position();
  cursor.advance();
  /** @type {(Declared | Comment | Directive)[]} */
  const fields = [];
  while (true) {
    fields.push(...cursor.commentsHere());
    if (cursor.takeSign(';')) continue;
    if (cursor.peek().type === 'directive') fields.push(readDirective(cursor));
    else if (cursor.isWord('ENDSTRUCTURE') || cursor.peek().type !== 'word') break;
    else {
      fields.push(readDeclared(cursor, { plain: true }));
      if (cursor.continues() && !cursor.isSign(';') && !cursor.isWord('ENDSTRUCTURE')) cursor.fail('";" or a new line');
    }
  }
  cursor.needWord('ENDSTRUCTURE');
  return cursor.node(from, { kind: 'structure', fields });
}
