/**
 * What the kernel is judged by: plain 4×4 matrices as rows of rows, multiplied in full, sharing no code with it.
 * @import { ChainDescription } from '../../../src/kinematics/chain.js'
 * @import { JointRow } from '../../../src/kinematics/joint.js'
 *
 * @typedef {number[][]} Matrix
 */
import { readFileSync } from 'node:fs';
import fc from 'fast-check';

/** @param {Matrix} A @param {Matrix} B @returns {Matrix} */
export const times = (A, B) =>
  A.map((row) => B[0].map((_, j) => row.reduce((sum, value, k) => sum + value * B[k][j], 0)));

/** @param {Matrix} A @returns {Matrix} */
export const transpose = (A) => A[0].map((_, j) => A.map((row) => row[j]));

/** @param {number} angle @returns {Matrix} */
const rotateX = (angle) => {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [
    [1, 0, 0, 0],
    [0, c, -s, 0],
    [0, s, c, 0],
    [0, 0, 0, 1],
  ];
};

/** @param {number} angle @returns {Matrix} */
const rotateZ = (angle) => {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [
    [c, -s, 0, 0],
    [s, c, 0, 0],
    [0, 0, 1, 0],
    [0, 0, 0, 1],
  ];
};

/** @param {number} x @param {number} z @returns {Matrix} */
const shift = (x, z) => [
  [1, 0, 0, x],
  [0, 1, 0, 0],
  [0, 0, 1, z],
  [0, 0, 0, 1],
];

/** Column-major as the kernel keeps it → rows. @param {ArrayLike<number>} T @returns {Matrix} */
export const rowsOf = (T) => [0, 1, 2, 3].map((row) => [0, 1, 2, 3].map((column) => T[4 * column + row]));

/** @param {Matrix} rows @returns {Float64Array} */
export const columnMajor = (rows) => Float64Array.from(transpose(rows).flat());

/** Three upper rows in a line, as fixtures keep them. @param {number[]} values @returns {Matrix} */
export const fromLine = (values) => [values.slice(0, 4), values.slice(4, 8), values.slice(8, 12), [0, 0, 0, 1]];

/** The rotation about an axis, by Rodrigues' formula. @param {number[]} axis of any length @param {number} angle @returns {Matrix} 3×3 */
export function rodrigues(axis, angle) {
  const length = Math.hypot(...axis);
  const [x, y, z] = axis.map((value) => value / length);
  const K = [
    [0, -z, y],
    [z, 0, -x],
    [-y, x, 0],
  ];
  const KK = times(K, K);
  const [s, v] = [Math.sin(angle), 2 * Math.sin(angle / 2) ** 2];
  return K.map((row, i) => row.map((value, j) => (i === j ? 1 : 0) + s * value + v * KK[i][j]));
}

/** @param {Matrix} R @param {number[]} p @returns {Matrix} */
export const rigid = (R, p) => [...R.map((row, i) => [...row, p[i]]), [0, 0, 0, 1]];

/** The 3×3 part. @param {Matrix} T */
export const rotationOf = (T) => T.slice(0, 3).map((row) => row.slice(0, 3));

/** The angle between two orientations, by how far apart the axes' tips are. @param {Matrix} A @param {Matrix} B */
export function angleBetween(A, B) {
  const chord = Math.hypot(...rotationOf(A).flatMap((row, i) => row.map((value, j) => value - B[i][j])));
  return 2 * Math.asin(Math.min(1, chord / Math.sqrt(8)));
}

/** @param {Matrix} A @param {Matrix} B */
export const distanceBetween = (A, B) => Math.hypot(...[0, 1, 2].map((i) => A[i][3] - B[i][3]));

/** @param {Matrix} A @param {Matrix} B */
export const largestDifference = (A, B) =>
  Math.max(...A.flatMap((row, i) => row.map((value, j) => Math.abs(value - B[i][j]))));

/**
 * T_base_0 … T_base_n and T_base_tcp by the rows of the table, as the books print them.
 * @param {ChainDescription} description
 * @param {ArrayLike<number>} q
 */
