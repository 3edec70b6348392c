/**
 * The JavaScript peer closed-chain-ik 0.0.3 (G. Johnson) as a solver of the same question: thresholds that 1e-6 can be met
 * with, no rest pose, up to 30 iterations a start, and joint limits outside the solver, by full turns: inside it they lock
 * joints, and a third of the poses is lost. It is made for following a target that moves a little, so that tracking is its
 * fair comparison.
 *
 * It clamps the error that it works towards. Without the clamps it needs fewer iterations a start and many more starts; with
 * those below, the best of a dozen that were tried, it takes a third less time. Both are reported.
 *
 * @import { Arm } from './arms.mjs'
 */
import { SOLVE_STATUS } from 'closed-chain-ik/src/core/ChainSolver.js';
import { Goal } from 'closed-chain-ik/src/core/Goal.js';
import { Joint } from 'closed-chain-ik/src/core/Joint.js';
import { Link } from 'closed-chain-ik/src/core/Link.js';
import { Solver } from 'closed-chain-ik/src/core/Solver.js';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { createChain } from '../src/kinematics/chain.js';
import { tcpPose } from '../src/kinematics/forward.js';
import { createRandom } from '../src/kinematics/random.js';
import { TOLERANCE, isThere } from './arms.mjs';

/** Its numbers of the freedoms along and about z; its types have them as an enumeration that is not there at run time. */
const ALONG_Z = 2;
const ABOUT_Z = 5;

/** @typedef {{ translationErrorClamp: number, rotationErrorClamp: number }} Clamps */
/** @type {Clamps} */
export const BEST_CLAMPS = { translationErrorClamp: 0.15, rotationErrorClamp: 0.3 };
/** @type {Clamps} */
export const NO_CLAMPS = { translationErrorClamp: Infinity, rotationErrorClamp: Infinity };

const SETTINGS = {
  maxIterations: 30,
  translationConvergeThreshold: TOLERANCE,
  rotationConvergeThreshold: TOLERANCE / 2, // of a quaternion
  stallThreshold: 0,
  restPoseFactor: 0,
};

/** Few poses need more than twenty. */
const STARTS = 100;

const FULL_TURN = 2 * Math.PI;

/** What is fixed behind a joint: Rz(θ) Tz(d) Tx(a) Rx(α). @param {Arm['joints'][number]} joint */
export function linkMatrix({ a, alpha, d, theta }) {
  const [c, s, ca, sa] = [Math.cos(theta), Math.sin(theta), Math.cos(alpha), Math.sin(alpha)];
  return new Matrix4().set(c, -s * ca, s * sa, a * c, s, c * ca, -c * sa, a * s, 0, sa, ca, d, 0, 0, 0, 1);
}

/** @param {Arm} arm @param {Clamps} clamps */
export function createClosedChain(arm, clamps) {
  const position = new Vector3();
  const quaternion = new Quaternion();
  const scale = new Vector3();
  const freedoms = arm.joints.map(({ type }) => (type === 'revolute' ? ABOUT_Z : ALONG_Z));
  const root = new Link();
  let tip = root;
  let before = new Matrix4();
  const joints = arm.joints.map((row, i) => {
    const joint = new Joint();
    joint.setDoF(freedoms[i]);
    before.decompose(position, quaternion, scale);
    joint.setPosition(position.x, position.y, position.z);
    joint.setQuaternion(quaternion.x, quaternion.y, quaternion.z, quaternion.w);
    tip.addChild(joint);
    tip = new Link();
    joint.addChild(tip);
    before = linkMatrix(row);
    return joint;
  });
  before.decompose(position, quaternion, scale);
  tip.setPosition(position.x, position.y, position.z);
  tip.setQuaternion(quaternion.x, quaternion.y, quaternion.z, quaternion.w);
  const goal = new Goal();
  goal.makeClosure(tip);
  const solver = Object.assign(new Solver([root]), SETTINGS, clamps);
  const q = new Float64Array(arm.joints.length);
  const chain = createChain(arm);
  const T = new Float64Array(16);
  const target = new Matrix4();

  /** The posture inside the limits, if full turns bring it there. */
  function isInside() {
    return arm.joints.every(({ type, lower, upper }, i) => {
      let value = Number(joints[i].getDoFValue(freedoms[i]));
      if (type === 'revolute' && value < lower) value += FULL_TURN * Math.ceil((lower - value) / FULL_TURN);
      if (type === 'revolute' && value > upper) value -= FULL_TURN * Math.ceil((value - upper) / FULL_TURN);
      q[i] = value;
      return value >= lower && value <= upper;
    });
  }

  /** One descent from where the joints are. */
  function descend() {
    try {
      return Number(solver.solve()[0]) === Number(SOLVE_STATUS.CONVERGED);
    } catch {
      return false; // its elimination takes some systems for singular
    }
  }

  /**
   * Its matrices are in single precision, and now and then it is not where it thinks it is: then it starts anew.
   * @param {Float64Array} T_base_goal
   * @param {ArrayLike<number>} seed
   * @returns {Float64Array | null} a posture that is good until the next call
   */
  return function solve(T_base_goal, seed) {
    const random = createRandom(1);
    target.fromArray(T_base_goal).decompose(position, quaternion, scale);
    // Not by setPosition and setQuaternion: these pass over changes of less than 1e-5.
    goal.position.set([position.x, position.y, position.z]);
    goal.quaternion.set([quaternion.x, quaternion.y, quaternion.z, quaternion.w]);
    goal.setMatrixNeedsUpdate();
    for (let start = 0; start < STARTS; start++) {
      arm.joints.forEach(({ lower, upper }, i) => {
        joints[i].setDoFValue(freedoms[i], start === 0 ? seed[i] : lower + (upper - lower) * random());
      });
      if (descend() && isInside() && isThere(tcpPose(chain, q, T), T_base_goal)) return q;
    }
    return null;
  };
}
