/**
 * Faces of the box of joint values on which all free joints push the TCP along one line only, wherever they stand: their places are a line,
 * which the conditions of critical postures do not tell of.
 *
 * @import { SectionMap } from './sectionMap.js'
 */
import { createRandom } from '../kinematics/random.js';
import { facesOf } from './criticalCurves.js';

/** Postures of a face that are looked at, and how parallel (the sine) all that its joints do has to be. */
const LOOKS = 8;
const PARALLEL = 1e-9;

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
