/**
 * What a program asks of a move that no controller's language holds: ways through or past targets by the laws of textbooks. In
 * code they are joint moves that go on into each other; how far the tool is then from the program's own way is measured here.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { JointLimits, Move } from '../../motion/moves.js'
 * @import { PosturePath } from '../../motion/posturePath.js'
 * @import { FollowedMove } from './followMoves.js'
 * @import { Deviation } from './moveMargins.js'
 * @import { MoveStep, StepLaw } from '../document.js'
 * @import { WriteNote } from '../../karel/write/neutral.js'
 *
 * @typedef {{ law: string, deviation: Deviation }} Lost   law: as it is called in a sentence
 */
import { tcpPose } from '../../kinematics/forward.js';
import { poseDifference } from '../../kinematics/pose.js';
import { isVia, viaRun } from '../../motion/viaRun.js';
import { pathMomentAt } from '../../motion/posturePath.js';
import { postureAlong } from './followMoves.js';
import { fromKernel } from '../units.js';

const UNITS = /** @type {const} */ ({ length: 'mm', angle: 'deg' });

/** Places on the program's way, and on the code's, that are held against each other. */
const SAMPLES = 12;
const NEAR = 48;

/** What the laws are called in a sentence. @type {Readonly<Partial<Record<StepLaw, string>>>} */
const LAW_NAMES = { cubicSpline: 'a cubic spline', parabolicBlends: 'lines with parabolic blends' };

/**
 * The ways of a program's via moves, by the indices of the moves.
 * @param {Chain} chain
 * @param {readonly Move[]} moves
 * @param {JointLimits} limits
 */
export function viaWays(chain, moves, limits) {
  /** @type {Map<number, PosturePath>} */
  const ways = new Map();
  return {
    /** @param {number} index @param {Float64Array} from  where the arm is before it @returns {PosturePath | null} null: its way is as in code */
    of(index, from) {
      if (!isVia(moves[index])) return null;
      if (!ways.has(index))
        for (const { move, path } of viaRun(chain, from, moves, index, limits).parts) ways.set(move, path);
      return ways.get(index) ?? null;
    },
  };
}

/**
 * How far the program's way is from the code's at most: of places on it, to the nearest on the other.
 * @param {PosturePath} way
 * @param {FollowedMove} followed
 * @returns {Deviation}
 */
export function lostBy(way, { chain, path }) {
  const [begin, end] = [way.knots[0], way.knots[way.knots.length - 1]];
  const own = Array.from({ length: NEAR + 1 }, (_, i) => tcpPose(chain, postureAlong(path, i / NEAR)));
  const worst = { millimetres: 0, degrees: 0 };
  for (let k = 0; k <= SAMPLES; k++) {
    const T = tcpPose(chain, pathMomentAt(way, begin + (k / SAMPLES) * (end - begin)).posture);
    const away = (/** @type {Float64Array} */ { 12: x, 13: y, 14: z }) => Math.hypot(x - T[12], y - T[13], z - T[14]);
    const nearest = own.reduce((best, one) => (away(one) < away(best) ? one : best));
    const [x, y, z, a, b, c] = poseDifference(nearest, T);
    worst.millimetres = Math.max(worst.millimetres, fromKernel('length', Math.hypot(x, y, z), UNITS));
    worst.degrees = Math.max(worst.degrees, fromKernel('angle', Math.hypot(a, b, c), UNITS));
  }
  return worst;
}

/** @param {Pick<MoveStep, 'law'>} step @param {PosturePath | null} way @param {FollowedMove} followed @returns {Lost | null} */
export const lostOf = ({ law }, way, followed) =>
  way && law ? { law: LAW_NAMES[law] ?? law, deviation: lostBy(way, followed) } : null;

/** Said once for each law. @param {readonly { lost: Lost | null }[]} moves @returns {WriteNote[]} */
export const lawNotes = (moves) =>
  [...new Set(moves.flatMap(({ lost }) => (lost ? [lost.law] : [])))].map((law) => {
    const own = moves.filter(({ lost }) => lost?.law === law);
    const most = Math.max(...own.map(({ lost }) => lost?.deviation.millimetres ?? 0));
    return {
      ...{ severity: /** @type {const} */ ('warning'), code: 'lost-law' },
      message: `No controller goes by ${law}: ${own.length === 1 ? 'the move' : `the ${own.length} moves`} by it ${own.length === 1 ? 'is a joint move' : 'are joint moves'} here, up to ${most.toFixed(1)} mm away from the program's own way.`,
    };
  });
