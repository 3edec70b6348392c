/**
 * An orientation made by up to three turns about given directions: R_1(q_1) · … · R_m(q_m) = R, the directions as
 * they stand while all angles are zero, at any angles to one another. Three turns have two solutions in general;
 * fewer have one, if the orientation is one that they can make.
 *
 * Three turns (Paden–Kahan subproblems; Murray, Li, Sastry 1994, ch. 3): the last axis c must come to g = R c. The
 * first turn does not change its angle to a, so the second one has to bring it to the angle between a and g: a
 * spherical triangle with sides ∠ab, ∠bc and ∠ag, of which the half-angle formulas give the angle at b to the last
 * digits even where a and g are all but in line. More than three turns are one or more too many: a member is given of
 * the families that they make.
 *
 * @import { Rotation, Vector } from '../lines.js'
 *
 * @typedef {object} TurnFamily
 * @property {number[]} angles  one member
 * @property {number[]} moving  which turns move along it: about axes in line, of which only the sum counts
 *
 * @typedef {object} TurnSolutions
 * @property {number[][]} angles
 * @property {TurnFamily[]} families
 * @property {boolean} isComplete  whether it is proven that there are no others
 */
import {
  angleAbout,
  angleBetween,
  cross,
  dot,
  largestDifference,
  norm,
  product,
  rotate,
  squareTo,
  transposed,
  turn,
} from '../lines.js';
import { turnRoots } from './roots.js';

/** Axes are in line if the sine of the angle between them is below this. */
export const IN_LINE = 1e-9;

/** Radians by which an orientation may be missed here and still be met after polishing. */
const PLAUSIBLE = 1e-4;

/** Of a squared sine or cosine that is negative: rounding, or a rounded goal. */
const NONE = -1e-8;
const ONE = 4e-16;

/** @type {TurnSolutions} */
const NOTHING = Object.freeze({ angles: [], families: [], isComplete: true });

/** @param {Vector} a @param {Vector} b */
export const areInLine = (a, b) => norm(cross(a, b)) < IN_LINE;

/**
 * @param {readonly Vector[]} axes  unit vectors
 * @param {Rotation} R
 * @returns {TurnSolutions}
 */
export function solveTurns(axes, R) {
  const parallel = axes.findIndex((axis, i) => i > 0 && areInLine(axis, axes[i - 1]));
  if (parallel > 0) return withoutTurn(axes, R, parallel);
  if (axes.length > 3) return moreTurns(axes, R);
  if (axes.length === 3) return threeTurns(/** @type {[Vector, Vector, Vector]} */ (axes), R);
  const angles = axes.length === 0 ? [] : axes.length === 1 ? [lastAngle(axes[0], R)] : twoTurns(axes, R);
  const made = angles.reduce((product_, angle, i) => product(product_, turn(axes[i], angle)), turn([0, 0, 1], 0));
  return { ...NOTHING, angles: largestDifference(made, R) < PLAUSIBLE ? [angles] : [] };
}

/** @param {readonly Vector[]} axes @param {Rotation} R */
function twoTurns([a, b], R) {
  const first = angleAbout(a, b, rotate(R, b));
  return [first, lastAngle(b, product(turn(a, -first), R))];
}

/** The angle of a turn about a known axis. @param {Vector} axis @param {Rotation} R */
function lastAngle(axis, R) {
  const [u] = squareTo(axis);
  return angleAbout(axis, u, rotate(R, u));
}

/**
 * Two neighbours about the same direction do what one does alone.
 * @param {readonly Vector[]} axes
 * @param {Rotation} R
 * @param {number} still
 * @returns {TurnSolutions}
 */
