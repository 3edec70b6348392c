/**
 * Where two bodies are nearest to each other: points on their surfaces, or, where they overlap, one point in both.
 *
 * @import { Nearest, Workcell } from './workcell.js'
 */
import { ENDS, writeEnds } from './armBodies.js';
import { segmentFrom, segmentsApart } from './segmentDistance.js';

const at = new Float64Array(4);

/**
 * @param {Workcell} cell
 * @param {ArrayLike<number>} q
 * @param {Pick<Nearest, 'stretch' | 'obstacle' | 'other'>} near
 * @returns {readonly [ofArm: Float64Array, ofOther: Float64Array]}
 */
export function nearestPoints({ bodies, obstacles, room: { ends } }, q, { stretch, obstacle, other }) {
  const { stretches } = bodies;
  writeEnds(bodies, q, ends);
  const p = ENDS * stretch;
  if (obstacle !== null) {
    segmentFrom(ends, p, obstacles[obstacle].distance, at);
    return between(onSegment(ends, p, at[0]), at.slice(1), stretches[stretch].radius, 0);
  }
  if (other === null) throw new TypeError('Expected two bodies.');
  const r = ENDS * other;
  segmentsApart(ends, p, r, at);
  return between(onSegment(ends, p, at[0]), onSegment(ends, r, at[1]), stretches[stretch].radius, stretches[other].radius); // prettier-ignore
}

/** @param {Float64Array} ends @param {number} from @param {number} share */
const onSegment = (ends, from, share) =>
  Float64Array.from([0, 1, 2], (k) => ends[from + k] + share * (ends[from + 3 + k] - ends[from + k]));

/**
 * From the axis of one body to that of the other, less their radii.
 * @param {Float64Array} a @param {Float64Array} b @param {number} radius  about a @param {number} otherRadius  about b
 * @returns {[Float64Array, Float64Array]}
 */
function between(a, b, radius, otherRadius) {
  const far = Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  const whole = radius + otherRadius;
  const [from, to] =
    far > whole ? [radius / far, 1 - otherRadius / far] : Array(2).fill(whole > 0 ? radius / whole : 1);
  const along = (/** @type {number} */ share) => a.map((value, k) => value + share * (b[k] - value));
  return [along(from), along(to)];
}
