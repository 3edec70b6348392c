/**
 * The type of every expression, and what is against it.
 *
 * @import { Binary, Call, Expression, Field, Index, Name, Unary } from '../tree.js'
 * @import { Context } from './context.js'
 * @import { Type } from './types.js'
 */
import { BOOLEAN_PORTS, INTEGER_PORTS } from '../ports.js';
import { isKnownRoutine } from './builtins.js';
import { typeOfCallOf } from './calls.js';
import { PREDEFINED, PREDEFINED_FILES } from './constants.js';
import { unknownName } from './context.js';
import { binaryType } from './operators.js';
import { systemType } from './systemVariables.js';
import * as types from './types.js';

/** @param {Expression} node @param {Context} context @returns {Type} */
export function typeOfExpression(node, context) {
  const type = found(node, context);
  context.typeOf.set(node, type);
  return type;
}

/** @param {Expression} node @param {Context} context @returns {Type} */
function found(node, context) {
  switch (node.kind) {
    case 'integer':
      return types.INTEGER;
    case 'real':
      return types.REAL;
    case 'string':
      return types.STRING;
    case 'system':
      return systemType(node);
    case 'name':
      return typeOfName(node, context);
    case 'index':
      return typeOfIndex(node, context);
    case 'field':
      return typeOfField(node, context);
    case 'call':
      return typeOfCall(node, context, true);
    case 'unary':
      return typeOfUnary(node, context);
    case 'binary':
      return typeOfBinary(node, context);
  }
}

/** @param {Name} node @param {Context} context @returns {Type} */
function typeOfName(node, context) {
  const upper = node.name.toUpperCase();
  for (const [i, structure] of [...context.using.entries()].reverse()) {
    const field = structure.kind === 'UNKNOWN' ? null : types.fieldOf(structure, upper);
    if (field) {
      context.usingOf.set(node, context.usingNodes[i]);
      return field;
    }
  }
  const symbol = context.locals.get(upper) ?? context.scope.globals.get(upper);
  if (symbol) {
    context.symbolOf.set(node, symbol);
    if (symbol.kind === 'routine')
      return typeOfCall({ kind: 'call', name: node.name, args: [], span: node.span }, context, true);
    if (symbol.kind === 'variable') symbol.isUsed = true;
    if (context.isHandler && symbol.kind === 'variable' && !symbol.isGlobal)
      context.scope.report(
        'handler-local',
        `Expected variables of the program in a condition handler, got "${node.name}", which is the routine's own.`,
        node.span,
      );
    return symbol.type;
  }
  const constant = PREDEFINED.get(upper);
  if (constant) return constant.type;
  if (PREDEFINED_FILES.has(upper)) return types.FILE;
  if (isKnownRoutine(upper))
    return typeOfCall({ kind: 'call', name: node.name, args: [], span: node.span }, context, true);
  unknownName(node.name, node.span, context, 'a variable, a constant or a function');
  return types.UNKNOWN;
}

/** @param {Index} node @param {Context} context @returns {Type} */
function typeOfIndex(node, context) {
  const { target, indices, span } = node;
  const { report } = context.scope;
  const indexTypes = indices.map((index) => typeOfExpression(index, context));
  const upper = target.kind === 'name' ? target.name.toUpperCase() : '';
  const isDeclared = context.locals.has(upper) || context.scope.globals.has(upper);
  for (const [i, index] of indexTypes.entries()) {
    if (!types.isWhole(index) && !types.isUnknown(index))
      report('index-type', `Expected a whole number as index, got ${types.typeText(index)}.`, indices[i].span);
  }
  const isPort = !isDeclared && (BOOLEAN_PORTS.has(upper) || INTEGER_PORTS.has(upper));
  if (isPort && indices.length > 1) report('indices', `Expected 1 index of ${upper}, got ${indices.length}.`, span);
  if (isPort) return BOOLEAN_PORTS.has(upper) ? types.BOOLEAN : types.INTEGER;
  const type = typeOfExpression(target, context);
  if (types.isUnknown(type)) return systemType(node);
  if (type.kind === 'PATH') return type.node ?? types.UNKNOWN;
  if (type.kind !== 'ARRAY') {
    report('not-an-array', `Expected an array or a path before [, got ${types.typeText(type)}.`, span);
    return types.UNKNOWN;
  }
  const { sizes, of } = types.flattened(type);
  const dimensions = sizes.length || indices.length;
  if (indices.length > dimensions) {
    report('indices', `Expected ${dimensions} ${dimensions === 1 ? 'index' : 'indices'}, got ${indices.length}.`, span);
    return types.UNKNOWN;
  }
  for (const [i, index] of indices.entries()) {
    const size = sizes[i];
    if (index.kind === 'integer' && size && (index.value < 1 || index.value > size)) {
      report('index-range', `Expected an index from 1 to ${size}, got ${index.value}.`, index.span);
    }
  }
  return indices.length === dimensions ? of : { kind: 'ARRAY', sizes: sizes.slice(indices.length), of };
}

/** @param {Field} node @param {Context} context @returns {Type} */
function typeOfField(node, context) {
  const { target, name, system, span } = node;
  const type = typeOfExpression(target, context);
  if (system || types.isUnknown(type)) return systemType(node);
  const field = types.fieldOf(type, name);
  if (field) return field;
  context.scope.report(
    'unknown-field',
    `Expected a field of ${types.typeText(type)} behind the point, got "${name}".`,
    span,
  );
  return types.UNKNOWN;
}

/** @param {Unary} node @param {Context} context @returns {Type} */
function typeOfUnary({ operator, operand, span }, context) {
  const type = typeOfExpression(operand, context);
  if (types.isUnknown(type)) return type;
  const isRight =
    operator === 'NOT'
      ? type.kind === 'BOOLEAN' || types.isWhole(type)
      : types.isNumber(type) || type.kind === 'VECTOR';
  if (!isRight)
    context.scope.report(
      'operand',
      `Expected ${operator === 'NOT' ? 'BOOLEAN or INTEGER' : 'a number or VECTOR'} behind ${operator}, got ${types.typeText(type)}.`,
      span,
    );
  return types.isWhole(type) ? types.INTEGER : type;
}

/** @param {Binary} node @param {Context} context @returns {Type} */
function typeOfBinary(node, context) {
  const left = typeOfExpression(node.left, context);
  const right = typeOfExpression(node.right, context);
  const type = binaryType(node.operator, left, right);
  if (type) return type;
  // Pascal's trap: AND binds tighter than a comparison.
  const isTrap = holdsLogic(node.left) || holdsLogic(node.right);
  const hint =
    isTrap || node.operator === 'AND' || node.operator === 'OR'
      ? ' AND and OR bind tighter than comparisons: put those in parentheses.'
      : '';
  context.scope.report(
    'operands',
    `Expected operands that go with ${node.operator}, got ${types.typeText(left)} and ${types.typeText(right)}.${hint}`,
    node.span,
  );
  return types.UNKNOWN;
}

/** @param {Expression} node @returns {boolean} */
const holdsLogic = (node) =>
  node.kind === 'binary' && (/^(AND|OR)$/.test(node.operator) || holdsLogic(node.left) || holdsLogic(node.right));

/** @param {Call} node @param {Context} context @param {boolean} needsValue @returns {Type} */
export function typeOfCall(node, context, needsValue) {
  const args = node.args.map((arg) => (isByName(arg) ? types.UNKNOWN : typeOfExpression(arg, context)));
  return typeOfCallOf(node, args, context, needsValue);
}

/** @param {Expression} node */
const isByName = (node) => node.kind === 'call' && node.name.toUpperCase() === 'BYNAME';
