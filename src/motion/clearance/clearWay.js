/**
 * Whether an arm keeps clear on a whole way: a proof, not a sample. In the middle of a piece every body is looked at; none can go
 * farther from there, within the piece, than the joints' ways times their levers (armBodies.js). What is farther from
 * everything than that is free all along the piece; what is not is looked at in two halves, until a piece is too short to
 * tell from a touch.
 *
 * So "clear" is certain, and "not clear" means: somewhere on the way two bodies are nearer than the resolution. A margin is kept
 * to obstacles alone: how near the arm's own links come to each other is how it is built.
 *
 * @import { PosturePath } from '../posturePath.js'
 * @import { Needs, Nearest, Workcell } from './workcell.js'
 *
 * @typedef {Nearest & { share: number, posture: Float64Array }} Touch  where on the way, from 0 to 1, and how the arm stands there
 *
 * @typedef {object} Curve   the joints by λ, from 0 to 1
 * @property {(middle: number, posture: Float64Array) => void} writePosture
 * @property {(middle: number, half: number, reach: Float64Array) => void} writeReach  how far each joint goes from its value in the
 *   middle, at most, while λ is within half of it
 *
 * @typedef {{ resolution?: number, margin?: number }} TouchOptions  m; the margin is kept to obstacles besides
 */
import { TERMS } from '../posturePath.js';
import { writeLevers } from './armBodies.js';
import { tooNear } from './workcell.js';

/** m: bodies nearer than this are said to touch. */
export const RESOLUTION = 1e-3;

/** A way that needs more looks is not free by any useful measure: hundreds of turns long, or as near as can be all along. */
const MOST_LOOKS = 20_000;

/**
 * Every joint straight from one value to the other, all in proportion.
 * @param {Workcell} cell
 * @param {ArrayLike<number>} from
 * @param {ArrayLike<number>} to
 * @param {TouchOptions} [options]
 * @returns {Touch | null}  null: clear all along
 */
export const touchOnWay = (cell, from, to, options) =>
  touchOnCurve(
    cell,
    {
      writePosture(middle, posture) {
        for (let j = 0; j < posture.length; j++) posture[j] = from[j] + middle * (to[j] - from[j]);
      },
      writeReach(middle, half, reach) {
        for (let j = 0; j < reach.length; j++) reach[j] = half * Math.abs(to[j] - from[j]);
      },
    },
    options,
  );

/**
 * @param {Workcell} cell
 * @param {PosturePath} path
 * @param {TouchOptions} [options]
 * @returns {Touch | null}  its share is of the whole path
 */
export function touchOnPath(cell, path, options) {
  const { knots } = path;
  const [begin, end] = [knots[0], knots[knots.length - 1]];
  for (let k = 0; k < knots.length - 1; k++) {
    const touch = touchOnCurve(cell, pieceOf(path, k), options);
    if (touch === null) continue;
    const s = knots[k] + touch.share * (knots[k + 1] - knots[k]);
    return { ...touch, share: end > begin ? (s - begin) / (end - begin) : 0 };
  }
  return null;
}

/**
 * A piece as its polynomials say: with their derivatives in the middle, p(m + δ) − p(m) = Σ p⁽ᵏ⁾(m) δᵏ / k!, which is at most the same sum
 * of what is positive.
 * @param {PosturePath} path
 * @param {number} piece
 * @returns {Curve}
 */
function pieceOf({ dof, coefficients: c }, piece) {
  const first = TERMS * dof * piece;
  const terms = new Float64Array(TERMS);
  return {
    writePosture(middle, posture) {
      for (let j = 0, at = first; j < dof; j++, at += TERMS) {
        let value = 0;
        for (let k = TERMS - 1; k >= 0; k--) value = value * middle + c[at + k];
        posture[j] = value;
      }
    },
    writeReach(middle, half, reach) {
      for (let j = 0, at = first; j < dof; j++, at += TERMS) {
        // the polynomial about the middle, by dividing again and again
        for (let k = 0; k < TERMS; k++) terms[k] = c[at + k];
        for (let k = 0; k < TERMS - 1; k++) {
          for (let i = TERMS - 2; i >= k; i--) terms[i] += middle * terms[i + 1];
        }
        let most = 0;
        for (let k = TERMS - 1; k >= 1; k--) most = (most + Math.abs(terms[k])) * half;
        reach[j] = most;
      }
    },
  };
}

/**
 * @param {Workcell} cell
 * @param {Curve} curve
 * @param {TouchOptions} [options]
 * @returns {Touch | null}
 */
