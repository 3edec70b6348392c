/**
 * Expressions as closures. A call of a function of the program becomes instructions of its own before the expression, so
 * that the machine can stop in it; its value waits in a slot.
 *
 * @import { Call, Designator, Expression, Name, Unary } from '../tree.js'
 * @import { Compiler } from './compiler.js'
 * @import { Evaluate, Locate } from './machine.js'
 * @import { RoutineSymbol } from '../check/declarations.js'
 * @import { Reference } from './values.js'
 * @import { Type } from '../check/types.js'
 */
import { isPort } from '../ports.js';
import { PREDEFINED, PREDEFINED_FILES } from '../check/constants.js';
import { BUILTINS } from '../check/builtins.js';
import { isDesignator } from '../check/context.js';
import { isPosition, isWhole, UNKNOWN } from '../check/types.js';
import { emitCallOf, isSetByBuiltin, parameterOf, runBuiltin } from './calls.js';
import { compileBinary, placed } from './operators.js';
import { asRecord, elementAt, fieldAt, indexIn, portAt } from './places.js';
import { asPosition, axisOf, CONFIG_BITS } from './positions.js';
import { noValueOf, systemKey } from './systemVariables.js';
import { Alarm, copied, list, number, numbers, text, truth, whole } from './values.js';
import { variableNamed } from './variablesByName.js';

/** @param {Expression} node @param {Compiler} compiler @returns {Evaluate} */
export function compileExpression(node, compiler) {
  switch (node.kind) {
    case 'integer':
    case 'string': {
      const { value } = node;
      return () => value;
    }
    case 'real': {
      const value = Math.fround(node.value);
      return () => value;
    }
    case 'unary':
      return compileUnary(node, compiler);
    case 'binary': {
      const left = compileExpression(node.left, compiler);
      const right = compileExpression(node.right, compiler);
      return compileBinary(node.operator, left, right, compiler.typeOf(node.left), compiler.typeOf(node.right));
    }
    case 'call':
      return compileCall(node, compiler);
    case 'name':
      return compileName(node, compiler);
    default:
      return compileReading(node, compiler);
  }
}

/** @param {Unary} node @param {Compiler} compiler @returns {Evaluate} */
function compileUnary({ operator, operand }, compiler) {
  const value = compileExpression(operand, compiler);
  const type = compiler.typeOf(operand);
  if (operator === '+') return value;
  if (operator === 'NOT')
    return type.kind === 'BOOLEAN' ? (m, f) => !truth(value(m, f)) : (m, f) => ~number(value(m, f));
  if (type.kind === 'VECTOR') return (m, f) => numbers(value(m, f)).map((one) => -one);
  return isWhole(type) ? (m, f) => whole(-number(value(m, f))) : (m, f) => -number(value(m, f));
}

/** @param {Extract<Expression, { kind: 'name' }>} node @param {Compiler} compiler @returns {Evaluate} */
function compileName(node, compiler) {
  const symbol = compiler.symbolOf(node);
  if (symbol?.kind === 'constant') {
    const { value } = symbol;
    return () => value;
  }
  if (symbol?.kind === 'routine')
    return compileCall({ kind: 'call', name: node.name, args: [], span: node.span }, compiler);
  if (symbol?.kind === 'variable') {
    const { slot, isGlobal, isParameter } = symbol;
    if (!isGlobal && !isParameter) return (_, f) => f.locals[slot];
    if (isGlobal && !symbol.from) return (m) => m.globals[slot];
    return compileReading(node, compiler);
  }
  if (compiler.isUsing(node)) return compileReading(node, compiler);
  const predefined = PREDEFINED.get(node.name.toUpperCase());
  if (predefined) return () => predefined.value;
  if (BUILTINS.has(node.name.toUpperCase()))
    return compileCall({ kind: 'call', name: node.name, args: [], span: node.span }, compiler);
  // What stands for the files that are always open: they have no trouble to tell of.
  if (PREDEFINED_FILES.has(node.name.toUpperCase())) return () => ({});
  const { name } = node;
  return () => {
    throw new Alarm(`"${name}" is not known`, 'unknown-name');
  };
}

