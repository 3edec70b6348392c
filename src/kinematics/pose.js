/**
 * Rigid-body poses as 4×4 homogeneous transforms. A pose named `T_a_b` is frame b seen from frame a; adjacent names
 * cancel: T_a_c = compose(T_a_b, T_b_c). Promises: the functions here never change what they are given, `out` may be one
 * of the inputs, and rotation differences are right to the last digits from no turn at all up to a half turn.
 *
 * @typedef {Float64Array} Pose  16 numbers, column-major; metres
 */

/** How far from orthonormal a rotation may be (largest entry of RᵀR − 1): six decimals always pass, a typing error does not. */
const RIGID_TOLERANCE = 2e-6;

/** @returns {Pose} */
export function identity() {
  return Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
}

/**
 * @example
 * position(translation([1, 2, 3])) // → [1, 2, 3]
 * @param {ArrayLike<number>} xyz metres
 * @returns {Pose}
 */
export function translation(xyz) {
  return Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, xyz[0], xyz[1], xyz[2], 1);
}

/** @param {ArrayLike<number>} T @returns {[number, number, number]} */
export const position = (T) => [T[12], T[13], T[14]];

/**
 * T_a_c from T_a_b and T_b_c.
 * @example
 * position(compose(translation([1, 0, 0]), translation([0, 2, 0]))) // → [1, 2, 0]
 * @param {ArrayLike<number>} T_a_b
 * @param {ArrayLike<number>} T_b_c
 * @param {Pose} [out]
 * @returns {Pose}
 */
export function compose(T_a_b, T_b_c, out = new Float64Array(16)) {
  const x0 = T_a_b[0];
  const x1 = T_a_b[1];
  const x2 = T_a_b[2];
  const y0 = T_a_b[4];
  const y1 = T_a_b[5];
  const y2 = T_a_b[6];
  const z0 = T_a_b[8];
  const z1 = T_a_b[9];
  const z2 = T_a_b[10];
  const p0 = T_a_b[12];
  const p1 = T_a_b[13];
  const p2 = T_a_b[14];
  for (let column = 0; column < 16; column += 4) {
    const u = T_b_c[column];
    const v = T_b_c[column + 1];
    const w = T_b_c[column + 2];
    const isPosition = column === 12;
    out[column] = x0 * u + y0 * v + z0 * w + (isPosition ? p0 : 0);
    out[column + 1] = x1 * u + y1 * v + z1 * w + (isPosition ? p1 : 0);
    out[column + 2] = x2 * u + y2 * v + z2 * w + (isPosition ? p2 : 0);
    out[column + 3] = isPosition ? 1 : 0;
  }
  return out;
}

/**
 * T_b_a from T_a_b.
 * @example
 * position(invert(translation([1, 2, 3]))) // → [-1, -2, -3]
 * @param {ArrayLike<number>} T_a_b
 * @param {Pose} [out]
 * @returns {Pose}
 */
export function invert(T_a_b, out = new Float64Array(16)) {
  const x0 = T_a_b[0];
  const x1 = T_a_b[1];
  const x2 = T_a_b[2];
  const y0 = T_a_b[4];
  const y1 = T_a_b[5];
  const y2 = T_a_b[6];
  const z0 = T_a_b[8];
  const z1 = T_a_b[9];
  const z2 = T_a_b[10];
  const p0 = T_a_b[12];
  const p1 = T_a_b[13];
  const p2 = T_a_b[14];
  out[0] = x0;
  out[1] = y0;
  out[2] = z0;
  out[3] = 0;
  out[4] = x1;
  out[5] = y1;
  out[6] = z1;
  out[7] = 0;
  out[8] = x2;
  out[9] = y2;
  out[10] = z2;
  out[11] = 0;
  out[12] = -(x0 * p0 + x1 * p1 + x2 * p2);
  out[13] = -(y0 * p0 + y1 * p1 + y2 * p2);
  out[14] = -(z0 * p0 + z1 * p1 + z2 * p2);
  out[15] = 1;
  return out;
}

/**
 * From one pose to another, both seen from frame a: the way to go in metres, then the rotation vector (axis times angle,
 * radians, at most a half turn) that takes the first orientation to the second. All in axes of frame a. At exactly a half
 * turn both directions are right; one of them is returned.
 *
 * The rotation goes through the quaternion with its largest component as pivot (Shepperd 1978): the trace alone loses
 * half the digits of a small angle, and R − Rᵀ alone vanishes at a half turn, which would pass for no turn at all.
 * @param {ArrayLike<number>} T_a_from
 * @param {ArrayLike<number>} T_a_to
 * @param {Float64Array} [out] 6 numbers, linear part first
 * @returns {Float64Array}
 */
