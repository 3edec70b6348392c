/**
 * Values while a program runs. Numbers, strings and booleans are themselves; a variable that was never set is undefined; an
 * array is an array of arrays, a structure an object by field names in capitals, a path `{ header, nodes }`, a VECTOR three
 * numbers, a Cartesian position ten (x y z w p r, the CONFIG word, three more axes), a JOINTPOS its axes. All of it is plain
 * data, so that a state can be copied.
 *
 * @import { Type } from '../check/types.js'
 * @typedef {unknown} Value
 * @typedef {{ code: string, reason: string, line: number, routine: string, file?: string }} AlarmText  file: one that %INCLUDE has brought
 * @typedef {{ holder: Record<string | number, Value>, key: string | number, most?: number }} Reference  most: characters of a string
 */
import { countOf } from '../check/types.js';
import { MAX_STRING_LENGTH } from '../words.js';

/** What stops a program: a reason, told with its line. */
export class Alarm extends Error {
  /** @param {string} reason @param {string} [code] */
  constructor(reason, code = 'run-time') {
    super(reason);
    this.code = code;
  }
}

const UNSET = 'an uninitialised variable is read';

/** @param {Value} value @returns {number} */
export function number(value) {
  if (typeof value === 'number') return value;
  throw new Alarm(value === undefined ? UNSET : 'a number was expected', 'uninitialised');
}

/** @param {Value} value @returns {boolean} */
export function truth(value) {
  if (typeof value === 'boolean') return value;
  throw new Alarm(value === undefined ? UNSET : 'TRUE or FALSE was expected', 'uninitialised');
}

/** @param {Value} value @returns {string} */
export function text(value) {
  if (typeof value === 'string') return value;
  throw new Alarm(value === undefined ? UNSET : 'a string was expected', 'uninitialised');
}

/** So much of a string as has room. @param {Value} value @param {number} [most] @returns {Value} */
export const clipped = (value, most = MAX_STRING_LENGTH) =>
  typeof value === 'string' && value.length > most ? value.slice(0, most) : value;

/** @param {Value} value @returns {Value[]} */
export function list(value) {
  if (Array.isArray(value)) return value;
  throw new Alarm(UNSET, 'uninitialised');
}

/** @param {Value} value @returns {number[]} */
export function numbers(value) {
  const values = list(value);
  for (const one of values) if (one === undefined) throw new Alarm(UNSET, 'uninitialised');
  return /** @type {number[]} */ (values);
}

/** @param {Value} value @returns {Record<string, Value>} */
export function record(value) {
  if (typeof value === 'object' && value !== null) return /** @type {Record<string, Value>} */ (value);
  throw new Alarm(UNSET, 'uninitialised');
}

/** A value of its own. @param {Value} value @returns {Value} */
export function copied(value) {
  if (Array.isArray(value)) return value.map(copied);
  if (typeof value !== 'object' || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, copied(inner)]));
}

/** More than a controller has room for. */
const MOST_NODES = 20_000;
const MOST_VALUES = 1_000_000;

/** What a variable holds before anything is put into it. @param {Type} type @returns {Value} */
export function unsetValue(type) {
  if (type.kind === 'ARRAY') return unsetArray(type.sizes ?? [], type.of);
  if (type.kind === 'STRUCTURE')
    return Object.fromEntries([...(type.fields ?? [])].map(([name, field]) => [name, unsetValue(field)]));
  if (type.kind === 'PATH')
    return {
      header: type.header ? unsetValue(type.header) : {},
      nodes: [],
      blank: type.node ? unsetValue(type.node) : undefined,
      most: Math.min(MOST_NODES, Math.floor(MOST_VALUES / countOf(type.node ?? type))),
    };
  if (type.kind === 'FILE') return {};
  return undefined;
}

/** @param {readonly number[]} sizes @param {Type | undefined} of @returns {Value} */
function unsetArray([size, ...further], of) {
  return Array.from({ length: size ?? 0 }, () => (further.length ? unsetArray(further, of) : of && unsetValue(of)));
}

/** INTEGER has 32 bits. @param {number} value */
export function whole(value) {
  if (value >= -2147483648 && value <= 2147483647) return value;
  throw new Alarm('the result does not fit into an INTEGER', 'overflow');
}

/** REAL has 32 bits. @param {number} value */
export function single(value) {
  const rounded = Math.fround(value);
  if (Number.isFinite(rounded)) return rounded;
  throw new Alarm('the result does not fit into a REAL', 'overflow');
}

/** A whole state, with what is shared in it shared again. @template T @param {T} state @returns {T} */
export function copiedState(state) {
  /** @type {Map<object, object>} */
  const known = new Map();
  const copy = (/** @type {unknown} */ value) => {
    if (typeof value !== 'object' || value === null) return value;
    const before = known.get(value);
    if (before) return before;
    /** @type {Record<string | number, unknown>} */
    const made = Array.isArray(value)
      ? /** @type {Record<number, unknown>} */ (/** @type {unknown} */ (new Array(value.length)))
      : {};
    known.set(value, made);
    for (const key of Object.keys(value)) made[key] = copy(/** @type {Record<string, unknown>} */ (value)[key]);
    return made;
  };
  return /** @type {T} */ (copy(state));
}
