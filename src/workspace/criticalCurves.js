/**
 * The curves of a section on which the region of an arm can have its boundary. At a posture from which the free joints (those
 * not at a limit) can push the TCP in every direction of the section, all that is near can be reached; so a boundary is made
 * of postures from which they cannot. Of a face of the box of joint values with
 *
 * - one free joint that is every posture: its *edge* is traced;
 * - two free joints those where their two effects are parallel, det(∂(u, v)/∂(a, b)) = 0: a *fold*, the contour of a function
 *   on a rectangle;
 * - a limit of the joint that the plane takes care of: where that stands at its limit, again a contour.
 *
 * Faces of three and more free joints are those of criticalPostures.js.
 *
 * @import { Point } from './contour.js'
 * @import { SectionMap } from './sectionMap.js'
 * @import { Fixed, Traced, Vertex } from './traced.js'
 *
 * @typedef {object} Face  of the box of joint values
 * @property {number[]} free
 * @property {Float64Array} x
 * @property {Fixed[]} fixed
 * @property {number} [held]  where the joint stands that the plane takes care of, if that is at a limit
 */
import { createRandom } from '../kinematics/random.js';
import { contourPieces } from './contour.js';
import { refined, vertexAt } from './traced.js';

/** An edge is looked at in this many places before it is refined. */
const EDGE_PLACES = 48;

/** Squares along one side of the grid in which contours are looked for, and of those around crossings. */
const GRID = 128;
const FINER = 24;

/** Where a full turn begins and ends, rad from half a turn: not where arms are straight or folded, as it is there that contours run. */
const SEAM = 0.7316;

/** Postures of a face that are looked at, and how far beside the plane (m) is in it. */
const LOOKS = 4;
const IN_PLANE = 1e-9;

/** Where a contour ceases to count is looked for by so many halvings. */
const HALVINGS = 40;

/** So much closer do the latter look each time, so often at most. */
const CLOSER = 8;
const DEEPEST = 5;

/**
 * The faces with so many free arguments: which are free, and where the others stand.
 * @param {SectionMap} map
 * @param {number} freedom
 * @returns {Face[]}
 */
export function facesOf({ lower, upper, isClosed, free, placement }, freedom) {
  /** @type {Face[]} */
  let faces = [{ free: [], x: lower.slice(), fixed: [] }];
  for (let i = 0; i < lower.length; i++) {
    const joint = placement.ranges.joints[free[i]];
    faces = faces.flatMap((face) => {
      const isFree = { ...face, free: [...face.free, i] };
      if (isClosed[i]) return [isFree];
      const at = (/** @type {'lower' | 'upper'} */ bound) => {
        const x = face.x.slice();
        x[i] = (bound === 'lower' ? lower : upper)[i];
        return { free: face.free, x, fixed: [...face.fixed, { joint, bound }] };
      };
      return lower[i] === upper[i] ? [at('lower')] : [isFree, at('lower'), at('upper')];
    });
  }
  return faces.filter((face) => face.free.length === freedom);
}

/**
 * Those with places of the section all over them: where no joint takes care of the plane, faces that lie in it.
 * @param {SectionMap} map
 * @param {number} freedom
 * @returns {Face[]}
 */
export const innerFaces = (map, freedom) => facesOf(map, freedom).filter((face) => !map.isThin || isInPlane(map, face));

/**
 * Those with the joint that the plane takes care of at a limit; where there is none, with their places in the plane.
 * @param {SectionMap} map
 * @param {number} freedom
 * @returns {Face[]}
 */
export const heldFaces = (map, freedom) =>
  map.ends.flatMap(({ at, fixed }) =>
    facesOf(map, freedom)
      .filter((face) => !map.isThin || !isInPlane(map, face))
      .map((face) => ({ ...face, fixed: [...face.fixed, ...fixed], held: at })),
  );

