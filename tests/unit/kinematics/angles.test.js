import { describe, expect, test } from 'vitest';
import { exactCosine, exactSine } from '../../../src/kinematics/angles.js';

/** The binary neighbour `ulps` steps away from zero. @param {number} x @param {number} ulps */
function step(x, ulps) {
  const bits = new BigInt64Array(Float64Array.of(x).buffer);
  bits[0] += BigInt(ulps);
  return new Float64Array(bits.buffer)[0];
}

describe('sine and cosine of constants', () => {
  test('within 4 ulp of a multiple of a right angle they are exact', () => {
    for (let quarter = -9; quarter <= 9; quarter++) {
      if (quarter === 0) continue;
      const sines = [0, 1, 0, -1];
      const index = ((quarter % 4) + 4) % 4;
      for (let ulps = -4; ulps <= 4; ulps++) {
        const angle = step(quarter * (Math.PI / 2), ulps);
        expect([exactSine(angle), exactCosine(angle)]).toEqual([sines[index], sines[(index + 1) % 4]]);
      }
    }
  });
  test('degrees turned to radians in any usual way are recognised', () => {
    for (const degrees of [90, -90, 180, -180, 270, 360, 450]) {
      for (const angle of [(degrees * Math.PI) / 180, degrees * (Math.PI / 180), degrees / (180 / Math.PI)]) {
        expect(Math.abs(exactSine(angle)) + Math.abs(exactCosine(angle))).toBe(1);
      }
    }
  });
  test('five ulp away they are what Math says', () => {
    for (const angle of [step(Math.PI / 2, 5), step(-Math.PI, -5), 1.5708, 3.1416, 1e-17, -1e-300, 0.3]) {
      expect([exactSine(angle), exactCosine(angle)]).toEqual([Math.sin(angle), Math.cos(angle)]);
    }
  });
  test('zero of either sign has sine 0 and cosine 1', () => {
    for (const zero of [0, -0]) expect([exactSine(zero), exactCosine(zero)]).toEqual([0, 1]);
  });
});
