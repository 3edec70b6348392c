/**
 * The place that is meant by a press in the scene, where a line of sight says no more than a direction.
 *
 * @import { Session } from '../session.js'
 * @import { PickGround } from './asked.js'
 * @import { Cubes } from './mapped.js'
 *
 * @typedef {{ from: readonly number[], along: readonly number[] }} Ray  `along` is a unit vector
 */
import { along, cross, dot, minus } from '../../kinematics/lines.js';

/** A plane that is seen under a smaller angle than this (its sine) tells nothing about where on it. */
const ALONG_PLANE = 0.02;

/**
 * Where points can be picked now, the best first: what is in the scene, or else a plane through the tool point.
 * @param {Pick<Session, 'maps' | 'workspace'>} session
 * @returns {PickGround[]}
 */
export function pickGrounds({ maps: { section, volume }, workspace }) {
  const isShown = (/** @type {string} */ fold) => workspace?.open.includes(fold) ?? false;
  const hasVolume = Boolean(workspace?.hasVolume && isShown('volume') && volume?.cubes && !volume.isStale);
  const hasSection = Boolean(section && !section.isStale && !section.why && (section.section ?? section.first));
  const isSectionShown = hasSection && Boolean(workspace?.hasSection && isShown('section'));
  /** @type {PickGround[]} */
  const grounds = [];
  if (hasVolume) grounds.push('volume');
  if (hasSection) grounds.push('section');
  return grounds.length === 0 ? ['tool'] : isSectionShown ? grounds.reverse() : grounds;
}

/**
 * Where a line of sight meets a plane; null: nowhere, behind the eye, or seen from its edge.
 * @param {Ray} ray
 * @param {ArrayLike<number>} point
 * @param {ArrayLike<number>} normal  a unit vector
 */
function onPlane({ from, along: way }, point, normal) {
  const falls = dot(normal, way);
  if (Math.abs(falls) < ALONG_PLANE) return null;
  const t = dot(normal, minus(point, from)) / falls;
  return t > 0 ? along(from, t, way) : null;
}

/**
 * The middle of the first cube that a line of sight meets.
 * @param {Cubes} cubes
 * @param {Ray} ray
 */
export function firstCube({ size, corner, counts, reached }, { from, along: way }) {
  let [enter, leave] = [0, Infinity];
  for (let i = 0; i < 3; i++) {
    const ends = [corner[i], corner[i] + counts[i] * size].map((side) => (side - from[i]) / way[i]);
    if (way[i] === 0) {
      if (from[i] < corner[i] || from[i] > corner[i] + counts[i] * size) return null;
      continue;
    }
    enter = Math.max(enter, Math.min(...ends));
    leave = Math.min(leave, Math.max(...ends));
  }
  if (enter > leave) return null;
  const start = along(from, enter, way);
  const cube = counts.map((count, i) => Math.min(count - 1, Math.max(0, Math.floor((start[i] - corner[i]) / size))));
  /** How far along the line the next cube begins, on each axis. @param {number} i */
  const next = (i) =>
    way[i] === 0 ? Infinity : (corner[i] + (cube[i] + Number(way[i] > 0)) * size - from[i]) / way[i];
  for (;;) {
    if (reached[(cube[2] * counts[1] + cube[1]) * counts[0] + cube[0]]) {
      return cube.map((at, i) => corner[i] + (at + 0.5) * size);
    }
    const sides = [0, 1, 2].map(next);
    const axis = sides.indexOf(Math.min(...sides));
    cube[axis] += way[axis] > 0 ? 1 : -1;
    if (cube[axis] < 0 || cube[axis] >= counts[axis]) return null;
  }
}

/**
 * @param {Ray} ray
 * @param {PickGround} ground
 * @param {Session['maps']} maps
 * @param {{ at: ArrayLike<number>, towards: ArrayLike<number> }} tool  its point, and the way from there to the eye, a unit vector
 * @returns {readonly number[] | null} m; null: there is no such place
 */
export function placeUnder(ray, ground, { section, volume }, tool) {
  if (ground === 'volume') return volume?.cubes ? firstCube(volume.cubes, ray) : null;
  if (ground === 'tool') return onPlane(ray, tool.at, tool.towards);
  const { frame } = section?.section ?? section?.first ?? {};
  return frame ? onPlane(ray, frame.origin, cross(frame.u, frame.v)) : null;
}
