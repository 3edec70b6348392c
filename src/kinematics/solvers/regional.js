/**
 * The place of the wrist centre by the first joints, three at most, turning or sliding: all (q_1 … q_r) with E_1 · …
 * · E_r W = P. Joint 2 is taken out first (profileCurves.js); two joints are three of which the last is missing, one
 * is the middle one. Fewer than three reach only some points: what comes near enough is returned, for the caller to
 * check.
 *
 * @import { Line, Vector } from '../lines.js'
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
 * @property {number} radius  of W from the axis after the middle one
 *
 * @typedef {object} RegionalSolution
 * @property {number[]} q
 * @property {number[]} free    joints of which each may turn alone: the centre is on their axis
 * @property {number[]} coupled  joints that move together, the centre staying where it is
 * @property {boolean} isTurning  whether that turns the wrist
 */
import { lieAlong, meetings } from './curveMeetings.js';
import { angleAbout, cross, dot, minus, moved, norm } from '../lines.js';
import { curveOf, planeOf } from './profileCurves.js';

/**
 * A centre nearer to the axis of the middle joint than this (in arm lengths) is on it. Of the distance the square is
 * found, so near the axis it is known to half the digits only.
 */
const FOLDED = 2e-7;

/** A centre farther from the axis of another joint than this is not on it, even if a turn makes no difference. */
const FAR_FROM_AXIS = 1e-6;

/**
 * @param {readonly Line[]} joints 0 to 3
 * @param {Vector} centre
 * @returns {Regional}
 */
export function prepareRegional(joints, centre) {
  const [before, middle, after] = joints.length === 1 ? [null, joints[0], null] : [...joints, null, null, null];
  const plane = middle && planeOf(middle, [before, after]);
  const { curve, place, radius } = plane ? curveOf(plane, after, centre) : { curve: null, place: 0, radius: 0 };
  return { joints, centre, before, middle, after, plane, curve, place, radius };
}

/**
 * Whether the joints move the centre in a surface only, so that one of them is too many for it. (Of the curve before
 * the middle joint only the size depends on the goal.)
 * @param {Regional} regional
 */
export function isDeficient({ plane, curve, before }) {
  const anywhere = /** @type {Vector} */ ([0.61, 0.43, 0.27]);
  return Boolean(plane && curve && before && lieAlong(curveOf(plane, before, anywhere).curve, curve));
}

/** @param {Regional} regional @param {Vector} P @returns {RegionalSolution[]} */
export function solveRegional(regional, P) {
  const { joints, centre, before, middle, after, plane, curve, place, radius } = regional;
  if (!plane || !middle || !curve) return [{ q: [], free: [], coupled: [], isTurning: false }];
  const back = curveOf(plane, before, P);
  return meetings(back.curve, curve).map(({ one, two, isOneFree, isTwoFree, isOverlap }) => {
    // Where any place will do, the joint value is zero.
    const q1 = isOneFree ? 0 : before?.slides ? -one : back.place - one;
    const q3 = isTwoFree ? 0 : after?.slides ? two : two - place;
    const S = after ? moved(after, q3, centre) : centre;
    const Q = before ? moved(before, -q1, P) : P;
    const { value, isFree } = middleValue(plane.line, S, Q);
    const q = joints.length === 1 ? [value] : [q1, value, q3].slice(0, joints.length);
    const free = isFree ? [joints.length === 1 ? 0 : 1] : [];
    const coupled = isOverlap ? joints.map((_, i) => i) : [];
    if (isOneFree && isTied(before, back.radius)) coupled.push(0, 1);
    else if (isOneFree) free.push(0);
    if (isTwoFree && isTied(after, radius)) coupled.push(1, 2);
    else if (isTwoFree) free.push(2);
    return { q, free, coupled, isTurning: isOverlap };
  });
}

/**
 * Why a joint makes no difference: either the centre is on its axis, or it does nothing that the middle joint does
 * not do, being about the same line or along a parallel one.
 * @param {Line | null} joint
 * @param {number} radius
 */
const isTied = (joint, radius) => Boolean(joint?.slides) || radius > FAR_FROM_AXIS;

/** What takes S to Q. @param {Line} line @param {Vector} S @param {Vector} Q */
function middleValue({ slides, axis, point }, S, Q) {
  if (slides) return { value: dot(axis, minus(Q, S)), isFree: false };
  const from = minus(S, point);
  return { value: angleAbout(axis, from, minus(Q, point)), isFree: norm(cross(axis, from)) < FOLDED };
}
