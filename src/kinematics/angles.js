/**
 * Sine and cosine that know a right angle when they see one: π/2 cannot be written in binary, so Math.cos(π/2) is 6e-17
 * and every table with a twist of 90° would carry that dirt through all its products.
 */
const RIGHT_ANGLE = Math.PI / 2;

/** How far from a multiple of π/2 an angle may be, in units in its last place, and still mean it. */
const ULPS = 4;

/** The distance between a number and its neighbours in binary. */
const ulp = (/** @type {number} */ x) => 2 ** (Math.floor(Math.log2(Math.abs(x))) - 52);

/**
 * How many right angles an angle is: 0, 1, 2 or 3, full turns aside; or null if it is not a multiple of one.
 * @param {number} angle radians
 */
function quarterOf(angle) {
  const quarters = Math.round(angle / RIGHT_ANGLE);
  if (angle === 0) return 0;
  if (quarters === 0) return null;
  const multiple = quarters * RIGHT_ANGLE;
  return Math.abs(angle - multiple) <= ULPS * ulp(multiple) ? ((quarters % 4) + 4) % 4 : null;
}

/**
 * @example
 * exactSine(Math.PI) // → 0
 * exactSine(-Math.PI / 2) // → -1
 * @param {number} angle radians
 */
export function exactSine(angle) {
  const quarter = quarterOf(angle);
  return quarter === null ? Math.sin(angle) : [0, 1, 0, -1][quarter];
}

/**
 * @example
 * exactCosine(Math.PI / 2) // → 0
 * exactCosine(5 * Math.PI) // → -1
 * @param {number} angle radians
 */
export function exactCosine(angle) {
  const quarter = quarterOf(angle);
  return quarter === null ? Math.cos(angle) : [1, 0, -1, 0][quarter];
}
