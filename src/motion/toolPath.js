/**
 * Ways of the tool in space, by the share of the way from 0 to 1: the straight line, and the circle through a point on the
 * way. The tool turns at a constant rate about one axis, the shorter way round (as spherical interpolation of quaternions).
 *
 * @import { Pose } from '../kinematics/pose.js'
 *
 * @typedef {object} ToolPath
 * @property {number} length  m
 * @property {number} turn    rad, at most a half turn
 * @property {number} bend    1/m, of a circle; 0 for a line
 * @property {(share: number, out?: Pose) => Pose} poseAt
 * @property {(share: number, first: Float64Array, second: Float64Array) => void} motionAt   fills 6 numbers each, linear part
 *   first: the twist by the share, and its derivative
 * @property {(from: number, to: number) => number} sixthOfPlace   m; between two shares, by how much of the way between them
 *   is gone, no sixth derivative of the place is larger
 * @property {(from: number, to: number, sums: Float64Array) => void} addTurning   likewise adds to sums[k] what k-th
 *   derivatives the angles have by which the tool is turned
 *
 * @typedef {ToolPath & { center: number[], radius: number, normal: number[], sweep: number, viaShare: number }} ArcPath
 *   sweep: rad; viaShare: where it passes the point on the way
 */
import { poseFromRotationVector } from '../kinematics/orientations/axisAngle.js';
import { compose, poseDifference, requirePose } from '../kinematics/pose.js';

const ORIGIN = [0, 0, 0];

/** Three points whose triangle is flatter than this, over its longest side, have no circle that digits could tell. */
const FLAT = 1e-6;

/**
 * @param {ArrayLike<number>} T_base_from
 * @param {ArrayLike<number>} T_base_to
 * @returns {ToolPath}
 */
export function linePath(T_base_from, T_base_to) {
  const { turn, rotation, turnTo } = turning(T_base_from, T_base_to);
  const [from, to] = [pointOf(T_base_from), pointOf(T_base_to)];
  const way = minus(to, from);
  return {
    length: length(way),
    turn,
    bend: 0,
    motionAt(_, first, second) {
      first.set(way);
      first.set(rotation, 3);
      second.fill(0);
    },
    sixthOfPlace: () => 0,
    addTurning: (a, b, sums) => void (sums[1] += turn * (b - a)),
    poseAt: (share, out = new Float64Array(16)) =>
      turnTo(share, share === 1 ? to : from.map((x, k) => x + share * (to[k] - x)), out),
  };
}

/**
 * Whether a circle passes three points: they are apart, and not on one line.
 * @param {ArrayLike<number>} T_base_from
 * @param {ArrayLike<number>} via   x, y, z in metres
 * @param {ArrayLike<number>} T_base_to
 */
export function hasArc(T_base_from, via, T_base_to) {
  const [u, v] = [minus(Array.from(via), pointOf(T_base_from)), minus(pointOf(T_base_to), pointOf(T_base_from))];
  const longest = Math.max(length(u), length(v), length(minus(v, u)));
  return length(cross(u, v)) > FLAT * longest * longest;
}

/**
 * The arc from one pose past a point to another pose.
 * @param {ArrayLike<number>} T_base_from
 * @param {ArrayLike<number>} via   x, y, z in metres
 * @param {ArrayLike<number>} T_base_to
 * @returns {ArcPath}
 * @throws {RangeError} when the three points lie on a line, or two are the same
 */
export function arcPath(T_base_from, via, T_base_to) {
  const { turn, rotation, turnTo } = turning(T_base_from, T_base_to);
  const [from, to] = [pointOf(T_base_from), pointOf(T_base_to)];
  const [u, v] = [minus(Array.from(via), from), minus(to, from)];
  const across = cross(u, v);
  const area = length(across);
  if (!hasArc(T_base_from, via, T_base_to)) {
    throw new RangeError('Expected three points that are apart and not on one line, for a circle through them.');
  }
  // from + ((|v|² u − |u|² v) rotated a quarter about the normal) / (2 |u × v|): where the bisectors meet
  const [uu, vv] = [dot(u, u), dot(v, v)];
  const toCenter = cross(
    across,
    minus(
      v.map((x) => x * uu),
      u.map((x) => x * vv),
    ),
  ).map((x) => -x / (2 * area * area));
  const radius = length(toCenter);
  const normal = across.map((x) => x / area);
  const center = from.map((x, k) => x + toCenter[k]);
  const e = toCenter.map((x) => -x / radius);
  const f = cross(normal, e);
  // the normal is such that the way past the point is the positive one
  const [passed, sweep] = [Array.from(via), to].map((point) => {
    const r = minus(point, center);
    const angle = Math.atan2(dot(r, f), dot(r, e));
    return angle > 0 ? angle : angle + 2 * Math.PI;
  });
  return {
    length: radius * sweep,
    turn,
    bend: 1 / radius,
    center,
    radius,
    normal,
    sweep,
    viaShare: passed / sweep,
    motionAt(share, first, second) {
      const [c, s] = [radius * Math.cos(share * sweep), radius * Math.sin(share * sweep)];
      for (let k = 0; k < 3; k++) {
        first[k] = sweep * (c * f[k] - s * e[k]);
        first[3 + k] = rotation[k];
        second[k] = -sweep * sweep * (c * e[k] + s * f[k]);
        second[3 + k] = 0;
      }
    },
    sixthOfPlace: (a, b) => radius * (sweep * (b - a)) ** 6,
    addTurning: (a, b, sums) => void (sums[1] += turn * (b - a)),
    poseAt(share, out = new Float64Array(16)) {
      const [c, s] = [radius * Math.cos(share * sweep), radius * Math.sin(share * sweep)];
      const place = share === 0 ? from : share === 1 ? to : center.map((x, k) => x + c * e[k] + s * f[k]);
      return turnTo(share, place, out);
    },
  };
}

/** @param {ArrayLike<number>} T_base_from @param {ArrayLike<number>} T_base_to */
function turning(T_base_from, T_base_to) {
  const start = requirePose(T_base_from, 'the pose to go from');
  const [, , , x, y, z] = poseDifference(start, requirePose(T_base_to, 'the pose to go to'));
  const end = Float64Array.from(T_base_to);
  const R = new Float64Array(16);

  /** @param {number} share @param {readonly number[]} place @param {Pose} out */
  function turnTo(share, place, out) {
    if (share === 1) out.set(end);
    else compose(poseFromRotationVector(ORIGIN, [x * share, y * share, z * share], R), start, out);
    for (let k = 0; k < 3; k++) out[12 + k] = place[k];
    return out;
  }
  return { turn: length([x, y, z]), rotation: [x, y, z], turnTo };
}

/** @param {ArrayLike<number>} T */
const pointOf = (T) => [T[12], T[13], T[14]];
/** @param {readonly number[]} a @param {readonly number[]} b */
const minus = (a, b) => a.map((x, k) => x - b[k]);
/** @param {readonly number[]} a @param {readonly number[]} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @param {readonly number[]} a @param {readonly number[]} b */
const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
/** @param {readonly number[]} a */
const length = ([x, y, z]) => Math.sqrt(x * x + y * y + z * z);
