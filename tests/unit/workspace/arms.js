/** Arms whose workspace has a closed form, and that form: signed distances that share nothing with the kernel. */

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */
/** @import { Section } from '../../../src/workspace/section.js' */
/** @import { JointRow } from '../../../src/kinematics/joint.js' */

const QUARTER = Math.PI / 2;

/**
 * @param {'revolute' | 'prismatic'} type
 * @param {number[]} row  a, alpha, d, theta
 * @param {number[]} [limits]
 */
const joint = (type, [a, alpha, d, theta], [lower, upper] = []) => ({ type, a, alpha, d, theta, lower, upper });

/** @param {number[]} row @param {number[]} [limits] */
export const turning = (row, limits) => joint('revolute', row, limits);

/** @param {number[]} row @param {number[]} [limits] */
export const sliding = (row, limits) => joint('prismatic', row, limits);

/** @param {...JointRow} joints @returns {ChainDescription} */
export const armOf = (...joints) => ({ convention: 'standard', joints });

/** @param {number[]} lengths @param {number[][]} [limits] */
export const planar = (lengths, limits = []) => armOf(...lengths.map((a, i) => turning([a, 0, 0, 0], limits[i])));

/** Anthropomorphic: about the vertical, then two links in the vertical plane. @param {number} a2 @param {number} a3 */
export const anthropomorphic = (a2, a3) =>
  armOf(turning([0, QUARTER, 0, 0]), turning([a2, 0, 0, 0]), turning([a3, 0, 0, 0]));

/** @param {number} l1 @param {number} l2 @param {number} stroke @param {number[][]} [limits] */
export const scara = (l1, l2, stroke, limits = []) =>
  armOf(turning([l1, 0, 0, 0], limits[0]), turning([l2, Math.PI, 0, 0], limits[1]), sliding([0, 0, 0, 0], [0, stroke]));

/** Cylindrical. @param {number[]} heights @param {number[]} reaches */
export const cylindrical = (heights, reaches) =>
  armOf(turning([0, 0, 0, 0]), sliding([0, -QUARTER, 0, 0], heights), sliding([0, 0, 0, 0], reaches));

/** Spherical. @param {number[]} polar  limits of the second joint @param {number[]} reaches */
export const spherical = (polar, reaches) =>
  armOf(turning([0, -QUARTER, 0, 0]), turning([0, QUARTER, 0, 0], polar), sliding([0, 0, 0, 0], reaches));

/** Cartesian: along x, y and z in turn. @param {number[]} x @param {number[]} y @param {number[]} z */
export const cartesian = (x, y, z) =>
  armOf(sliding([0, QUARTER, 0, QUARTER], z), sliding([0, QUARTER, 0, QUARTER], x), sliding([0, 0, 0, 0], y));

/**
 * Distances from the boundary of a region, positive inside.
 * @typedef {(u: number, v: number) => number} Inside
 */

/** @param {number} inner @param {number} outer @returns {Inside} */
export const annulus = (inner, outer) => (u, v) => Math.min(outer - Math.hypot(u, v), Math.hypot(u, v) - inner);

/** @param {number[]} us @param {number[]} vs @returns {Inside} */
export const rectangle = ([u0, u1], [v0, v1]) => {
  return (u, v) => {
    const [du, dv] = [Math.min(u - u0, u1 - u), Math.min(v - v0, v1 - v)];
    return du < 0 && dv < 0 ? -Math.hypot(du, dv) : Math.min(du, dv);
  };
};

/** @param {Inside} a @param {Inside} b @returns {Inside} */
export const both = (a, b) => (u, v) => Math.min(a(u, v), b(u, v));

/** On the right side of the axis. @type {Inside} */
export const right = (u) => u;

/**
 * Two links whose elbow bends one way only, the first within a half turn about the x axis: of the annulus that the second
 * sweeps, what is not in the discs about the elbow at its two ends, or is.
 * @param {number} l1
 * @param {number} l2
 * @returns {Inside}
 */
export const sector = (l1, l2) => (x, y) => {
  const r = Math.hypot(x, y);
  const within = Math.min(l1 + l2 - r, r - Math.abs(l1 - l2));
  const fromLow = Math.hypot(x, y + l1) - l2; // outside the circle about the elbow at −90°
  const fromHigh = l2 - Math.hypot(x, y - l1); // inside that at +90°
  return x >= 0 ? Math.min(within, fromLow) : Math.min(within, fromHigh);
};

/** How far outlines are off the boundary, m. @param {Pick<Section, 'outlines'>} section @param {Inside} inside */
export function farthestOff({ outlines }, inside) {
  let worst = 0;
  for (const { places } of outlines) {
    const n = places.length / 2;
    for (let i = 0; i < n; i++) {
      const j = (i + 1) % n;
      for (const t of [0, 0.5]) {
        const [u, v] = [0, 1].map((k) => places[2 * i + k] * (1 - t) + places[2 * j + k] * t);
        worst = Math.max(worst, Math.abs(inside(u, v)));
      }
    }
  }
  return worst;
}

/**
 * Cells that say otherwise than their middle is, but for those that have the boundary within a margin.
 * @param {Pick<Section, 'cells'>} section
 * @param {Inside} inside
 * @param {number} margin  m
 */
export function wrongCells({ cells: { u: left, v: low, size, columns, reached } }, inside, margin) {
  let wrong = 0;
  for (let k = 0; k < reached.length; k++) {
    const u = left + ((k % columns) + 0.5) * size;
    const v = low + (Math.floor(k / columns) + 0.5) * size;
    if (Math.abs(inside(u, v)) > margin && reached[k] !== Number(inside(u, v) > 0)) wrong++;
  }
  return wrong;
}
