/**
 * Where an expression stands: the names that it may use, and what was found out about nodes, kept for the interpreter.
 *
 * @import { Designator, Expression, Span } from '../tree.js'
 * @import { RoutineSymbol, Scope, Symbol } from './declarations.js'
 * @import { Type } from './types.js'
 *
 * @typedef {object} Context
 * @property {Scope} scope
 * @property {Map<string, Symbol>} locals
 * @property {Type[]} using                       structures whose fields are named alone
 * @property {Designator[]} usingNodes
 * @property {RoutineSymbol | null} routine
 * @property {boolean} [isHandler]                in a global condition handler
 * @property {boolean} [isCondition]
 * @property {Map<object, Type>} typeOf
 * @property {Map<object, Symbol>} symbolOf
 * @property {Map<object, Designator>} usingOf    the structure that a name alone is a field of
 */

/** @param {string} name @param {Span | undefined} span @param {Context} context @param {string} what */
export function unknownName(name, span, { scope }, what) {
  const message = `Expected ${what}, got "${name}", which is not declared.`;
  if (scope.hasGaps) scope.report('unknown-name', `${message} A file that is missing may do so.`, span, 'warning');
  else scope.report('unknown-name', message, span);
}

/** @param {Expression} node @returns {node is Designator} */
export const isDesignator = (node) =>
  node.kind === 'name' || node.kind === 'system' || node.kind === 'index' || node.kind === 'field';

/** A variable that is set, or handed to who may set it. @param {Expression} node @param {Context} context */
export function markSet(node, context) {
  let inner = node;
  while (inner.kind === 'index' || inner.kind === 'field') inner = inner.target;
  if (inner.kind !== 'name') return;
  const upper = inner.name.toUpperCase();
  const symbol = context.locals.get(upper) ?? context.scope.globals.get(upper);
  if (symbol?.kind === 'variable') symbol.isSet = true;
}
