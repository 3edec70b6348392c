/**
 * Sections of arms that slide first and turn then, such as gantries: where a slide brings every place into the plane, the section is what
 * the other joints do as it is seen along that slide, and can be traced like any other.
 *
 * @import { Placement } from './placement.js'
 * @import { Vector } from '../kinematics/lines.js'
 * @import { SectionMap } from './sectionMap.js'
 */
import { along, dot, minus, norm } from '../kinematics/lines.js';
import { createRandom } from '../kinematics/random.js';
import { facesOf } from './criticalCurves.js';

/** Postures of a face that are looked at, and how parallel (the sine) all that its joints do has to be. */
const LOOKS = 8;
const PARALLEL = 1e-9;

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

/**
 * Along the slides of a face, with joints that make a full turn where they happen to be: a face whose slide and turning joint both push the
 * TCP along one line is this line, which no condition of critical postures tells of, and none of its edges has the turning joint at rest.
 * @param {SectionMap} map
 */
export function slideFaces(map) {
  const { isClosed, lower, upper, free, placement } = map;
  if (!isClosed.includes(true)) return [];
  const still = {
    ...map,
    isClosed: isClosed.map(() => false),
    upper: upper.map((value, k) => (isClosed[k] ? lower[k] : value)),
  };
  const turned = free.filter((_, k) => isClosed[k]).map((k) => placement.ranges.joints[k]);
  return facesOf(still, 1)
    .filter(({ free: [k] }) => placement.ranges.slides[free[k]])
    .map((face) => ({ ...face, fixed: face.fixed.filter(({ joint }) => !turned.includes(joint)) }));
}

/**
 * Whether on some face all free joints, with more than one that turns, push the TCP along one line only, wherever they stand: its ends
 * would have to be looked for.
 * @param {SectionMap} map
 */
export function hasFlatFace(map) {
  const { lower, upper, Jf, free: moved, placement } = map;
  const random = createRandom(3);
  const scale = placement.chain.characteristicLength;
  for (let freedom = 2; freedom <= lower.length; freedom++) {
    for (const { free, x } of facesOf(map, freedom)) {
      let isFlat = free.filter((k) => !placement.ranges.slides[moved[k]]).length > 1;
      for (let look = 0; look < LOOKS && isFlat; look++) {
        const at = x.slice();
        for (const k of free) at[k] = lower[k] + random() * (upper[k] - lower[k]);
        map.write(at);
        isFlat = free.every((i) =>
          free.every(
            (j) => Math.abs(Jf[2 * i] * Jf[2 * j + 1] - Jf[2 * i + 1] * Jf[2 * j]) <= PARALLEL * scale * scale,
          ),
        );
      }
      if (isFlat) return true;
    }
  }
  return false;
}
