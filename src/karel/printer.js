/**
 * KAREL syntax tree → text. The only place where KAREL text is made. What comes out is KAREL by the language's rules of
 * form: names, numbers, strings, precedence, line ends; whether names are declared and types agree is not its business. A
 * tree that has no text is the caller's mistake, a RangeError.
 *
 * Lines end with a line feed and, where they can be broken with the language's `&`, are at most 96 characters long: longer
 * ones are met in programs that run on controllers, and no document at hand states the limit of the translator.
 *
 * @import { Declaration, Declared, Directive, Program, Routine, Statement, TypeNode } from './tree.js'
 */
import { BREAK, callText, expressionText, indexText, listText } from './expressionPrinter.js';
import { integerText } from './numberText.js';
import { identifier, MAX_STRING_LENGTH, oneLine, quoted, typeName, word } from './words.js';

const LINE_LENGTH = 96;
const INDENT = '  ';

/** @param {Program} program @returns {string} */
export function printKarel({ comments, name, declarations, body }) {
  const lines = [
    ...comments.map(({ text }) => commentText(text)),
    `PROGRAM ${identifier(name)}`,
    ...declarationLines(declarations),
    '',
    'BEGIN',
    ...indented(body.flatMap(statementLines)),
    `END ${identifier(name)}`,
  ];
  return lines.map((line) => `${folded(line)}\n`).join('');
}

const indented = (/** @type {string[]} */ lines) => lines.map((line) => INDENT + line);

const commentText = (/** @type {string} */ text) => `-- ${oneLine(text)}`.trimEnd();

/** Sections stand apart; a comment stays with what follows it. @param {readonly Declaration[]} declarations */
function declarationLines(declarations) {
  return declarations.flatMap((declaration, i) => {
    const before = declarations[i - 1]?.kind ?? 'directive';
    const joined = before === 'comment' || (before === 'directive' && declaration.kind === 'directive');
    return joined ? printDeclaration(declaration) : ['', ...printDeclaration(declaration)];
  });
}

/** @param {Declaration} declaration @returns {string[]} */
function printDeclaration(declaration) {
  switch (declaration.kind) {
    case 'comment':
      return [commentText(declaration.text)];
    case 'directive':
      return [directiveText(declaration)];
    case 'constants':
      return section(
        'CONST',
        declaration.entries.map(({ name, value }) => `${identifier(name)} = ${expressionText(value)}`),
      );
    case 'variables':
      return section('VAR', declaration.entries.map(declaredText));
    case 'routine':
      return routineLines(declaration);
    default: {
      /** @type {never} */
      const unknown = declaration;
      throw new TypeError(`Expected a declaration, got ${JSON.stringify(unknown)}.`);
    }
  }
}

/** @param {string} title @param {string[]} lines */
function section(title, lines) {
  if (lines.length === 0) throw new RangeError(`Expected at least one entry under ${title}, got none.`);
  return [title, ...indented(lines)];
}

/** @param {Declared} declared */
function declaredText({ names, type }) {
  if (names.length === 0) throw new RangeError('Expected at least one name before a type, got none.');
  return `${listText(names.map(identifier))} : ${typeText(type)}`;
}

/** @param {TypeNode} type @returns {string} */
function typeText(type) {
  switch (type.kind) {
    case 'type':
      return typeName(type.name);
    case 'string-type':
      if (type.length === undefined) return 'STRING';
      return `STRING[${sizeText(type.length, MAX_STRING_LENGTH)}]`;
    case 'array-type':
      if (type.sizes.length < 1 || type.sizes.length > 3) {
        throw new RangeError(`Expected an array of 1 to 3 dimensions, got ${type.sizes.length}.`);
      }
      return `ARRAY[${type.sizes.map((size) => sizeText(size, Infinity)).join(', ')}] OF ${typeText(type.of)}`;
    default: {
      /** @type {never} */
      const unknown = type;
      throw new TypeError(`Expected a type, got ${JSON.stringify(unknown)}.`);
    }
  }
}

/** @param {number} size @param {number} largest */
function sizeText(size, largest) {
  if (size >= 1 && size <= largest) return integerText(size);
  throw new RangeError(`Expected a size from 1${largest < Infinity ? ` to ${largest}` : ''}, got ${size}.`);
}

/** @param {Directive} directive */
function directiveText({ name, value, word: argument }) {
  if (argument !== undefined) return `%${word(name)} ${word(argument)}`;
  if (value === undefined) return `%${word(name)}`;
  if (value.kind === 'integer') return `%${word(name)} = ${integerText(value.value)}`;
  if (value.kind === 'string') return `%${word(name)} = ${quoted(value.value)}`;
  return `%${word(name)} = ${value.words.map(word).join(' + ')}`;
}

/** @param {Routine} routine */
function routineLines({ name, parameters, returns, from, declarations = [], body }) {
  if ((from === undefined) === (body === undefined)) {
    throw new RangeError(`Expected routine "${name}" to have a body or a program that it is from, and not both.`);
  }
  const list = parameters.length ? `(${parameters.map(declaredText).join(`; ${BREAK}`)})` : '';
  const header = `ROUTINE ${identifier(name)}${list}${returns ? ` : ${typeText(returns)}` : ''}`;
  if (!body) return [`${header} FROM ${identifier(from ?? '')}`];
  const statements = indented(body.flatMap(statementLines));
  return [header, ...declarations.flatMap(printDeclaration), 'BEGIN', ...statements, `END ${name}`];
}

/** @param {Statement} statement @returns {string[]} */
function statementLines(statement) {
  switch (statement.kind) {
    case 'comment':
      return [commentText(statement.text)];
    case 'assign': {
      const { target, value } = statement;
      const left = target.kind === 'index' ? indexText(target) : identifier(target.name);
      return [`${left} = ${BREAK}${expressionText(value)}`];
    }
    case 'call':
      return [callText(statement)];
    case 'if':
      return [
        `IF ${expressionText(statement.condition)} THEN`,
        ...indented(statement.then.flatMap(statementLines)),
        ...(statement.else ? ['ELSE', ...indented(statement.else.flatMap(statementLines))] : []),
        'ENDIF',
      ];
    case 'write': {
      const items = statement.items.map((item) => (item.kind === 'new-line' ? 'CR' : expressionText(item)));
      if (items.length === 0) throw new RangeError('Expected something to WRITE, got nothing.');
      return [`WRITE${statement.file === undefined ? '' : ` ${identifier(statement.file)} `}(${listText(items)})`];
    }
    case 'return':
      return [statement.value ? `RETURN(${expressionText(statement.value)})` : 'RETURN'];
    case 'abort':
      return ['ABORT'];
    default: {
      /** @type {never} */
      const unknown = statement;
      throw new TypeError(`Expected a statement, got ${JSON.stringify(unknown)}.`);
    }
  }
}

/** Break a line where it may be, only if it must be; what cannot be broken, a long string, stays whole. @param {string} line */
function folded(line) {
  if (line.replaceAll(BREAK, '').length <= LINE_LENGTH) return line.replaceAll(BREAK, '');
  const further = `${line.slice(0, line.search(/\S/))}${INDENT}${INDENT}`;
  const [first, ...rest] = line.split(BREAK);
  const lines = [first];
  for (const piece of rest) {
    const last = lines[lines.length - 1];
    if (`${last}${piece} &`.trimEnd().length <= LINE_LENGTH) lines[lines.length - 1] = last + piece;
    else lines.push(further + piece);
  }
  return lines.map((text, i) => (i < lines.length - 1 ? `${text.trimEnd()} &` : text)).join('\n');
}
