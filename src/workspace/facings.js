/**
 * Directions by where they go through a cube about the origin: each of its six faces is nine squares. A set of them is two
 * numbers of 32 bits.
 */

/** Numbers for one set. */
export const FACINGS = 2;

const SQUARES = 54;

/** Thirds of the angle, not of the face, so that the squares see about the same of the sphere. @param {number} t */
const thirdOf = (t) => Math.min(2, Math.floor(((4 / Math.PI) * Math.atan(t) + 1) * 1.5));

/** @param {ArrayLike<number>} axis @returns {number} 0 … 53 */
export function facingOf(axis) {
  const [x, y, z] = [Math.abs(axis[0]), Math.abs(axis[1]), Math.abs(axis[2])];
  const along = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  const size = Math.abs(axis[along]);
  const [p, q] = [axis[(along + 1) % 3] / size, axis[(along + 2) % 3] / size];
  return 9 * (2 * along + Number(axis[along] < 0)) + 3 * thirdOf(p) + thirdOf(q);
}

/** How much of all directions is in a set. @param {Uint32Array} facings @param {number} set */
export function shareOfFacings(facings, set) {
  let count = 0;
  for (let k = FACINGS * set; k < FACINGS * (set + 1); k++)
    for (let bits = facings[k]; bits !== 0; bits = (bits & (bits - 1)) >>> 0) count++;
  return count / SQUARES;
}
