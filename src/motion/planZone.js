/**
 * The postures of a zone between two moves, on either side of its middle, or why it cannot be gone through.
 *
 * @import { MoveWay } from './moveWay.js'
 * @import { PathRefusal } from './followPath.js'
 * @import { PathMoment, PosturePath } from './posturePath.js'
 *
 * @typedef {{ halves: [PosturePath, PosturePath], ceiling: number } | { refused: PathRefusal['reason'] }} Zone
 */
import { blendPath } from './blend.js';
import { followPath } from './followPath.js';
import { createSpan, writeHermite, writeSpan } from './hermite.js';
import { TERMS, headingBy, measuredBy, pathMomentAt } from './posturePath.js';

/** How fast one rate goes over into the other at most, and how suddenly: the slope of 3λ² − 2λ³, and its. */
const STEEPEST = 3 / 2;
const MOST_SUDDEN = 6;

/**
 * In space, of one tool.
 * @param {MoveWay} before
 * @param {MoveWay} after
 * @param {number} side    s, how long the zone is on either side
 * @param {PathMoment} begin   at its beginning, by seconds
 * @returns {Zone}
 */
export function zoneInSpace(before, after, side, begin) {
  if (!before.tool || !after.tool) throw new TypeError('Expected two ways of the tool.');
  const way = blendPath(before.tool, after.tool, side / before.length, side / after.length);
  const first = followPath(before.chain, way, begin.posture, { to: 1 / 2, heading: headingBy(begin, 2 * side) });
  if (first.status === 'refused') return { refused: first.reason };
  const middle = pathMomentAt(first.path, 1 / 2);
  const second = followPath(before.chain, way, middle.posture, { from: 1 / 2, heading: middle });
  if (second.status === 'refused') return { refused: second.reason };
  // the acceleration across the way: of the corner, and of the bends of both
  const [u, w] = [velocityAt(before, 1), velocityAt(after, 0)];
  const turn = Math.hypot(...u.map((value, k) => w[k] - value));
  const corner = (STEEPEST * turn) / (2 * side);
  const bends = [before, after].map(({ tool, length }) => (tool ? tool.bend * (tool.length / length) ** 2 : 0));
  const least = (/** @type {(way: MoveWay) => number} */ of) =>
    Math.min(...[before, after].map((each) => (of(each) * (each.tool?.length ?? 0)) / each.length));
  const most = least(({ acceleration }) => acceleration);
  const across = corner + Math.max(...bends);
  const slow = across > 0 && most > 0 ? Math.sqrt(most / across) : 1;
  // and the jerk of the corner
  const mostSudden = least(({ jerk }) => jerk);
  const sudden = (MOST_SUDDEN * turn) / (2 * side) ** 2;
  const slower = sudden > 0 && mostSudden > 0 ? Math.cbrt(mostSudden / sudden) : 1;
  return {
    halves: [measuredBy(first.path, 0, 2 * side), measuredBy(second.path, 0, 2 * side)],
    ceiling: Math.min(1, slow, slower),
  };
}

/** m/s at a rate of 1. @param {MoveWay} way @param {number} share */
function velocityAt({ tool, length }, share) {
  const [first, second] = [new Float64Array(6), new Float64Array(6)];
  tool?.motionAt(share, first, second);
  return Array.from(first.subarray(0, 3), (value) => value / length);
}

/**
 * By the joints.
 * @param {MoveWay} before
 * @param {PathMoment} begin   where the zone is entered, by seconds
 * @param {PathMoment} end
 * @param {number} side
 * @param {ArrayLike<number> | null} jerks   what the joints' are at most, if that is limited
 * @returns {Zone}
 */
export function zoneOfJoints({ chain: { dof, packed } }, begin, end, side, jerks) {
  const [a, b] = [knotOf(begin), knotOf(end)];
  const coefficients = new Float64Array(TERMS * dof);
  writeHermite(a, b, 2 * side, coefficients);
  const span = createSpan();
  let ceiling = 1;
  for (let i = 0; i < dof; i++) {
    writeSpan(coefficients, TERMS * i, span);
    if (span.low < packed.lower[i] || span.high > packed.upper[i]) return { refused: 'limit' };
    const sudden = span.derivatives[3] / (2 * side) ** 3;
    if (jerks && sudden > jerks[i]) ceiling = Math.min(ceiling, Math.cbrt(jerks[i] / sudden));
  }
  const whole = { dof, knots: Float64Array.of(0, 2 * side), coefficients };
  const middle = knotOf(pathMomentAt(whole, side));
  /** @param {typeof a} from @param {typeof a} to */
  const half = (from, to) => {
    const own = new Float64Array(TERMS * dof);
    writeHermite(from, to, side, own);
    return { dof, knots: Float64Array.of(0, side), coefficients: own };
  };
  return { halves: [half(a, middle), half(middle, b)], ceiling };
}

/** @param {PathMoment} moment */
const knotOf = ({ posture, first, second }) => ({ q: posture, first, second });
