/**
 * Critical curves on faces of three and more free joints: postures from which all of them together cannot push the TCP across
 * some line of the section. With the line's normal n = (cos θ, sin θ) that is n · ∂(u, v)/∂x_i = 0 for every free joint, m
 * conditions on m + 1 unknowns (x, θ): curves again. (Geometrically, the line through the TCP along n meets the axes of all
 * free joints, or is parallel to them.)
 *
 * They are looked for from many postures, by Newton's method, and followed by steps along and back onto the curve. A curve
 * that none of the starts leads to is not seen: where faces have three free joints or more, a section is estimated.
 *
 * Where the same places are reached by whole families of critical postures, the curve is followed along the direction in
 * which the place moves most.
 *
 * @import { Face } from './criticalCurves.js'
 * @import { SectionMap } from './sectionMap.js'
 * @import { Traced, Vertex } from './traced.js'
 */
import { createRandom } from '../kinematics/random.js';
import { createConditions } from './criticalConditions.js';
import { faceAt, heldFaces, innerFaces } from './criticalCurves.js';
import { flatFaces } from './flatFaces.js';
import { Squares } from './squares.js';
import { apart, refining } from './traced.js';

/** Starts on each face, at most; and in a row that come upon nothing new. */
const STARTS = 400;
const PATIENCE = 60;

/** A vertex lies on a curve if it is no farther off its lines than this, in tolerances. */
const ON = 1.5;

/** Tolerances along the side of a square of what is drawn. */
const SQUARE = 150;

/** The line's normal and its opposite are one. */
const HALF_TURN = Math.PI;
const FULL_TURN = 2 * Math.PI;

/** Steps of the unknowns: at first, and at most, rad. */
const FIRST_STEP = 0.02;
const LONGEST_STEP = 0.06;
const MOST_STEPS = 3000;

/** Up to what ends a curve it is followed by steps that are halved until they are no longer than this, and over the axis by one of the other, rad. */
const SHORTEST_STEP = 1e-7;
const OVER = 1e-4;

/** Steps along a curve between two steps of work. */
const FOLLOWED = 100;

/** A step of which less than this share is left has been taken back: the curve ends, as on the axis of a half-plane. */
const HELD = 0.1;

/** A posture whose place is the farthest of many along n = (cos θ, sin θ). @typedef {{ x: Float64Array, theta: number }} Farthest */

/**
 * One that is as near as can be to a place: the way that is missing is along n, and beside the plane by μ times as much.
 * @typedef {Farthest & { mu: number, held: number | null }} FellShort  held: where the joint stands that the plane takes care of, if at a limit
 */

/** What has been traced, whatever the face. @typedef {Squares<[Vertex, Vertex]>} Drawn */

/** Nothing yet. @param {number} tolerance @returns {Drawn} */
export const nothingDrawn = (tolerance) => new Squares(SQUARE * tolerance);

/**
 * @param {SectionMap} map
 * @param {number} tolerance
 * @param {number} seed
 * @param {Drawn} drawn  added to; what is in it is not found again
 * @param {readonly Farthest[]} farthest  postures to start from, besides those by chance
 * @returns {Generator<Traced | null>}  null now and then, when there has been nothing for a while
 */
export function* criticalPostures(map, tolerance, seed, drawn, farthest) {
  const random = createRandom(seed);
  const { lower, upper } = map;
  for (let freedom = 2; freedom <= lower.length; freedom++) {
    for (const face of freedom === 2 ? flatFaces(map) : [...innerFaces(map, freedom), ...heldFaces(map, freedom)]) {
      const own = face.held === undefined ? [] : [0];
      const tracer = createTracer(map, face, tolerance, drawn);
      for (let start = -farthest.length, idle = 0; start < STARTS && idle < PATIENCE; start++) {
        if (start % 10 === 9) yield null;
        if (start >= 0) idle++;
        const from = farthest[start + farthest.length];
        const y = from
          ? Float64Array.from([...face.free.map((k) => from.x[k]), from.theta, ...own])
          : Float64Array.from([
              ...face.free.map((k) => lower[k] + random() * (upper[k] - lower[k])),
              random() * HALF_TURN,
              ...own.map(() => 2 * random() - 1),
            ]);
        const runs = yield* tracer(y);
        if (runs.length > 0) idle = 0;
        yield* runs;
      }
    }
  }
}

/**
 * The curve on which a posture lies that is as near as can be to a place out of reach: the way that is missing is the normal.
 * @param {SectionMap} map
 * @param {number} tolerance
 * @param {Drawn} drawn  added to
 * @param {FellShort} from
 * @returns {Generator<null, Traced[]>}  none, if it is drawn, or none of those that are looked for here
 */
export function* criticalFrom(map, tolerance, drawn, { x, theta, mu, held }) {
  const face = faceAt(map, x, held);
  if (face.free.length < (held === null ? 3 : 2)) return [];
  const own = held === null ? [] : [mu];
  const y = Float64Array.from([...face.free.map((k) => x[k]), theta, ...own]);
  return yield* createTracer(map, face, tolerance, drawn)(y);
}

/**
 * Finds the curve that some unknowns are near to, and follows it both ways.
 * @param {SectionMap} map
 * @param {Face} face
 * @param {number} tolerance
 * @param {Drawn} drawn
 * @returns {(y: Float64Array) => Generator<null, Traced[]>}
 */
