/**
 * Chains built to have a wrist, and what the tests of their solver ask of its answers: all by the plain matrices of
 * oracle.js.
 * @import { Candidates } from '../../../src/kinematics/solvers/candidates.js'
 * @import { ChainDescription } from '../../../src/kinematics/chain.js'
 * @import { Convention, JointRow } from '../../../src/kinematics/joint.js'
 */
import { createChain } from '../../../src/kinematics/chain.js';
import { goalFromStart, screwsOf } from '../../../src/kinematics/screws.js';
import { recogniseWristPartition, solveWristPartition } from '../../../src/kinematics/solvers/wristPartition.js';
import { angleBetween, columnMajor, distanceBetween, oracleForward } from './oracle.js';

export const RIGHT = Math.PI / 2;

/**
 * @typedef {[a: number, alpha: number, d: number, theta?: number, type?: 'slides']} Row
 * @param {readonly Row[]} rows
 * @param {Convention} [convention]
 */
export const table = (rows, convention = 'standard') => ({
  convention,
  joints: rows.map(([a, alpha, d, theta = 0, type]) => ({
    type: /** @type {JointRow['type']} */ (type ? 'prismatic' : 'revolute'),
    a,
    alpha,
    d,
    theta,
  })),
});

/** @param {ChainDescription} description */
export function prepare(description) {
  const chain = createChain(description);
  const constants = recogniseWristPartition(screwsOf(chain));
  if (constants === null) throw new Error('Expected the arm to be recognised.');
  return { chain, constants };
}

/** @param {ChainDescription} description @param {ArrayLike<number>} T_base_goal @returns {Candidates} */
export function solve(description, T_base_goal) {
  const { chain, constants } = prepare(description);
  return solveWristPartition(constants, goalFromStart(chain, T_base_goal));
}

/** @param {ChainDescription} description @param {ArrayLike<number>} q */
export const poseAt = (description, q) => columnMajor(oracleForward(description, q).tcp);

/**
 * How far a posture is from the pose of another one; metres and radians alike.
 * @param {ChainDescription} description
 * @param {ArrayLike<number>} p
 * @param {ArrayLike<number>} q
 */
export function miss(description, p, q) {
  const [there, goal] = [oracleForward(description, p).tcp, oracleForward(description, q).tcp];
  return Math.max(distanceBetween(there, goal), angleBetween(there, goal));
}

/**
 * How far apart two postures are, full turns aside.
 * @param {ChainDescription} description
 * @param {ArrayLike<number>} p
 * @param {ArrayLike<number>} q
 */
export const apart = ({ joints }, p, q) =>
  Math.max(
    ...joints.map(({ type }, i) =>
      type === 'revolute' ? Math.abs(2 * Math.sin((p[i] - q[i]) / 2)) : Math.abs(p[i] - q[i]),
    ),
  );

/** @param {ChainDescription} description @param {Candidates} candidates @param {ArrayLike<number>} q */
export const nearest = (description, { postures }, q) =>
  Math.min(Infinity, ...postures.map((p) => apart(description, p, q)));

/**
 * The worst miss of everything that was found.
 * @param {ChainDescription} description
 * @param {Candidates} candidates
 * @param {ArrayLike<number>} q
 */
export const worst = (description, { postures, families }, q) =>
  Math.max(0, ...[...postures, ...families.map((family) => family.q)].map((p) => miss(description, p, q)));

/**
 * Candidates that meet the pose: an arm of few joints also has some that come near and are for the caller to throw out.
 * @param {ChainDescription} description
 * @param {Candidates} candidates
 * @param {ArrayLike<number>} q
 */
export const met = (description, { postures }, q) => postures.filter((p) => miss(description, p, q) < 1e-9);

/**
 * How many pairs are the same posture.
 * @param {ChainDescription} description
 * @param {readonly Float64Array[]} postures
 */
export const repeats = (description, postures) =>
  postures.filter((p, i) => postures.slice(0, i).some((other) => apart(description, p, other) < 1e-6)).length;

/**
 * Away from what would make an arm degenerate.
 * @param {() => number} random
 * @param {number} low
 * @param {number} high
 */
const eitherWay = (random, low, high) => (random() < 0.5 ? -1 : 1) * (low + (high - low) * random());

/** @param {() => number} random */
const generic = (random) => ({
  length: () => eitherWay(random, 0.1, 0.6),
  twist: () => eitherWay(random, 0.3, 1.3) + (random() < 0.3 ? RIGHT : 0),
  angle: () => eitherWay(random, 0.05, 3),
});

/** What tables are full of, now and then something else. @param {() => number} random */
const special = (random) => ({
  length: () => (random() < 0.4 ? 0 : eitherWay(random, 0.1, 0.6)),
  twist: () => [0, RIGHT, -RIGHT, Math.PI, eitherWay(random, 0.3, 1.3)][Math.floor(5 * random())],
  angle: () => [0, RIGHT, -RIGHT, Math.PI, eitherWay(random, 0.05, 3)][Math.floor(5 * random())],
});

/**
 * Any arm of `regional` joints (P slides, R turns) before a wrist of 0 to 3, with a posture. `isBackwards` turns it
 * round, so that its first axes meet.
 * @param {() => number} random
 * @param {string} regional
 * @param {number} wrist
 * @param {{ isBackwards?: boolean, isSpecial?: boolean }} [options]  isSpecial: parallel axes and lengths of zero,
 *   perhaps a joint too many
 * @returns {{ description: ChainDescription, q: number[] }}
 */
export function anyPartitioned(random, regional, wrist, { isBackwards = false, isSpecial = false } = {}) {
  const kinds = [...regional, ...'R'.repeat(wrist)];
  const first = regional.length;
  const { length, twist, angle } = (isSpecial ? special : generic)(random);
  const rows = kinds.map((kind, i) => {
    const isInside = i >= first && i < first + wrist - 1;
    return {
      type: /** @type {JointRow['type']} */ (kind === 'P' ? 'prismatic' : 'revolute'),
      a: isInside ? 0 : length(),
      alpha: isInside ? generic(random).twist() : twist(),
      d: isInside && i > first ? 0 : length(),
      theta: angle(),
    };
  });
  const q = kinds.map((kind) => (kind === 'P' ? eitherWay(random, 0, 0.6) : eitherWay(random, 0, Math.PI)));
  if (!isBackwards) return { description: { convention: 'standard', joints: rows }, q };
  // The inverse of a standard row is a modified one: Rx(−α) Tx(−a) · Tz(−d) Rz(−θ).
  const joints = rows
    .toReversed()
    .map(({ type, a, alpha, d, theta }) => ({ type, a: -a, alpha: -alpha, d: -d, theta: -theta }));
  return { description: { convention: 'modified', joints }, q: q.toReversed() };
}
