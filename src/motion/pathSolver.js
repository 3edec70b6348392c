/**
 * Postures that have the tool at a share of a way, found from a posture near by on the same branch, with the rates and
 * accelerations of the joints by the share. Nothing here keeps to limits or says why there is no posture.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Knot } from './hermite.js'
 * @import { TaskName } from '../kinematics/descent/task.js'
 * @import { ToolPath } from './toolPath.js'
 *
 * @typedef {Knot & { J: Float64Array, determinant: number, off: Miss }} PathKnot   off: what of the tool's place and turn, and
 *   their first two derivatives, was not met
 * @typedef {{ position: Float64Array, turn: Float64Array }} Miss   3 each: of the pose, its first and its second derivative
 */
import { lesserTasks, uprightOf } from '../kinematics/descent/lesserTasks.js';
import { shapeJacobian, shapeResidual, taskTurn } from '../kinematics/descent/task.js';
import { tcpPose } from '../kinematics/forward.js';
import { geometricJacobian } from '../kinematics/jacobian.js';
import { poseDifference } from '../kinematics/pose.js';
import { createToolSystem } from './toolSystem.js';

/** Next to a singularity each step only halves what is left, or so. */
const MOST_STEPS = 24;

/** After the first steps each has to leave less than this share of what was left; beside a singularity it is a quarter. */
const SLOWEST = 0.7;
const FREE_STEPS = 3;

/** A joint that is sent farther than this by one step (radians, arm lengths) is sent elsewhere. */
const MOST_CORRECTION = 0.5;

/** A step that leaves more than this share of what was left, and not more than it, gains nothing. */
const AT_REST = 0.99;

/** @param {number} dof @returns {PathKnot} */
export const createKnot = (dof) => ({
  q: new Float64Array(dof),
  first: new Float64Array(dof),
  second: new Float64Array(dof),
  J: new Float64Array(6 * dof),
  determinant: 0,
  off: { position: new Float64Array(3), turn: new Float64Array(3) },
});

/**
 * @param {Chain} chain
 * @param {ToolPath} path   seen from the chain's root
 * @param {number} solved   a pose is met to so many arm lengths and radians
 * @param {{ place: number, turn: number }} [missed]   m, rad: an arm that has too few joints may rest so far from a pose
 */
export function createPathSolver(chain, path, solved, missed = { place: 0, turn: 0 }) {
  const { dof, characteristicLength: length } = chain;
  const task = /** @type {TaskName} */ (lesserTasks(chain)[0]?.name ?? 'pose');
  const up = task === 'pose' ? [0, 0, 1] : uprightOf(chain);
  const system = createToolSystem(dof);
  const goal = new Float64Array(16);
  const T = new Float64Array(16);
  const J = new Float64Array(6 * dof);
  const twist = new Float64Array(6);
  const change = new Float64Array(6);
  const residual = new Float64Array(6);
  const step = new Float64Array(dof);

  /** What is left to the goal at q, into `residual`; with the Jacobian there, both as the task has them. @param {Float64Array} q @param {Float64Array} whole */
  function look(q, whole) {
    tcpPose(chain, q, T);
    poseDifference(T, goal, residual);
    geometricJacobian(chain, q, whole);
    J.set(whole);
    if (task === 'pose') return;
    taskTurn(task, up, T, goal, residual);
    shapeResidual(task, 0, residual);
    shapeJacobian(task, 0, J);
  }

  const placeLeft = () => Math.hypot(residual[0], residual[1], residual[2]);
  const turnLeft = () => Math.hypot(residual[3], residual[4], residual[5]);
  const left = () => Math.max(placeLeft() / length, turnLeft());
  const isNear = () => task !== 'pose' && placeLeft() <= missed.place && turnLeft() <= missed.turn;

  /** What a twist or its derivative is of the task. @param {Float64Array} vector */
  function shape(vector) {
    if (task !== 'pose') shapeJacobian(task, 0, vector);
  }

  /** How far J x is from b, into place k of what is missed. @param {Float64Array} b @param {Float64Array} x @param {PathKnot['off']} off @param {number} k */
  function miss(b, x, off, k) {
    for (let row = 0; row < 6; row++) {
      let sum = b[row];
      for (let i = 0; i < dof; i++) sum -= J[6 * i + row] * x[i];
      residual[row] = sum;
    }
    off.position[k] = placeLeft();
    off.turn[k] = turnLeft();
  }

  return {
    task,

    /**
     * @param {number} share
     * @param {Float64Array} near   a posture that is nearly there
     * @param {PathKnot} knot   filled; its rates and accelerations are taken for a guess
     * @returns {boolean}
     */
    solve(share, near, knot) {
      const { q } = knot;
      q.set(near);
      path.poseAt(share, goal);
      look(q, knot.J);
      for (let left0 = Infinity, steps = 0; ; steps++) {
        const now = left();
        // one more step than is needed costs little, and leaves the last digits only
        if (now <= solved && (now > left0 / 4 || now < 1e-14 || steps === 0)) break;
        if (now > AT_REST * left0 && now < left0 / AT_REST && isNear()) break;
        const isSlow = steps > FREE_STEPS && now > SLOWEST * left0 && !isNear(); // it slows down where it comes to rest
        if (steps === MOST_STEPS || !(now < Infinity) || isSlow) return false;
        left0 = now;
        system.set(J, length);
        step.fill(0);
        system.solve(residual, step);
        for (let i = 0; i < dof; i++) {
          if (!(Math.abs(step[i]) < MOST_CORRECTION * (chain.joints[i].type === 'prismatic' ? length : 1)))
            return false;
          q[i] += step[i];
        }
        look(q, knot.J);
      }
      knot.off.position[0] = placeLeft();
      knot.off.turn[0] = turnLeft();
      system.set(J, length);
      knot.determinant = system.determinant;
      path.motionAt(share, twist, change);
      shape(twist);
      system.solve(twist, knot.first);
      miss(twist, knot.first, knot.off, 1);
      subtractBias(knot.J, knot.first, change);
      shape(change);
      system.solve(change, knot.second);
      miss(change, knot.second, knot.off, 2);
      return true;
    },
  };
}

/**
 * What the tool's twist changes by while no rate does: with W the turning rates of the joints up to this one added up, that of
 * place is Σ (W_i + W_{i−1}) × v_i q̇_i and of turning Σ W_{i−1} × ω_i q̇_i (the kinematic Hessian, summed from the base on).
 * @param {Float64Array} J
 * @param {Float64Array} rates
 * @param {Float64Array} out   6, less that
 */
function subtractBias(J, rates, out) {
  let [x, y, z] = [0, 0, 0];
  for (let i = 0, at = 0; i < rates.length; i++, at += 6) {
    const rate = rates[i];
    const [vx, vy, vz] = [J[at] * rate, J[at + 1] * rate, J[at + 2] * rate];
    const [wx, wy, wz] = [J[at + 3] * rate, J[at + 4] * rate, J[at + 5] * rate];
    const [sx, sy, sz] = [2 * x + wx, 2 * y + wy, 2 * z + wz];
    out[0] -= sy * vz - sz * vy;
    out[1] -= sz * vx - sx * vz;
    out[2] -= sx * vy - sy * vx;
    out[3] -= y * wz - z * wy;
    out[4] -= z * wx - x * wz;
    out[5] -= x * wy - y * wx;
    x += wx;
    y += wy;
    z += wz;
  }
}
