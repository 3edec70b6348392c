/**
 * The quickest law along a path, where moves lead into each other or one is to be as quick as it can: with jumps of the acceleration
 * (timePath.js), or rounded (keepRounded.js).
 *
 * @import { PosturePath } from './posturePath.js'
 * @import { Limits, Section, Slowed } from './timePath.js'
 * @import { TimeLaw } from './timeLaw.js'
 */
import { keepRounded } from './keepRounded.js';
import { timeLaw } from './timeLaw.js';
import { IN_TIME, alongGrid, partsOf } from './timePath.js';

/** Intervals of the grid over the whole time at most. */
const MOST_IN_TIME = 2000;

/**
 * As quick as limits allow.
 * @param {PosturePath} path
 * @param {Limits} limits
 * @param {readonly Section[]} sections   the last one to the path's end
 * @returns {{ law: TimeLaw, slowed: Slowed[] }}   slowed: beside what the sections alone would allow
 */
export function quickestLaw(path, limits, sections) {
  const { knots } = path;
  const [begin, end] = [knots[0], knots[knots.length - 1]];
  const count = Math.min(MOST_IN_TIME, IN_TIME * sections.length);
  // evenly, and denser at both ends, where it starts and stops
  const shares = Array.from({ length: count + 1 }, (_, k) => [k / count, (1 - Math.cos((Math.PI * k) / count)) / 2]);
  const points = shares.flat().map((share) => begin + share * (end - begin));
  const { law, slowedBy, plane, grid, x } = alongGrid(path, limits, sections, null, points);
  if (sections.every(({ jerk }) => jerk === Infinity)) return { law, slowed: slowedBy(x) };
  const lawOf = (/** @type {Float64Array} */ squares) => timeLaw(begin, end, partsOf(grid, squares));
  const rounded = keepRounded(path, plane, limits, sections, lawOf);
  return { law: rounded.law, slowed: rounded.slowedFrom(slowedBy(rounded.x)) };
}