function createTracer(map, face, tolerance, drawn) {
  const { lower, upper, isClosed } = map;
  const conditions = createConditions(map, face);
  const isHeld = face.held !== undefined;
  const isInside = (/** @type {Float64Array} */ y) =>
    face.free.every((k, i) => isClosed[k] || (y[i] >= lower[k] && y[i] <= upper[k])) && conditions.isBrought(y);
  const closed = face.free.map((k) => (isClosed[k] ? FULL_TURN : 0));
  const rounds = isHeld ? [...closed, FULL_TURN, 0] : [...closed, HALF_TURN];
  /** @param {Vertex} a @param {Vertex} b */
  const between = (a, b) => {
    const middle = conditions.unknowns(a).map((value, i) => (value + conditions.unknowns(b)[i]) / 2);
    if (!conditions.meet(middle)) return null;
    const vertex = conditions.vertex(middle);
    return Math.max(apart(vertex, a), apart(vertex, b)) > 2 * apart(a, b) ? null : vertex;
  };
  return function* (y) {
    if (!conditions.meet(y) || !isInside(y)) return [];
    const first = conditions.vertex(y);
    if (isDrawn(drawn, first, tolerance)) return [];
    const ahead = yield* follow(conditions, y, 1, isInside, rounds, drawn, tolerance);
    const isRing = ahead.length > 0 && apart(ahead[ahead.length - 1], first) < tolerance / 100;
    const behind = isRing ? [] : yield* follow(conditions, y, -1, isInside, rounds, drawn, tolerance);
    const vertices = [...behind.reverse(), first, ...ahead];
    if (vertices.length < 2) return [];
    const { runs } = yield* refining({ kind: 'singular', fixed: face.fixed, between }, vertices, tolerance);
    for (const run of runs) addDrawn(drawn, run);
    return runs;
  };
}

/** @param {Drawn} drawn @param {Traced} curve */
export function addDrawn(drawn, { vertices }) {
  for (let i = 1; i < vertices.length; i++) drawn.add([vertices[i - 1], vertices[i]], vertices[i - 1], vertices[i]);
}

/** Whether a place lies on a line that is drawn. @param {Drawn} drawn @param {{ u: number, v: number }} at @param {number} tolerance */
export function isDrawn(drawn, at, tolerance) {
  for (const [a, b] of drawn.near(at, at, ON * tolerance)) {
    const length = apart(a, b);
    const t = length && ((at.u - a.u) * (b.u - a.u) + (at.v - a.v) * (b.v - a.v)) / length ** 2;
    const share = Math.min(1, Math.max(0, t));
    if (Math.hypot(at.u - a.u - share * (b.u - a.u), at.v - a.v - share * (b.v - a.v)) <= ON * tolerance) return true;
  }
  return false;
}

/**
 * @param {ReturnType<typeof createConditions>} conditions
 * @param {Float64Array} from
 * @param {1 | -1} sense
 * @param {(y: Float64Array) => boolean} isInside
 * @param {readonly number[]} rounds  what each unknown may differ by and be the same; 0: nothing
 * @param {Drawn} drawn
 * @param {number} tolerance
 * @returns {Generator<null, Vertex[]>} without the first
 */
function* follow(conditions, from, sense, isInside, rounds, drawn, tolerance) {
  /** @type {Vertex[]} */
  const vertices = [];
  const first = conditions.vertex(from);
  let y = from.slice();
  let last = first;
  let step = FIRST_STEP;
  let onDrawn = 0;
  /** @type {Float64Array | null} */
  let heading = null;
  for (let count = 0; count < MOST_STEPS; count++) {
    if (count % FOLLOWED === FOLLOWED - 1) yield null;
    const found = conditions.tangentAt(y);
    if (!found) break;
    const { tangent } = found;
    const before = heading;
    const turn = before ? tangent.reduce((sum, value, i) => sum + value * before[i], 0) : sense;
    if (turn < 0) for (let i = 0; i < tangent.length; i++) tangent[i] = -tangent[i];
    const next = y.map((value, i) => value + step * tangent[i]);
    if (conditions.crosses(y, next)) {
      if (step > SHORTEST_STEP) {
        step /= 2; // up to the axis
        continue;
      }
      // there it is turned back: the same curve goes on, seen from the other side
      const over = conditions.mirrored(y.map((value, i) => value + OVER * tangent[i]));
      if (!conditions.meet(over) || !isInside(over)) break;
      vertices.push(conditions.vertex(conditions.mirrored(y)), conditions.vertex(over));
      heading = conditions.mirrored(tangent, 0);
      y = over;
      step = OVER;
      continue;
    }
    const isMet = conditions.meet(next);
    const way = Math.hypot(...next.map((value, i) => value - y[i]));
    const along = next.reduce((sum, value, i) => sum + (value - y[i]) * tangent[i], 0);
    const isStep = isMet && way <= 2 * step && along >= HELD * step;
    if (!isStep || Math.abs(turn) < 0.9) {
      if (step > 1e-5) {
        step /= 2;
        continue;
      }
      if (!isStep) break;
    }
    if (!isInside(next)) {
      if (step < SHORTEST_STEP) break;
      step /= 2; // up to the face's border
      continue;
    }
    heading = tangent;
    y = next;
    const vertex = conditions.vertex(y);
    vertices.push(vertex);
    onDrawn = isDrawn(drawn, vertex, tolerance) ? onDrawn + 1 : 0;
    if (onDrawn > 3) break;
    // back where it began: the next vertex closes the ring
    const again = from.map((value, i) => value + (rounds[i] && rounds[i] * Math.round((y[i] - value) / rounds[i])));
    const isBack = y.every((value, i) => Math.abs(value - again[i]) < 2 * step);
    if (count > 8 && isBack && apart(vertex, first) < apart(vertex, last)) {
      vertices.push(conditions.vertex(again));
      break;
    }
    last = vertex;
    step = Math.min(LONGEST_STEP, step * 1.5);
  }
  return vertices;
}
