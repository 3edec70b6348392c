/** What other programs computed (tests/fixtures/motion). */
import { readFileSync } from 'node:fs';

/** @param {string} name */
const read = (name) =>
  JSON.parse(readFileSync(new URL(`../../fixtures/motion/${name}.json`, import.meta.url), 'utf8')).cases;

/**
 * @typedef {{ name: string, q0: number[], q1: number[], v0: number[], v1: number[], vmax: number[], amax: number[],
 *   jmax: number[] | null, duration: number, samples: { t: number, q: number[], qd: number[], qdd: number[] }[] }} RuckigCase
 * @typedef {{ name: string, t: number[], q: number[], qd: number[], qdd: number[] }} LawCase
 * @typedef {{ name: string, t: number[], q: number[][], qd: number[][], qdd: number[][] }} JointsCase
 * @typedef {{ name: string, s: number[], T0: number[][], T1: number[][], T: number[][][] }} LineCase
 * @typedef {{ name: string, via: number[][], center: number[], radius: number, normal: number[], sweep_rad: number,
 *   arc_length: number, points: number[][] }} ArcCase
 */

/** @type {RuckigCase[]} */
export const RUCKIG = read('ruckig');

/** @type {{ name: string }[]} */
const toolbox = read('toolbox');

/** @template T @param {string} name @returns {T} */
export function toolboxCase(name) {
  const found = toolbox.find((each) => each.name === name);
  if (!found) throw new Error(`There is no case "${name}".`);
  return /** @type {T} */ (/** @type {unknown} */ (found));
}

/** @type {ArcCase[]} */
export const ARCS = ['arc quarter xy', 'arc half', 'arc long way 270', 'arc oblique'].map((name) => toolboxCase(name));

/** @type {{ name: string, waypoints: number[][], s: number[], vmax: number[], amax: number[], duration: number }[]} */
export const TOPPRA = read('toppra');
