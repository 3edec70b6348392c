/**
 * Faces of the box of joint values with two free joints that push the TCP along one line only, wherever they stand: their places are a
 * curve, of which no contour tells.
 *
 * @import { Face } from './criticalCurves.js'
 * @import { SectionMap } from './sectionMap.js'
 */
import { createRandom } from '../kinematics/random.js';
import { innerFaces } from './criticalCurves.js';

/** Postures of a face that are looked at, and how parallel (the sine) what its joints do has to be. */
const LOOKS = 8;
const PARALLEL = 1e-9;

/** @param {SectionMap} map @returns {Face[]} */
export function flatFaces(map) {
  const { lower, upper, Jf, placement } = map;
  const random = createRandom(3);
  const least = PARALLEL * placement.chain.characteristicLength ** 2;
  return innerFaces(map, 2).filter(({ free, x: [...x] }) => {
    const [i, j] = free;
    for (let look = 0; look < LOOKS; look++) {
      for (const k of free) x[k] = lower[k] + random() * (upper[k] - lower[k]);
      map.write(x);
      if (Math.abs(Jf[2 * i] * Jf[2 * j + 1] - Jf[2 * i + 1] * Jf[2 * j]) > least) return false;
    }
    return true;
  });
}
