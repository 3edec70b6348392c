/**
 * The place of the wrist centre by the first joints, three at most, turning or sliding: all (q_1 … q_r) with E_1 · … · E_r W = P. Joint 2 is
 * taken out first (profileCurves.js); two joints are three of which the last is missing, one is the middle one. Fewer than three
 * reach only some points: what comes near enough is returned, for the caller to check.
 *
 * @import { Line, Vector } from './lines.js'
 * @import { Curve, Plane } from './profileCurves.js'
 *
 * @typedef {object} Regional   constants
 * @property {readonly Line[]} joints
 * @property {Vector} centre   W
 * @property {Line | null} before  the joint before the middle one
 * @property {Line | null} middle
 * @property {Line | null} after
 * @property {Plane | null} plane
 * @property {Curve | null} curve  of W as the joint after the middle one moves
 * @property {number} place   of W on it
 *
 * @typedef {object} RegionalSolution
 * @property {number[]} q
 * @property {number[]} free    joints of which each may turn alone: the centre is on their axis
 * @property {number[]} coupled  joints that move together, the centre staying where it is
 */
import { meetings } from './curveMeetings.js';
import { cross, dot, minus, moved, norm } from './lines.js';
import { curveOf, planeOf } from './profileCurves.js';

/** A centre nearer to an axis than this (in arm lengths) is on it. */
export const ON_AXIS = 1e-9;

/**
 * @param {readonly Line[]} joints 0 to 3
 * @param {Vector} centre
 * @returns {Regional}
 */
export function prepareRegional(joints, centre) {
  const [before, middle, after] = joints.length === 1 ? [null, joints[0], null] : [...joints, null, null, null];
  const plane = middle && planeOf(middle, [before, after]);
  const { curve, place } = plane ? curveOf(plane, after, centre) : { curve: null, place: 0 };
  return { joints, centre, before, middle, after, plane, curve, place };
}

/** @param {Regional} regional @param {Vector} P @returns {RegionalSolution[]} */
export function solveRegional({ joints, centre, before, middle, after, plane, curve, place }, P) {
  if (!plane || !middle || !curve) return [{ q: [], free: [], coupled: [] }];
  const back = curveOf(plane, before, P);
  return meetings(back.curve, curve).map(({ one, two, isOneFree, isTwoFree, isOverlap }) => {
    const first = before?.slides ? -one : back.place - one;
    const third = after?.slides ? two : two - place;
    // Where any place will do, the joint value is zero.
    const q1 = isOneFree ? 0 : first;
    const q3 = isTwoFree ? 0 : third;
    const S = after ? moved(after, q3, centre) : centre;
    const Q = before ? moved(before, -q1, P) : P;
    const { angle, isFree } = middleValue(plane.line, S, Q);
    const q = joints.length === 1 ? [angle] : [q1, angle, q3].slice(0, joints.length);
    const at = joints.length === 1 ? 0 : 1;
    const free = [...(isOneFree ? [0] : []), ...(isFree ? [at] : []), ...(isTwoFree ? [2] : [])];
    return { q, free, coupled: isOverlap ? joints.map((_, i) => i) : [] };
  });
}

/** What takes S to Q. @param {Line} line @param {Vector} S @param {Vector} Q */
function middleValue({ slides, axis, point }, S, Q) {
  if (slides) return { angle: dot(axis, minus(Q, S)), isFree: false };
  const from = minus(S, point);
  const to = minus(Q, point);
  const sine = dot(axis, cross(from, to));
  const cosine = dot(cross(axis, from), cross(axis, to));
  return { angle: Math.atan2(sine, cosine), isFree: norm(cross(axis, from)) < ON_AXIS };
}
