/**
 * Sections of arms that slide first and turn then, such as gantries: where a slide brings every place into the plane, the section is what
 * the other joints do as it is seen along that slide, and can be traced like any other.
 *
 * @import { Placement } from './placement.js'
 * @import { Vector } from '../kinematics/lines.js'
 */
import { along, dot, minus, norm } from '../kinematics/lines.js';

/**
 * Whether a slide brings every place into the plane, whatever the other joints do: of arms that slide first and turn then. What turns keeps
 * within a sphere about the first axis, as wide as its links are long.
 * @param {Placement} placement at zero
 * @param {number} left
 * @param {Vector} gauge   how far the slide has to go for a place beside the plane
 * @param {Vector} origin  of the plane
 */
export function alwaysCrosses({ ranges: { joints, slides, lower, upper }, axes, frames, place }, left, gauge, origin) {
  const turns = slides.indexOf(false);
  if (turns < 0 ? slides.length < 3 : slides.includes(true, turns)) return false;
  const at = (/** @type {number} */ i) => frames.subarray(16 * i + 12, 16 * i + 15);
  /** @type {ArrayLike<number>} */
  let centre = place;
  let radius = 0;
  if (turns >= 0) {
    const axis = axes.subarray(3 * turns, 3 * turns + 3);
    const points = [
      ...Array.from({ length: frames.length / 16 - joints[turns] }, (_, i) => at(joints[turns] + i)),
      place,
    ];
    centre = along([points[0][0], points[0][1], points[0][2]], dot(axis, minus(points[1], points[0])), axis);
    [centre, ...points.slice(1)].forEach((point, i, all) => (radius += i && norm(minus(point, all[i - 1]))));
  }
  const middle = dot(gauge, minus(centre, origin));
  const room = norm(gauge) * radius;
  let [least, most] = [middle - room, middle + room];
  slides.forEach((isSlide, k) => {
    if (!isSlide || k === left) return;
    const ends = [lower[k], upper[k]].map((value) => value * dot(gauge, axes.subarray(3 * k, 3 * k + 3)));
    least += Math.min(...ends);
    most += Math.max(...ends);
  });
  return least >= lower[left] && most <= upper[left];
}
