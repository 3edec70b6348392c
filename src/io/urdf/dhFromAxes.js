/**
 * Joint axes in space → a standard Denavit–Hartenberg table, exactly. Any serial chain of turning and sliding joints has one;
 * where it has many, the choices are those that give the plainest numbers (docs/model.md).
 *
 * Frame i − 1 has its z along axis i. Its origin is the foot on axis i of the common normal from axis i − 1, and its x lies along
 * that normal (Denavit & Hartenberg 1955). What is free: the first frame has the foot of the base's origin; where axes are
 * parallel, d = 0; where they cross or run along each other, x turns as little as may be; a slide has no place, and is taken
 * through the next axis; the last frame has its z along the tip's. The rest is in base and tool.
 *
 * @import { Pose } from '../../kinematics/pose.js'
 *
 * @typedef {object} Axis   at zero joint values, seen from the base
 * @property {readonly number[]} point
 * @property {readonly number[]} direction  of length 1
 * @property {boolean} slides
 *
 * @typedef {{ theta: number, d: number, a: number, alpha: number }} Row  metres and radians
 * @typedef {{ after: number, angle: number }} NearlyParallel  the axes of joints `after` and `after` + 1 (from 1); radians
 */
import { compose, invert, position } from '../../kinematics/pose.js';

/** Closer to parallel than this an axis is parallel: √ε, where the normal of nearly parallel lines loses as much as that. */
const PARALLEL = 1.5e-8;

/** Closer than this, and the table of exact axes has links so long that a person should be asked. */
const NEARLY_PARALLEL = 2e-3;

/** A normal shorter than this, in metres or as a share of where the axes are, is rounding: the axes are one. */
const NO_LENGTH = { metres: 1e-12, share: 4e-15 };

/** @param {readonly number[]} a @param {readonly number[]} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @param {readonly number[]} a @param {readonly number[]} b */
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @param {readonly number[]} p @param {number} s @param {readonly number[]} v */
const along = (p, s, v) => [p[0] + s * v[0], p[1] + s * v[1], p[2] + s * v[2]];
/** @param {readonly number[]} p @param {readonly number[]} from */
const minus = (p, from) => along(p, -1, from);
/** What of v is at a right angle to z. @param {readonly number[]} v @param {readonly number[]} z */
const squared = (v, z) => along(v, -dot(v, z), z);
/** @param {readonly number[]} v */
const unit = (v) => along([0, 0, 0], 1 / Math.hypot(...v), v);
/** @param {ArrayLike<number>} T @param {0 | 4 | 8} column */
const axisOf = (T, column) => [T[column], T[column + 1], T[column + 2]];

/** @param {readonly number[]} x @param {readonly number[]} z @param {readonly number[]} p @returns {Pose} */
function frame(x, z, p) {
  const y = cross(z, x);
  return Float64Array.of(...x, 0, ...y, 0, ...z, 0, ...p, 1);
}

/** Of x and −x the one that turns less from the last. @param {readonly number[]} x @param {readonly number[]} last */
const nearer = (x, last) => (dot(x, last) < 0 ? minus([0, 0, 0], x) : x);

/** At a right angle to z, as near to `wanted` as may be, or else to `instead`. @param {readonly number[]} z @param {readonly number[][]} wanted */
function across(z, wanted) {
  for (const v of wanted) {
    const rest = squared(v, z);
    if (Math.hypot(...rest) > 0.5) return unit(rest);
  }
  throw new RangeError('Expected directions of which one is not along z.');
}

/**
 * @param {readonly Axis[]} axes
 * @param {ArrayLike<number>} T_base_tip  at zero joint values
 * @param {number} [snap]  axes closer to parallel than this, in radians, are made parallel
 * @returns {{ T_base_frame0: Pose, rows: Row[], T_flange_tip: Pose, nearlyParallel: NearlyParallel[] }}
 */
export function dhFromAxes(axes, T_base_tip, snap = 0) {
  const parallel = Math.max(PARALLEL, snap);
  const tip = { point: position(T_base_tip), direction: axisOf(T_base_tip, 8), slides: false };
  const lines = placed([...axes, tip]);
  /** @type {NearlyParallel[]} */
  const nearlyParallel = [];
  /** @type {readonly number[]} */
  let z = lines[0].direction;
  /** @type {readonly number[]} */
  let origin = along(lines[0].point, -dot(lines[0].point, z), z);
  /** @type {readonly number[]} */
  let x = across(z, [
    [1, 0, 0],
    [0, 1, 0],
  ]);
  const first = frame(x, z, origin);
  let last = first;
  const rows = lines.slice(1).map(({ point, direction }, i) => {
    const normal = cross(z, direction);
    const sine = Math.hypot(...normal);
    const apart = minus(point, origin);
    const isLast = i + 1 === axes.length; // the tip's z is a wish: the tool makes up for what it is off
    if (sine > PARALLEL && sine < NEARLY_PARALLEL && !isLast)
      nearlyParallel.push({ after: i + 1, angle: Math.asin(sine) });
    if (sine < (isLast ? NEARLY_PARALLEL : parallel)) {
      // the axis is taken for parallel; the normal starts at the last origin, so that d = 0
      const normalThere = squared(squared(apart, z), z); // twice, since the origin may be far away
      const length = Math.hypot(...normalThere);
      if (dot(z, direction) < 0) z = minus([0, 0, 0], z);
      if (length > Math.max(NO_LENGTH.metres, NO_LENGTH.share * Math.hypot(...apart))) {
        x = nearer(unit(normalThere), x);
        origin = along(origin, 1, normalThere);
      }
    } else {
      const foot = dot(cross(apart, z), normal) / sine ** 2;
      origin = along(point, foot, direction);
      z = direction;
      x = nearer(unit(normal), x);
    }
    // rounding of one frame is not handed on to the next
    x = unit(squared(x, z));
    const next = frame(x, z, origin);
    const M = compose(invert(last), next);
    last = next;
    return rowOf(M);
  });
  return { T_base_frame0: first, rows, T_flange_tip: compose(invert(last), T_base_tip), nearlyParallel };
}

/** The four numbers of Rz(θ) Tz(d) Tx(a) Rx(α). @param {ArrayLike<number>} M @returns {Row} */
const rowOf = (M) => ({
  theta: Math.atan2(M[1], M[0]),
  d: M[14],
  a: M[12] * M[0] + M[13] * M[1],
  alpha: Math.atan2(M[6], M[10]),
});

/** Slides, which have only a direction, run through the next line that has a place. @param {readonly Axis[]} lines */
const placed = (lines) =>
  lines.map((line, i) =>
    line.slides ? { ...line, point: lines.slice(i).find(({ slides }) => !slides)?.point ?? line.point } : line,
  );
