/**
 * What an arm whose turning axes are all parallel (a planar arm, a SCARA, a gantry) can never do, known without a search:
 * its tool turns about one direction u of space and no other, so the angle between u and anything on the tool stays.
 *
 * @import { Chain } from './chain.js'
 * @import { TaskName } from './descent/task.js'
 */
import { linkFrames, tcpPose } from './forward.js';
import { ROW, SIN_TWIST } from './packed.js';
import { poseDifference, skewness } from './pose.js';

/**
 * @param {Chain} chain
 * @returns {number} the joint whose axis all turning joints are parallel to, or −1 if they are not, or none turns
 */
export function leadingJoint({ joints, packed }) {
  const first = joints.findIndex(({ type }) => type === 'revolute');
  const last = joints.findLastIndex(({ type }) => type === 'revolute');
  for (let i = first; i < last; i++) if (packed.rows[ROW * i + SIN_TWIST] !== 0) return -1;
  return first;
}

/** Radians that a product of frames may be off by, with room to spare. */
const ROUNDING = 1e-13;

/** Of angles between axes that are off by their skewness and by rounding: each is off by no more than this many times it. */
const DOUBT = 4;

/**
 * The orientation that a task asks for is missed by at least this angle, whatever the posture and its limits.
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {TaskName} task
 * @returns {number} radians; 0 also where nothing is known
 */
export function certainTurn(chain, T_base_goal, task) {
  const { start, tool } = chain.packed;
  const doubt = DOUBT * (skewness(start) + skewness(tool) + skewness(T_base_goal) + ROUNDING);
  return Math.max(0, leastTurn(chain, T_base_goal, task) - doubt);
}

/**
 * The same, as if all axes were orthonormal.
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {TaskName} task
 */
function leastTurn(chain, T_base_goal, task) {
  const leader = leadingJoint(chain);
  if (leader < 0 || !(task === 'pose' || task === 'position-and-tilt')) return 0;
  const q = new Float64Array(chain.dof);
  const frame = 16 * (chain.convention === 'standard' ? leader : leader + 1);
  const u = linkFrames(chain, q).subarray(frame + 8, frame + 11);
  const T = tcpPose(chain, q);
  const G = T_base_goal;
  // The quaternion (cos, v sin) of the turn that is missing, less its part about u (swing–twist decomposition). What is
  // across u is taken as a vector: squares subtracted would leave half the digits, and call possible things impossible.
  const [x, y, z] = poseDifference(T, G).subarray(3);
  const half = Math.hypot(x, y, z) / 2;
  if (half === 0) return 0;
  const about = (x * u[0] + y * u[1] + z * u[2]) / 2;
  const across = Math.hypot(x / 2 - about * u[0], y / 2 - about * u[1], z / 2 - about * u[2]);
  const sine = Math.sin(half) / half;
  return 2 * Math.atan2(sine * across, Math.hypot(Math.cos(half), sine * about));
}
