/**
 * Declarations as lines of text.
 *
 * @import { Comment, Constant, Declaration, Declared, Directive, Expression, PathType, Routine, TypeDefinition, TypeNode } from '../tree.js'
 */
import { BREAK, expressionText, listText } from '../expressionPrinter.js';
import { integerText } from '../numberText.js';
import { identifier, MAX_STRING_LENGTH, typeName, word } from '../words.js';
import { directiveText } from './directives.js';
import { commentText, indented } from './lines.js';
import { statementLines } from './statements.js';

/** Sections stand apart; a comment stays with what follows it. @param {readonly Declaration[]} declarations */
export function declarationLines(declarations) {
  return declarations.flatMap((declaration, i) => {
    const before = declarations[i - 1]?.kind ?? 'directive';
    const trails = declaration.kind === 'comment' && declaration.trailing;
    const joined = trails || before === 'comment' || (before === 'directive' && declaration.kind === 'directive');
    return joined ? printDeclaration(declaration) : ['', ...printDeclaration(declaration)];
  });
}

/** @param {Declaration} declaration @returns {string[]} */
export function printDeclaration(declaration) {
  switch (declaration.kind) {
    case 'comment':
      return [commentText(declaration)];
    case 'directive':
      return [directiveText(declaration)];
    case 'constants':
      return section('CONST', declaration, constantLines);
    case 'types':
      return section('TYPE', declaration, typeLines);
    case 'variables':
      return section('VAR', declaration, (declared) => [declaredText(declared)]);
    case 'routine':
      return routineLines(declaration);
    default: {
      /** @type {never} */
      const unknown = declaration;
      throw new TypeError(`Expected a declaration, got ${JSON.stringify(unknown)}.`);
    }
  }
}

/**
 * @template {object} T
 * @param {string} title
 * @param {{ entries: readonly (T | Comment | Directive)[], bare?: true }} section
 * @param {(entry: T) => string[]} print
 */
function section(title, { entries, bare }, print) {
  if (entries.length === 0) throw new RangeError(`Expected at least one entry under ${title}, got none.`);
  const lines = entryLines(entries, print);
  return bare ? lines : [title, ...indented(lines)];
}

/** @template {object} T @param {readonly (T | Comment | Directive)[]} entries @param {(entry: T) => string[]} print */
const entryLines = (entries, print) =>
  entries.flatMap((entry) => {
    if (!('kind' in entry)) return print(entry);
    if (entry.kind === 'comment') return [commentText(entry)];
    return [directiveText(/** @type {Directive} */ (entry))];
  });

/** @param {Constant} constant */
const constantLines = ({ name, value }) => [`${identifier(name)} = ${expressionText(value)}`];

/** @param {TypeDefinition} type */
function typeLines({ name, from, definition, group }) {
  const header = `${identifier(name)}${from === undefined ? '' : ` FROM ${identifier(from)}`} =`;
  if (definition.kind === 'structure') {
    const fields = entryLines(definition.fields, (field) => [declaredText(field, word)]);
    return [`${header} STRUCTURE`, ...indented(fields), 'ENDSTRUCTURE'];
  }
  return [`${header} ${typeText(definition)}${groupText(group)}`];
}

/** @param {PathType} type */
function pathText({ node, header }) {
  const data = [
    ...(node === undefined ? [] : [`NODEDATA = ${typeName(node)}`]),
    ...(header === undefined ? [] : [`PATHHEADER = ${typeName(header)}`]),
  ];
  return `PATH${data.length ? ` ${data.join(', ')}` : ''}`;
}

/** @param {Declared} declared @param {(name: string) => string} [print] */
function declaredText({ names, type, storage, from, group }, print = identifier) {
  if (names.length === 0) throw new RangeError('Expected at least one name before a type, got none.');
  const where = `${storage === undefined ? '' : ` IN ${word(storage)}`}${from === undefined ? '' : ` FROM ${identifier(from)}`}`;
  return `${listText(names.map(print))}${where} : ${typeText(type)}${groupText(group)}`;
}

/** @param {number | undefined} group */
const groupText = (group) => (group === undefined ? '' : ` IN GROUP[${integerText(group)}]`);

/** @param {TypeNode} type @returns {string} */
function typeText(type) {
  switch (type.kind) {
    case 'type':
      return typeName(type.name);
    case 'string-type':
      if (type.length === undefined) return 'STRING';
      return `STRING[${sizeText(type.length, MAX_STRING_LENGTH)}]`;
    case 'array-type':
      if (type.sizes.length > 3) {
        throw new RangeError(`Expected an array of 1 to 3 dimensions, got ${type.sizes.length}.`);
      }
      if (type.sizes.length === 0) return `ARRAY OF ${typeText(type.of)}`;
      return `ARRAY[${type.sizes.map((size) => (size === '*' ? size : sizeText(size, Infinity))).join(', ')}] OF ${typeText(type.of)}`;
    case 'path-type':
      return pathText(type);
    default: {
      /** @type {never} */
      const unknown = type;
      throw new TypeError(`Expected a type, got ${JSON.stringify(unknown)}.`);
    }
  }
}

/** @param {number | Expression} size @param {number} largest */
function sizeText(size, largest) {
  if (typeof size !== 'number') return expressionText(size);
  if (size >= 1 && size <= largest) return integerText(size);
  throw new RangeError(`Expected a size from 1${largest < Infinity ? ` to ${largest}` : ''}, got ${size}.`);
}

/** @param {Routine} routine */
function routineLines({ name, parameters, returns, from, declarations = [], body }) {
  if ((from === undefined) === (body === undefined)) {
    throw new RangeError(`Expected routine "${name}" to have a body or a program that it is from, and not both.`);
  }
  const list = parameters.length ? `(${parameters.map((one) => declaredText(one)).join(`; ${BREAK}`)})` : '';
  const header = `ROUTINE ${identifier(name)}${list}${returns ? ` : ${typeText(returns)}` : ''}`;
  if (!body) return [`${header} FROM ${identifier(from ?? '')}`];
  const statements = indented(body.flatMap(statementLines));
  return [header, ...declarations.flatMap(printDeclaration), 'BEGIN', ...statements, `END ${name}`];
}
