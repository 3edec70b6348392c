/**
 * The joints along a way of the tool: postures so close together that between them, with every joint going at a constant
 * rate, the tool keeps to the way as exactly as promised. Always on the branch of solutions on which it begins; where the
 * way cannot be followed it says from where on, and why.
 *
 * The promise is a bound, not a sample. Let q go from one posture to the next as q + λ Δq while the way is covered evenly. What
 * the tool is off the way vanishes at both ends, so it is at most an eighth of its largest second derivative in between. That
 * of the place is at most Σᵢⱼ |Δqᵢ Δqⱼ| ρ of the outer of both joints, ρⱼ being the distance of the TCP from axis j (1 where a slide
 * is the outer and a turn the inner, 0 where a slide is the inner), and of a circle its own length² / radius; ρⱼ
 * itself grows between them by no more than the joints beyond j can move the TCP. The rate of turning changes by at most
 * Σ_{i<j} |Δqᵢ Δqⱼ|; of its eighth twice is taken, for what turns that do not commute add while no piece turns far.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Followed } from '../kinematics/follow.js'
 * @import { TaskName } from '../kinematics/descent/task.js'
 * @import { ToolPath } from './toolPath.js'
 *
 * @typedef {object} FollowedPath
 * @property {'done'} status
 * @property {number[]} shares            of the way, from 0 to 1
 * @property {Float64Array[]} postures    one a share
 * @property {number} positionDeviation   m, at most
 * @property {number} turnDeviation       rad, at most; of no account where the task leaves the orientation free
 * @property {TaskName} task              what of the way's poses is met: the whole, or what an arm with fewer joints can
 *
 * @typedef {object} PathRefusal
 * @property {'refused'} status
 * @property {Exclude<Followed['status'], 'there' | 'behind'> | 'start'} reason   start: the posture to begin with is not there
 * @property {number} [joint]   with limit: the joint that would have to go past it
 * @property {number} share     where it can be followed to, to a millionth of the way
 * @property {Float64Array} posture   there
 */
import { requirePositive, requirePosture } from '../kinematics/checks.js';
import { followPose } from '../kinematics/follow.js';
import { tcpPose } from '../kinematics/forward.js';
import { geometricJacobian } from '../kinematics/jacobian.js';
import { poseDifference } from '../kinematics/pose.js';

const HUNDREDTH_DEGREE = 1.745e-4; // rad, rounded down

const FIRST_PIECE = 0.05;
const LEAST_PIECE = 1e-6;

/** No joint goes farther than this from one posture to the next: radians, or metres of a slide over the arm's length. */
const MOST_STEP = 0.1;

/** Of the piece that would just keep the promise, so much is tried next. */
const CAUTION = 0.85;

/** The postures themselves are on the way to this: metres over the arm's length, radians. */
const SOLVED = 1e-10;

/** Shares of the way at which it shows why it ends. */
const LOOK_AHEAD = [1e-3, 1e-2, 0.05];

const difference = new Float64Array(6);

/**
 * @param {Chain} chain
 * @param {ToolPath} path    seen from the chain's root
 * @param {ArrayLike<number>} begin   a posture that has the tool where the way begins
 * @param {{ positionDeviation?: number, turnDeviation?: number }} [promise]  m and rad; 0.01 mm and 0.01° if nothing is said
 * @returns {FollowedPath | PathRefusal}
 */
