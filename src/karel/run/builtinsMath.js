/**
 * Built-ins that only reckon: numbers, strings, positions, arrays, paths.
 *
 * @import { Builtin } from './machine.js'
 * @import { Reference, Value } from './values.js'
 */
import { convertedReal, convertedWhole } from './format.js';
import { packedTime, timeText } from './packedTime.js';
import { axisOf, configOf, configText, degrees, frameOf, inverted, mirrored, radians } from './positions.js';
import { Alarm, clipped, copied, list, number, numbers, record, single, text, truth, whole } from './values.js';

/** @param {(x: number) => number} f @returns {Builtin} */
const real =
  (f) =>
  ([x]) =>
    single(f(number(x)));

/** @param {(x: number) => number} f @param {(x: number) => boolean} isFit @returns {Builtin} */
const within =
  (f, isFit) =>
  ([x]) => {
    if (!isFit(number(x))) throw new Alarm(`the argument ${number(x)} is out of range`, 'range');
    return single(f(number(x)));
  };

export const put = (/** @type {unknown} */ reference, /** @type {Value} */ value) => {
  const { holder, key, most } = /** @type {Reference} */ (reference);
  if (holder) holder[key] = clipped(value, most);
};
export const held = (/** @type {unknown} */ reference) => {
  const { holder, key } = /** @type {Reference} */ (reference);
  return holder ? holder[key] : reference; // a value where a variable was expected
};

const isUnit = (/** @type {number} */ x) => Math.abs(x) <= 1;
/** Away from zero at a half: ROUND(2.5) is 3. @param {number} x */
const rounded = (x) => Math.sign(x) * Math.floor(Math.abs(x) + 0.5) + 0;

