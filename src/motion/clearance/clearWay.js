/**
 * Whether an arm keeps clear on the whole way from one posture to another, every joint going straight from its value to the
 * other: a proof, not a sample. In the middle of a piece every body is looked at; none can go farther from there, within the piece,
 * than the joints' ways times their levers (armBodies.js). What is farther from everything than that is free all
 * along the piece; what is not is looked at in two halves, until a piece is too short to tell from a touch.
 *
 * So "clear" is certain, and "not clear" means: somewhere on the way two bodies are nearer than the resolution.
 *
 * @import { Needs, Nearest, Workcell } from './workcell.js'
 *
 * @typedef {Nearest & { share: number, posture: Float64Array }} Touch  where on the way, from 0 to 1, and how the arm stands there
 */
import { writeLevers } from './armBodies.js';
import { tooNear } from './workcell.js';

/** m: bodies nearer than this are said to touch. */
export const RESOLUTION = 1e-3;

/** A way that needs more looks is not free by any useful measure; it is hundreds of turns long, or as near as can be. */
const MOST_LOOKS = 20_000;

/**
 * @param {Workcell} cell
 * @param {ArrayLike<number>} from
 * @param {ArrayLike<number>} to
 * @param {{ resolution?: number, margin?: number }} [options]  m; the margin is kept to everything besides
 * @returns {Touch | null}  null: clear all along
 */
export function touchOnWay(cell, from, to, { resolution = RESOLUTION, margin = 0 } = {}) {
  const { whole, needs } = cell.room;
  writeNeeds(cell, from, to, whole);
  const ways = Math.max(0, ...whole.ofStretch, ...whole.ofPair);
  const posture = new Float64Array(from.length);
  // pieces of the way by their middle, coarse ones first: a touch is likelier found early so
  const middles = [0.5];
  let half = 0.5;
  for (let k = 0, ofThisSize = 1; k < middles.length; k++) {
    if (k === ofThisSize) {
      // all pieces of one size have been looked at: the rest are half as long
      ofThisSize = middles.length;
      half /= 2;
    }
    const isFine = ways * half <= resolution || middles.length > MOST_LOOKS;
    for (let i = 0; i < needs.ofStretch.length; i++) needs.ofStretch[i] = whole.ofStretch[i] * half + margin;
    for (let i = 0; i < needs.ofPair.length; i++) needs.ofPair[i] = whole.ofPair[i] * half + margin;
    const middle = middles[k];
    for (let j = 0; j < posture.length; j++) posture[j] = from[j] + middle * (to[j] - from[j]);
    const near = tooNear(cell, posture, needs);
    if (near === null) continue;
    if (near.distance <= margin || isFine) return { ...near, share: middle, posture };
    middles.push(middle - half / 2, middle + half / 2);
  }
  return null;
}

/**
 * How far each stretch, and each pair with respect to each other, can go on the whole way.
 * @param {Workcell} cell
 * @param {ArrayLike<number>} from
 * @param {ArrayLike<number>} to
 * @param {Needs} out
 */
function writeNeeds({ bodies, room: { levers } }, from, to, { ofStretch, ofPair }) {
  const { chain, stretches, pairs } = bodies;
  const { dof, joints } = chain;
  writeLevers(bodies, from, to, levers);
  /** The way of a stretch by the joints from one up to another. @param {number} i @param {number} first @param {number} last */
  const way = (i, first, last) => {
    let sum = 0;
    for (let j = first; j <= last; j++) sum += Math.abs(to[j] - from[j]) * levers[dof * i + j];
    return sum;
  };
  for (let i = 0; i < stretches.length; i++) ofStretch[i] = way(i, 0, stretches[i].link);
  for (let k = 0; k < pairs.length; k++) {
    const [i, j] = pairs[k];
    const { link, kind } = stretches[i];
    // a slide's own stretch grows with it, seen from the links beyond
    const isGrowing = kind === 'offset' && joints[link].type === 'prismatic';
    ofPair[k] = way(j, isGrowing ? link : link + 1, stretches[j].link);
  }
}