export function poseDifference(T_a_from, T_a_to, out = new Float64Array(6)) {
  const F = T_a_from;
  const G = T_a_to;
  // R = R_to · R_fromᵀ
  const r00 = G[0] * F[0] + G[4] * F[4] + G[8] * F[8];
  const r01 = G[0] * F[1] + G[4] * F[5] + G[8] * F[9];
  const r02 = G[0] * F[2] + G[4] * F[6] + G[8] * F[10];
  const r10 = G[1] * F[0] + G[5] * F[4] + G[9] * F[8];
  const r11 = G[1] * F[1] + G[5] * F[5] + G[9] * F[9];
  const r12 = G[1] * F[2] + G[5] * F[6] + G[9] * F[10];
  const r20 = G[2] * F[0] + G[6] * F[4] + G[10] * F[8];
  const r21 = G[2] * F[1] + G[6] * F[5] + G[10] * F[9];
  const r22 = G[2] * F[2] + G[6] * F[6] + G[10] * F[10];
  const trace = r00 + r11 + r22;
  // 4w·(w, x, y, z), or the same with x, y or z as the factor
  let w = 1 + trace;
  let x = r21 - r12;
  let y = r02 - r20;
  let z = r10 - r01;
  if (trace < 0) {
    if (r00 >= r11 && r00 >= r22) {
      w = x;
      x = 1 + r00 - r11 - r22;
      y = r10 + r01;
      z = r20 + r02;
    } else if (r11 >= r22) {
      w = y;
      x = r10 + r01;
      y = 1 + r11 - r00 - r22;
      z = r21 + r12;
    } else {
      w = z;
      x = r20 + r02;
      y = r21 + r12;
      z = 1 + r22 - r00 - r11;
    }
  }
  const sine = Math.sqrt(x * x + y * y + z * z);
  const scale = sine === 0 ? 0 : (2 * (w < 0 ? -Math.atan2(sine, -w) : Math.atan2(sine, w))) / sine; // the shorter way
  out[0] = G[12] - F[12];
  out[1] = G[13] - F[13];
  out[2] = G[14] - F[14];
  out[3] = x * scale;
  out[4] = y * scale;
  out[5] = z * scale;
  return out;
}

/**
 * How far the axes are from orthonormal: the Frobenius norm of RᵀR − 1. Rounding leaves 1e-16, six typed decimals 1e-6.
 * @param {ArrayLike<number>} T
 */
export function skewness(T) {
  let square = 0;
  for (let i = 0; i < 12; i += 4) {
    for (let j = 0; j < 12; j += 4) {
      square += (T[i] * T[j] + T[i + 1] * T[j + 1] + T[i + 2] * T[j + 2] - (i === j ? 1 : 0)) ** 2;
    }
  }
  return Math.sqrt(square);
}

/**
 * The largest element of RᵀR − 1, by size. Written out, since each inverse kinematics asks for it.
 * @param {ArrayLike<number>} T
 */
function offOrthonormal(T) {
  const [x0, x1, x2, y0, y1, y2, z0, z1, z2] = [T[0], T[1], T[2], T[4], T[5], T[6], T[8], T[9], T[10]];
  return Math.max(
    Math.abs(x0 * x0 + x1 * x1 + x2 * x2 - 1),
    Math.abs(y0 * y0 + y1 * y1 + y2 * y2 - 1),
    Math.abs(z0 * z0 + z1 * z1 + z2 * z2 - 1),
    Math.abs(x0 * y0 + x1 * y1 + x2 * y2),
    Math.abs(x0 * z0 + x1 * z1 + x2 * z2),
    Math.abs(y0 * z0 + y1 * z1 + y2 * z2),
  );
}

/**
 * What keeps sixteen numbers from being a pose, in words that end a sentence beginning "got"; null if nothing does.
 * @param {ArrayLike<number>} T
 * @returns {string | null}
 */
function faultOf(T) {
  if (T === null || typeof T !== 'object' || typeof T.length !== 'number') return `${T === null ? null : typeof T}`;
  if (T.length !== 16) return `${T.length} numbers`;
  for (let i = 0; i < 16; i++) if (!Number.isFinite(T[i])) return `${T[i]} at index ${i}`;
  if (T[3] !== 0 || T[7] !== 0 || T[11] !== 0 || T[15] !== 1) {
    return `a bottom row of ${T[3]} ${T[7]} ${T[11]} ${T[15]} (is the matrix row-major?)`;
  }
  const off = offOrthonormal(T);
  if (off > RIGID_TOLERANCE) return `axes that are ${off.toPrecision(2)} from orthonormal`;
  const handedness =
    T[8] * (T[1] * T[6] - T[2] * T[5]) + T[9] * (T[2] * T[4] - T[0] * T[6]) + T[10] * (T[0] * T[5] - T[1] * T[4]);
  return handedness > 0 ? null : 'left-handed axes';
}

/** @param {ArrayLike<number>} T */
export const isPose = (T) => faultOf(T) === null;

/**
 * Throws unless `T` is a rigid transform. The caller's own values come back: nothing is rounded or repaired.
 * @template {ArrayLike<number>} P
 * @param {P} T
 * @param {string} name  what the pose is, for the message
 * @returns {P}
 */
export function requirePose(T, name) {
  const fault = faultOf(T);
  if (fault === null) return T;
  const message = `Expected ${name} to be a pose (16 numbers, column-major, right-handed orthonormal axes), got ${fault}.`;
  throw T !== null && typeof T === 'object' && typeof T.length === 'number'
    ? new RangeError(message)
    : new TypeError(message);
}