/** @type {Readonly<Record<string, Builtin>>} */
export const MATHEMATICS = {
  ABS: ([x]) => Math.abs(number(x)),
  ROUND: ([x]) => whole(rounded(number(x))),
  TRUNC: ([x]) => whole(Math.trunc(number(x)) + 0),
  SQRT: within(Math.sqrt, (x) => x >= 0),
  EXP: real(Math.exp),
  LN: within(Math.log, (x) => x > 0),
  SIN: real((x) => Math.sin(radians(x))),
  COS: real((x) => Math.cos(radians(x))),
  TAN: real((x) => Math.tan(radians(x))),
  ASIN: within((x) => degrees(Math.asin(x)), isUnit),
  ACOS: within((x) => degrees(Math.acos(x)), isUnit),
  ATAN2: ([x, y]) => single(degrees(Math.atan2(number(y), number(x)))),

  POS: (args) => {
    const values = args.slice(0, 7).map(number);
    return [...values.slice(0, 6).map(single), values[6] ?? 0, 0, 0, 0];
  },
  UNPOS: ([position, ...targets]) => void targets.forEach((target, i) => put(target, numbers(position)[i])),
  INV: ([position]) => inverted(numbers(position)),
  MIRROR: ([position, frame, turns]) => mirrored(numbers(position), numbers(frame), truth(turns)),
  FRAME: (points) => frameOf(points.map(numbers)),
  NORMAL: ([position]) => axisOf(numbers(position), 0),
  ORIENT: ([position]) => axisOf(numbers(position), 1),
  APPROACH: ([position]) => axisOf(numbers(position), 2),
  CNV_JPOS_REL: ([joints, values, status]) => {
    const axes = numbers(joints);
    const target = list(held(values));
    for (const i of target.keys()) if (i < axes.length) target[i] = axes[i];
    put(status, 0);
  },
  CNV_REL_JPOS: ([values, joints, status]) => {
    const axes = list(values);
    const last = axes.findIndex((value) => value === undefined);
    put(joints, axes.slice(0, last < 0 ? undefined : last).map(number));
    put(status, 0);
  },
  CNV_CONF_STR: ([config, target]) => put(target, configText(number(config))),
  CNV_STR_CONF: ([source, target, status]) => {
    const config = configOf(text(source));
    if (config !== null) put(target, config);
    put(status, config === null ? 1 : 0);
  },

  CHR: ([code]) => String.fromCharCode(number(code) & 255),
  ORD: ([source, index]) => {
    const [value, at] = [text(source), number(index)];
    if (at < 1 || at > value.length) throw new Alarm(`the index ${at} is not from 1 to ${value.length}`, 'index');
    return value.charCodeAt(at - 1);
  },
  STR_LEN: ([source]) => text(source).length,
  SUB_STR: ([source, start, length]) => {
    const [value, from, count] = [text(source), number(start), number(length)];
    if (from < 1 || count < 0) throw new Alarm('SUB_STR begins at 1 and takes 0 characters or more', 'range');
    return value.slice(from - 1, from - 1 + count);
  },
  INDEX: ([source, part]) => (text(part) === '' ? 0 : text(source).indexOf(text(part)) + 1),
  CNV_INT_STR: ([value, length, base, target]) =>
    put(target, convertedWhole(number(value), number(length), number(base))),
  CNV_REAL_STR: ([value, length, digits, target]) =>
    put(target, convertedReal(number(value), number(length), number(digits))),
  CNV_STR_INT: ([source, target]) => {
    const value = /^\s*[+-]?\d+/.exec(text(source));
    put(target, value ? whole(Number(value[0])) : undefined);
  },
  CNV_STR_REAL: ([source, target]) => {
    const value = /^\s*[+-]?(\d+\.?\d*|\.\d+)(E[+-]?\d+)?/i.exec(text(source));
    put(target, value ? single(Number(value[0])) : undefined);
  },

  CNV_TIME_STR: ([time, target]) => put(target, timeText(number(time))),
  CNV_STR_TIME: ([source, target]) => put(target, packedTime(text(source))),

  UNINIT: ([variable]) => {
    const value = typeof variable === 'object' && variable && 'holder' in variable ? held(variable) : variable;
    return isUnset(value);
  },
  ARRAY_LEN: ([array]) => list(array).length,

  PATH_LEN: ([path]) => nodesOf(path).length,
  APPEND_NODE: ([path, status]) => {
    const { nodes, blank, most } = record(held(path));
    const isRoom = list(nodes).length < number(most);
    if (isRoom) list(nodes).push(copied(blank));
    put(status, isRoom ? 0 : NO_ROOM);
  },
  INSERT_NODE: ([path, index, status]) =>
    changeNodes(
      path,
      index,
      status,
      (nodes, at) =>
        nodes.length < number(record(held(path)).most) && nodes.splice(at, 0, copied(record(held(path)).blank)),
    ),
  DELETE_NODE: ([path, index, status]) => changeNodes(path, index, status, (nodes, at) => nodes.splice(at, 1)),
  COPY_PATH: ([from, first, last, to, status]) => {
    const nodes = nodesOf(from);
    const [a, b] = [number(first) || 1, number(last) || nodes.length];
    record(held(to)).nodes = nodes.slice(a - 1, b).map(copied);
    put(status, 0);
  },
};

/** Not zero; that of a controller is not known. */
const NO_ROOM = 1;

/** @param {Value} value @returns {boolean} */
function isUnset(value) {
  return value === undefined || (Array.isArray(value) && value.length > 0 && value.every((one) => one === undefined));
}

/** @param {unknown} path a reference */
const nodesOf = (path) => list(record(held(path)).nodes);

/** @param {unknown} path @param {unknown} index @param {unknown} status @param {(nodes: Value[], at: number) => void} change */
function changeNodes(path, index, status, change) {
  const nodes = nodesOf(path);
  const at = number(index);
  const isThere = at >= 1 && at <= nodes.length;
  if (isThere) change(nodes, at - 1);
  put(status, isThere ? 0 : 12009);
}
