/**
 * All postures of six turning joints of which three neighbours are parallel and the two beyond them meet: the arms of
 * Universal Robots and of most who build like them (axes 2 ∥ 3 ∥ 4; 5 meets 6), or the same arm held by its other end
 * (3 ∥ 4 ∥ 5; 1 meets 2), which is solved as the chain read backwards. What angles the axes make is of no account.
 *
 * Seen in a frame whose z is the direction of the three, with G = E_1 … E_6 and c the point where 5 and 6 meet:
 *
 *   1. (E_1⁻¹ G c)_z = c_z, since 2, 3, 4 move nothing along z and 5, 6 leave c alone: two values of q1.
 *   2. R_1⁻¹ R_G = Rz(φ) R_5 R_6 with φ = q2 + q3 + q4, three turns about known axes: two values of q5, then φ and q6.
 *   3. E_2 E_3 takes the point of axis 4 to where φ and E_1⁻¹ G c put it: a triangle of two links, two values of q3.
 *
 * The steps are subproblems of Paden and Kahan (Murray, Li, Sastry 1994, section 3.2), with angles taken from their halves:
 * an arccosine would lose half the digits where two solutions are about to meet. Every later step starts from what the
 * earlier ones really came to, so that the pose is met to the last digits even there.
 *
 * @import { Candidates } from './candidates.js'
 * @import { Screws } from '../screws.js'
 * @import { ThreeParallel } from './threeParallelLines.js'
 */
import { noCandidates } from './candidates.js';
import { halfAngle } from './halfAngle.js';
import { compose, invert } from '../pose.js';
import { straightening, sumSlack } from './straightening.js';
import { threeParallelLines } from './threeParallelLines.js';

/** Axes in line to this sine, or points nearer than this part of the arm's length, are one: half of what is checked later. */
const IN_LINE = 5e-10;

/** How many values of q1 are tried where all of them may do. */
const SAMPLES = 16;

const G = new Float64Array(16);
/** R_G times axis 6, then times a direction across it. */
const goals = new Float64Array(6);
/** From the point of axis 1 to G c. */
const arrow = new Float64Array(3);
/** What is left when the turn about axis 1 is taken off: the place of c, and the two directions of `goals`. */
const wrist = new Float64Array(3);
const left = new Float64Array(6);
/** R_5 times axis 6, times the direction across it, and times the one across both. */
const turned = new Float64Array(9);

/**
 * @param {Screws} screws
 * @returns {ThreeParallel | null} null if the arm is not of this kind
 */
export function recogniseThreeParallel(screws) {
  return threeParallelLines(screws, false) ?? threeParallelLines(screws, true);
}

/**
 * @param {ThreeParallel} arm
 * @param {ArrayLike<number>} T_start_goal
 * @returns {Candidates}
 */
export function solveThreeParallel(arm, T_start_goal) {
  compose(compose(arm.T_frame_start, T_start_goal, G), arm.T_home_frame, G);
  if (arm.isReversed) invert(G, G);
  const found = noCandidates();
  solveFirst(arm, found);
  return arm.isReversed ? reversed(found) : found;
}

/** Step 1. @param {ThreeParallel} arm @param {Candidates} found */
function solveFirst(arm, found) {
  const { axis1, point1, axis6, across6, meeting, length } = arm;
  for (let i = 0; i < 3; i++) {
    goals[i] = G[i] * axis6[0] + G[4 + i] * axis6[1] + G[8 + i] * axis6[2];
    goals[3 + i] = G[i] * across6[0] + G[4 + i] * across6[1] + G[8 + i] * across6[2];
    arrow[i] = G[i] * meeting[0] + G[4 + i] * meeting[1] + G[12 + i] - point1[i];
  }
  const along = axis1[0] * arrow[0] + axis1[1] * arrow[1] + axis1[2] * arrow[2];
  const cosine = arrow[2] - axis1[2] * along;
  const sine = axis1[1] * arrow[0] - axis1[0] * arrow[1];
  const height = -point1[2] - axis1[2] * along;
  const swing = Math.sqrt(cosine * cosine + sine * sine);
  if (swing < IN_LINE * length && Math.abs(height) < IN_LINE * length) {
    solveAnyFirst(arm, found);
    return;
  }
  const scale = length + swing;
  const half = halfAngle(swing - height, scale, swing + height, scale, scale);
  if (Number.isNaN(half)) return;
  const middle = Math.atan2(sine, cosine);
  solveFifth(arm, middle + half, found);
  if (half > 0 && half < Math.PI) solveFifth(arm, middle - half, found);
}

