/**
 * The type of every expression, and what is against it. What was found out is kept by node, for the interpreter.
 *
 * @import { Binary, Call, Designator, Expression, Field, Index, Name, Span, Unary } from '../tree.js'
 * @import { Builtin } from './builtins.js'
 * @import { Scope, Symbol, RoutineSymbol } from './declarations.js'
 * @import { Type } from './types.js'
 *
 * @typedef {object} Context
 * @property {Scope} scope
 * @property {Map<string, Symbol>} locals
 * @property {Type[]} using                       structures whose fields are named alone
 * @property {Designator[]} usingNodes
 * @property {RoutineSymbol | null} routine
 * @property {Map<object, Type>} typeOf
 * @property {Map<object, Symbol>} symbolOf
 * @property {Map<object, Designator>} usingOf    the structure that a name alone is a field of
 */
import { BOOLEAN_PORTS, INTEGER_PORTS } from '../ports.js';
import { BUILTINS, isKnownRoutine, signatureText, WORDS } from './builtins.js';
import { PREDEFINED, PREDEFINED_FILES } from './constants.js';
import { binaryType } from './operators.js';
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
      return types.UNKNOWN;
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

/** @param {string} name @param {Span | undefined} span @param {Context} context @param {string} what */
function unknownName(name, span, { scope }, what) {
  const message = `Expected ${what}, got "${name}", which is not declared.`;
  if (scope.hasGaps) scope.report('unknown-name', `${message} A file that is missing may do so.`, span, 'warning');
  else scope.report('unknown-name', message, span);
}

