/**
 * Assignment: a value of its own, fitted to the variable.
 *
 * @import { Designator } from '../tree.js'
 * @import { Type } from '../check/types.js'
 * @import { Compiler } from './compiler.js'
 * @import { Evaluate, Frame, Machine } from './machine.js'
 */
import { isNumber, isPosition, UNKNOWN } from '../check/types.js';
import { emitPlain } from './emit.js';
import { compileReference } from './expressions.js';
import { asPosition, CONFIG_BITS } from './positions.js';
import { clipped, copied, list, number, numbers, record, text, truth } from './values.js';

/** @param {Designator} target @param {Evaluate} value @param {Compiler} compiler @param {Type} [from]  what the value is */
export function compileAssignment(target, value, compiler, from = UNKNOWN) {
  const put = compileSetting(target, value, compiler, from);
  emitPlain(compiler, put);
}

/** @param {Designator} target @param {Evaluate} value @param {Compiler} compiler @param {Type} from @returns {(machine: Machine, frame: Frame) => void} */
function compileSetting(target, value, compiler, from) {
  const type = compiler.typeOf(target);
  if (target.kind === 'field') {
    const owner = compiler.typeOf(target.target);
    const at =
      owner.kind === 'CONFIG' || target.name.toUpperCase() === 'LOCATION'
        ? compileReference(target.target, compiler)
        : null;
    if (at && owner.kind === 'CONFIG') {
      const upper = target.name.toUpperCase();
      const bit = CONFIG_BITS[upper];
      const shift = 8 * (Number(upper.at(-1)) - 1);
      return (m, f) => {
        const { holder, key } = at(m, f);
        const before = number(holder[key] ?? 0);
        if (bit === undefined) holder[key] = (before & ~(255 << shift)) | ((number(value(m, f)) & 255) << shift);
        else holder[key] = truth(value(m, f)) ? before | (1 << bit) : before & ~(1 << bit);
      };
    }
    if (at && owner.kind === 'POSITION') {
      return (m, f) => {
        const { holder, key } = at(m, f);
        holder[key] = [...numbers(value(m, f)), ...list(holder[key] ?? [0, 0, 0, 0, 0, 0, 0, 0, 0, 0]).slice(3)];
      };
    }
  }
  const symbol = target.kind === 'name' ? compiler.symbolOf(target) : undefined;
  if (isNumber(type) && symbol?.kind === 'variable' && !symbol.isParameter && !symbol.from) {
    const { slot, isGlobal } = symbol;
    if (type.kind === 'REAL') {
      if (isGlobal) return (m, f) => void (m.globals[slot] = Math.fround(number(value(m, f))));
      return (m, f) => void (f.locals[slot] = Math.fround(number(value(m, f))));
    }
    if (isGlobal) return (m, f) => void (m.globals[slot] = number(value(m, f)));
    return (m, f) => void (f.locals[slot] = number(value(m, f)));
  }
  const at = compileReference(target, compiler);
  const fit = fitting(type);
  if (type.kind === 'PATH' && type.header && from.kind === 'STRUCTURE')
    return (m, f) => {
      const header = fit(value(m, f), m);
      const { holder, key } = at(m, f);
      record(holder[key]).header = header;
    };
  return (m, f) => {
    const fitted = fit(value(m, f), m);
    const { holder, key, most } = at(m, f);
    if (type.kind === 'ARRAY' && Array.isArray(holder[key]) && Array.isArray(fitted)) {
      for (const i of /** @type {unknown[]} */ (holder[key]).keys())
        /** @type {unknown[]} */ (holder[key])[i] = clipped(fitted[i], most);
    } else holder[key] = clipped(fitted, most);
  };
}

/** @param {Type} type @returns {(value: unknown, machine: Machine) => unknown} */
function fitting(type) {
  if (type.kind === 'STRING') return text;
  if (type.kind === 'REAL') return (value) => Math.fround(number(value));
  if (type.kind === 'INTEGER') return number;
  if (type.kind === 'BOOLEAN') return truth;
  if (type.kind === 'BYTE') return (value) => number(value) & 255;
  if (type.kind === 'SHORT') return (value) => (number(value) << 16) >> 16;
  if (type.kind === 'STRUCTURE' || type.kind === 'PATH') return (value) => copied(record(value));
  if (type.kind === 'UNKNOWN' || type.kind === 'ARRAY') return copied;
  if (isPosition(type)) return (value, m) => copied(asPosition(value ?? number(value), type.kind, m));
  return (value) => copied(value ?? number(value));
}
