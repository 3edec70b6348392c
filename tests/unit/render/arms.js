/**
 * Arms to draw, and a second opinion on where their links are: 4×4 arrays of rows multiplied straight from the book (Spong,
 * equation 3.10; Craig, equation 3.6), sharing nothing with the kernel or the scene.
 *
 * @import { JointRow } from '../../../src/kinematics/joint.js'
 * @import { Part } from '../../../src/render/arm/armParts.js'
 *
 * @typedef {number[][]} Rows  a homogeneous transform, row by row
 */
import fc from 'fast-check';
import { createChain } from '../../../src/kinematics/chain.js';
import { compileRobot } from '../../../src/model/compile.js';
import { LIBRARY } from '../../../src/model/library.js';
import { solidOf } from '../../../src/render/arm/solid.js';

export const libraryArms = Object.entries(LIBRARY).map(
  ([id, robot]) => /** @type {const} */ ([id, compileRobot(robot)]),
);

const RIGHT = Math.PI / 2;
const length = fc.oneof(fc.constant(0), fc.double({ min: -1, max: 1, noNaN: true }));
const angle = fc.oneof(fc.constantFrom(0, RIGHT, -RIGHT, Math.PI), fc.double({ min: -4, max: 4, noNaN: true }));
const limits = fc.oneof(
  fc.constant({}),
  fc.double({ min: -1, max: 1, noNaN: true }).map((lower) => ({ lower })),
  fc
    .tuple(fc.double({ min: -7, max: 0, noNaN: true }), fc.double({ min: 0, max: 7, noNaN: true }))
    .map(([lower, upper]) => ({ lower, upper })),
);

/** @type {fc.Arbitrary<JointRow>} */
export const anyRow = fc
  .tuple(
    fc.record({ type: fc.constantFrom('revolute', 'prismatic'), a: length, alpha: angle, d: length, theta: angle }),
    limits,
  )
  .map(([row, limit]) => /** @type {JointRow} */ ({ ...row, ...limit }));

/** Rows and, for each, a joint value. */
export const anyRows = fc.array(fc.tuple(anyRow, fc.double({ min: -3, max: 3, noNaN: true })), {
  minLength: 2,
  maxLength: 6,
});

/** Chains in both conventions, from toys to cranes. */
export const anyChain = fc
  .record({ rows: anyRows, convention: fc.constantFrom('standard', 'modified'), scale: fc.constantFrom(0.02, 1, 20) })
  .map(({ rows, convention, scale }) => ({
    chain: createChain({
      convention: /** @type {'standard' | 'modified'} */ (convention),
      joints: rows.map(([row]) => ({ ...row, a: row.a * scale, d: row.d * scale })),
    }),
    q: rows.map(([row, value]) => (row.type === 'prismatic' ? value * scale : value)),
  }));

/** @param {Rows} A @param {Rows} B @returns {Rows} */
export const times = (A, B) =>
  A.map((row) => B[0].map((_, j) => row.reduce((sum, value, k) => sum + value * B[k][j], 0)));

/** @param {Rows} A @param {ArrayLike<number>} p @returns {number[]} */
export const apply = (A, p) => [0, 1, 2].map((i) => A[i][0] * p[0] + A[i][1] * p[1] + A[i][2] * p[2] + A[i][3]);

/** The inverse of a rigid transform. @param {Rows} A @returns {Rows} */
export const inverse = (A) => [
  ...[0, 1, 2].map((i) => [A[0][i], A[1][i], A[2][i], -(A[0][i] * A[0][3] + A[1][i] * A[1][3] + A[2][i] * A[2][3])]),
  [0, 0, 0, 1],
];

/** @param {ArrayLike<number>} T column by column @returns {Rows} */
export const rowsOf = (T) => [0, 1, 2, 3].map((i) => [T[i], T[4 + i], T[8 + i], T[12 + i]]);

/** @param {number} t @returns {Rows} */
const turnZ = (t) => [
  [Math.cos(t), -Math.sin(t), 0, 0],
  [Math.sin(t), Math.cos(t), 0, 0],
  [0, 0, 1, 0],
  [0, 0, 0, 1],
];
/** @param {number} t @returns {Rows} */
const turnX = (t) => [
  [1, 0, 0, 0],
  [0, Math.cos(t), -Math.sin(t), 0],
  [0, Math.sin(t), Math.cos(t), 0],
  [0, 0, 0, 1],
];
/** @param {number} x @param {number} z @returns {Rows} */
const shift = (x, z) => [
  [1, 0, 0, x],
  [0, 1, 0, 0],
  [0, 0, 1, z],
  [0, 0, 0, 1],
];

/**
 * Frame 0 … frame n.
 * @param {'standard' | 'modified'} convention
 * @param {readonly JointRow[]} joints
 * @param {ArrayLike<number>} q
 * @returns {Rows[]}
 */
export function framesByHand(convention, joints, q) {
  const frames = [shift(0, 0)];
  joints.forEach(({ type, a, alpha, d, theta }, i) => {
    const [angleZ, alongZ] = type === 'revolute' ? [theta + q[i], d] : [theta, d + q[i]];
    const aboutZ = times(turnZ(angleZ), shift(0, alongZ));
    const aboutX = times(shift(a, 0), turnX(alpha));
    const step = convention === 'standard' ? times(aboutZ, aboutX) : times(aboutX, aboutZ);
    frames.push(times(frames[i], step));
  });
  return frames;
}

/**
 * Where the corners of a part are, seen from the world.
 * @param {Pick<Part, 'shape' | 'pose'>} part
 * @param {Rows} link  the frame of its link
 * @returns {number[][]}
 */
export function placed({ shape, pose }, link) {
  const { positions } = solidOf(shape);
  const T = times(link, rowsOf(pose));
  return Array.from({ length: positions.length / 3 }, (_, i) => apply(T, positions.slice(3 * i, 3 * i + 3)));
}

/** The least and the greatest coordinate along an axis. @param {number[][]} points @param {0 | 1 | 2} axis @returns {[number, number]} */
export function rangeOf(points, axis) {
  const values = points.map((point) => point[axis]);
  return [Math.min(...values), Math.max(...values)];
}