export function oracleForward({ convention, base, tool, joints }, q) {
  const unit = shift(0, 0);
  let T = base ? rowsOf(base) : unit;
  const frames = [T];
  joints.forEach(({ type, a, alpha, d, theta }, i) => {
    const Z = times(rotateZ(theta + (type === 'revolute' ? q[i] : 0)), shift(0, d + (type === 'prismatic' ? q[i] : 0)));
    const X = times(rotateX(alpha), shift(a, 0));
    T = times(T, convention === 'standard' ? times(Z, X) : times(X, Z));
    frames.push(T);
  });
  return { frames, tcp: times(T, tool ? rowsOf(tool) : unit) };
}

/** @param {string} name @returns {unknown} */
const readFixture = (name) =>
  JSON.parse(readFileSync(new URL(`../../fixtures/kinematics/${name}`, import.meta.url), 'utf8'));

/** @typedef {'puma560' | 'ur5' | 'scara_cobra600' | 'planar2r'} ArmName */
export const ARMS = /** @type {const} */ (['puma560', 'ur5', 'scara_cobra600', 'planar2r']);

/** @typedef {[JointRow['type'], number, number, number, number, number, number]} JointLine */
const armTable = /** @type {{ arms: Record<ArmName, { joints: JointLine[] }> }} */ (readFixture('arms.json')).arms;

/** @param {ArmName} name @param {number} [scale] of every length @returns {{ convention: 'standard', joints: Required<JointRow>[] }} */
export const arm = (name, scale = 1) => ({
  convention: 'standard',
  joints: armTable[name].joints.map(([type, a, alpha, d, theta, lower, upper]) => {
    const unit = type === 'prismatic' ? scale : 1;
    return { type, a: a * scale, alpha, d: d * scale, theta, lower: lower * unit, upper: upper * unit };
  }),
});

/** @typedef {{ q: number[][], tcp: number[][], frames: number[][], jacobians: number[][] }} ForwardCases */
export const forwardCases = /** @type {{ arms: Record<ArmName, ForwardCases> }} */ (readFixture('forward.json')).arms;

/** @typedef {{ reachable: number[][], nearSingular?: number[][], unreachable?: [string, ...number[]][] }} InverseCases */
export const inverseCases = /** @type {{ arms: Record<ArmName, InverseCases> }} */ (readFixture('inverse.json')).arms;

const between = (/** @type {number} */ min, /** @type {number} */ max) => fc.double({ min, max, noNaN: true });
export const anyLength = fc.oneof(fc.constant(0), between(-1, 1));
export const anyAngle = fc.oneof(fc.constantFrom(0, Math.PI / 2, -Math.PI / 2, Math.PI), between(-3, 3));

/** A pose anywhere near, turned anyhow. */
export const anyPose = fc
  .tuple(
    fc.array(between(-1, 1), { minLength: 3, maxLength: 3 }),
    fc.array(between(-1, 1), { minLength: 3, maxLength: 3 }),
    between(0, Math.PI),
  )
  .map(([p, axis, angle]) =>
    columnMajor(rigid(Math.hypot(...axis) < 1e-3 ? rodrigues([0, 0, 1], angle) : rodrigues(axis, angle), p)),
  );

/** @type {fc.Arbitrary<JointRow>} */
const anyJoint = fc.record({
  type: fc.constantFrom('revolute', 'revolute', 'prismatic'),
  a: anyLength,
  alpha: anyAngle,
  d: anyLength,
  theta: anyAngle,
});

/** Any chain of 1 to 7 joints, with a posture. @type {fc.Arbitrary<{ description: ChainDescription, q: number[] }>} */
export const anyChain = fc
  .record({
    convention: fc.constantFrom('standard', 'modified'),
    base: fc.option(anyPose, { nil: undefined }),
    tool: fc.option(anyPose, { nil: undefined }),
    joints: fc.array(anyJoint, { minLength: 1, maxLength: 7 }),
  })
  .chain((description) =>
    fc.record({
      description: fc.constant(description),
      q: fc.array(between(-3, 3), { minLength: description.joints.length, maxLength: description.joints.length }),
    }),
  );

/** What the arm is about as large as, for tolerances. @param {ChainDescription} description */
export const sizeOf = ({ base, tool, joints }) =>
  [base, tool].reduce((sum, T) => sum + (T ? Math.hypot(T[12], T[13], T[14]) : 0), 1) +
  joints.reduce((sum, { a, d, type }) => sum + Math.hypot(a, Math.abs(d) + (type === 'prismatic' ? 3 : 0)), 0);
