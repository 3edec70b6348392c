import fc from 'fast-check';
import { expect, test } from 'vitest';
import { writeArcTangents } from '../../../src/kinematics/arcTangents.js';
import { SEED, runs } from '../../helpers/property.js';

/** @param {number} y @param {number} x */
function angleOf(y, x) {
  const angles = new Float64Array(1);
  writeArcTangents(Float64Array.of(y), Float64Array.of(x), angles);
  return angles[0];
}

/** @param {number} y @param {number} x */
function expectRight(y, x) {
  if (Math.max(Math.abs(x), Math.abs(y)) < 1e-290) return; // so small numbers have fewer digits
  const right = Math.atan2(y + 0, x + 0); // minus zero is zero here
  expect(Math.abs(angleOf(y, x) - right)).toBeLessThanOrEqual(2 ** -51 * Math.abs(right));
}

test('the angle is that of Math to the last digits, of any two numbers, and next to every sixteenth of a turn', () => {
  for (const most of [1, 1e3, 1e-150, 1e150]) {
    const number = fc.double({ min: -most, max: most, noNaN: true });
    fc.assert(fc.property(number, number, expectRight), { seed: SEED, numRuns: runs(500) });
  }
  for (let sixteenths = -16; sixteenths <= 16; sixteenths++) {
    for (const off of [0, 1e-16, -1e-16, 1e-12, -1e-12, 1e-6, -1e-6]) {
      const angle = (sixteenths * Math.PI) / 8 + off;
      expectRight(Math.sin(angle), Math.cos(angle));
    }
  }
});

test('quarter turns are exact, half a turn is positive, and no direction is no angle', () => {
  expect([angleOf(0, 2), angleOf(2, 0), angleOf(0, -2), angleOf(-2, 0)]).toEqual([
    0,
    Math.PI / 2,
    Math.PI,
    -Math.PI / 2,
  ]);
  expect([angleOf(3, 3), angleOf(-0, -1), angleOf(0, 0)]).toEqual([Math.PI / 4, Math.PI, 0]);
});

test('as many angles as there are pairs', () => {
  const angles = new Float64Array(3);
  writeArcTangents(Float64Array.of(0, 1, -1), Float64Array.of(1, 0, -1), angles);
  expect([...angles]).toEqual([0, Math.PI / 2, (-3 * Math.PI) / 4]);
});
