/**
 * Cosine and sine of one angle together, written out: forward kinematics spends most of its time on them, and the two
 * calls of Math cost twice as much. Both within 2⁻⁵² of the true values, exact at zero, and the same digits in every browser,
 * which Math does not promise.
 */

/** A quarter turn in two parts, the first so short that whole multiples of it are exact (Cody & Waite 1980). */
const QUARTER = Math.round((Math.PI / 2) * 2 ** 32) / 2 ** 32;
const QUARTER_REST = Math.PI / 2 - QUARTER + 6.123233995736766e-17; // the last is π/2 − Math.PI / 2

/** Farther away than this the multiples are not exact, and nobody turns so far. */
const FARTHEST = 1e6;

/** Adding and taking away this rounds to a whole number. */
const ROUNDER = 1.5 * 2 ** 52;

const COS_OF_QUARTERS = Float64Array.of(1, 0, -1, 0);
const SIN_OF_QUARTERS = Float64Array.of(0, 1, 0, -1);

/**
 * @param {number} angle
 * @param {Float64Array} out  the cosine is written at `at`, the sine behind it
 * @param {number} at
 */
export function writeCosSin(angle, out, at) {
  if (!(Math.abs(angle) < FARTHEST)) {
    out[at] = Math.cos(angle);
    out[at + 1] = Math.sin(angle);
    return;
  }
  const quarters = angle * (2 / Math.PI) + ROUNDER - ROUNDER;
  const r = angle - quarters * QUARTER - quarters * QUARTER_REST;
  // Taylor's series, grouped so that the processor can work on its terms side by side: for |r| ≤ π/4 the terms that are
  // missing are less than 2⁻⁵³.
  const z = r * r;
  const zz = z * z;
  const zzzz = zz * zz;
  const s =
    r +
    r *
      z *
      (-1 / 6 +
        z * (1 / 120) +
        zz * (-1 / 5040 + z * (1 / 362880)) +
        zzzz * (-1 / 39916800 + z * (1 / 6227020800) - zz * (1 / 1307674368000)));
  const c =
    1 +
    z *
      (-1 / 2 +
        z * (1 / 24) +
        zz * (-1 / 720 + z * (1 / 40320)) +
        zzzz * (-1 / 3628800 + z * (1 / 479001600) + zz * (-1 / 87178291200 + z * (1 / 20922789888000))));
  // and back by the quarter turns, without a branch: a wrong guess at one costs as much as all of the above
  const cosQuarters = COS_OF_QUARTERS[quarters & 3];
  const sinQuarters = SIN_OF_QUARTERS[quarters & 3];
  out[at] = cosQuarters * c - sinQuarters * s;
  out[at + 1] = cosQuarters * s + sinQuarters * c;
}
