/**
 * The eight postures of the arm that nearly every factory has: axis 2 square to axis 1, axis 3 parallel to axis 2,
 * axes 4, 5 and 6 meeting in one point, 4 square to 3, 5 to 4 and 6 to 5. With offsets of the shoulder, the elbow and
 * to the side it is the "ortho-parallel basis with spherical wrist" of Brandstötter, Angerer and Hofbaur (2014):
 * seven lengths, all solved alike. Written for speed: no allocation, and the twenty arc tangents of eight postures at once.
 *
 * The arm's plane is the vertical one square to axis 2; x points in it away from axis 1, y along axis 2, z along axis
 * 1. Angles in it count from z to x, the way that axis 2 turns.
 *
 * @import { Screws } from '../screws.js'
 * @typedef {ArrayLike<number>} Vector
 *
 * @typedef {object} OrthoParallel   m and rad; at home, which is while all joint values are zero
 * @property {number} heading    of the arm's plane, about axis 1 from the x axis of `start`
 * @property {number} side       of the wrist centre from axis 1, along y
 * @property {number} shoulderX  of axis 2
 * @property {number} shoulderZ
 * @property {number} upper      length of the upper arm, from axis 2 to axis 3
 * @property {number} fore       of the forearm, from axis 3 to the wrist centre
 * @property {number} upperAngle of the upper arm
 * @property {number} elbowAngle between the two
 * @property {number} sense3     1 or −1: the way that joint 3 turns
 * @property {number} cosine4    between the forearm and axis 4
 * @property {number} sine4
 * @property {number} angle4     between axis 5 and y, about axis 4
 * @property {number} angle5     between axis 4 and axis 6, about axis 5
 * @property {Float64Array} centre  of the wrist, seen from the TCP
 * @property {Float64Array} hand    9 numbers, columns: a frame with axis 6 as its z and axis 5 as its y, seen from the
 *   TCP
 * @property {number} onAxis     what is nearer to axis 1 than this is on it, m
 * @property {number} folded     likewise to axis 2
 */
import { writeArcTangents } from '../arcTangents.js';
import { cross, dot, minus, nearestTo, norm } from '../lines.js';

/**
 * Bits of the answer beyond the eight of the postures. Four of them: the wrist is in line, for each place of the elbow.
 */
export const WRIST_IN_LINE = 0xf00;
/** The wrist centre is on axis 1: what is written is one of infinitely many, for each place of the elbow. */
export const SHOULDER_SINGULAR = 0x1000;
/** The wrist centre is on axis 2: likewise. */
export const FOLDED = 0x2000;

const TOLERANCE = 1e-9;
/** Nearer to axis 2, in arm lengths, the elbow's angle is known to half the digits only. */
const FOLDED_ARM = 2e-7;
/** Relative discriminants: as small as rounding, and as negative as from a goal that is rounded (roots.js). */
const ONE = 1e-14;
const NONE = -1e-8;

/**
 * @param {Screws} screws
 * @returns {OrthoParallel | null}
 */
export function recogniseOrthoParallel({ dof, slides, axes, points, home, length }) {
  if (dof !== 6 || slides.includes(true)) return null;
  const at = (/** @type {Float64Array} */ list, /** @type {number} */ i) => list.subarray(3 * i, 3 * i + 3);
  const [z, y, a3, a4, a5, a6] = [0, 1, 2, 3, 4, 5].map((i) => at(axes, i));
  const isSquare = (/** @type {Vector} */ a, /** @type {Vector} */ b) => Math.abs(dot(a, b)) < TOLERANCE;
  const areSquare = isSquare(z, y) && isSquare(y, a4) && isSquare(a4, a5) && isSquare(a5, a6);
  if (!areSquare || norm(cross(y, a3)) > TOLERANCE) return null;

  const W = nearestTo({ axis: a5, point: at(points, 4) }, { axis: a6, point: at(points, 5) });
  const isOn = (/** @type {number} */ i) => norm(cross(at(axes, i), minus(W, at(points, i)))) < TOLERANCE * length;
  if (!isOn(3) || !isOn(4) || !isOn(5)) return null;

  const x = cross(y, z);
  const seen = (/** @type {Vector} */ v) => [dot(v, x), dot(v, y), dot(v, z)];
  const start = at(points, 0);
  const [shoulder, elbow, wrist] = [at(points, 1), at(points, 2), W].map((p) => seen(minus(p, start)));
  const [upperX, upperZ] = [elbow[0] - shoulder[0], elbow[2] - shoulder[2]];
  const [foreX, foreZ] = [wrist[0] - elbow[0], wrist[2] - elbow[2]];
  const upper = Math.hypot(upperX, upperZ);
  const fore = Math.hypot(foreX, foreZ);
  if (!(Math.min(upper, fore) > 1e-6 * length)) return null;
  const [axis4X, , axis4Z] = seen(a4);
  const across = cross(y, a4);
  const fromTcp = (/** @type {Vector} */ v) => [0, 4, 8].map((i) => dot(v, home.subarray(i, i + 3)));
  return {
    heading: Math.atan2(x[1], x[0]),
    side: wrist[1],
    shoulderX: shoulder[0],
    shoulderZ: shoulder[2],
    upper,
    fore,
    upperAngle: Math.atan2(upperX, upperZ),
    elbowAngle: Math.atan2(upperZ * foreX - upperX * foreZ, upperZ * foreZ + upperX * foreX),
    sense3: Math.sign(dot(y, a3)),
    cosine4: (foreZ * axis4Z + foreX * axis4X) / fore,
    sine4: (foreZ * axis4X - foreX * axis4Z) / fore,
    angle4: Math.atan2(-dot(a5, across), dot(a5, y)),
    angle5: Math.atan2(dot(a5, cross(a4, a6)), dot(a4, a6)),
    centre: Float64Array.from(fromTcp(minus(W, home.subarray(12, 15)))),
    hand: Float64Array.from([cross(a5, a6), a5, a6].flatMap(fromTcp)),
    onAxis: TOLERANCE * length,
    folded: FOLDED_ARM * length,
  };
}