/**
 * That on which a posture lies.
 * @param {SectionMap} map
 * @param {Float64Array} x
 * @param {number | null} held  where the joint stands that the plane takes care of, if at a limit
 * @returns {Face}
 */
export function faceAt({ lower, upper, isClosed, free, placement, ends }, x, held) {
  /** @type {Face} */
  const face = { free: [], x: x.slice(), fixed: [] };
  for (let k = 0; k < lower.length; k++) {
    if (isClosed[k] || (x[k] > lower[k] && x[k] < upper[k])) face.free.push(k);
    else face.fixed.push({ joint: placement.ranges.joints[free[k]], bound: x[k] <= lower[k] ? 'lower' : 'upper' });
  }
  const end = ends.find(({ at }) => at === held);
  return end ? { ...face, fixed: [...face.fixed, ...end.fixed], held: end.at } : face;
}

/** Whether all places of a face lie in the plane. @param {SectionMap} map @param {Face} face */
function isInPlane({ lower, upper, write, writeBeside }, { free, x: [...x] }) {
  const random = createRandom(5);
  const beside = new Float64Array(2);
  for (let look = 0; look < LOOKS; look++) {
    for (const k of free) x[k] = lower[k] + random() * (upper[k] - lower[k]);
    write(x);
    writeBeside(0, beside);
    if (Math.abs(beside[0]) > IN_PLANE) return false;
  }
  return true;
}

/**
 * @param {SectionMap} map
 * @param {number} tolerance  m
 * @param {Face[]} [faces]
 * @returns {Generator<Traced>}
 */
export function* edges(map, tolerance, faces = innerFaces(map, 1)) {
  for (const { free, x, fixed } of faces) {
    const [i] = free;
    /** @param {Vertex} a @param {Vertex} b */
    const between = (a, b) =>
      vertexAt(
        map,
        a.x.map((value, k) => (value + b.x[k]) / 2),
      );
    const vertices = Array.from({ length: EDGE_PLACES + 1 }, (_, k) => {
      const share = k / EDGE_PLACES;
      const place = x.slice();
      place[i] = share === 1 ? map.upper[i] : map.lower[i] + share * (map.upper[i] - map.lower[i]);
      return vertexAt(map, place);
    });
    yield* refined({ kind: 'limit', fixed, between }, vertices, tolerance).runs;
  }
}

/**
 * @param {SectionMap} map
 * @param {number} tolerance
 * @returns {Generator<Traced | null>}  null after each face
 */
export function* folds(map, tolerance) {
  const { Jf } = map;
  for (const { free, x, fixed } of innerFaces(map, 2)) {
    const [a, b] = free;
    const place = x.slice();
    const determinant = (/** @type {number} */ p, /** @type {number} */ q) => {
      place[a] = p;
      place[b] = q;
      map.write(place);
      return Jf[2 * a] * Jf[2 * b + 1] - Jf[2 * a + 1] * Jf[2 * b];
    };
    yield* contours(map, { free, x, fixed, kind: 'singular', of: determinant, isThere: () => true }, tolerance);
    yield null;
  }
}

/**
 * Where the joint that the plane takes care of would stand at a limit of its own.
 * @param {SectionMap} map
 * @param {number} tolerance
 * @returns {Generator<Traced | null>}  likewise
 */
export function* ownLimits(map, tolerance) {
  const beside = new Float64Array(2);
  for (const { free, x, fixed, held = 0 } of heldFaces(map, 2)) {
    const [a, b] = free;
    const place = x.slice();
    const write = (/** @type {number} */ p, /** @type {number} */ q) => {
      place[a] = p;
      place[b] = q;
      map.write(place);
      map.writeBeside(held, beside);
    };
    const of = (/** @type {number} */ p, /** @type {number} */ q) => (write(p, q), beside[0]);
    const isThere = (/** @type {number} */ p, /** @type {number} */ q) => (write(p, q), beside[1] > 0);
    yield* contours(map, { free, x, fixed, kind: 'limit', of, isThere }, tolerance);
    yield null;
  }
}

