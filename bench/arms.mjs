/**
 * What the benchmarks run on: the arms and poses of the test fixtures, and an independent judge of every answer.
 *
 * @import { ChainDescription } from '../src/kinematics/chain.js'
 * @import { JointRow } from '../src/kinematics/joint.js'
 */
import { readFileSync } from 'node:fs';
import { createRandom } from '../src/kinematics/random.js';

/** Of a joint of these arms the limits are known. @typedef {Required<JointRow>} ArmJoint */
/** @typedef {{ convention: 'standard', joints: ArmJoint[] }} Arm */
/** @typedef {[ArmJoint['type'], number, number, number, number, number, number]} JointLine */
/** @typedef {{ reachable: number[][], postures: number[][], unreachable?: [string, ...number[]][] }} InverseCases */

/** @param {string} name @returns {unknown} */
const readFixture = (name) =>
  JSON.parse(readFileSync(new URL(`../tests/fixtures/kinematics/${name}`, import.meta.url), 'utf8'));

const table = /** @type {{ arms: Record<string, { joints: JointLine[] }> }} */ (readFixture('arms.json')).arms;
const inverse = /** @type {{ arms: Record<string, InverseCases> }} */ (readFixture('inverse.json')).arms;

/** The arms that the figures of this folder are means over: four makers, a spherical wrist or none, a slide. */
export const FIVE_ARMS = ['puma560', 'ur5', 'kuka_kr6_r900', 'fanuc_lrmate200id', 'stanford'];

/** @param {string} name @returns {Arm} */
export const readArm = (name) => ({
  convention: 'standard',
  joints: table[name].joints.map(([type, a, alpha, d, theta, lower, upper]) => ({
    type,
    a,
    alpha,
    d,
    theta,
    lower,
    upper,
  })),
});

/** The three upper rows of a pose in a line → column-major. @param {readonly number[]} line */
const poseOf = (line) =>
  Float64Array.from({ length: 16 }, (_, i) => (i % 4 === 3 ? Number(i === 15) : line[4 * (i % 4) + Math.floor(i / 4)]));

/** @param {string} name @returns {Float64Array[]} */
export const reachablePoses = (name) => inverse[name].reachable.map(poseOf);

/** The postures that those poses were made of. @param {string} name */
export const reachablePostures = (name) => inverse[name].postures.map((q) => Float64Array.from(q));

/** @param {string} name */
export const unreachablePoses = (name) => (inverse[name].unreachable ?? []).map(([, ...line]) => poseOf(line));

/**
 * Postures uniformly inside the limits, always the same ones.
 * @param {Arm} arm
 * @param {number} count
 */
export function somePostures({ joints }, count) {
  const random = createRandom(20260705);
  return Array.from({ length: count }, () =>
    Float64Array.from(joints, ({ lower, upper }) => lower + (upper - lower) * random()),
  );
}

/** @param {Arm} arm @returns {Float64Array} */
export const middleOf = ({ joints }) => Float64Array.from(joints, ({ lower, upper }) => (lower + upper) / 2);

/**
 * T_base_tcp by multiplying matrices in full; shares nothing with the kernel.
 * @param {Arm} arm
 * @param {ArrayLike<number>} q
 * @returns {Float64Array} column-major
 */
export function judgePose({ joints }, q) {
  let T = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]; // row by row
  joints.forEach(({ type, a, alpha, d, theta }, i) => {
    const turn = theta + (type === 'revolute' ? q[i] : 0);
    const along = d + (type === 'prismatic' ? q[i] : 0);
    const [c, s, ca, sa] = [Math.cos(turn), Math.sin(turn), Math.cos(alpha), Math.sin(alpha)];
    const A = [c, -s * ca, s * sa, a * c, s, c * ca, -c * sa, a * s, 0, sa, ca, along, 0, 0, 0, 1];
    T = T.map((_, at) => [0, 1, 2, 3].reduce((sum, k) => sum + T[at - (at % 4) + k] * A[4 * k + (at % 4)], 0));
  });
  return Float64Array.from(T, (_, at) => T[4 * (at % 4) + Math.floor(at / 4)]);
}

/** What every solver is asked for: metres and radians. */
export const TOLERANCE = 1e-6;

/**
 * Whether a posture is an answer: inside the limits, and there.
 * @param {Arm} arm
 * @param {ArrayLike<number>} q
 * @param {ArrayLike<number>} goal
 */
export const isSolved = (arm, q, goal) =>
  arm.joints.every(({ lower, upper }, i) => q[i] >= lower && q[i] <= upper) && isThere(judgePose(arm, q), goal);

/** @param {ArrayLike<number>} T @param {ArrayLike<number>} goal */
export function isThere(T, goal) {
  const distance = Math.hypot(T[12] - goal[12], T[13] - goal[13], T[14] - goal[14]);
  let chord = 0;
  for (let k = 0; k < 12; k++) chord += (T[k] - goal[k]) ** 2;
  const angle = 2 * Math.asin(Math.min(1, Math.sqrt(chord / 8)));
  return distance <= TOLERANCE && angle <= TOLERANCE;
}
