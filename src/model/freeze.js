/**
 * Freeze plain data, all the way down.
 * @template T
 * @param {T} value
 * @returns {T} the same object
 */
export function deepFreeze(value) {
  if (value !== null && typeof value === 'object' && !Object.isFrozen(value)) {
    Object.freeze(value);
    Object.values(value).forEach(deepFreeze);
  }
  return value;
}
