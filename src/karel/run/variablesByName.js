/**
 * GET_VAR and SET_VAR: a variable of any program by its name as text, `count` or `part.size[2]`, and system variables.
 *
 * @import { Type } from '../check/types.js'
 * @import { Builtin, Frame, Locate, Machine } from './machine.js'
 * @import { Reference } from './values.js'
 */
import { fieldOf, fits, isPosition, UNKNOWN } from '../check/types.js';
import { put } from './builtinsMath.js';
import { asRecord, elementAt, fieldAt } from './places.js';
import { asPosition } from './positions.js';
import { linkedProgram } from './programs.js';
import { keyOfText } from './systemVariables.js';
import { Alarm, copied, single, text } from './values.js';

/** Status: no such variable; one that was never set; a value of another type. */
const NO_VARIABLE = 12006;
const UNSET = 12311;
const OTHER_TYPE = 12009;

const SYSTEM = '*SYSTEM*';
/** Counts in milliseconds, by 2. */
const FAST_CLOCK = '$FAST_CLOCK';

const NO_FRAME = /** @type {Frame} */ ({ code: 0, pc: 0, locals: [], result: -1 });

/** @param {Machine} machine @param {string} program @param {string} name both in capitals @returns {{ at: Reference, type: Type } | null} */
export function variableNamed(machine, program, name) {
  if (program === SYSTEM) return { at: { holder: machine.state.system, key: keyOfText(name) }, type: UNKNOWN };
  const index = linkedProgram(machine, program);
  const [first, ...steps] = /^\w+(\.\w+|\[\s*\d+(\s*,\s*\d+)*\s*\])*$/.test(name)
    ? (name.match(/\.?\w+|\[[^\]]*\]/g) ?? [])
    : [];
  const symbol = index < 0 ? undefined : machine.linker.analyses[index].scope.globals.get(first ?? '');
  if (symbol?.kind !== 'variable' || symbol.from) return null;
  let { type } = symbol;
  /** @type {Locate} */
  let at = ({ state }) => ({ holder: asRecord(state.globals[index]), key: symbol.slot });
  for (const step of steps) {
    const inner = step.startsWith('.') ? fieldOf(type, step.slice(1)) : (type.of ?? type.node);
    if (!inner) return null;
    at = step.startsWith('.') ? fieldAt(at, type, step.slice(1)) : elementAt(at, indicesOf(step), type.kind);
    type = inner;
  }
  try {
    return { at: { ...at(machine, NO_FRAME), most: type.length }, type };
  } catch (error) {
    if (error instanceof Alarm) return null;
    throw error;
  }
}

const indicesOf = (/** @type {string} */ step) =>
  step
    .slice(1, -1)
    .split(',')
    .map((one) => () => Number(one));

/** @type {Readonly<Record<string, Builtin>>} */
export const VARIABLES_BY_NAME = {
  GET_VAR: ([, program, name, value, status], machine) => {
    const wanted = text(name).toUpperCase();
    const owner = text(program).toUpperCase();
    if (owner === SYSTEM && wanted === FAST_CLOCK) {
      put(value, 2 * Math.trunc(machine.state.time / 2));
      return put(status, 0);
    }
    const found = variableNamed(machine, owner, wanted);
    if (!found) return put(status, NO_VARIABLE);
    const held = found.at.holder[found.at.key];
    if (held === undefined) return put(status, owner === SYSTEM ? NO_VARIABLE : UNSET);
    const { type = UNKNOWN } = /** @type {{ type?: Type }} */ (value);
    if (!fits(found.type, type) || !isOf(type, held)) return put(status, OTHER_TYPE);
    put(value, isPosition(type) ? asPosition(copied(held), type.kind, machine) : copied(held));
    return put(status, 0);
  },
  SET_VAR: ([, program, name, value, status], machine) => {
    const found = variableNamed(machine, text(program).toUpperCase(), text(name).toUpperCase());
    if (!found) return put(status, NO_VARIABLE);
    if (!isOf(found.type, value)) return put(status, OTHER_TYPE);
    const { holder, key } = found.at;
    holder[key] =
      found.type.kind === 'REAL'
        ? single(Number(value))
        : found.type.kind === 'STRING'
          ? text(value).slice(0, found.type.length)
          : copied(value);
    return put(status, 0);
  },
};

/** Whether a value can be one of this type. @param {Type} type @param {unknown} value */
function isOf({ kind }, value) {
  if (kind === 'UNKNOWN' || kind === 'OPAQUE') return true;
  if (/^(INTEGER|SHORT|BYTE)$/.test(kind) && !Number.isInteger(value)) return false;
  const isList = !/^(STRUCTURE|PATH|FILE)$/.test(kind);
  if (!JS_TYPES[kind]) return typeof value === 'object' && Array.isArray(value) === isList;
  return typeof value === JS_TYPES[kind];
}

/** What values of the simple types are. @type {Readonly<Record<string, string>>} */
const JS_TYPES = {
  INTEGER: 'number',
  SHORT: 'number',
  BYTE: 'number',
  REAL: 'number',
  STRING: 'string',
  BOOLEAN: 'boolean',
  CONFIG: 'number',
};
