import { expect, test } from 'vitest';
import { LIBRARY } from '../../../src/model/library.js';
import { startDocument } from '../../../src/model/startDocument.js';

const { puma560: puma, scara_cobra600: scara } = LIBRARY;

test('without wishes the robot stands at home in its own units', () => {
  expect(startDocument(puma)).toMatchObject({ doc: { robot: puma, posture: [0, 45, -180, 0, 45, 0] }, faults: [] });
});

test('units convert the robot, and joint values are then meant in them', () => {
  const { doc, faults } = startDocument(scara, { units: { length: 'm' }, q: [10, -10, 0.1, 45] });
  expect(faults).toEqual([]);
  expect(doc.robot.units).toEqual({ length: 'm', angle: 'deg' });
  expect(doc.robot.joints[0].a).toBe(scara.joints[0].a / 1000);
  expect(doc.posture).toEqual([10, -10, 0.1, 45]);
});

test('joint values that cannot be had are left out and reported', () => {
  const { doc } = startDocument(puma);
  expect(startDocument(puma, { q: [1, 2] })).toEqual({ doc, faults: [{ code: 'count', given: 2, joints: 6 }] });
  expect(startDocument(puma, { q: [1, 2, 3, 4, 5, 6], isOther: true })).toEqual({
    doc,
    faults: [{ code: 'other-robot' }],
  });
});

test('joint values outside the limits are taken, and reported', () => {
  const { doc, faults } = startDocument(puma, { q: [0, 900, 0, 0, -900, 0] });
  expect(doc.posture).toEqual([0, 900, 0, 0, -900, 0]);
  expect(faults).toEqual([{ code: 'outside', joints: [1, 4] }]);
});