/**
 * Writes the postures that reach a goal. Posture k is at `out[6 · k]`, and there if bit k of the answer is set:
 *
 * - k & 4: the arm reaches over its shoulder, the wrist centre behind axis 1
 * - k & 2: the elbow's angle, from the upper arm to the forearm and the way that axis 2 turns, is negative
 * - k & 1: the wrist is flipped: the angle from axis 4 to axis 6, the way that axis 5 turns, is negative
 *
 * At the edge of the reach two postures are one; then it is the one without the bit. Joint values are not wrapped.
 * Limits do not count. The further bits are named above.
 * @param {OrthoParallel} arm
 * @param {ArrayLike<number>} T_start_goal
 * @param {Float64Array} out  48 numbers; those of postures that are not there are left as they were
 * @returns {number}
 */
export function writeOrthoParallelPostures(arm, T_start_goal, out) {
  const { side, shoulderX, shoulderZ, upper, fore, onAxis, folded, cosine4, sine4, centre, hand } = arm;
  const r00 = T_start_goal[0];
  const r10 = T_start_goal[1];
  const r20 = T_start_goal[2];
  const r01 = T_start_goal[4];
  const r11 = T_start_goal[5];
  const r21 = T_start_goal[6];
  const r02 = T_start_goal[8];
  const r12 = T_start_goal[9];
  const r22 = T_start_goal[10];
  const w0 = centre[0];
  const w1 = centre[1];
  const w2 = centre[2];
  const px = T_start_goal[12] + r00 * w0 + r01 * w1 + r02 * w2;
  const py = T_start_goal[13] + r10 * w0 + r11 * w1 + r12 * w2;
  const pz = T_start_goal[14] + r20 * w0 + r21 * w1 + r22 * w2;

  const square = px * px + py * py;
  const radius = Math.sqrt(square);
  const beyond = (radius - side) * (radius + side);
  if (!(beyond >= NONE * square) && radius > onAxis) return 0;
  const isOnAxis1 = radius <= onAxis;
  if (isOnAxis1 && Math.abs(side) > onAxis) return 0;
  const isOneSided = !isOnAxis1 && beyond <= ONE * square;
  const ahead = isOneSided || isOnAxis1 ? 0 : Math.sqrt(beyond);

  // The hand, seen from `start`
  const x0 = r00 * hand[0] + r01 * hand[1] + r02 * hand[2];
  const x1 = r10 * hand[0] + r11 * hand[1] + r12 * hand[2];
  const x2 = r20 * hand[0] + r21 * hand[1] + r22 * hand[2];
  const y0 = r00 * hand[3] + r01 * hand[4] + r02 * hand[5];
  const y1 = r10 * hand[3] + r11 * hand[4] + r12 * hand[5];
  const y2 = r20 * hand[3] + r21 * hand[4] + r22 * hand[5];
  const z0 = r00 * hand[6] + r01 * hand[7] + r02 * hand[8];
  const z1 = r10 * hand[6] + r11 * hand[7] + r12 * hand[8];
  const z2 = r20 * hand[6] + r21 * hand[7] + r22 * hand[8];

  const Z = pz - shoulderZ;
  const links = upper * upper + fore * fore;
  const twice = 2 * upper * fore;
  let bits = isOnAxis1 ? SHOULDER_SINGULAR : 0;
  for (let back = 0; back < 8; back += 4) {
    if (back === 4 && (isOneSided || isOnAxis1)) break;
    const forward = back === 0 ? ahead : -ahead;
    const X = forward - shoulderX;
    const distance = X * X + Z * Z;
    let C = (distance - links) / twice;
    const slack = (1 - C) * (1 + C);
    if (!(slack >= NONE)) continue;
    const isStretched = slack <= ONE;
    if (isStretched) C = C < 0 ? -1 : 1;
    const bend = isStretched ? 0 : Math.sqrt(slack);
    const isOnAxis2 = distance <= folded * folded;
    if (isOnAxis2) bits |= FOLDED;

    let cosine1 = px * forward + py * side;
    let sine1 = py * forward - px * side;
    if (isOnAxis1) {
      cosine1 = 1;
      sine1 = 0;
    }
    const scale1 = 1 / Math.sqrt(cosine1 * cosine1 + sine1 * sine1);
    cosine1 *= scale1;
    sine1 *= scale1;
    sines[JOINT_1 + back / 4] = sine1;
    cosines[JOINT_1 + back / 4] = cosine1;
    sines[JOINT_3 + back / 4] = bend;
    cosines[JOINT_3 + back / 4] = C;
    // Of the hand: along x and y of the arm's plane
    const zx = cosine1 * z0 + sine1 * z1;
    const zy = cosine1 * z1 - sine1 * z0;

    for (let down = 0; down < 4; down += 2) {
      if (down === 2 && isStretched) break;
      const S = down === 0 ? bend : -bend;
      const along = upper + fore * C;
      const across = fore * S;
      let cosine2 = Z * along + X * across;
      let sine2 = X * along - Z * across;
      if (isOnAxis2) {
        cosine2 = 1;
        sine2 = 0;
      }
      const scale2 = 1 / Math.sqrt(cosine2 * cosine2 + sine2 * sine2);
      cosine2 *= scale2;
      sine2 *= scale2;
      const cosine3 = cosine2 * C - sine2 * S;
      const sine3 = sine2 * C + cosine2 * S;
      // Axis 4 in the plane, then axis 6 seen from it: x across, y as ever, z along axis 4
      const eZ = cosine3 * cosine4 - sine3 * sine4;
      const eX = sine3 * cosine4 + cosine3 * sine4;
      const gx = eZ * zx - eX * z2;
      const gz = eX * zx + eZ * z2;
      const sine5 = Math.sqrt(gx * gx + zy * zy);
      const pair = (back + down) / 2;
      let c4 = 1;
      let s4 = 0;
      if (sine5 < TOLERANCE) {
        bits |= 0x100 << pair;
      } else {
        c4 = gx / sine5;
        s4 = zy / sine5;
      }
      // From the first angle found, so that the last one makes up for its error near a singularity
      const vx = -s4 * eZ;
      const v0 = vx * cosine1 - c4 * sine1;
      const v1 = vx * sine1 + c4 * cosine1;
      const v2 = s4 * eX;
      sines[JOINT_2 + pair] = sine2;
      cosines[JOINT_2 + pair] = cosine2;
      sines[JOINT_4 + pair] = s4;
      cosines[JOINT_4 + pair] = c4;
      sines[JOINT_5 + pair] = sine5;
      cosines[JOINT_5 + pair] = gz;
      sines[JOINT_6 + pair] = v0 * x0 + v1 * x1 + v2 * x2;
      cosines[JOINT_6 + pair] = v0 * y0 + v1 * y1 + v2 * y2;
      bits |= 3 << (back + down);
    }
  }
  writeArcTangents(sines, cosines, angles);
  writePostures(arm, bits, out);
  return bits;
}

