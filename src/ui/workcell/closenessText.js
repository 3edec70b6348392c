/**
 * How near the arm comes to something, in words.
 *
 * @import { Units } from '../../model/document.js'
 * @import { Clearance } from '../../model/workcell/workcell.js'
 */
import '../css/workcell.css';
import { fixed, withUnit } from '../parts/format.js';
import { OBSTACLES } from '../words/obstacles.js';

/** A tenth of a millimetre is more than capsules know. */
const DECIMALS = { mm: 1, cm: 2, m: 4 };

/** @param {number} distance  in document units @param {Units} units */
export const distanceText = (distance, { length }) => withUnit(fixed(distance, DECIMALS[length]), length);

/** The two bodies: "link 4", "box_1". @param {Pick<Clearance, 'link' | 'obstacle' | 'other'>} near @returns {[string, string]} */
export const bodiesText = ({ link, obstacle, other }) => [
  OBSTACLES.link(link + 1),
  obstacle ?? OBSTACLES.link((other ?? 0) + 1),
];

/** @param {Clearance} near @param {Units} units */
export function closenessText(near, units) {
  const [one, other] = bodiesText(near);
  return near.distance <= 0
    ? OBSTACLES.touch(one, other)
    : OBSTACLES.clear(distanceText(near.distance, units), OBSTACLES.between(one, other));
}

/** Beside the line in the scene. @param {Clearance} near @param {Units} units */
export const nearestLabel = (near, units) =>
  near.distance <= 0 ? OBSTACLES.touch(...bodiesText(near)) : distanceText(near.distance, units);
