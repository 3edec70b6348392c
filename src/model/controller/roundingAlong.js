/**
 * What decimals cost the tool on the way of a joint move. The decimals of a position leave the joints open, by so much the more the
 * nearer its posture is to a singular one; there they make up for each other, on the way they do not.
 *
 * @import { Doc } from '../document.js'
 * @import { CodeMove } from './codeMoves.js'
 * @import { Deviation } from './moveMargins.js'
 */
import { solveCholesky } from '../../kinematics/cholesky.js';
import { geometricJacobian } from '../../kinematics/jacobian.js';
import { createSvd, decompose } from '../../kinematics/measures/singularValues.js';
import { pathMomentAt } from '../../motion/posturePath.js';
import { fromKernel, toKernel } from '../units.js';
import { DECIMALS_COST, jointsOff, takenAlong } from './moveMargins.js';

const UNITS = /** @type {const} */ ({ length: 'mm', angle: 'deg' });
const SHARES = [0.25, 0.5, 0.75];

/** Joints of an arm that meets whole poses: of others, joint moves are written as joint values. */
const FULL = 6;

/** What a position may be off by: its place (m), its turn (rad). */
const OFF = {
  place: toKernel('length', Math.sqrt(3) * DECIMALS_COST, UNITS),
  turn: toKernel('angle', 3 * DECIMALS_COST, UNITS),
};

/**
 * Between the ends of a joint move, where each is off by its own decimals, to the first order.
 * @param {Doc} doc
 * @param {CodeMove | null} before   the move that the arm comes from; null: it stands where it begins exactly
 * @param {CodeMove} done
 * @returns {Deviation}
 */
export function roundingAlong({ robot }, before, done) {
  const worst = { millimetres: 0, degrees: 0 };
  if (done.motion !== 'joint') return worst;
  const { chain, path } = done.followed;
  const [from, to] = [before, done].map((move) => move && endOf(robot, move));
  for (const share of SHARES) {
    const q = pathMomentAt(path, share).posture.slice();
    const [first, last] = [from, to].map((cost) => cost?.(chain, q) ?? { millimetres: 0, degrees: 0 });
    for (const unit of /** @type {const} */ (['millimetres', 'degrees']))
      worst[unit] = Math.max(worst[unit], (1 - share) * first[unit] + share * last[unit]);
  }
  return worst;
}

/**
 * What the tool is off by in another posture, where the joints are off as they may be at the end of a move.
 * @param {Doc['robot']} robot
 * @param {CodeMove} move
 * @returns {(chain: CodeMove['followed']['chain'], q: Float64Array) => Deviation}
 */
function endOf(robot, { followed: { chain, end }, isJoint }) {
  if (isJoint || chain.dof !== FULL) {
    const off = isJoint ? jointsOff(robot, chain, end) : chain.joints.map(() => 0);
    return (other, q) => takenAlong(other, q, off);
  }
  const joints = inverseColumns(geometricJacobian(chain, end));
  return (other, q) => {
    const J = geometricJacobian(other, q);
    const part = (/** @type {0 | 3} */ row, /** @type {0 | 3} */ column) => largestGain(J, joints, row, column);
    return {
      millimetres: fromKernel('length', part(0, 0) * OFF.place + part(0, 3) * OFF.turn, UNITS),
      degrees: fromKernel('angle', part(3, 0) * OFF.place + part(3, 3) * OFF.turn, UNITS),
    };
  };
}

/** The joints' answers to the six unit twists; none in a singular posture. @param {Float64Array} J  6 · 6, column-major */
function inverseColumns(J) {
  const H = new Float64Array(FULL * FULL);
  for (let i = 0; i < FULL; i++)
    for (let j = 0; j <= i; j++) for (let k = 0; k < FULL; k++) H[FULL * i + j] += J[FULL * i + k] * J[FULL * j + k];
  return Array.from({ length: FULL }, (_, k) => {
    const column = Float64Array.from({ length: FULL }, (__, i) => J[FULL * i + k]);
    return solveCholesky(H, column, column) ? column : column.fill(0);
  });
}

const svd = createSvd(3, 3);

/**
 * How much the place (row 0) or the turn (3) of the tool goes at most for a unit of the place (column 0) or turn (3) at the end.
 * @param {Float64Array} J
 * @param {readonly Float64Array[]} joints
 * @param {0 | 3} row
 * @param {0 | 3} column
 */
function largestGain(J, joints, row, column) {
  const block = new Float64Array(9);
  for (let c = 0; c < 3; c++)
    for (let r = 0; r < 3; r++)
      joints[column + c].forEach((rate, i) => (block[3 * c + r] += J[FULL * i + row + r] * rate));
  return decompose(block, svd).values[0];
}
