import fc from 'fast-check';
import { expect, test } from 'vitest';
import { writeCosSin } from '../../../src/kinematics/cosSin.js';
import { SEED, runs } from '../../helpers/property.js';

/** @param {number} angle */
function cosSin(angle) {
  const out = new Float64Array(4).fill(7);
  writeCosSin(angle, out, 1);
  expect([out[0], out[3]]).toEqual([7, 7]);
  return [out[1], out[2]];
}

/** @param {number} angle */
function expectRight(angle) {
  const [c, s] = cosSin(angle);
  expect(Math.abs(c - Math.cos(angle))).toBeLessThanOrEqual(2 ** -52);
  expect(Math.abs(s - Math.sin(angle))).toBeLessThanOrEqual(2 ** -52);
}

test('the cosine and the sine are those of Math to the last digit, near and far, and next to every eighth of a turn', () => {
  for (const most of [1e-9, 1, 10, 1e3, 999999, 1e9, Number.MAX_VALUE]) {
    fc.assert(fc.property(fc.double({ min: -most, max: most, noNaN: true }), expectRight), {
      seed: SEED,
      numRuns: runs(300),
    });
  }
  for (let eighths = -80; eighths <= 80; eighths++) {
    for (const off of [0, 1e-16, -1e-16, 1e-12, -1e-12, 1e-6, -1e-6]) expectRight((eighths * Math.PI) / 4 + off);
  }
});

test('no turn is exact, and what is no angle has neither', () => {
  expect(cosSin(0)).toEqual([1, 0]);
  for (const angle of [NaN, Infinity, -Infinity]) expect(cosSin(angle)).toEqual([NaN, NaN]);
});
