import fc from 'fast-check';
import { expect, test } from 'vitest';
import { pendantValues } from '../../../src/model/controller/controllerValues.js';
import { LIBRARY } from '../../../src/model/library.js';
import { runs, SEED } from '../../helpers/property.js';

/** @import { ControllerDoc, JointType, RobotDoc, Units } from '../../../src/model/document.js' */

/** @type {Units} */
const MM_DEG = { length: 'mm', angle: 'deg' };
const PLAIN = { sign: /** @type {const} */ (1), offset: 0, coupling: 0 };

/**
 * An arm of which only the controllers matter; joints are called a, b, c …
 * @param {Partial<ControllerDoc>[]} controllers
 * @param {{ units?: Units, types?: JointType[] }} [options]
 * @returns {RobotDoc}
 */
function arm(controllers, { units = MM_DEG, types = [] } = {}) {
  const [joint] = LIBRARY.puma560.joints;
  return {
    ...LIBRARY.puma560,
    units,
    joints: controllers.map((controller, i) => ({
      ...joint,
      id: 'abcdef'[i],
      type: types[i] ?? 'revolute',
      controller: { ...PLAIN, ...controller },
    })),
  };
}

test('without controller data the pendant shows the model’s own values, to the last digit', () => {
  const anyValues = fc.array(fc.double({ min: -1e6, max: 1e6, noNaN: true }), { minLength: 6, maxLength: 6 });
  fc.assert(
    fc.property(anyValues, (q) => {
      expect(pendantValues(LIBRARY.puma560, q)).toEqual(q.map((value) => value + 0));
    }),
    { seed: SEED, numRuns: runs(100) },
  );
});

test('FANUC’s J3 is measured from the horizontal', () => {
  // A published pose of an R-2000iB/165F: on the pendant J2 = -5.284 and J3 = -36.250, so that the elbow itself is bent
  // by J3 + J2 = -41.534 degrees (onerobotics.com, "The perils of six-axis robots").
  const fanuc = arm([{}, {}, { coupledTo: 'b', coupling: -1 }, {}, {}, {}]);
  const values = pendantValues(fanuc, [7.962, -5.284, -41.534, 77.661, -51.975, -79.273]);
  const published = [7.962, -5.284, -36.25, 77.661, -51.975, -79.273];
  values.forEach((value, i) => expect(value).toBeCloseTo(published[i], 12));
});

test('a joint may be coupled to a later one, which is itself coupled', () => {
  const robot = arm([
    { coupledTo: 'c', coupling: 2 },
    { sign: -1, offset: 5 },
    { coupledTo: 'b', coupling: 0.5, offset: 1 },
  ]);
  // b = -20 + 5 = -15; c = 30 + 1 - 7.5 = 23.5; a = 10 + 47 = 57
  expect(pendantValues(robot, [10, 20, 30])).toEqual([57, -15, 23.5]);
});

test('offsets are in the units of the document, values in degrees and millimetres', () => {
  /** @type {JointType[]} */
  const types = ['revolute', 'prismatic', 'continuous'];
  const controllers = /** @type {Partial<ControllerDoc>[]} */ ([
    { sign: -1, offset: Math.PI / 2 },
    { offset: 0.25 },
    {},
  ]);
  const values = pendantValues(arm(controllers, { types, units: { length: 'm', angle: 'rad' } }), [
    Math.PI,
    0.5,
    4 * Math.PI,
  ]);
  [-90, 750, 720].forEach((value, i) => expect(values[i]).toBeCloseTo(value, 10));
  expect(
    pendantValues(arm([{ offset: 2.5 }], { types: ['prismatic'], units: { length: 'cm', angle: 'deg' } }), [10]),
  ).toEqual([125]);
});

test('the pendant’s values satisfy the definition, whatever the order of the couplings', () => {
  const anyArm = fc.shuffledSubarray([0, 1, 2, 3, 4, 5], { minLength: 6, maxLength: 6 }).chain((order) =>
    fc.tuple(
      fc.constant(order),
      ...order.map((_, rank) =>
        fc.record({
          sign: fc.constantFrom(/** @type {const} */ (1), /** @type {const} */ (-1)),
          offset: fc.double({ min: -400, max: 400, noNaN: true }),
          // Only to joints earlier in the order, so that there is no cycle.
          to: rank === 0 ? fc.constant(-1) : fc.integer({ min: -1, max: rank - 1 }),
          coupling: fc.double({ min: -2, max: 2, noNaN: true }),
        }),
      ),
    ),
  );
  const anyValues = fc.array(fc.double({ min: -400, max: 400, noNaN: true }), { minLength: 6, maxLength: 6 });
  fc.assert(
    fc.property(anyArm, anyValues, ([order, ...drawn], q) => {
      /** @type {ControllerDoc[]} */
      const controllers = [];
      drawn.forEach(({ to, ...controller }, rank) => {
        controllers[order[rank]] = to < 0 ? controller : { ...controller, coupledTo: 'abcdef'[order[to]] };
      });
      const values = pendantValues(arm(controllers), q);
      controllers.forEach(({ sign, offset, coupling, coupledTo }, i) => {
        const coupled = coupledTo === undefined ? 0 : coupling * values['abcdef'.indexOf(coupledTo)];
        expect(values[i]).toBeCloseTo(sign * q[i] + offset + coupled, 8);
      });
    }),
    { seed: SEED, numRuns: runs(200) },
  );
});

test.for(
  /** @type {[string, string, Partial<ControllerDoc>[]][]} */ ([
    ['a joint coupled to itself', 'cycle', [{ coupledTo: 'a', coupling: 1 }, {}]],
    ['two joints coupled to each other', 'cycle', [{ coupledTo: 'b' }, { coupledTo: 'a' }]],
    ['a cycle of three', 'cycle', [{ coupledTo: 'b' }, { coupledTo: 'c' }, { coupledTo: 'a' }]],
    ['a cycle that is not reached first', 'cycle', [{ coupledTo: 'b' }, { coupledTo: 'c' }, { coupledTo: 'b' }]],
    ['a coupling to a joint that is not there', 'got "z"', [{ coupledTo: 'z', coupling: 1 }, {}]],
    ['an offset that is no number', 'got NaN', [{ offset: NaN }, {}]],
  ]),
)('%s is refused', ([, message, controllers]) => {
  const read = () => pendantValues(arm(controllers), Array(controllers.length).fill(1));
  expect(read).toThrow(RangeError);
  expect(read).toThrow(message);
});

test('too few or too many joint values are refused', () => {
  expect(() => pendantValues(LIBRARY.puma560, [1, 2, 3])).toThrow('Expected 6 joint values, got 3.');
  expect(() => pendantValues(LIBRARY.planar2r, [1, 2, 3])).toThrow(RangeError);
});