/** Where the angles stand: of joints 1 and 3 for the arm ahead and back, of the others for each place of the elbow. */
const JOINT_1 = 0;
const JOINT_3 = 2;
const JOINT_2 = 4;
const JOINT_4 = 8;
const JOINT_5 = 12;
const JOINT_6 = 16;
const sines = new Float64Array(20);
const cosines = new Float64Array(20);
const angles = new Float64Array(20);

/**
 * The angles that were found, as joint values: each place of the elbow with the wrist as it is, and flipped.
 * @param {OrthoParallel} arm
 * @param {number} bits  which postures are there
 * @param {Float64Array} out
 */
function writePostures({ heading, upperAngle, elbowAngle, sense3, angle4, angle5 }, bits, out) {
  for (let pair = 0; pair < 4; pair++) {
    if (!(bits & (3 << (2 * pair)))) continue;
    const back = pair >> 1;
    const angle3 = angles[JOINT_3 + back];
    const q1 = angles[JOINT_1 + back] - heading;
    const q2 = angles[JOINT_2 + pair] - upperAngle;
    const q3 = sense3 * ((pair & 1 ? -angle3 : angle3) - elbowAngle);
    const q4 = angles[JOINT_4 + pair] - angle4;
    const q5 = angles[JOINT_5 + pair];
    const q6 = angles[JOINT_6 + pair];
    let to = 12 * pair;
    out[to++] = q1;
    out[to++] = q2;
    out[to++] = q3;
    out[to++] = q4;
    out[to++] = q5 - angle5;
    out[to++] = q6;
    out[to++] = q1;
    out[to++] = q2;
    out[to++] = q3;
    out[to++] = q4 > 0 ? q4 - Math.PI : q4 + Math.PI;
    out[to++] = -q5 - angle5;
    out[to] = q6 > 0 ? q6 - Math.PI : q6 + Math.PI;
  }
}
