/**
 * Joint moves by the laws of the textbooks that go on through, or past, their targets: the cubic spline meets each of them with
 * a continuous acceleration; linear segments with parabolic blends pass near them at constant rates. A run begins and ends at
 * rest and goes on while the next move is by the same law and this one is not to stop.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { TimedMove } from './motionRun.js'
 * @import { JointLimits, Move, ViaMove } from './moves.js'
 * @import { MotionRefusal, NotBlended } from './planReasons.js'
 * @import { PosturePath } from './posturePath.js'
 *
 * @typedef {object} ViaRun
 * @property {(TimedMove & { notBlended: NotBlended | null })[]} parts   one a move
 * @property {Float64Array} end
 * @property {MotionRefusal | null} refused   parts: those before it
 */
import { requirePosture } from '../kinematics/checks.js';
import { firstPast, requireShare } from './moveWay.js';
import { TERMS, pathMomentAt } from './posturePath.js';
import { blendPaths, splinePaths } from './viaPaths.js';
import { timeLaw } from './timeLaw.js';

/** @param {Move | undefined} move @returns {move is ViaMove} */
export const isVia = (move) => move?.kind === 'joint' && (move.law === 'cubicSpline' || move.law === 'parabolicBlends');

/**
 * @param {Chain} chain
 * @param {Float64Array} start
 * @param {readonly Move[]} moves
 * @param {number} first    the index of a via move
 * @param {JointLimits} limits
 * @returns {ViaRun}
 */
export function viaRun(chain, start, moves, first, limits) {
  const { run, notBlended } = gather(chain, start, moves, first);
  const points = [start, ...run.map(({ posture }) => posture)];
  for (const [i, move] of run.entries()) {
    const past = firstPast(chain, points[i], move.posture);
    if (past) return upTo(chain, start, moves, first, limits, { move: first + i, ...past });
  }
  const paths = (run[0].law === 'cubicSpline' ? splinePaths : blendPaths)(points, run, limits);
  for (const [i, path] of paths.entries()) {
    const past = firstOutside(chain, path);
    if (past) return upTo(chain, start, moves, first, limits, { move: first + i, reason: 'limit', ...past });
  }
  const parts = paths.map((path, i) => {
    const [begin, end] = [path.knots[0], path.knots[path.knots.length - 1]];
    // the way is measured by the time itself
    const law = timeLaw(begin, end, [{ duration: end - begin, coefficients: [begin, 1] }]);
    const last = i === run.length - 1;
    return {
      move: first + i,
      path,
      law,
      timing: run[i].law,
      instead: null,
      slowed: [],
      notBlended: last ? notBlended : null,
    };
  });
  return { parts, end: points[points.length - 1], refused: null };
}

/** What comes before a move that is refused. @param {Chain} chain @param {Float64Array} start @param {readonly Move[]} moves @param {number} first @param {JointLimits} limits @param {MotionRefusal} refused @returns {ViaRun} */
function upTo(chain, start, moves, first, limits, refused) {
  if (refused.move === first) return { parts: [], end: start, refused };
  const before = viaRun(chain, start, moves.slice(0, refused.move), first, limits);
  return before.refused ? before : { ...before, refused };
}

/**
 * The moves of a run, and why it stops where it does though the last of them was not to.
 * @param {Chain} chain @param {Float64Array} start @param {readonly Move[]} moves @param {number} first
 * @returns {{ run: ViaMove[], notBlended: NotBlended | null }}
 */
function gather({ dof }, start, moves, first) {
  /** @type {ViaMove[]} */
  const run = [];
  let from = start;
  for (let index = first; ; index++) {
    const move = /** @type {ViaMove} */ (moves[index]);
    requirePosture(dof, move.posture);
    requireShare('speed', move.speed);
    requireShare('acceleration', move.acceleration);
    run.push(move);
    if (move.ending.kind === 'fine') return { run, notBlended: null };
    const next = moves[index + 1];
    if (!next) return { run, notBlended: 'last' };
    if (next.kind === 'wait') return { run, notBlended: 'wait' };
    if (!isVia(next) || next.law !== move.law) return { run, notBlended: 'law' };
    requirePosture(dof, next.posture);
    if (isThere(from, move.posture) || isThere(move.posture, next.posture)) return { run, notBlended: 'still' };
    from = move.posture;
  }
}

/** @param {Float64Array} from @param {Float64Array} to */
const isThere = (from, to) => to.every((value, i) => value === from[i]);

/** A joint may be past its limit by this: rounding. */
const ROUNDING = 1e-12;
const HALVINGS = 50;

/**
 * Where a way of cubic polynomials first leaves the limits, as splines do beside their points.
 * @param {Chain} chain @param {PosturePath} path
 * @returns {{ joint: number, share: number, posture: Float64Array } | null}
 */
function firstOutside({ packed: { lower, upper } }, path) {
  const { dof, knots, coefficients } = path;
  const [begin, end] = [knots[0], knots[knots.length - 1]];
  for (let piece = 0, at = 0; piece < knots.length - 1; piece++) {
    let [joint, first] = [-1, Infinity];
    for (let i = 0; i < dof; i++, at += TERMS) {
      const c = coefficients.subarray(at, at + TERMS);
      const valueAt = (/** @type {number} */ x) => c[0] + x * (c[1] + x * (c[2] + x * c[3]));
      const isOutside = (/** @type {number} */ x) =>
        valueAt(x) < lower[i] - ROUNDING || valueAt(x) > upper[i] + ROUNDING;
      // between its turning points it goes one way only
      const ends = [0, ...turningPoints(c), 1];
      const past = ends.findIndex((x, k) => k > 0 && isOutside(x));
      if (past < 0) continue;
      let [inside, outside] = [ends[past - 1], ends[past]];
      for (let halving = 0; halving < HALVINGS; halving++) {
        const middle = (inside + outside) / 2;
        if (isOutside(middle)) outside = middle;
        else inside = middle;
      }
      if (inside < first) [joint, first] = [i, inside];
    }
    if (joint < 0) continue;
    const s = knots[piece] + first * (knots[piece + 1] - knots[piece]);
    return { joint, share: (s - begin) / (end - begin), posture: pathMomentAt(path, s).posture };
  }
  return null;
}

/** Where a cubic polynomial turns back between 0 and 1, ascending. @param {ArrayLike<number>} c */
function turningPoints(c) {
  const [a, half, b] = [3 * c[3], c[2], c[1]];
  const square = half * half - a * b;
  if (!(square > 0)) return [];
  const sum = -(half + Math.sign(half || 1) * Math.sqrt(square));
  return [sum / a, b / sum].filter((x) => x > 0 && x < 1).sort((x, y) => x - y);
}
