/**
 * The plane in which the first three joints of an arm part. Joint 2 carries the point S that joint 3 leaves it to the
 * point Q that joint 1 needs: E_2 S = Q with S = E_3 W and Q = E_1⁻¹ P. It can do so if and only if two numbers of S
 * and Q agree that it does not change: if it turns, the height along its axis and half the square of the distance
 * from a point of it; if it slides, the two coordinates square to it. As joint 3 moves, the numbers of S draw a curve
 * in the plane of the two, as joint 1 moves those of Q do: an ellipse for a turn, a parabola or a straight line for a
 * slide. Where the curves meet are the answers: four at most (Pieper 1968; Craig, Introduction to Robotics, ch. 4). A
 * flat curve (a straight line, traversed to and fro) makes it two quadratic equations one after the other, and the
 * joints of ordinary arms all make one: axes that are parallel or meet.
 *
 * @import { Line, Vector } from '../lines.js'
 *
 * @typedef {[number, number]} Pair
 *
 * @typedef {object} Curve
 * @property {'turns' | 'slides' | 'stays'} kind
 * @property {Pair} start
 * @property {Pair} first   turns: start + first · cos x + second · sin x
 * @property {Pair} second  slides: start + first · x + second · x²
 * @property {Pair} normal  along which a flat curve does not move
 * @property {Pair} tangent square to it: along which the curve moves most
 * @property {number} width   how far it moves along `normal`
 * @property {number} size    how far it moves along `tangent`
 *
 * @typedef {object} Plane  of joint 2
 * @property {Line} line
 * @property {[Vector, Vector]} sides  square to its axis
 */
import { cross, dot, footOn, minus, nearestTo, norm, squareTo } from '../lines.js';

/** @param {Pair} a @param {Pair} b */
export const times = (a, b) => a[0] * b[0] + a[1] * b[1];

/**
 * @param {Line} line
 * @param {readonly (Line | null)[]} neighbours  the first one that is not parallel tells where on the line to measure
 *   from
 * @returns {Plane}
 */
export function planeOf(line, neighbours) {
  const other = neighbours.find((some) => some && norm(cross(some.axis, line.axis)) > 1e-6);
  const point = other ? nearestTo(line, other) : line.point;
  return { line: { ...line, point }, sides: squareTo(line.axis) };
}

/** What joint 2 does not change of a point. @param {Plane} plane @param {Vector} point @returns {Pair} */
export function profileOf({ line, sides }, point) {
  if (line.slides) return [dot(sides[0], point), dot(sides[1], point)];
  const from = minus(point, line.point);
  return [dot(line.axis, from), dot(from, from) / 2];
}

/**
 * Of a point that moves in this direction: the rate.
 * @param {Plane} plane
 * @param {Vector} point
 * @param {Vector} way
 * @returns {Pair}
 */
function rateOf({ line, sides }, point, way) {
  if (line.slides) return [dot(sides[0], way), dot(sides[1], way)];
  return [dot(line.axis, way), dot(minus(point, line.point), way)];
}

/**
 * The curve of a point that a joint carries along, and the joint's place on it while the point is where it is.
 * @param {Plane} plane
 * @param {Line | null} joint  null: none, the point stays
 * @param {Vector} point
 * @returns {{ curve: Curve, place: number, radius: number }}  radius: of the circle that a turning joint carries the
 *   point on
 */
export function curveOf(plane, joint, point) {
  if (!joint) {
    const start = profileOf(plane, point);
    return { curve: shaped({ kind: 'stays', start, first: [0, 0], second: [0, 0] }), place: 0, radius: 0 };
  }
  if (joint.slides) {
    const curve = shaped({
      kind: 'slides',
      start: profileOf(plane, point),
      first: rateOf(plane, point, joint.axis),
      second: [0, plane.line.slides ? 0 : 0.5],
    });
    return { curve, place: 0, radius: 0 };
  }
  const centre = footOn(joint, point);
  const arm = minus(point, centre);
  const radius = norm(arm);
  const [u, v] = squareTo(joint.axis);
  const [h, d] = profileOf(plane, centre);
  const scaled = (/** @type {Pair} */ [x, y]) => /** @type {Pair} */ ([radius * x, radius * y]);
  const curve = shaped({
    kind: 'turns',
    start: plane.line.slides ? [h, d] : [h, d + (radius * radius) / 2],
    first: scaled(rateOf(plane, centre, u)),
    second: scaled(rateOf(plane, centre, v)),
  });
  return { curve, place: Math.atan2(dot(arm, v), dot(arm, u)), radius };
}

/**
 * Finds how flat a curve is. For an ellipse by the singular values of its 2×2 matrix, the smaller as the determinant
 * over the larger, which keeps its digits.
 * @param {Omit<Curve, 'normal' | 'tangent' | 'width' | 'size'>} curve
 * @returns {Curve}
 */
function shaped(curve) {
  const { kind, first, second } = curve;
  if (kind === 'stays') return { ...curve, normal: [1, 0], tangent: [0, 1], width: 0, size: 0 };
  if (kind === 'slides' && second[1] !== 0) {
    return { ...curve, normal: [1, 0], tangent: [0, 1], width: Math.abs(first[0]), size: 1 };
  }
  const angle = Math.atan2(
    2 * (first[0] * first[1] + second[0] * second[1]),
    first[0] ** 2 + second[0] ** 2 - first[1] ** 2 - second[1] ** 2,
  );
  /** @type {Pair} */
  const tangent = [Math.cos(angle / 2), Math.sin(angle / 2)];
  const size = Math.hypot(times(tangent, first), times(tangent, second));
  const width = size === 0 ? 0 : Math.abs(first[0] * second[1] - first[1] * second[0]) / size;
  return { ...curve, tangent, normal: [-tangent[1], tangent[0]], size, width };
}

/** @param {Curve} curve @param {number} x @returns {Pair} */
export function pointAt({ kind, start, first, second }, x) {
  const p = kind === 'turns' ? Math.cos(x) : x;
  const q = kind === 'turns' ? Math.sin(x) : x * x;
  return [start[0] + p * first[0] + q * second[0], start[1] + p * first[1] + q * second[1]];
}

/** @param {Curve} curve @param {number} x @returns {Pair} */
export function slopeAt({ kind, first, second }, x) {
  const p = kind === 'turns' ? -Math.sin(x) : 1;
  const q = kind === 'turns' ? Math.cos(x) : 2 * x;
  return [p * first[0] + q * second[0], p * first[1] + q * second[1]];
}
