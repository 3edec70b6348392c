/**
 * Names for singular postures, where the geometry of the arm has any. Read off the axes at the posture, not off the table.
 *
 * An arm has a *centre*: the point where its last three axes meet (a spherical wrist), or, where axes 2, 3 and 4 are parallel
 * (UR and its like), where axes 5 and 6 do; for an arm of three joints it is the TCP. Its first joints carry the centre.
 *
 * @import { Chain } from '../chain.js'
 *
 * @typedef {'wrist' | 'elbow' | 'shoulder' | 'other'} SingularityKind
 *   wrist: axes 4 and 6 are parallel; of a wrist without an arm, axes 1 and 3. elbow: two joints that follow each other
 *   move the centre the same way: the arm is stretched or folded; of a SCARA arm, its parallel axes are in one plane.
 *   shoulder: joint 1 moves the centre as joints 2 and 3 could: it is above the shoulder. other: singular in a way that has
 *   no name here.
 *
 * @typedef {object} Axes
 * @property {number} dof
 * @property {readonly boolean[]} turns
 * @property {Float64Array} z       3 · n: directions
 * @property {Float64Array} p       3 · n: a point on each axis, m
 * @property {Float64Array} tip     the TCP, m
 * @property {number} L             characteristic length, m
 */
import { linkFrames, tcpPose } from '../forward.js';
import { along, cross, dot, minus, norm } from '../lines.js';

/** Radians, and metres over L: posture and table are singular by intention if they are by so little. */
const NEAR = 1e-6;

/** @param {Chain} chain @param {ArrayLike<number>} q @returns {Axes} */
function axesAt(chain, q) {
  const { dof, joints, convention, characteristicLength } = chain;
  const frames = linkFrames(chain, q);
  const z = new Float64Array(3 * dof);
  const p = new Float64Array(3 * dof);
  for (let i = 0; i < dof; i++) {
    const frame = 16 * (convention === 'standard' ? i : i + 1);
    z.set(frames.subarray(frame + 8, frame + 11), 3 * i);
    p.set(frames.subarray(frame + 12, frame + 15), 3 * i);
  }
  const tip = tcpPose(chain, q).slice(12, 15);
  return { dof, turns: joints.map(({ type }) => type === 'revolute'), z, p, tip, L: characteristicLength };
}

const direction = (/** @type {Axes} */ { z }, /** @type {number} */ i) => z.subarray(3 * i, 3 * i + 3);
const pointOn = (/** @type {Axes} */ { p }, /** @type {number} */ i) => p.subarray(3 * i, 3 * i + 3);
const areParallel = (/** @type {Axes} */ axes, /** @type {number} */ i, /** @type {number} */ j) =>
  norm(cross(direction(axes, i), direction(axes, j))) < NEAR;

/** How far a point is from an axis, over L. @param {Axes} axes @param {number} i @param {ArrayLike<number>} point */
const offAxis = (axes, i, point) => norm(cross(minus(point, pointOn(axes, i)), direction(axes, i))) / axes.L;

/**
 * Where two axes meet; null if they do not, or are parallel.
 * @param {Axes} axes
 * @param {number} i
 * @param {number} j
 * @returns {ArrayLike<number> | null}
 */
function meeting(axes, i, j) {
  const [a, b] = [direction(axes, i), direction(axes, j)];
  const normal = cross(a, b);
  const sine = norm(normal);
  if (sine < NEAR) return null;
  const [from, to] = [pointOn(axes, i), pointOn(axes, j)];
  const point = along(from, dot(cross(minus(to, from), b), normal) / sine ** 2, a);
  return offAxis(axes, j, point) < NEAR ? point : null;
}

/**
 * What the arm is built like, or null: its last axes meet in the centre; or axes 2, 3 and 4 are parallel and the centre is
 * where axes 5 and 6 meet, none if there is no axis 6; or it has three joints and its TCP is the centre.
 * @param {Axes} axes
 * @returns {{ centre: ArrayLike<number> | null, wrist: 'spherical' | 'parallel' | 'none' } | null}
 */
