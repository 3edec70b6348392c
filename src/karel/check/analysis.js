/**
 * A whole program, analysed: what it declares, the type of every expression, and what is against it. The checker tells the
 * diagnostics; the interpreter builds on the rest.
 *
 * @import { Declaration, Fragment, Program, Statement } from '../tree.js'
 * @import { Diagnostic } from '../parse/cursor.js'
 * @import { Files } from '../parser.js'
 * @import { Scope, Symbol } from './declarations.js'
 * @import { Context } from './context.js'
 * @import { Type } from './types.js'
 *
 * @typedef {object} Analysis
 * @property {Program} program           with the included files in place
 * @property {Scope} scope
 * @property {Map<object, Type>} typeOf
 * @property {Map<object, Symbol>} symbolOf
 * @property {Context['usingOf']} usingOf
 * @property {Diagnostic[]} diagnostics
 */
import { finished, inPieces } from '../slices.js';
import { DIRECTIVES } from './constants.js';
import { declareAll, MOST_VALUES, NOWHERE, roomFor } from './declarations.js';
import { includeFiles } from './includes.js';
import { checkLabels } from './labels.js';
import { checkBody } from './statements.js';
import { checkUnset } from './unset.js';

const DECLARATIONS = new Set(['constants', 'types', 'variables', 'routine', 'directive', 'comment']);

/** @param {Program | Fragment} tree @param {Files} files @param {boolean} [hasGaps] whether something else of the text is missing @returns {Analysis} */
export const analyse = (tree, files, hasGaps) => finished(analyseInSlices(tree, files, hasGaps));

/** The same, some statements at a time. @param {Program | Fragment} tree @param {Files} files @param {boolean} [hasGaps] @returns {Generator<null, Analysis>} */
export function* analyseInSlices(tree, files, hasGaps = false) {
  const inclusion = includeFiles(tree, files);
  const program = asProgram(inclusion.tree);
  const diagnostics = inclusion.diagnostics;
  /** @type {Scope} */
  const scope = {
    program: program.name.toUpperCase(),
    globals: new Map(),
    types: new Map(),
    globalSlots: 0,
    room: roomFor(MOST_VALUES),
    hasGaps: hasGaps || inclusion.gaps > 0 || tree.kind === 'fragment',
    report: (code, message, span = NOWHERE, severity = 'error') =>
      void diagnostics.push({ severity, code, message, span }),
  };
  const all = [...program.declarations, ...(program.after ?? [])];
  declareAll(all, scope);
  checkDirectives(all, scope);
  const context = { scope, using: [], usingNodes: [], typeOf: new Map(), symbolOf: new Map(), usingOf: new Map() };
  const leavesUnset = all.some((one) => one.kind === 'directive' && one.name === 'UNINITVARS');
  for (const symbol of scope.globals.values()) {
    if (symbol.kind !== 'routine' || !symbol.node) continue;
    checkBody(symbol.node.body ?? [], { ...context, locals: symbol.locals, routine: symbol });
    checkLabels(symbol.node.body ?? [], scope);
    if (!leavesUnset) checkUnset(symbol.node.body ?? [], { ...context, locals: symbol.locals, routine: symbol });
    checkVariables(symbol.locals, scope, false);
  }
  const main = { ...context, locals: new Map(), routine: null };
  yield* inPieces(program.body, (piece) => checkBody(piece, main));
  checkLabels(program.body, scope);
  if (tree.kind === 'program') checkVariables(scope.globals, scope, true);
  return { program, scope, typeOf: context.typeOf, symbolOf: context.symbolOf, usingOf: context.usingOf, diagnostics };
}

/** A fragment is checked as a program of its parts. @param {Program | Fragment} tree @returns {Program} */
function asProgram(tree) {
  if (tree.kind === 'program') return tree;
  const declarations = /** @type {Declaration[]} */ (tree.parts.filter(({ kind }) => DECLARATIONS.has(kind)));
  const body = /** @type {Statement[]} */ (tree.parts.filter(({ kind }) => !DECLARATIONS.has(kind)));
  return { kind: 'program', comments: [], name: '*', declarations, body };
}

/** @param {readonly Declaration[]} declarations @param {Scope} scope */
function checkDirectives(declarations, scope) {
  for (const declaration of declarations) {
    if (declaration.kind !== 'directive') continue;
    const { name, value, span } = declaration;
    if (!DIRECTIVES.has(name))
      scope.report('directive', `Expected a directive of the translator, got %${name}.`, span, 'warning');
    if (name === 'COMMENT' && value?.kind !== 'string')
      scope.report('directive', "Expected a string behind %COMMENT, as in %COMMENT = 'text'.", span);
    if (/^(STACKSIZE|PRIORITY|TIMESLICE|DELAY|DEFGROUP)$/.test(name) && value?.kind !== 'integer') {
      scope.report('directive', `Expected a whole number behind %${name} =.`, span);
    }
  }
}

/** @param {Map<string, Symbol>} names @param {Scope} scope @param {boolean} isGlobal */
function checkVariables(names, scope, isGlobal) {
  for (const symbol of names.values()) {
    if (symbol.kind !== 'variable' || symbol.isParameter || symbol.from) continue;
    if (!symbol.isUsed && !symbol.isSet)
      scope.report('unused', `"${symbol.name}" is never used.`, symbol.span, 'warning');
    // Variables of the program keep what an earlier run, or another program, has put into them.
    else if (!isGlobal && symbol.isUsed && !symbol.isSet)
      scope.report('uninitialised', `"${symbol.name}" is used, but never set.`, symbol.span, 'warning');
  }
}