/** @param {Designator} node @param {Compiler} compiler @returns {Evaluate} */
function compileReading(node, compiler) {
  const axis =
    node.kind === 'field' && isPosition(compiler.typeOf(node.target))
      ? ['NORMAL', 'ORIENT', 'APPROACH', 'LOCATION'].indexOf(node.name.toUpperCase())
      : -1;
  if (node.kind === 'field' && axis >= 0) {
    const position = compileExpression(node.target, compiler);
    return (m, f) => (axis === 3 ? numbers(position(m, f)).slice(0, 3) : axisOf(numbers(position(m, f)), axis));
  }
  if (node.kind === 'field' && compiler.typeOf(node.target).kind === 'CONFIG') {
    const config = compileExpression(node.target, compiler);
    const upper = node.name.toUpperCase();
    const bit = CONFIG_BITS[upper];
    if (bit !== undefined) return (m, f) => ((number(config(m, f)) >> bit) & 1) === 1;
    const shift = 32 - 8 * Number(upper.at(-1));
    return (m, f) => (number(config(m, f)) << shift) >> 24;
  }
  if (isPort(node)) {
    const at = compileReference(node, compiler);
    const isNumber = compiler.typeOf(node).kind === 'INTEGER';
    return (m, f) => {
      const { holder, key } = at(m, f);
      return holder[key] ?? (isNumber ? 0 : false);
    };
  }
  if (node.kind === 'index' && compiler.typeOf(node.target).kind === 'ARRAY' && node.indices.length === 1) {
    const array = compileExpression(/** @type {Expression} */ (node.target), compiler);
    const index = compileExpression(node.indices[0], compiler);
    return (m, f) => {
      const values = list(array(m, f));
      return values[indexIn(number(index(m, f)), values.length)];
    };
  }
  const at = compileReference(node, compiler);
  return (m, f) => {
    const { holder, key } = at(m, f);
    const value = holder[key];
    if (value === undefined && holder === m.state.system) throw new Alarm(noValueOf(String(key)), 'uninitialised');
    return value;
  };
}

/** Where a variable is. @param {Designator | Call} node @param {Compiler} compiler @returns {Locate} */
export function compileReference(node, compiler) {
  const at = placeOf(node, compiler);
  const most = longestOf(compiler.typeOf(node));
  if (most === undefined) return at;
  return (m, f) => {
    const { holder, key } = at(m, f);
    return { holder, key, most };
  };
}

/** Characters of a string, or of those of an array. @param {Type} type @returns {number | undefined} */
const longestOf = ({ kind, length, of }) => (kind === 'ARRAY' && of ? longestOf(of) : length);

/** @param {Designator | Call} node @param {Compiler} compiler @returns {Locate} */
function placeOf(node, compiler) {
  switch (node.kind) {
    case 'call': {
      const value = compileExpression(node, compiler);
      return (m, f) => ({ holder: { value: value(m, f) }, key: 'value' });
    }
    case 'system': {
      const key = systemKey(node.name.toUpperCase());
      return (m) => ({ holder: m.state.system, key });
    }
    case 'name': {
      const symbol = compiler.symbolOf(node);
      const using = compiler.isUsing(node);
      if (using) return compileReference({ kind: 'field', target: using, name: node.name }, compiler);
      if (symbol?.kind !== 'variable') {
        const value = compileExpression(node, compiler);
        return (m, f) => ({ holder: { value: value(m, f) }, key: 'value' });
      }
      const { slot, isGlobal, isParameter } = symbol;
      if (isParameter) return (_, f) => /** @type {Reference} */ (f.locals[slot]);
      if (!isGlobal) return (_, f) => ({ holder: asRecord(f.locals), key: slot });
      const program = compiler.programOf(symbol);
      return (m) => ({ holder: asRecord(m.state.globals[program.index]), key: program.slot });
    }
    case 'index':
      return compileElement(node, compiler);
    case 'field':
      return fieldAt(compileReference(node.target, compiler), compiler.typeOf(node.target), node.name);
  }
}

