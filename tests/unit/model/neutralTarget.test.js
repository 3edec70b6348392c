/** The point on the way of an arc: only its place is asked for, so in code it is turned as the tool is there. */
import { expect, test } from 'vitest';
import { neutralProgram } from '../../../src/model/controller/neutralProgram.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { WRITTEN } from './codePrograms.js';

/** @import { Doc, StepTarget } from '../../../src/model/document.js' */

const HOME = [0, 10, -20, 0, -60, 0];
/** @param {number} j1 @param {number} [j6] @returns {StepTarget} */
const taught = (j1, j6 = 0) => ({ kind: 'posture', values: [j1, ...HOME.slice(1, 5), j6] });
/** On a circle of 80 mm, the tool turned about the vertical. @param {number} angle @param {number} turn @returns {StepTarget} */
const onCircle = (angle, turn) => ({
  kind: 'pose',
  xyz: [828 + 80 * Math.cos((angle * Math.PI) / 180), 80 * Math.sin((angle * Math.PI) / 180), 794],
  rpy: [180, 0, turn],
});

/** The point on the way from, past and to. @param {StepTarget} from @param {StepTarget} via @param {StepTarget} to */
function viaOf(from, via, to) {
  const manner = { acceleration: 100, ending: { kind: 'fine' }, speed: 100, speedUnit: 'length/s' };
  const steps = [
    { id: 's1', kind: 'joint', target: taught(0), ...manner, speed: 50, speedUnit: '%' },
    { id: 's2', kind: 'linear', target: from, ...manner },
    { id: 's3', kind: 'circular', via, target: to, ...manner },
  ];
  const doc = /** @type {Doc} */ ({
    ...newDocument(LIBRARY.fanuc_m10ia),
    motionPrograms: [{ id: 'm', name: 'Arc', steps }],
  });
  const { made, issues } = neutralProgram(doc, doc.motionPrograms[0], { brand: 'fanuc', ...WRITTEN });
  expect(issues).toEqual([]);
  const found = made?.moves.at(-1)?.move.via;
  if (!found) throw new Error('Expected a point on the way.');
  return found;
}

test('two fifths along an arc the tool has made two fifths of its turn, whatever the point was given', () => {
  const via = { ...onCircle(40, 0), rpy: [0, 0, 0] };
  const { position, fanuc } = viaOf(onCircle(0, 0), /** @type {StepTarget} */ (via), onCircle(100, 50));
  const wanted = [
    828 + 80 * Math.cos((40 * Math.PI) / 180),
    80 * Math.sin((40 * Math.PI) / 180),
    794 - 450,
    180,
    0,
    20,
  ];
  position.forEach((value, k) => expect(Math.abs(value - wanted[k])).toBeLessThan(k < 3 ? 1e-6 : 0.01));
  expect(fanuc).toBe('N U T, 0, 0, 0');
});

test('a taught point on the way stays as it was taught, unless the tool is turned otherwise there', () => {
  // axis 1 alone carries the tool on a circle, and turns it evenly
  const kept = viaOf(taught(0), taught(10), taught(25));
  expect(kept.isJoint).toBe(true);
  expect(kept.joints[0]).toBeCloseTo(10, 9);
  const turned = viaOf(taught(0), taught(10, 30), taught(25));
  expect(turned.isJoint).toBe(false);
  expect(turned.position[0]).toBeCloseTo(kept.position[0], 6);
  for (const k of [3, 4, 5]) expect(Math.abs(turned.position[k] - kept.position[k])).toBeLessThan(0.01);
});
