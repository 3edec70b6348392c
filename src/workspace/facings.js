/**
 * Directions by where they go through a cube about the origin: each of its six faces is nine squares. A set of them is two
 * numbers of 32 bits.
 */

/** Numbers for one set. */
export const FACINGS = 2;

const SQUARES = 54;

/** @param {ArrayLike<number>} axis @returns {number} 0 … 53 */
export function facingOf(axis) {
  const sizes = [Math.abs(axis[0]), Math.abs(axis[1]), Math.abs(axis[2])];
  const along = sizes[0] >= sizes[1] && sizes[0] >= sizes[2] ? 0 : sizes[1] >= sizes[2] ? 1 : 2;
  const [p, q] = [axis[(along + 1) % 3] / sizes[along], axis[(along + 2) % 3] / sizes[along]];
  // thirds of the angle, not of the face, so that the squares see about the same of the sphere
  const third = (/** @type {number} */ t) => Math.min(2, Math.floor(((4 / Math.PI) * Math.atan(t) + 1) * 1.5));
  return 9 * (2 * along + Number(axis[along] < 0)) + 3 * third(p) + third(q);
}

/** How much of all directions is in a set. @param {Uint32Array} facings @param {number} set */
export function shareOfFacings(facings, set) {
  let count = 0;
  for (let k = FACINGS * set; k < FACINGS * (set + 1); k++)
    for (let bits = facings[k]; bits !== 0; bits = (bits & (bits - 1)) >>> 0) count++;
  return count / SQUARES;
}
