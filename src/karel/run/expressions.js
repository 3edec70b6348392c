/**
 * Expressions as closures. A call of a function of the program becomes instructions of its own before the expression, so
 * that the machine can stop in it; its value waits in a slot.
 *
 * @import { Call, Designator, Expression, Name, Unary } from '../tree.js'
 * @import { Compiler } from './compiler.js'
 * @import { Evaluate, Locate } from './machine.js'
 * @import { RoutineSymbol } from '../check/declarations.js'
 * @import { Reference, Value } from './values.js'
 */
import { isPort } from '../ports.js';
import { PREDEFINED } from '../check/constants.js';
import { BUILTINS } from '../check/builtins.js';
import { isPosition, isWhole } from '../check/types.js';
import { isDesignator } from '../check/expressions.js';
import { RUN } from './builtins.js';
import { HALT, pushFrame, SWITCH } from './machine.js';
import { compileBinary } from './operators.js';
import { axisOf, CONFIG_BITS } from './positions.js';
import { Alarm, copied, list, number, numbers, record, truth, whole } from './values.js';

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
    return holder[key];
  };
}

/** @param {number} index from 1 @param {number} length */
function indexIn(index, length) {
  if (index >= 1 && index <= length) return index - 1;
  throw new Alarm(`the index ${index} is not from 1 to ${length}`, 'index');
}

const XYZ = ['X', 'Y', 'Z', 'W', 'P', 'R', 'CONFIG_DATA', 'EXT1', 'EXT2', 'EXT3'];

/** Where a variable is. @param {Designator | Call} node @param {Compiler} compiler @returns {Locate} */
export function compileReference(node, compiler) {
  switch (node.kind) {
    case 'call': {
      const value = compileExpression(node, compiler);
      return (m, f) => ({ holder: { value: value(m, f) }, key: 'value' });
    }
    case 'system': {
      const { name } = node;
      return (m) => ({ holder: m.state.system, key: name.toUpperCase() });
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
      return compileField(node, compiler);
  }
}

const asRecord = (/** @type {Value[]} */ values) =>
  /** @type {Record<number, Value>} */ (/** @type {unknown} */ (values));

/** @param {Extract<Designator, { kind: 'index' }>} node @param {Compiler} compiler @returns {Locate} */
function compileElement(node, compiler) {
  const { target, indices } = node;
  const places = indices.map((index) => compileExpression(index, compiler));
  if (isPort(node) && target.kind === 'name') {
    const port = target.name.toUpperCase();
    return (m, f) => ({ holder: (m.state.ports[port] ??= {}), key: number(places[0](m, f)) });
  }
  const isPath = target.kind !== 'call' && compiler.typeOf(target).kind === 'PATH';
  const isSystem = compiler.typeOf(target).kind === 'UNKNOWN';
  const at = compileReference(target, compiler);
  return (m, f) => {
    let { holder, key } = at(m, f);
    for (const place of places) {
      const index = number(place(m, f));
      if (isSystem) {
        key = `${key}[${index}]`;
        continue;
      }
      const values = list(isPath ? record(holder[key]).nodes : holder[key]);
      holder = asRecord(values);
      key = indexIn(index, values.length);
    }
    return { holder, key };
  };
}

/** @param {Extract<Designator, { kind: 'field' }>} node @param {Compiler} compiler @returns {Locate} */
function compileField({ target, name }, compiler) {
  const type = compiler.typeOf(target);
  const upper = name.toUpperCase();
  const at = compileReference(target, compiler);
  if (type.kind === 'UNKNOWN') {
    return (m, f) => {
      const { holder, key } = at(m, f);
      return { holder, key: `${key}.${upper}` };
    };
  }
  if (type.kind === 'VECTOR' || isPosition(type)) {
    const slot = XYZ.indexOf(upper);
    const size = type.kind === 'VECTOR' ? 3 : 10;
    return (m, f) => {
      const { holder, key } = at(m, f);
      holder[key] ??= Array.from({ length: size }, (_, i) => (i >= 6 ? 0 : undefined));
      return { holder: asRecord(list(holder[key])), key: slot };
    };
  }
  if (type.kind === 'PATH')
    return (m, f) => ({ holder: record(record(at(m, f).holder[at(m, f).key]).header), key: upper });
  return (m, f) => {
    const { holder, key } = at(m, f);
    return { holder: record(holder[key]), key: upper };
  };
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
  const upper = node.name.toUpperCase();
  const known = BUILTINS.get(upper);
  const run = Object.hasOwn(RUN, upper) ? RUN[upper] : null;
  const args = node.args.map((arg, i) => {
    const parameter = known?.parameters[i];
    const isSet = parameter?.isSet || upper === 'UNINIT' || parameter?.type === 'H' || parameter?.type === 'F';
    return isSet && isDesignator(arg) ? compileReference(arg, compiler) : compileExpression(arg, compiler);
  });
  if (!run) {
    return () => {
      throw new Alarm(`"${node.name}" is not built in here`, 'unknown-routine');
    };
  }
  const values = /** @type {(Evaluate | Locate)[]} */ (args);
  return (m, f) =>
    run(
      values.map((value) => value(m, f)),
      m,
    );
}

/** @param {Call} node @param {RoutineSymbol} symbol @param {number} result  the slot of the value @param {Compiler} compiler */
export function emitCall(node, symbol, result, compiler) {
  const { analysis, linker } = compiler;
  const args = node.args.map((arg, i) => compileArgument(arg, symbol, i, compiler));
  const program = symbol.from ?? analysis.scope.program;
  if (symbol.from) linker.programNamed(symbol.from);
  const key = `${program.toUpperCase()}.${symbol.name.toUpperCase()}`;
  const { entries } = linker.image;
  const line = compiler.line;
  const next = compiler.here() + 1;
  compiler.emit((machine, frame) => {
    const target = entries[key];
    const values = args.map((arg) => arg(machine, frame));
    frame.pc = next;
    if (target === undefined) {
      // A TP program, or one that nobody has here.
      machine.effect = {
        kind: 'call',
        program: (symbol.from ?? symbol.name).toUpperCase(),
        args: values.map(({ holder, key: at }) => copied(holder[at])),
        line,
      };
      return HALT;
    }
    pushFrame(machine, machine.state.tasks[machine.state.current], target, values, result);
    return SWITCH;
  });
}

/** A variable of the parameter's type goes by reference, everything else by value. @param {Expression} arg @param {RoutineSymbol} symbol @param {number} i @param {Compiler} compiler @returns {Locate} */
function compileArgument(arg, symbol, i, compiler) {
  const wanted = symbol.parameters[i]?.type;
  const given = compiler.typeOf(arg);
  const isVariable =
    isDesignator(arg) &&
    !(
      arg.kind === 'name' &&
      compiler.symbolOf(/** @type {Name} */ (arg))?.kind !== 'variable' &&
      !compiler.isUsing(arg)
    );
  if (isVariable && wanted?.kind === given.kind) return compileReference(arg, compiler);
  const value = compileExpression(arg, compiler);
  return (m, f) => ({
    holder: { value: copied(value(m, f)) },
    key: 'value',
  });
}
