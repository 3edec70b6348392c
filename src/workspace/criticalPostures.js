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
 * @import { SectionMap } from './sectionMap.js'
 * @import { Traced, Vertex } from './traced.js'
 */
import { createRandom } from '../kinematics/random.js';
import { createSvd, decompose } from '../kinematics/measures/singularValues.js';
import { facesOf } from './criticalCurves.js';
import { Squares } from './squares.js';
import { apart, refined } from './traced.js';

/** Starts on each face, at most; and in a row that come upon nothing new. */
const STARTS = 400;
const PATIENCE = 60;

/** Tolerances along the side of a square of what is drawn. */
const SQUARE = 800;

/** The line's normal and its opposite are one. */
const HALF_TURN = Math.PI;

const NEWTON_STEPS = 30;

/** Of differences, rad and m. */
const DIFFERENCE = 1e-6;

/** Conditions met within this (arm lengths per radian) are met. */
const MET = 1e-10;

/** A singular value smaller than this, of the largest, belongs to a direction in which the conditions go on being met. */
const FLAT = 1e-5;

/** Steps of the unknowns: at first, and at most, rad. */
const FIRST_STEP = 0.02;
const LONGEST_STEP = 0.06;
const MOST_STEPS = 3000;

/** The place has to move by this share of the arm's length for each radian of the unknowns, or the curve stands still. */
const STANDING = 1e-6;

/**
 * The conditions of one face, at unknowns y = (free arguments …, θ).
 * @param {SectionMap} map
 * @param {{ free: number[], x: Float64Array }} face
 */
function createConditions(map, { free, x }) {
  const m = free.length;
  const place = Float64Array.from([...x, 0]);
  const scale = map.placement.chain.characteristicLength;
  const values = new Float64Array(m);
  const plus = new Float64Array(m);
  const slopes = new Float64Array(m * (m + 1));
  const svd = createSvd(m, m + 1);
  const step = new Float64Array(m + 1);

  /** @param {Float64Array} y @param {Float64Array} out */
  const write = (y, out) => {
    free.forEach((k, i) => (place[k] = y[i]));
    map.write(place);
    const { f, Jf } = map;
    const outward = map.kind === 'meridian' ? Math.max(f[0], 1e-12) : 1;
    const [c, s] = [Math.cos(y[m]), Math.sin(y[m])];
    for (let i = 0; i < m; i++) out[i] = ((c * Jf[2 * free[i]]) / outward + s * Jf[2 * free[i] + 1]) / scale;
  };

  /** The conditions and how they change, decomposed. @param {Float64Array} y @returns {number} the largest condition */
  const decomposeAt = (y) => {
    for (let j = 0; j <= m; j++) {
      const at = y[j];
      y[j] = at + DIFFERENCE;
      write(y, plus);
      y[j] = at - DIFFERENCE;
      write(y, values);
      y[j] = at;
      for (let i = 0; i < m; i++) slopes[m * j + i] = (plus[i] - values[i]) / (2 * DIFFERENCE);
    }
    write(y, values);
    decompose(slopes, svd);
    return values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  };

  return {
    m,
    svd,
    /** Newton's method, the shortest step each time. @param {Float64Array} y changed in place @returns {boolean} whether it has met the conditions */
    meet(y) {
      for (let round = 0; round < NEWTON_STEPS; round++) {
        const most = decomposeAt(y);
        if (most <= MET) return true;
        step.fill(0);
        for (let k = 0; k < m; k++) {
          if (svd.values[k] <= FLAT * svd.values[0]) continue;
          let along = 0;
          for (let i = 0; i < m; i++) along += svd.U[m * k + i] * values[i];
          for (let j = 0; j <= m; j++) step[j] -= (along / svd.values[k]) * svd.V[(m + 1) * k + j];
        }
        const longest = step.reduce((size, value) => Math.max(size, Math.abs(value)), 0);
        const share = Math.min(1, 0.5 / longest);
        for (let j = 0; j <= m; j++) y[j] += share * step[j];
      }
      return false;
    },
    /**
     * The direction along the curve in which the place moves most; null if it does not move.
     * @param {Float64Array} y
     * @returns {{ tangent: Float64Array, du: number, dv: number } | null}
     */
    tangentAt(y) {
      decomposeAt(y);
      const { f, Jf } = map;
      const outward = map.kind === 'meridian' ? Math.max(f[0], 1e-12) : 1;
      /** How the place moves along each direction that is open. @type {number[][]} */
      const open = [];
      for (let k = m; k >= 0; k--) {
        if (k < m && svd.values[k] > FLAT * svd.values[0]) break;
        let [du, dv] = [0, 0];
        for (let i = 0; i < m; i++) {
          du += (svd.V[(m + 1) * k + i] * Jf[2 * free[i]]) / outward;
          dv += svd.V[(m + 1) * k + i] * Jf[2 * free[i] + 1];
        }
        open.push([k, du, dv]);
      }
      // Places only move square to n here: their speed along the curve says how much each direction counts.
      const [nu, nv] = [-Math.sin(y[m]), Math.cos(y[m])];
      const shares = open.map(([, du, dv]) => du * nu + dv * nv);
      const size = Math.hypot(...shares);
      if (size < STANDING * scale) return null;
      const tangent = new Float64Array(m + 1);
      open.forEach(([k], i) => {
        for (let j = 0; j <= m; j++) tangent[j] += (shares[i] / size) * svd.V[(m + 1) * k + j];
      });
      return { tangent, du: nu * size, dv: nv * size };
    },
    /** @param {Float64Array} y @returns {Vertex} */
    vertex(y) {
      const full = Float64Array.from([...x, y[m]]);
      free.forEach((k, i) => (full[k] = y[i]));
      map.write(full);
      return { x: full, u: map.f[0], v: map.f[1] };
    },
    /** @param {Vertex} vertex @returns {Float64Array} */
    unknowns: ({ x: full }) => Float64Array.from([...free.map((k) => full[k]), full[full.length - 1]]),
  };
}

