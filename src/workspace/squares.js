/**
 * Things in the plane by the squares of a grid that they touch, so that what is near a line is found without looking at all.
 *
 * @typedef {{ u: number, v: number }} Point
 */

/** Squares in a row, at most: more than any plane here has. */
const ROW = 2 ** 26;

/** @template T */
export class Squares {
  /** @type {Map<number, T[]>} */
  #kept = new Map();
  #side;

  /** @param {number} side */
  constructor(side) {
    this.#side = side;
  }

  /** @param {number} u0 @param {number} v0 @param {number} u1 @param {number} v1 @returns {number[]} */
  #keys(u0, v0, u1, v1) {
    const at = (/** @type {number} */ value) => Math.floor(value / this.#side);
    const keys = [];
    for (let i = at(Math.min(u0, u1)); i <= at(Math.max(u0, u1)); i++)
      for (let j = at(Math.min(v0, v1)); j <= at(Math.max(v0, v1)); j++) keys.push(i * ROW + j);
    return keys;
  }

  /**
   * Whether a thing near a line is as asked for; it may be asked about more than once.
   * @param {Point} a
   * @param {Point} b
   * @param {(thing: T) => boolean} isIt
   */
  some(a, b, isIt) {
    for (const key of this.#keys(a.u, a.v, b.u, b.v)) if (this.#kept.get(key)?.some(isIt)) return true;
    return false;
  }

  /** @param {T} thing @param {Point} a @param {Point} b */
  add(thing, a, b) {
    for (const key of this.#keys(a.u, a.v, b.u, b.v)) {
      const there = this.#kept.get(key);
      if (there) there.push(thing);
      else this.#kept.set(key, [thing]);
    }
  }

  /** @param {Point} a @param {Point} b @param {number} margin @returns {Set<T>} */
  near(a, b, margin) {
    /** @type {Set<T>} */
    const found = new Set();
    const [u0, u1] = [Math.min(a.u, b.u) - margin, Math.max(a.u, b.u) + margin];
    const [v0, v1] = [Math.min(a.v, b.v) - margin, Math.max(a.v, b.v) + margin];
    for (const key of this.#keys(u0, v0, u1, v1)) for (const thing of this.#kept.get(key) ?? []) found.add(thing);
    return found;
  }
}