function withoutTurn(axes, R, still) {
  const { angles, families, isComplete } = solveTurns(
    axes.filter((_, i) => i !== still),
    R,
  );
  const restore = (/** @type {number[]} */ some) => some.toSpliced(still, 0, 0);
  return {
    angles: [],
    isComplete,
    families: [
      ...angles.map((some) => ({ angles: restore(some), moving: [still - 1, still] })),
      ...families.map(({ angles: some, moving }) => ({
        angles: restore(some),
        moving: [...new Set([still - 1, still, ...moving.map((i) => (i < still ? i : i + 1))])].sort(),
      })),
    ],
  };
}

/** @param {[Vector, Vector, Vector]} axes @param {Rotation} R @returns {TurnSolutions} */
function threeTurns([a, b, c], R) {
  const g = rotate(R, c);
  const ab = angleBetween(a, b);
  const bc = angleBetween(b, c);
  const ag = Math.atan2(norm(cross(a, g)), dot(a, g));
  const scale = Math.sin(ab) * Math.sin(bc);
  const sine = (Math.sin((ag + ab - bc) / 2) * Math.sin((ag - ab + bc) / 2)) / scale;
  const cosine = (Math.sin((ab + bc - ag) / 2) * Math.sin((ab + bc + ag) / 2)) / scale;
  if (sine < NONE || cosine < NONE) return NOTHING;
  const middle = angleAbout(b, c, a);
  const half = 2 * Math.atan2(Math.sqrt(Math.max(sine, 0)), Math.sqrt(Math.max(cosine, 0)));
  const back = transposed(R);
  const solutionAt = (/** @type {number} */ second, /** @type {boolean} */ isInLine) => {
    const R2 = turn(b, second);
    const first = isInLine ? 0 : angleAbout(a, rotate(R2, c), g);
    const [u] = squareTo(c);
    const start = rotate(product(back, product(turn(a, first), R2)), u);
    return [first, second, angleAbout(c, start, u)];
  };
  if (Math.sin(ag) < IN_LINE) {
    return { ...NOTHING, families: [{ angles: solutionAt(middle + half, true), moving: [0, 2] }] };
  }
  // Where a and g come in line both half angles are right to the last digits; at the other ends they are roots of
  // something rounded.
  const isDouble =
    (sine < ONE && Math.abs(ab - bc) > IN_LINE) || (cosine < ONE && Math.abs(ab + bc - Math.PI) > IN_LINE);
  const seconds = isDouble ? [middle + half] : [middle + half, middle - half];
  return { ...NOTHING, angles: seconds.map((second) => solutionAt(second, false)) };
}

/**
 * The first turn is given an angle that the others can do with.
 * @param {readonly Vector[]} axes  4 or more
 * @param {Rotation} R
 * @returns {TurnSolutions}
 */
function moreTurns(axes, R) {
  const moving = axes.map((_, i) => i);
  for (const angle of [0, ...middleAngles(axes, R)]) {
    const { angles, families } = solveTurns(axes.slice(1), product(turn(axes[0], -angle), R));
    const members = [...angles, ...families.map(({ angles: some }) => some)];
    if (members.length > 0) {
      return { ...NOTHING, families: members.map((some) => ({ angles: [angle, ...some], moving })) };
    }
  }
  return { ...NOTHING, isComplete: axes.length === 4 };
}

/**
 * Angles of the first turn that leave the last three as far as can be from the edge of what they can do: the cosine
 * of the angle ∠ag of the triangle above is in the middle of where the turn can bring it and they can use it.
 * @param {readonly Vector[]} axes
 * @param {Rotation} R
 */
function middleAngles(axes, R) {
  const [a, b, c] = axes.slice(-3);
  const [o] = axes;
  const g = rotate(R, c);
  const still = dot(a, o) * dot(o, g);
  const x = dot(a, g) - still;
  const y = -dot(a, cross(o, g));
  const radius = Math.hypot(x, y);
  const ab = angleBetween(a, b);
  const bc = angleBetween(b, c);
  const low = Math.max(still - radius, Math.cos(ab + bc));
  const high = Math.min(still + radius, Math.cos(ab - bc));
  return radius > IN_LINE && low <= high ? turnRoots(x, y, (low + high) / 2 - still) : [];
}