function touchOnCurve(cell, curve, { resolution = RESOLUTION, margin = 0 } = {}) {
  const { needs, reach } = cell.room;
  const posture = new Float64Array(reach.length);
  writeLeversOn(cell, curve, posture);
  // pieces of the way by their middle, coarse ones first: a touch is likelier found early so
  const middles = [0.5];
  let half = 0.5;
  for (let k = 0, ofThisSize = 1; k < middles.length; k++) {
    if (k === ofThisSize) {
      ofThisSize = middles.length;
      half /= 2;
    }
    const middle = middles[k];
    curve.writePosture(middle, posture);
    curve.writeReach(middle, half, reach);
    const most = writeNeeds(cell, margin);
    const near = tooNear(cell, posture, needs);
    if (near === null) continue;
    const isTouch = near.distance <= (near.obstacle === null ? 0 : margin);
    if (isTouch || most <= resolution || middles.length > MOST_LOOKS) return { ...near, share: middle, posture };
    middles.push(middle - half / 2, middle + half / 2);
  }
  return null;
}

/**
 * The first place on a path that is not clear, to the resolution: pieces are proven in their order, so all before it is.
 * @param {Workcell} cell
 * @param {PosturePath} path
 * @param {TouchOptions} [options]
 * @returns {(Touch & { s: number }) | null}  s: where, as the path counts; null: clear all along
 */
export function firstTouchOnPath(cell, path, options) {
  const { knots } = path;
  const [begin, end] = [knots[0], knots[knots.length - 1]];
  for (let k = 0; k < knots.length - 1; k++) {
    const touch = firstOnCurve(cell, pieceOf(path, k), options);
    if (touch === null) continue;
    const s = knots[k] + touch.share * (knots[k + 1] - knots[k]);
    return { ...touch, s, share: end > begin ? (s - begin) / (end - begin) : 0 };
  }
  return null;
}

/** @param {Workcell} cell @param {Curve} curve @param {TouchOptions} [options] @returns {Touch | null} */
function firstOnCurve(cell, curve, { resolution = RESOLUTION, margin = 0 } = {}) {
  const { needs, reach } = cell.room;
  const posture = new Float64Array(reach.length);
  writeLeversOn(cell, curve, posture);
  // what is still to be looked at, the nearest piece last
  const pieces = [{ middle: 0.5, half: 0.5 }];
  for (let looks = 0, piece = pieces.pop(); piece; looks++, piece = pieces.pop()) {
    const { middle, half } = piece;
    curve.writePosture(middle, posture);
    curve.writeReach(middle, half, reach);
    const most = writeNeeds(cell, margin);
    const near = tooNear(cell, posture, needs);
    if (near === null) continue;
    if (most <= resolution || looks > MOST_LOOKS) return { ...near, share: middle, posture };
    pieces.push({ middle: middle + half / 2, half: half / 2 }, { middle: middle - half / 2, half: half / 2 });
  }
  return null;
}

/** The levers that hold on the whole curve. @param {Workcell} cell @param {Curve} curve @param {Float64Array} posture  room */
function writeLeversOn({ bodies, room: { levers, reach } }, curve, posture) {
  curve.writePosture(0.5, posture);
  curve.writeReach(0.5, 0.5, reach);
  for (let j = 0; j < posture.length; j++) posture[j] -= reach[j];
  for (let j = 0; j < posture.length; j++) reach[j] = posture[j] + 2 * reach[j];
  writeLevers(bodies, posture, reach, levers);
}

/**
 * How far each stretch, and each pair with respect to each other, can go while the joints go as far as they reach, and the margin.
 * @param {Workcell} cell
 * @param {number} margin
 * @returns {number} the farthest any goes, m
 */
function writeNeeds({ bodies, room: { levers, reach, needs } }, margin) {
  const { chain, stretches, pairs } = bodies;
  const { dof, joints } = chain;
  let most = 0;
  for (let i = 0; i < stretches.length; i++) {
    const way = wayOf(levers, dof * i, reach, 0, stretches[i].link);
    most = Math.max(most, way);
    needs.ofStretch[i] = way + margin;
  }
  for (let k = 0; k < pairs.length; k++) {
    const [i, j] = pairs[k];
    const { link, kind } = stretches[i];
    // a slide's own stretch grows with it, seen from the links beyond
    const isGrowing = kind === 'offset' && joints[link].type === 'prismatic';
    needs.ofPair[k] = wayOf(levers, dof * j, reach, isGrowing ? link : link + 1, stretches[j].link);
  }
  return most;
}

/**
 * How far the joints from one to another can take a stretch.
 * @param {Float64Array} levers
 * @param {number} row    where those of the stretch begin
 * @param {Float64Array} reach
 * @param {number} first
 * @param {number} last
 */
function wayOf(levers, row, reach, first, last) {
  let sum = 0;
  for (let j = first; j <= last; j++) sum += reach[j] * levers[row + j];
  return sum;
}