export function followPath(chain, path, begin, promise = {}) {
  const { positionDeviation = 1e-5, turnDeviation = HUNDREDTH_DEGREE } = promise;
  requirePosture(chain.dof, begin);
  requirePositive('positionDeviation', positionDeviation);
  requirePositive('turnDeviation', turnDeviation);
  const tolerances = { positionTolerance: SOLVED * chain.characteristicLength, orientationTolerance: SOLVED };

  const first = followPose(chain, { q: begin }, path.poseAt(0), { ...tolerances, mostStep: MOST_STEP });
  const isThere = first.status === 'there' && farthest(chain, begin, first.q) < 1e-6;
  if (!isThere) return { status: 'refused', reason: 'start', share: 0, posture: Float64Array.from(begin) };

  const { task } = first;
  const keepsTurn = task === 'pose';
  const shares = [0];
  const postures = [first.q];
  const worst = { position: 0, turn: 0 };
  let piece = FIRST_PIECE;
  while (shares[shares.length - 1] < 1) {
    const share = shares[shares.length - 1];
    const q = postures[postures.length - 1];
    const next = share + piece > 1 - LEAST_PIECE ? 1 : share + piece;
    const found = followPose(chain, { q }, path.poseAt(next), { ...tolerances, mostStep: MOST_STEP, task });
    if (found.status !== 'there') {
      if (piece > LEAST_PIECE) {
        piece = Math.max(LEAST_PIECE, piece / 2);
        continue;
      }
      const why = whyNot(chain, path, q, share, { ...tolerances, task });
      return { status: 'refused', ...why, share, posture: q };
    }
    const off = deviation(chain, q, found.q, path, next - share);
    const over = Math.max(off.position / positionDeviation, keepsTurn ? off.turn / turnDeviation : 0);
    if (over > 1 && piece > LEAST_PIECE) {
      piece = Math.max(LEAST_PIECE, (piece * CAUTION) / Math.sqrt(over));
      continue;
    }
    if (over > 1) return { status: 'refused', reason: 'singularity', share, posture: q };
    shares.push(next);
    postures.push(found.q);
    worst.position = Math.max(worst.position, off.position);
    worst.turn = Math.max(worst.turn, off.turn);
    piece *= Math.min(2, CAUTION / Math.sqrt(Math.max(over, 1e-9)));
  }
  return { status: 'done', shares, postures, positionDeviation: worst.position, turnDeviation: worst.turn, task };
}

/**
 * What the way ends at. Just beyond the end the tool misses it by next to nothing, whatever the reason; farther on it shows.
 * @param {Chain} chain
 * @param {ToolPath} path
 * @param {Float64Array} q
 * @param {number} share
 * @param {{ positionTolerance: number, orientationTolerance: number, task: TaskName }} settings
 * @returns {Pick<PathRefusal, 'reason' | 'joint'>}
 */
function whyNot(chain, path, q, share, settings) {
  for (const ahead of LOOK_AHEAD) {
    const goal = path.poseAt(Math.min(1, share + ahead));
    const { status, joint } = followPose(chain, { q }, goal, { ...settings, mostStep: Math.PI });
    if (status === 'there' || status === 'behind' || status === 'singularity') continue;
    return joint === undefined ? { reason: status } : { reason: status, joint };
  }
  return { reason: 'singularity' };
}

/**
 * How far the tool may be off the way between two postures, at most.
 * @param {Chain} chain
 * @param {Float64Array} a
 * @param {Float64Array} b
 * @param {ToolPath} path
 * @param {number} piece  of the way
 */
function deviation(chain, a, b, { bend, length }, piece) {
  const { dof, joints } = chain;
  const J = geometricJacobian(chain, a);
  const go = joints.map((_, i) => Math.abs(b[i] - a[i]));
  const turns = joints.map(({ type }) => type !== 'prismatic');
  let [place, turn, moved] = [bend * (length * piece) ** 2, 0, 0];
  for (let j = dof - 1; j >= 0; j--) {
    const lever = turns[j] ? Math.hypot(J[6 * j], J[6 * j + 1], J[6 * j + 2]) + moved : 1;
    moved += go[j] * lever;
    if (turns[j]) place += go[j] * go[j] * lever;
    for (let i = 0; i < j; i++) {
      if (!turns[i]) continue;
      place += 2 * go[i] * go[j] * lever;
      if (turns[j]) turn += go[i] * go[j];
    }
  }
  const solved = SOLVED * chain.characteristicLength;
  return { position: place / 8 + solved, turn: turn / 4 + SOLVED };
}

/** @param {Chain} chain @param {ArrayLike<number>} a @param {ArrayLike<number>} b  how far apart the tool is, arm lengths or radians */
function farthest(chain, a, b) {
  poseDifference(tcpPose(chain, a), tcpPose(chain, b), difference);
  const [x, y, z, rx, ry, rz] = difference;
  return Math.max(Math.hypot(x, y, z) / chain.characteristicLength, Math.hypot(rx, ry, rz));
}
