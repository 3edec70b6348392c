/**
 * Where values are: elements, fields and ports, from closures that tell where the whole is.
 *
 * @import { Type } from '../check/types.js'
 * @import { Evaluate, Locate } from './machine.js'
 * @import { Value } from './values.js'
 */
import { isPosition } from '../check/types.js';
import { Alarm, list, number, record } from './values.js';

/** @param {number} index from 1 @param {number} length */
export function indexIn(index, length) {
  if (index >= 1 && index <= length) return index - 1;
  throw new Alarm(`the index ${index} is not from 1 to ${length}`, 'index');
}

const XYZ = ['X', 'Y', 'Z', 'W', 'P', 'R', 'CONFIG_DATA', 'EXT1', 'EXT2', 'EXT3'];

export const asRecord = (/** @type {Value[]} */ values) =>
  /** @type {Record<number, Value>} */ (/** @type {unknown} */ (values));

/** @param {string} port  its name in capitals @param {Evaluate} index @returns {Locate} */
export const portAt = (port, index) => (m, f) => {
  const at = number(index(m, f));
  if (!hasNumber(at, 0)) throw new Alarm(`there is no ${port}[${at}]`, 'port');
  // By FANUC's manual the panel's ports go on as those of the user panel.
  const panel = at < PANEL ? undefined : USER_PANEL[port];
  return { holder: (m.state.ports[panel ?? port] ??= {}), key: panel ? at - PANEL + 1 : at };
};

const PANEL = 16;
const USER_PANEL = /** @type {Readonly<Record<string, string>>} */ ({ OPIN: 'UIN', OPOUT: 'UOUT' });

/** More registers, ports and semaphores than any controller has. */
const MOST = 32767;
export const hasNumber = (/** @type {number} */ index, least = 1) => index >= least && index <= MOST;

/** An element of an array or a path; of what is of unknown type, a system variable's text. @param {Locate} at @param {Evaluate[]} places @param {string} kind @returns {Locate} */
export function elementAt(at, places, kind) {
  const isPath = kind === 'PATH';
  const isSystem = kind === 'UNKNOWN';
  return (m, f) => {
    const { most, ...whole } = at(m, f);
    let { holder, key } = whole;
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
    return { holder, key, most };
  };
}

/** @param {Locate} at  the structure @param {Type} type @param {string} name @returns {Locate} */
export function fieldAt(at, type, name) {
  const upper = name.toUpperCase();
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