function build(axes) {
  const { dof, turns, tip } = axes;
  if (dof === 3) return { centre: tip, wrist: 'none' };
  if ((dof !== 5 && dof !== 6) || turns.indexOf(false, 3) !== -1) return null;
  const isParallel = turns[0] && turns[1] && turns[2] && areParallel(axes, 1, 2) && areParallel(axes, 2, 3);
  if (dof === 5) return isParallel ? { centre: null, wrist: 'parallel' } : null;
  const centre = meeting(axes, 4, 5);
  if (!centre) return null;
  if (offAxis(axes, 3, centre) < NEAR && !areParallel(axes, 3, 4)) return { centre, wrist: 'spherical' };
  return isParallel ? { centre, wrist: 'parallel' } : null;
}

/** Whether the arm is a wrist and nothing else: three turning axes that meet. @param {Axes} axes */
function isWrist(axes) {
  if (axes.dof !== 3 || axes.turns.includes(false)) return false;
  const centre = meeting(axes, 0, 1);
  return centre !== null && offAxis(axes, 2, centre) < NEAR && !areParallel(axes, 1, 2);
}

/** How joint i moves a point, over L; of a slide, its direction. @param {Axes} axes @param {number} i @param {ArrayLike<number>} point */
function velocity(axes, i, point) {
  const z = direction(axes, i);
  if (!axes.turns[i]) return Array.from(z);
  return cross(z, minus(point, pointOn(axes, i))).map((value) => value / axes.L);
}

const turningJoints = (/** @type {Axes} */ { turns }) => turns.flatMap((isTurning, i) => (isTurning ? [i] : []));

/** Whether all turning axes are parallel: a planar or SCARA arm. @param {Axes} axes */
function isPlanar(axes) {
  const [one, ...others] = turningJoints(axes);
  return others.length > 0 && others.every((i) => areParallel(axes, one, i));
}

/**
 * Whether the parallel axes of such an arm are in one plane; of two, which always are, the TCP stands for the third.
 * @param {Axes} axes
 */
function isFlat(axes) {
  const [one, ...others] = turningJoints(axes);
  const z = direction(axes, one);
  const points = others.map((i) => /** @type {ArrayLike<number>} */ (pointOn(axes, i)));
  if (points.length === 1) points.push(axes.tip);
  const arms = points.map((point) => cross(z, minus(point, pointOn(axes, one))));
  return arms.every((a) => arms.every((b) => norm(cross(a, b)) < NEAR * axes.L ** 2));
}

/**
 * Elbow and shoulder, by how the first joints move the centre.
 * @param {Axes} axes
 * @param {NonNullable<ReturnType<typeof build>>} built
 * @returns {SingularityKind[]}
 */
function armKinds(axes, { centre, wrist }) {
  const { turns } = axes;
  // parallel axes 2 and 3 carry axis 4 as they would carry a centre on it
  const end = wrist === 'parallel' || !centre ? pointOn(axes, 3) : centre;
  const [two, three] = [velocity(axes, 1, end), velocity(axes, 2, end)];
  const across = cross(two, three);
  /** @type {SingularityKind[]} */
  const kinds = [];
  if (turns[1] && turns[2] && norm(across) < NEAR) kinds.push('elbow');
  if (!centre || !turns[0]) return kinds;
  const one = velocity(axes, 0, centre);
  if (turns[1] && areParallel(axes, 0, 1)) return norm(cross(one, two)) < NEAR ? ['elbow'] : kinds;
  // the direction in which joints 2 and 3 do not move the centre
  const normal = turns[1] && turns[2] && areParallel(axes, 1, 2) ? direction(axes, 1) : across;
  if (norm(normal) >= NEAR && Math.abs(dot(one, normal)) < NEAR * norm(normal)) kinds.push('shoulder');
  return kinds;
}

/**
 * The names that a singular posture has. One that is not singular has none, and gets `other`.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q  singular
 * @returns {SingularityKind[]}  at least one; `other` alone if nothing is recognised
 */
export function singularityKinds(chain, q) {
  const axes = axesAt(chain, q);
  if (isPlanar(axes)) return isFlat(axes) ? ['elbow'] : ['other'];
  if (isWrist(axes)) return areParallel(axes, 0, 2) ? ['wrist'] : ['other'];
  const built = build(axes);
  if (!built) return ['other'];
  const kinds = armKinds(axes, built);
  if (axes.dof === 6 && areParallel(axes, 3, 5)) kinds.unshift('wrist');
  return kinds.length > 0 ? kinds : ['other'];
}
