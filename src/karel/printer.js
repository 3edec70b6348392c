/**
 * KAREL syntax tree → text. The only place where KAREL text is made. What comes out is KAREL by the language's rules of
 * form: names, numbers, strings, precedence, line ends; whether names are declared and types agree is not its business. A
 * tree that has no text is the caller's mistake, a RangeError.
 *
 * Lines end with a line feed and, where they can be broken with the language's `&`, are at most 96 characters long: longer
 * ones are met in programs that run on controllers, and no document at hand states the limit of the translator.
 *
 * @import { Declaration, Fragment, Program, Statement } from './tree.js'
 */
import { declarationLines, printDeclaration } from './print/declarations.js';
import { commentText, indented, joinedLines } from './print/lines.js';
import { statementLines } from './print/statements.js';
import { finished, inPieces } from './slices.js';
import { identifier } from './words.js';

const DECLARATIONS = new Set(['constants', 'types', 'variables', 'routine']);

/** @param {Program | Fragment} tree @returns {string} */
export const printKarel = (tree) => finished(printInSlices(tree));

/** The same, some statements at a time. @param {Program | Fragment} tree @returns {Generator<null, string>} */
export function* printInSlices(tree) {
  if (tree.kind === 'fragment') return joinedLines(tree.parts.flatMap(partLines));
  const { comments, name, declarations, body, after = [] } = tree;
  /** @type {string[]} */
  const lines = [];
  yield* inPieces(body, (piece) => void lines.push(...indented(piece.flatMap(statementLines))));
  return joinedLines([
    ...comments.map(commentText),
    `PROGRAM ${identifier(name)}`,
    ...declarationLines(declarations),
    '',
    'BEGIN',
    ...lines,
    `END ${identifier(name)}`,
    ...declarationLines(after),
  ]);
}

/** @param {Declaration | Statement} part */
const partLines = (part) =>
  DECLARATIONS.has(part.kind)
    ? printDeclaration(/** @type {Declaration} */ (part))
    : statementLines(/** @type {Statement} */ (part));
