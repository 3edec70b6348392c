/**
 * The angles of many directions at once, written out: a closed form in which twenty of them are wanted spends most of its time
 * on Math.atan2. Within 2⁻⁵¹ of the true values (relatively; tested), and the same digits in every browser, which Math does
 * not promise.
 */

/**
 * Coefficients of a polynomial P with arctan t = t − t³ P(t²) for |t| ≤ 7/16, which its makers state to be right to 2⁻⁵⁶
 * (FDLIBM, s_atan.c, Sun Microsystems 1993).
 */
const P0 = 3.33333333333329318027e-1;
const P1 = -1.99999999998764832476e-1;
const P2 = 1.42857142725034663711e-1;
const P3 = -1.1111110405462355788e-1;
const P4 = 9.09088713343650656196e-2;
const P5 = -7.69187620504482999495e-2;
const P6 = 6.66107313738753120669e-2;
const P7 = -5.83357013379057348645e-2;
const P8 = 4.97687799461593236017e-2;
const P9 = -3.6531572744216915527e-2;
const P10 = 1.62858201153657823623e-2;

/** What Math.PI leaves of π. */
const REST = 1.2246467991473532e-16;

/** The tangent of π/8: up to it a quotient is small enough as it is. */
const EIGHTH = Math.SQRT2 - 1;

/**
 * angles[k] = atan2(sines[k], cosines[k]), in (−π, π], for any two numbers in proportion to sine and cosine that are not both
 * below 1e-290; 0 if both are 0.
 * @param {Float64Array} sines
 * @param {Float64Array} cosines  as many
 * @param {Float64Array} angles   likewise, filled
 */
export function writeArcTangents(sines, cosines, angles) {
  for (let k = 0; k < angles.length; k++) {
    const y = sines[k];
    const x = cosines[k];
    const high = Math.abs(y);
    const wide = Math.abs(x);
    const isSteep = high > wide;
    const small = isSteep ? wide : high;
    const large = isSteep ? high : wide;
    // in the first eighth of the circle; its outer half is turned back by π/4
    const isFar = small > EIGHTH * large;
    const over = isFar ? small - large : small;
    const under = isFar ? small + large : large;
    const t = under > 0 ? over / under : 0;
    const z = t * t;
    const w = z * z;
    const odd = w * (P1 + w * (P3 + w * (P5 + w * (P7 + w * P9))));
    const even = z * (P0 + w * (P2 + w * (P4 + w * (P6 + w * (P8 + w * P10)))));
    const turned = isFar ? Math.PI / 4 + (REST / 4 - (t * (even + odd) - t)) : t - t * (even + odd);
    const first = isSteep ? Math.PI / 2 - (turned - REST / 2) : turned;
    const half = x < 0 ? Math.PI - (first - REST) : first;
    angles[k] = y < 0 ? -half : half;
  }
}
