/**
 * What clearances and ways around obstacles are judged by: the arm's stretches from plain matrices, and distances from many points on
 * them. Shares no code with the kernel.
 * @import { ChainDescription } from '../../../src/kinematics/chain.js'
 * @import { Obstacle } from '../../../src/motion/clearance/obstacles.js'
 * @import { Matrix } from '../kinematics/oracle.js'
 *
 * @typedef {{ link: number, kind: 'offset' | 'length' | 'tool', ends: [number[], number[]] }} OracleStretch
 */
import { readFileSync } from 'node:fs';
import { oracleForward, rowsOf } from '../kinematics/oracle.js';

/** @param {Matrix} T @param {number} axis */
const along = (T, axis) => T.slice(0, 3).map((row) => row[axis]);
/** @param {Matrix} T */
const placeOf = (T) => along(T, 3);
/** @param {number[]} p @param {number[]} u @param {number} far */
const gone = (p, u, far) => p.map((value, i) => value + far * u[i]);

/** @param {ChainDescription} description @param {ArrayLike<number>} q @returns {OracleStretch[]} those of no length, too */
export function oracleStretches(description, q) {
  const { convention, joints, tool } = description;
  const { frames, tcp } = oracleForward(description, q);
  return joints.flatMap(({ type, a, d }, link) => {
    const offset = d + (type === 'prismatic' ? q[link] : 0);
    /** @type {OracleStretch[]} */
    const own = [];
    if (convention === 'standard') {
      const elbow = gone(placeOf(frames[link]), along(frames[link], 2), offset);
      own.push({ link, kind: 'offset', ends: [placeOf(frames[link]), elbow] });
      own.push({ link, kind: 'length', ends: [elbow, placeOf(frames[link + 1])] });
    } else {
      const start = gone(placeOf(frames[link]), along(frames[link], 0), a);
      const end = placeOf(frames[link + 1]);
      own.push({ link, kind: 'offset', ends: [start, end] });
      const next = joints[link + 1];
      if (next) own.push({ link, kind: 'length', ends: [end, gone(end, along(frames[link + 1], 0), next.a)] });
    }
    if (link === joints.length - 1 && tool)
      own.push({ link, kind: 'tool', ends: [placeOf(frames[link + 1]), placeOf(tcp)] });
    return own;
  });
}

/** @param {number[]} p @param {number[]} q */
export const apart = (p, q) => Math.hypot(...p.map((value, i) => value - q[i]));

/** @param {ArrayLike<number>} T @param {number[]} p  as seen from T */
function seenFrom(T, p) {
  const rows = rowsOf(T);
  const way = p.map((value, i) => value - rows[i][3]);
  return [0, 1, 2].map((axis) => way.reduce((sum, value, i) => sum + value * rows[i][axis], 0));
}

/** How far a point is outside an obstacle; 0 inside. @param {Obstacle} obstacle @param {number[]} p */
export function outside(obstacle, p) {
  if (obstacle.kind === 'sphere') return Math.max(0, apart(p, Array.from(obstacle.centre)) - obstacle.radius);
  if (obstacle.kind === 'plane') {
    return Math.max(0, p.reduce((sum, value, i) => sum + value * obstacle.normal[i], 0) - obstacle.offset);
  }
  if (obstacle.kind === 'box') {
    const past = seenFrom(obstacle.T_base_box, p).map((value, i) =>
      Math.max(0, Math.abs(value) - obstacle.size[i] / 2),
    );
    return Math.hypot(...past);
  }
  const [x, y, z] = seenFrom(obstacle.T_base_cylinder, p);
  return Math.hypot(Math.max(0, Math.hypot(x, y) - obstacle.radius), Math.max(0, Math.abs(z) - obstacle.height / 2));
}

/** So many points on a segment, both ends among them. @param {[number[], number[]]} ends @param {number} count */
export const pointsOn = ([from, to], count) =>
  Array.from({ length: count + 1 }, (_, i) => from.map((value, k) => value + (i / count) * (to[k] - value)));

/**
 * @typedef {object} PlanarCase
 * @property {[number, number]} links     m
 * @property {number} capsule_radius      m
 * @property {[number, number]} limits_deg
 * @property {[number, number, number][]} obstacles_xyr  m
 * @property {[number, number]} start_deg
 * @property {[number, number]} goal_deg
 * @property {'solvable' | 'unsolvable'} label
 * @property {number} [grid_shortest_deg_1deg_8conn]
 */
export const PLANAR = /** @type {PlanarCase[]} */ (
  JSON.parse(readFileSync(new URL('../../fixtures/motion/planar.json', import.meta.url), 'utf8'))
);