/** @param {Index} node @param {Context} context @returns {Type} */
function typeOfIndex({ target, indices, span }, context) {
  const { report } = context.scope;
  const indexTypes = indices.map((index) => typeOfExpression(index, context));
  const upper = target.kind === 'name' ? target.name.toUpperCase() : '';
  const isDeclared = context.locals.has(upper) || context.scope.globals.has(upper);
  if (!isDeclared && BOOLEAN_PORTS.has(upper)) return types.BOOLEAN;
  if (!isDeclared && INTEGER_PORTS.has(upper)) return types.INTEGER;
  const type = typeOfExpression(target, context);
  for (const [i, index] of indexTypes.entries()) {
    if (!types.isWhole(index) && !types.isUnknown(index))
      report('index-type', `Expected a whole number as index, got ${types.typeText(index)}.`, indices[i].span);
  }
  if (types.isUnknown(type)) return types.UNKNOWN;
  if (type.kind === 'PATH') return type.node ?? types.UNKNOWN;
  if (type.kind !== 'ARRAY') {
    report('not-an-array', `Expected an array or a path before [, got ${types.typeText(type)}.`, span);
    return types.UNKNOWN;
  }
  const { sizes = [], of = types.UNKNOWN } = type;
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
function typeOfField({ target, name, system, span }, context) {
  const type = typeOfExpression(target, context);
  if (system || types.isUnknown(type)) return types.UNKNOWN;
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
  const upper = node.name.toUpperCase();
  const symbol = context.locals.get(upper) ?? context.scope.globals.get(upper);
  const args = node.args.map((arg) => (isByName(arg) ? types.UNKNOWN : typeOfExpression(arg, context)));
  /** @param {Type} type */
  const given = (type) => {
    if (needsValue && type.kind === 'NOTHING') {
      if (symbol?.kind === 'routine' && isIncomplete(symbol, context.scope)) return types.UNKNOWN;
      context.scope.report(
        'no-value',
        `Expected a function, got the routine "${node.name}", which gives no value.`,
        node.span,
      );
      return types.UNKNOWN;
    }
    return type;
  };
  if (symbol?.kind === 'routine') {
    context.symbolOf.set(node, symbol);
    checkArguments(node, args, symbol, context);
    return given(symbol.returns);
  }
  if (symbol) {
    if (symbol.kind === 'variable') symbol.isUsed = true;
    if (!types.isUnknown(symbol.type))
      context.scope.report('not-a-routine', `Expected a routine, got the ${symbol.kind} "${node.name}".`, node.span);
    return types.UNKNOWN;
  }
  const builtin = BUILTINS.get(upper);
  if (builtin) return given(typeOfBuiltin(node, args, builtin, context));
  for (const arg of node.args) markSet(arg, context);
  if (!isKnownRoutine(upper)) unknownName(node.name, node.span, context, 'a routine');
  return types.UNKNOWN;
}

/** @param {Expression} node */
const isByName = (node) => node.kind === 'call' && node.name.toUpperCase() === 'BYNAME';

/** Its head may stand in a file that is missing. @param {RoutineSymbol} routine @param {Scope} scope */
export const isIncomplete = ({ parameters, returns, node }, { hasGaps }) =>
  hasGaps && node !== undefined && parameters.length === 0 && returns.kind === 'NOTHING';

/** @param {Call} node @param {Type[]} args @param {RoutineSymbol} routine @param {Context} context */
function checkArguments(node, args, routine, context) {
  const { name, parameters } = routine;
  if (args.length !== parameters.length && !isIncomplete(routine, context.scope)) {
    context.scope.report(
      'arguments',
      `Expected ${countText(parameters.length)} for "${name}", got ${args.length || 'none'}.`,
      node.span,
    );
  }
  for (const [i, arg] of node.args.entries()) {
    markSet(arg, context);
    const parameter = parameters[i];
    if (parameter && !types.fits(args[i], parameter.type)) {
      context.scope.report(
        'argument-type',
        `Expected ${types.typeText(parameter.type)} for "${parameter.name}" of "${name}", got ${types.typeText(args[i])}.`,
        arg.span,
      );
    }
  }
}

const countText = (/** @type {number} */ count) =>
  count === 0 ? 'no arguments' : count === 1 ? '1 argument' : `${count} arguments`;

/** @param {Call} node @param {Type[]} args @param {Builtin} builtin @param {Context} context @returns {Type} */
function typeOfBuiltin(node, args, builtin, context) {
  const { parameters, gives } = builtin;
  const least = parameters.filter(({ isOptional }) => !isOptional).length;
  if (args.length < least || args.length > parameters.length) {
    context.scope.report('arguments', `Expected ${signatureText(builtin)}, got ${countText(args.length)}.`, node.span);
  }
  for (const [i, arg] of node.args.entries()) {
    const parameter = parameters[i];
    if (!parameter) continue;
    if (parameter.isSet) {
      markSet(arg, context);
      if (!isDesignator(arg))
        context.scope.report(
          'argument',
          `Expected a variable for "${parameter.name}" of ${builtin.name}, which is set, got a value.`,
          arg.span,
          'warning',
        );
    } else if (builtin.name === 'UNINIT' || parameter.type === 'H' || parameter.type === 'F') markSet(arg, context);
    if (!isOfType(args[i], parameter.type)) {
      context.scope.report(
        'argument-type',
        `Expected ${WORDS[parameter.type]} for "${parameter.name}" of ${builtin.name}, got ${types.typeText(args[i])}.`,
        arg.span,
      );
    }
  }
  if (gives === '=') return types.isWhole(args[0] ?? types.UNKNOWN) ? types.INTEGER : (args[0] ?? types.UNKNOWN);
  return gives === null ? types.NOTHING : (GIVEN[gives] ?? types.UNKNOWN);
}

/** @type {Readonly<Record<string, Type>>} */
const GIVEN = {
  ...{ I: types.INTEGER, R: types.REAL, S: types.STRING, B: types.BOOLEAN, V: types.VECTOR, C: types.CONFIG },
  ...{ XYZWPR: types.XYZWPR, XYZWPREXT: types.XYZWPREXT, POSITION: types.POSITION, JOINTPOS: types.JOINTPOS },
};

/** @param {Type} type @param {string} letter */
function isOfType(type, letter) {
  if (types.isUnknown(type) || letter === 'X') return true;
  if (letter === 'P') return types.isPosition(type);
  if (letter === 'N' || letter === 'R') return types.isNumber(type);
  if (letter === 'I') return types.isWhole(type);
  return WORDS[letter] === type.kind;
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