/**
 * @typedef {object} Wanted   a contour on a face of two free arguments
 * @property {number[]} free
 * @property {Float64Array} x
 * @property {Fixed[]} fixed
 * @property {Traced['kind']} kind
 * @property {(p: number, q: number) => number} of
 * @property {(p: number, q: number) => boolean} isThere  where it counts
 */

/**
 * @param {SectionMap} map
 * @param {Wanted} wanted
 * @param {number} tolerance
 * @returns {Generator<Traced>}
 */
function* contours(map, { free: [a, b], x, fixed, kind, of, isThere }, tolerance) {
  const vertexOf = (/** @type {number[]} */ [p, q]) => {
    const place = x.slice();
    place[a] = p;
    place[b] = q;
    return vertexAt(map, place);
  };
  const [low, high] = [map.lower, map.upper].map((ends) => [a, b].map((k) => ends[k] + Number(map.isClosed[k]) * SEAM));
  /** @type {{ low: number[], high: number[], grid: number, depth: number }[]} */
  const rectangles = [{ low, high, grid: GRID, depth: 0 }];
  for (let rectangle = rectangles.pop(); rectangle; rectangle = rectangles.pop()) {
    const { depth } = rectangle;
    const { pieces, between } = contourPieces(of, rectangle);
    for (const piece of pieces.flatMap((each) => stretchesOf(each, isThere, between))) {
      const { runs, gaps } = refined(
        {
          kind,
          fixed,
          between(from, to) {
            const middle = between([from.x[a], from.x[b]], [to.x[a], to.x[b]]);
            return middle && vertexOf(middle);
          },
        },
        piece.map(vertexOf),
        tolerance,
      );
      yield* runs;
      // Two branches cross nearby: a finer grid tells them apart.
      if (depth === DEEPEST) continue;
      for (const [from, to] of gaps) {
        const around = (/** @type {number} */ k, /** @type {0 | 1} */ axis) => {
          const [one, other] = [from.x[k], to.x[k]];
          const margin = Math.max(Math.abs(other - one), (high[axis] - low[axis]) / (GRID * CLOSER ** depth));
          return [
            Math.max(low[axis], Math.min(one, other) - margin),
            Math.min(high[axis], Math.max(one, other) + margin),
          ];
        };
        const [[lowA, highA], [lowB, highB]] = [around(a, 0), around(b, 1)];
        rectangles.push({ low: [lowA, lowB], high: [highA, highB], grid: FINER, depth: depth + 1 });
      }
    }
  }
}

/**
 * Parts of a contour that count, up to where that ends.
 * @param {readonly Point[]} piece
 * @param {(p: number, q: number) => boolean} isThere
 * @param {(a: Point, b: Point) => Point | null} between
 * @returns {Point[][]}
 */
function stretchesOf(piece, isThere, between) {
  /** @type {Point[][]} */
  const stretches = [];
  /** The last that counts between one that does and one that does not. @param {Point} there @param {Point} beyond */
  const lastBetween = (there, beyond) => {
    for (let halving = 0; halving < HALVINGS; halving++) {
      const middle = between(there, beyond);
      if (!middle) break;
      if (isThere(middle[0], middle[1])) there = middle;
      else beyond = middle;
    }
    return there;
  };
  piece.forEach((point, k) => {
    const before = k > 0 ? piece[k - 1] : null;
    const wasThere = before !== null && isThere(before[0], before[1]);
    if (!isThere(point[0], point[1])) {
      if (wasThere) stretches[stretches.length - 1].push(lastBetween(before, point));
    } else if (wasThere) stretches[stretches.length - 1].push(point);
    else stretches.push(before ? [lastBetween(point, before), point] : [point]);
  });
  return stretches.filter(({ length }) => length > 1);
}