/** What has been traced, whatever the face. @typedef {Squares<[Vertex, Vertex]>} Drawn */

/** Nothing yet. @param {number} tolerance @returns {Drawn} */
export const nothingDrawn = (tolerance) => new Squares(SQUARE * tolerance);

/**
 * @param {SectionMap} map
 * @param {number} tolerance
 * @param {number} seed
 * @param {Drawn} drawn  added to; what is in it is not found again
 * @returns {Generator<Traced | null>}  null now and then, when there has been nothing for a while
 */
export function* criticalPostures(map, tolerance, seed, drawn) {
  const random = createRandom(seed);
  const { lower, upper, isClosed } = map;
  for (let freedom = 3; freedom <= lower.length; freedom++) {
    for (const face of facesOf(map, freedom)) {
      const conditions = createConditions(map, face);
      const isInside = (/** @type {Float64Array} */ y) =>
        face.free.every((k, i) => isClosed[k] || (y[i] >= lower[k] && y[i] <= upper[k]));
      for (let start = 0, idle = 0; start < STARTS && idle < PATIENCE; start++, idle++) {
        if (start % 10 === 9) yield null;
        const y = Float64Array.from([
          ...face.free.map((k) => lower[k] + random() * (upper[k] - lower[k])),
          random() * HALF_TURN,
        ]);
        if (!conditions.meet(y) || !isInside(y)) continue;
        const first = conditions.vertex(y);
        if (isDrawn(drawn, first, tolerance)) continue;
        const ahead = follow(conditions, y, 1, isInside, drawn, tolerance);
        const behind = follow(conditions, y, -1, isInside, drawn, tolerance);
        const vertices = [...behind.reverse(), first, ...ahead];
        if (vertices.length < 2) continue;
        idle = 0;
        /** @param {Vertex} a @param {Vertex} b */
        const between = (a, b) => {
          const middle = conditions.unknowns(a).map((value, i) => (value + conditions.unknowns(b)[i]) / 2);
          if (!conditions.meet(middle)) return null;
          const vertex = conditions.vertex(middle);
          return Math.max(apart(vertex, a), apart(vertex, b)) > 2 * apart(a, b) ? null : vertex;
        };
        const { runs } = refined({ kind: 'singular', fixed: face.fixed, between }, vertices, tolerance);
        for (const run of runs) {
          for (let i = 1; i < run.vertices.length; i++)
            drawn.add([run.vertices[i - 1], run.vertices[i]], run.vertices[i - 1], run.vertices[i]);
          yield run;
        }
      }
    }
  }
}

/** Whether a place lies on a line that is drawn. @param {Drawn} drawn @param {Vertex} at @param {number} tolerance */
function isDrawn(drawn, at, tolerance) {
  for (const [a, b] of drawn.near(at, at, 3 * tolerance)) {
    const length = apart(a, b);
    const t = length && ((at.u - a.u) * (b.u - a.u) + (at.v - a.v) * (b.v - a.v)) / length ** 2;
    const share = Math.min(1, Math.max(0, t));
    if (Math.hypot(at.u - a.u - share * (b.u - a.u), at.v - a.v - share * (b.v - a.v)) <= 3 * tolerance) return true;
  }
  return false;
}

/**
 * @param {ReturnType<typeof createConditions>} conditions
 * @param {Float64Array} from
 * @param {1 | -1} sense
 * @param {(y: Float64Array) => boolean} isInside
 * @param {Drawn} drawn
 * @param {number} tolerance
 * @returns {Vertex[]} without the first
 */
function follow(conditions, from, sense, isInside, drawn, tolerance) {
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
    const found = conditions.tangentAt(y);
    if (!found) break;
    const { tangent } = found;
    const before = heading;
    const turn = before ? tangent.reduce((sum, value, i) => sum + value * before[i], 0) : sense;
    if (turn < 0) for (let i = 0; i < tangent.length; i++) tangent[i] = -tangent[i];
    const next = y.map((value, i) => value + step * tangent[i]);
    const isMet = conditions.meet(next);
    const way = Math.hypot(...next.map((value, i) => value - y[i]));
    if (!isMet || way > 2 * step || Math.abs(turn) < 0.9) {
      if (step > 1e-5) {
        step /= 2;
        continue;
      }
      if (!isMet || way > 2 * step) break;
    }
    if (!isInside(next)) {
      if (step < 1e-7) break;
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
    if (count > 8 && apart(vertex, first) < apart(vertex, last) && isRound(y, from, 2 * step)) {
      vertices.push(first);
      break;
    }
    last = vertex;
    step = Math.min(LONGEST_STEP, step * 1.5);
  }
  return vertices;
}

/** Whether unknowns agree but for half turns. @param {Float64Array} a @param {Float64Array} b @param {number} within */
const isRound = (a, b, within) =>
  a.every((value, i) => Math.abs(value - b[i] - HALF_TURN * Math.round((value - b[i]) / HALF_TURN)) < within);