/** @param {Extract<Designator, { kind: 'index' }>} node @param {Compiler} compiler @returns {Locate} */
function compileElement(node, compiler) {
  const { target, indices } = node;
  const places = indices.map((index) => compileExpression(index, compiler));
  if (isPort(node) && target.kind === 'name') return portAt(target.name.toUpperCase(), places[0]);
  const { kind } = target.kind === 'call' ? UNKNOWN : compiler.typeOf(target);
  return elementAt(compileReference(target, compiler), places, kind);
}

/** @param {Call} node @param {Compiler} compiler @returns {Evaluate} */
export function compileCall(node, compiler) {
  const symbol = compiler.routineNamed(node.name);
  if (symbol) {
    const slot = compiler.temporary();
    emitCall(node, symbol, slot, compiler);
    return (_, f) => f.locals[slot];
  }
  return callBuiltin(node, compiler);
}

/** @param {Call} node @param {Compiler} compiler @returns {Evaluate} */
function callBuiltin(node, compiler) {
  const isKept = /^SET_E?POS_REG$/i.test(node.name);
  const args = node.args.map((arg, i) => {
    const type = compiler.typeOf(arg);
    const named = compileByName(arg, compiler);
    if (named) return isSetByBuiltin(node.name, i) ? named : held(named);
    if (!isSetByBuiltin(node.name, i) || !isDesignator(arg)) {
      const value = compileExpression(arg, compiler);
      return isKept || parameterOf(node.name, i)?.type !== 'P' ? value : placed(value, type);
    }
    const at = compileReference(arg, compiler);
    return parameterOf(node.name, i)?.type === 'X' ? typed(at, type) : at;
  });
  return runBuiltin(node.name, args);
}

/** @param {Locate} at @returns {Evaluate} */
const held = (at) => (m, f) => {
  const { holder, key } = at(m, f);
  return holder[key];
};

/** @param {Locate} at @param {Type} type @returns {Locate} */
const typed = (at, type) => (m, f) => ({ ...at(m, f), type });

/** `BYNAME(program, variable, entry)`: a variable by its name, as an argument. @param {Expression} node @param {Compiler} compiler @returns {Locate | null} */
function compileByName(node, compiler) {
  if (node.kind !== 'call' || node.name.toUpperCase() !== 'BYNAME') return null;
  const [program, name] = node.args.map((arg) => compileExpression(arg, compiler));
  return (m, f) => {
    const [owner, wanted] = [program, name].map((one) => text(one(m, f)).toUpperCase());
    const found = variableNamed(m, owner, wanted);
    if (!found) throw new Alarm(`there is no variable "${wanted}" in "${owner}"`, 'unknown-name');
    return found.at;
  };
}

/** @param {Call} node @param {RoutineSymbol} symbol @param {number} result  the slot of the value @param {Compiler} compiler */
export function emitCall(node, symbol, result, compiler) {
  emitCallOf(
    symbol,
    node.args.map((arg, i) => compileArgument(node, i, symbol, compiler)),
    result,
    compiler,
  );
}

/** A variable of the parameter's type goes by reference, everything else, and what stands in parentheses, by value. @param {Call} call @param {number} i @param {RoutineSymbol} symbol @param {Compiler} compiler @returns {Locate} */
function compileArgument({ args, byValue = [] }, i, symbol, compiler) {
  const arg = args[i];
  const named = compileByName(arg, compiler);
  if (named) return named;
  const wanted = symbol.parameters[i]?.type;
  const given = compiler.typeOf(arg);
  const isVariable =
    isDesignator(arg) &&
    !byValue.includes(i) &&
    !(
      arg.kind === 'name' &&
      compiler.symbolOf(/** @type {Name} */ (arg))?.kind !== 'variable' &&
      !compiler.isUsing(arg)
    );
  if (isVariable && wanted?.kind === given.kind) return compileReference(arg, compiler);
  const value = compileExpression(arg, compiler);
  const fit = wanted && isPosition(wanted) ? wanted.kind : null;
  return (m, f) => {
    const own = copied(value(m, f));
    return { holder: { value: fit ? asPosition(own, fit, m) : own }, key: 'value' };
  };
}
