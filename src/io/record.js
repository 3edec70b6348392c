/**
 * Values in nested plain objects, by paths that come from a table and never from a file.
 * @typedef {Record<string, unknown>} PlainRecord
 */

const isRecord = (/** @type {unknown} */ value) => typeof value === 'object' && value !== null && !Array.isArray(value);

/**
 * @param {PlainRecord} record
 * @param {string} path  'units.length'
 * @returns {unknown} undefined where the path leads nowhere
 */
export function valueAt(record, path) {
  if (!path.includes('.')) return record[path];
  /** @type {unknown} */
  let value = record;
  for (const key of path.split('.')) {
    if (!isRecord(value)) return undefined;
    value = /** @type {PlainRecord} */ (value)[key];
  }
  return value;
}

/**
 * Make the objects on the way, too.
 * @param {PlainRecord} record
 * @param {string} path
 * @param {unknown} value
 */
export function setAt(record, path, value) {
  if (!path.includes('.')) {
    record[path] = value;
    return;
  }
  const keys = path.split('.');
  const last = /** @type {string} */ (keys.pop());
  let holder = record;
  for (const key of keys) holder = /** @type {PlainRecord} */ (holder[key] ??= {});
  holder[last] = value;
}

/**
 * Whether two values are the same data, −0 and 0 being different, as they are in a file.
 * @param {unknown} a
 * @param {unknown} b
 * @returns {boolean}
 */
export function isSameData(a, b) {
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return Object.is(a, b);
  const [keysA, keysB] = [Object.keys(a), Object.keys(b)];
  const [inA, inB] = [/** @type {PlainRecord} */ (a), /** @type {PlainRecord} */ (b)];
  return keysA.length === keysB.length && keysA.every((key) => Object.hasOwn(b, key) && isSameData(inA[key], inB[key]));
}
