/**
 * A small line drawing of an arm at home, from its own table: where the links run and where the joints are, as numbers for
 * whoever draws them.
 *
 * @import { RobotDoc } from '../document.js'
 *
 * @typedef {[x: number, y: number]} Point  in the unit square, y up
 *
 * @typedef {object} JointMark
 * @property {Point} at
 * @property {boolean} isSliding
 * @property {number | null} axis  direction of the joint axis in the picture, radians from x; null when it is seen end-on
 *
 * @typedef {object} Sketch
 * @property {Point[]} line       the links, from the base to the tool
 * @property {JointMark[]} joints
 * @property {number | null} ground  height of the floor; null in a view from above
 * @property {number} reach       in the length unit of the robot; Infinity with an unlimited slide
 */
import { linkFrames } from '../../kinematics/forward.js';
import { compilePosture, compileRobot } from '../compile.js';
import { homePosture, isSliding } from '../document.js';
import { fromKernel } from '../units.js';

/** An arm flatter than this, as height over width, is looked at from above. */
const FLAT = 0.1;

/** Axes that lean less than this out of the line of sight, as a sine, count as seen end-on. */
const END_ON = 0.5;

/** A shorter link offset than this, in parts of the picture, is no place for a mark of its own. */
const SHORT = 0.08;

/** @typedef {[number, number, number]} Vector */

/**
 * @param {RobotDoc} robot
 * @returns {Sketch}
 */
export function sketchRobot(robot) {
  const chain = compileRobot(robot);
  const frames = linkFrames(chain, compilePosture(robot, homePosture(robot)));
  const column = (/** @type {number} */ frame, /** @type {number} */ k) =>
    /** @type {Vector} */ ([...frames.subarray(16 * frame + 4 * k, 16 * frame + 4 * k + 3)]);

  const isStandard = robot.convention === 'standard';
  const links = robot.joints.map((joint, i) => {
    const [from, to] = [column(i, 3), column(i + 1, 3)];
    const axis = column(isStandard ? i : i + 1, 2);
    // Along the joint axis first (standard) or last (modified): the corner between d and a.
    const turned = isStandard ? from : to;
    const length = dot(axis, minus(to, from));
    const corner = /** @type {Vector} */ (turned.map((value, k) => value + (isStandard ? length : -length) * axis[k]));
    return { isSliding: isSliding(joint), from, corner, to, axis, onAxis: [turned, corner] };
  });
  const points = [links[0].from, ...links.flatMap(({ corner, to }) => [corner, to])];

  const { project, isFromAbove } = chooseView(points);
  const flat = points.map(project);
  if (!isFromAbove) flat.push([project(points[0])[0], 0]); // the floor under the base belongs to the picture
  const [left, right, low, high] = boundsOf(flat);
  const size = Math.max(right - left, high - low) || 1;
  const place = (/** @type {Vector} */ point) => {
    const [x, y] = project(point);
    return /** @type {Point} */ ([0.5 + (x - (left + right) / 2) / size, 0.5 + (y - (low + high) / 2) / size]);
  };

  return {
    line: points.map(place),
    joints: links.map((link) => {
      const [x, y] = project(link.axis);
      const [start, end] = link.onAxis.map(place);
      const isLong = Math.hypot(end[0] - start[0], end[1] - start[1]) > SHORT;
      return {
        at: isLong ? [(start[0] + end[0]) / 2, (start[1] + end[1]) / 2] : start,
        isSliding: link.isSliding,
        axis: Math.hypot(x, y) < END_ON ? null : Math.atan2(y, x),
      };
    }),
    ground: isFromAbove ? null : 0.5 - (low + high) / 2 / size,
    reach: fromKernel('length', chain.reach, robot.units),
  };
}

/**
 * From the side on which the arm spreads most, to the right; from above if it lies flat.
 * @param {Vector[]} points
 * @returns {{ isFromAbove: boolean, project: (vector: Vector) => Point }}
 */
function chooseView(points) {
  const [base] = points;
  const away = points.map((point) => minus(point, base));
  const far = away.reduce((best, v) => (Math.hypot(v[0], v[1]) > Math.hypot(best[0], best[1]) ? v : best));
  const spread = Math.hypot(far[0], far[1]);
  const heights = points.map(([, , z]) => z);
  const height = Math.max(...heights) - Math.min(...heights);
  if (height < FLAT * spread) return { isFromAbove: true, project: ([x, y]) => [x, y] };
  const [ux, uy] = spread > 0 ? [far[0] / spread, far[1] / spread] : [1, 0];
  return { isFromAbove: false, project: ([x, y, z]) => [x * ux + y * uy, z] };
}

/** @param {Point[]} points @returns {[left: number, right: number, low: number, high: number]} */
function boundsOf(points) {
  const xs = points.map(([x]) => x);
  const ys = points.map(([, y]) => y);
  return [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
}

/** @param {Vector} a @param {Vector} b */
const minus = (a, b) => /** @type {Vector} */ (a.map((value, k) => value - b[k]));

/** @param {Vector} a @param {Vector} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