/**
 * The wrist is on axis 1, at its height whatever q1 is: any q1 that leaves it within the others' reach will do. Postures of
 * the best of some values of q1 stand for the families they are in; which of those are one is not known.
 * @param {ThreeParallel} arm
 * @param {Candidates} found
 */
function solveAnyFirst(arm, found) {
  /** @type {Float64Array[]} */
  let best = [];
  for (let i = 0; i < SAMPLES; i++) {
    const { postures } = collected((tried) => solveFifth(arm, (2 * Math.PI * (i + 0.5)) / SAMPLES, tried));
    if (postures.length > best.length) best = postures;
  }
  found.isComplete = false;
  found.families = best.map((q) => ({ kind: 'shoulder', q, joints: [0, 1, 2, 3, 4, 5] }));
}

/** @param {(found: Candidates) => void} solve */
function collected(solve) {
  const found = noCandidates();
  solve(found);
  return found;
}

/** Step 2. @param {ThreeParallel} arm @param {number} q1 @param {Candidates} found */
function solveFifth(arm, q1, found) {
  const { axis1, point1, tilt5, tilt6, nearest5 } = arm;
  const cos = Math.cos(q1);
  const sin = -Math.sin(q1);
  turn(axis1, cos, sin, arrow, 0, wrist);
  for (let i = 0; i < 3; i++) wrist[i] += point1[i];
  turn(axis1, cos, sin, goals, 0, left);
  turn(axis1, cos, sin, goals, 3, left);
  const tilt = Math.sqrt(left[0] * left[0] + left[1] * left[1]);
  const angle = Math.atan2(tilt, left[2]);
  const half = halfAngle(
    Math.sin((angle + tilt5 - tilt6) / 2),
    Math.sin((angle - tilt5 + tilt6) / 2),
    Math.sin((tilt5 + tilt6 + angle) / 2),
    Math.sin((tilt5 + tilt6 - angle) / 2),
    1,
  );
  if (Number.isNaN(half)) return;
  if (tilt < IN_LINE) {
    const q5 = nearest5 + Math.round(half / Math.PI) * Math.PI;
    turnFifth(arm, q5);
    solveInLine(arm, q1, q5, found);
    return;
  }
  const slack = sumSlack(tilt);
  solveSum(arm, q1, nearest5 + half, slack, found);
  if (half > 0 && half < Math.PI) solveSum(arm, q1, nearest5 - half, slack, found);
}

/** @param {ThreeParallel} arm @param {number} q5 */
function turnFifth({ turns5 }, q5) {
  const cos = Math.cos(q5);
  const sin = Math.sin(q5);
  for (let i = 0; i < 3; i++) {
    for (let at = i; at < 9; at += 3) {
      const from = 3 * (at - i) + i;
      turned[at] = turns5[from] + cos * turns5[from + 3] + sin * turns5[from + 6];
    }
  }
}

/**
 * φ takes axis 6, as q5 leaves it, to where it has to be.
 * @param {ThreeParallel} arm
 * @param {number} q1
 * @param {number} q5
 * @param {number} slack  of φ, radians
 * @param {Candidates} found
 */
function solveSum(arm, q1, q5, slack, found) {
  turnFifth(arm, q5);
  const x = turned[0];
  const y = turned[1];
  const sum = Math.atan2(x * left[1] - y * left[0], x * left[0] + y * left[1]);
  solveElbow(arm, q1, q5, sum + straightening(arm, wrist, sum, slack), found);
}

/**
 * Step 3, once all else is known: axis 4 has to be at (x, y) from axis 2.
 * @param {ThreeParallel} arm
 * @param {number} q1
 * @param {number} q5
 * @param {number} sum  φ
 * @param {Candidates} found
 */
function solveElbow(arm, q1, q5, sum, found) {
  const { upper, fore, offset, length } = arm;
  const cos = Math.cos(sum);
  const sin = Math.sin(sum);
  const x = wrist[0] - cos * offset[0] + sin * offset[1];
  const y = wrist[1] - sin * offset[0] - cos * offset[1];
  const reach = Math.sqrt(x * x + y * y);
  const whole = upper + fore;
  const apart = Math.abs(upper - fore);
  const half = halfAngle(whole - reach, whole + reach, reach - apart, reach + apart, length);
  if (Number.isNaN(half)) return;
  const toward = Math.atan2(y, x);
  const q6 = lastOf(cos, sin);
  if (reach < IN_LINE * length) {
    const q = postureOf(arm, q1, toward, Math.PI, sum, q5, q6);
    found.families.push({ kind: 'other', q, joints: [1, 3] });
    return;
  }
  found.postures.push(postureOf(arm, q1, toward, half, sum, q5, q6));
  if (half > 0 && half < Math.PI) found.postures.push(postureOf(arm, q1, toward, -half, sum, q5, q6));
}

