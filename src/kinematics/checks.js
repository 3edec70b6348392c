/**
 * Wrong calls, told apart from impossible wishes: these throw.
 */

/**
 * @param {number} dof
 * @param {ArrayLike<number>} q
 */
export function requirePosture(dof, q) {
  if (q === null || typeof q !== 'object') throw new TypeError(`Expected ${dof} joint values, got ${typeof q}.`);
  if (q.length !== dof) throw new RangeError(`Expected ${dof} joint values, got ${q.length}.`);
  for (let i = 0; i < dof; i++) {
    if (!Number.isFinite(q[i]))
      throw new RangeError(`Expected joint value ${i + 1} to be a finite number, got ${q[i]}.`);
  }
}

/**
 * @param {ArrayLike<number>} out
 * @param {number} length
 */
export function requireRoom(out, length) {
  if (out.length !== length) throw new RangeError(`Expected room for ${length} numbers, got ${out.length}.`);
}

/** @param {string} name @param {number} value */
export function requirePositive(name, value) {
  if (!(value > 0 && value < Infinity)) throw new RangeError(`Expected ${name} to be positive, got ${value}.`);
}

/** @param {string} name @param {number} value @param {number} [least] */
export function requireWhole(name, value, least = 0) {
  if (!(Number.isSafeInteger(value) && value >= least)) {
    throw new RangeError(`Expected ${name} to be a whole number, got ${value}.`);
  }
}
