import { expect, test } from 'vitest';
import { kinematicIssues } from '../../../src/io/kinematicIssues.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';

const doc = newDocument(LIBRARY.planar2r);
const spoilt = (/** @type {number} */ a) => ({
  ...doc,
  robot: {
    ...doc.robot,
    units: { ...doc.robot.units, length: /** @type {const} */ ('m') },
    joints: doc.robot.joints.map((joint) => ({ ...joint, a })),
  },
});

test('an arm with finite poses has nothing against it', () => {
  for (const robot of Object.values(LIBRARY)) expect(kinematicIssues(newDocument(robot))).toEqual([]);
  expect(kinematicIssues(spoilt(1e9))).toEqual([]);
});

test('an arm whose poses overflow is refused', () => {
  expect(kinematicIssues(spoilt(1.7e308)).map(({ code, severity }) => [code, severity])).toEqual([
    ['not-finite', 'error'],
  ]);
});

test('so is a posture that the kernel cannot take, and numbers that are none', () => {
  expect(kinematicIssues(spoilt(NaN)).map(({ code }) => code)).toEqual(['not-finite']);
  expect(kinematicIssues({ ...doc, postures: [{ id: 'p1', q: [0, NaN] }] }).map(({ code }) => code)).toEqual([
    'not-finite',
  ]);
});
