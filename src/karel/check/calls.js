/**
 * What a call gives, and what is against its arguments, whose types are known already.
 *
 * @import { Call } from '../tree.js'
 * @import { Builtin } from './builtins.js'
 * @import { Context } from './context.js'
 * @import { RoutineSymbol, Scope } from './declarations.js'
 * @import { Type } from './types.js'
 */
import { BUILTINS, isKnownRoutine, signatureText, WORDS } from './builtins.js';
import { isDesignator, markSet, unknownName } from './context.js';
import * as types from './types.js';

/**
 * @param {Call} node
 * @param {Type[]} args  their types
 * @param {Context} context
 * @param {boolean} needsValue
 * @returns {Type}
 */
export function typeOfCallOf(node, args, context, needsValue) {
  const upper = node.name.toUpperCase();
  const symbol = context.locals.get(upper) ?? context.scope.globals.get(upper);
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
    if (context.isCondition)
      context.scope.report(
        'condition-call',
        `Expected ports, variables and constants in a condition, got a call of "${node.name}".`,
        node.span,
      );
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
    if (!node.byValue?.includes(i)) markSet(arg, context);
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
    } else if (builtin.name === 'UNINIT' || parameter.isKept || parameter.type === 'H' || parameter.type === 'F')
      markSet(arg, context);
    if (!isOfType(args[i], parameter.type, parameter.isSet)) {
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

/** @param {Type} type @param {string} letter @param {boolean} isSet  a whole number is good for a REAL, but does not hold one */
function isOfType(type, letter, isSet) {
  if (types.isUnknown(type) || letter === 'X') return true;
  if (letter === 'P') return types.isPosition(type);
  if (letter === 'L') return type.kind === 'ARRAY' && types.flattened(type).of.kind === 'REAL';
  if (letter === 'K') return types.isPosition(type) && type.kind !== 'JOINTPOS';
  if (letter === 'R' && isSet) return type.kind === 'REAL';
  if (letter === 'N' || letter === 'R') return types.isNumber(type);
  if (letter === 'I') return types.isWhole(type);
  return WORDS[letter] === type.kind;
}
