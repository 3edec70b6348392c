/**
 * What threeParallel.js knows of an arm before it is given a goal: the lines of its axes in the frame that suits them.
 *
 * That frame has its z along the three parallel axes, its origin on the first of them at the height of the point where the
 * last two axes meet, and its x towards the second of them. In it the two links between the three axes are seen in the
 * plane z = 0, as the triangle they make there.
 *
 * @import { Vector } from '../lines.js'
 * @import { Pose } from '../pose.js'
 * @import { Screws } from '../screws.js'
 *
 * @typedef {object} ThreeParallel   constants of an arm, in the order of the chain or (isReversed) against it
 * @property {boolean} isReversed
 * @property {Pose} T_frame_start   with T_home_frame: frame⁻¹ · T · home⁻¹ · frame is the product of the turns about the lines
 * @property {Pose} T_home_frame
 * @property {number} length  m
 * @property {Vector} axis1
 * @property {Vector} point1
 * @property {readonly [number, number, number]} senses  1 or −1: whether axes 2, 3, 4 go up or down
 * @property {number} upper   from axis 2 to 3, m
 * @property {number} fore    from axis 3 to 4, m
 * @property {number} bend    the angle of the second link against the first while all joint values are zero
 * @property {readonly [number, number]} offset   from axis 4 to the point where 5 and 6 meet
 * @property {readonly [number, number]} meeting  that point; its z is 0
 * @property {Vector} axis6
 * @property {Vector} across6   a direction across axis 6
 * @property {Float64Array} turns5  3 · 9: of axis 6, across6 and the third across both, the part along axis 5, the part across
 *   it, and that turned by a right angle: the cosine and sine of q5 do the rest
 * @property {number} tilt5   the angle between z and axis 5
 * @property {number} tilt6   between axis 5 and axis 6
 * @property {number} nearest5  the q5 at which axis 6 is nearest to z
 */
import { along, cross, dot, minus, nearestTo, norm, unit } from '../lines.js';
import { compose, identity, invert } from '../pose.js';

/** Directions that differ by less are parallel; points nearer than this part of the arm's length are one. */
const SAME = 1e-9;

/** Axes have to make at least this angle (its sine) to be called across each other: the steps divide by it. */
const ACROSS = 1e-3;

/**
 * @param {Screws} screws
 * @param {boolean} isReversed  whether the last joint counts as the first
 * @returns {ThreeParallel | null} null if the arm is not of this kind
 */
export function threeParallelLines({ dof, slides, axes, points, home, length }, isReversed) {
  if (dof !== 6 || slides.includes(true)) return null;
  const joint = (/** @type {number} */ i) => 3 * (isReversed ? 6 - i : i - 1);
  const axis = (/** @type {number} */ i) => /** @type {Vector} */ (Array.from(axes.subarray(joint(i), joint(i) + 3)));
  const point = (/** @type {number} */ i) =>
    /** @type {Vector} */ (Array.from(points.subarray(joint(i), joint(i) + 3)));
  const z = axis(2);
  const isAlong = (/** @type {number} */ i) => norm(cross(z, axis(i))) < SAME;
  if (!isAlong(3) || !isAlong(4)) return null;
  const isAcross = (/** @type {Vector} */ a, /** @type {Vector} */ b) => norm(cross(a, b)) > ACROSS;
  if (!isAcross(axis(1), z) || !isAcross(z, axis(5)) || !isAcross(axis(5), axis(6))) return null;

  const normal = cross(axis(5), axis(6));
  const between = minus(point(6), point(5));
  if (Math.abs(dot(between, normal)) > SAME * length * norm(normal)) return null;
  const c = nearestTo({ axis: axis(5), point: point(5) }, { axis: axis(6), point: point(6) });
  const origin = along(point(2), dot(minus(c, point(2)), z), z);
  const link = minus(point(3), point(2));
  const flat = along(link, -dot(link, z), z);
  const upper = norm(flat);
  if (!(upper > SAME * length)) return null;
  const x = unit(flat);
  const y = cross(z, x);
  const seen = (/** @type {Vector} */ v) => /** @type {Vector} */ ([dot(v, x), dot(v, y), dot(v, z)]);
  const place = (/** @type {Vector} */ p) => seen(minus(p, origin));
  const elbow = place(point(3));
  const end = place(point(4));
  const meeting = place(c);
  const fore = Math.hypot(end[0] - elbow[0], end[1] - elbow[1]);
  if (!(fore > SAME * length)) return null;

  const T_start_frame = identity();
  [x, y, z, origin].forEach((column, i) => T_start_frame.set(column, 4 * i));
  const axis5 = seen(axis(5));
  const axis6 = seen(axis(6));
  const across6 = unit(seen(normal));
  const up = along([0, 0, 1], -axis5[2], axis5);
  return {
    isReversed,
    T_frame_start: invert(T_start_frame),
    T_home_frame: compose(invert(home), T_start_frame),
    length,
    axis1: seen(axis(1)),
    point1: place(point(1)),
    senses: [1, Math.sign(dot(z, axis(3))), Math.sign(dot(z, axis(4)))],
    upper,
    fore,
    bend: Math.atan2(end[1] - elbow[1], end[0] - elbow[0]),
    offset: [meeting[0] - end[0], meeting[1] - end[1]],
    meeting: [meeting[0], meeting[1]],
    axis6,
    across6,
    turns5: Float64Array.from([axis6, across6, cross(axis6, across6)].flatMap((v) => turnParts(axis5, v))),
    tilt5: Math.atan2(Math.hypot(axis5[0], axis5[1]), axis5[2]),
    tilt6: Math.atan2(norm(normal), dot(axis5, axis6)),
    nearest5: Math.atan2(dot(up, cross(axis5, axis6)), dot(up, axis6)),
  };
}

/** The three parts that a turn by q about a line puts together as 1, cos q and sin q. @param {Vector} axis @param {Vector} v */
function turnParts(axis, v) {
  const part = along([0, 0, 0], dot(axis, v), axis);
  return [...part, ...minus(v, part), ...cross(axis, v)];
}