/** q6 from what is left of the orientation when the others are taken off. @param {number} cos of φ @param {number} sin */
function lastOf(cos, sin) {
  const x = cos * left[3] + sin * left[4];
  const y = cos * left[4] - sin * left[3];
  const z = left[5];
  return Math.atan2(turned[6] * x + turned[7] * y + turned[8] * z, turned[3] * x + turned[4] * y + turned[5] * z);
}

/**
 * @param {ThreeParallel} arm
 * @param {number} q1
 * @param {number} toward  the direction from axis 2 to axis 4
 * @param {number} elbow  the angle of the second link against the first
 * @param {number} sum
 * @param {number} q5
 * @param {number} q6
 */
function postureOf({ upper, fore, bend, senses }, q1, toward, elbow, sum, q5, q6) {
  const second = toward - Math.atan2(fore * Math.sin(elbow), upper + fore * Math.cos(elbow));
  const third = elbow - bend;
  return Float64Array.of(q1, second, senses[1] * third, senses[2] * (sum - second - third), q5, q6);
}

/**
 * Axis 6 is parallel to the three, and φ is free as far as they reach: axis 4 is anywhere on a circle about c of which some
 * part lies in the ring that the two links reach. Where the ring's edges cut the circle, a family turns about with the
 * elbow straight; uncut, the circle is two families, one for each elbow; cut twice, it is two pieces.
 * @param {ThreeParallel} arm
 * @param {number} q1
 * @param {number} q5
 * @param {Candidates} found
 */
function solveInLine(arm, q1, q5, found) {
  const { upper, fore, offset, length } = arm;
  const distance = Math.hypot(wrist[0], wrist[1]);
  const radius = Math.hypot(offset[0], offset[1]);
  const near = Math.abs(distance - radius);
  const far = distance + radius;
  const isCutNear = near < Math.abs(upper - fore);
  const isCutFar = far > upper + fore;
  const low = isCutNear ? Math.abs(upper - fore) : near;
  const high = isCutFar ? upper + fore : far;
  const reach = (low + high) / 2;
  const isRound = far - near < IN_LINE * length;
  const outer = isRound ? 0 : halfAngle(far - reach, far + reach, reach - near, reach + near, length);
  if (low > high + IN_LINE * length || Number.isNaN(outer)) return;

  const start = Math.atan2(wrist[1], wrist[0]) - Math.atan2(offset[1], offset[0]) + Math.PI;
  const tried = collected((all) => {
    solveElbow(arm, q1, q5, start + outer, all);
    if (isCutNear && isCutFar && !isRound) solveElbow(arm, q1, q5, start - outer, all);
  });
  if (!isRound && high - low < IN_LINE * length) {
    found.postures.push(...tried.postures);
    return;
  }
  const kept = isCutNear || isCutFar ? tried.postures.filter((_, i) => i % 2 === 0) : tried.postures;
  const joints = isRound ? (radius < distance ? [3, 5] : [1, 5]) : [1, 2, 3, 5];
  for (const q of kept) found.families.push({ kind: 'wrist', q, joints });
}

/**
 * A vector turned about an axis through the origin (Rodrigues).
 * @param {ArrayLike<number>} axis
 * @param {number} cos
 * @param {number} sin
 * @param {Float64Array} from
 * @param {number} at  where the vector stands in `from`, and in `out`
 * @param {Float64Array} out
 */
function turn(axis, cos, sin, from, at, out) {
  const x = from[at];
  const y = from[at + 1];
  const z = from[at + 2];
  const along = (1 - cos) * (axis[0] * x + axis[1] * y + axis[2] * z);
  out[at] = cos * x + sin * (axis[1] * z - axis[2] * y) + along * axis[0];
  out[at + 1] = cos * y + sin * (axis[2] * x - axis[0] * z) + along * axis[1];
  out[at + 2] = cos * z + sin * (axis[0] * y - axis[1] * x) + along * axis[2];
}

/**
 * What was found for the chain read backwards, for the chain as it is.
 * @param {Candidates} found
 * @returns {Candidates}
 */
function reversed({ postures, families, isComplete }) {
  const turnedRound = (/** @type {Float64Array} */ q) => q.map((value) => -value).reverse();
  return {
    postures: postures.map(turnedRound),
    families: families.map(({ q, joints }) => ({
      kind: 'other',
      q: turnedRound(q),
      joints: joints.map((joint) => 5 - joint).reverse(),
    })),
    isComplete,
  };
}
