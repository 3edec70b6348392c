/** The user frame that a move's poses are seen from: other numbers, the same places; and the numbers that are typed. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { compilePose } from '../../../src/model/compile.js';
import { applyCommand } from '../../../src/model/commands.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { motionMoves } from '../../../src/model/program/motionPlan.js';
import { atNumbers, inFrame, poseNumbers } from '../../../src/model/program/stepFrame.js';
import { SEED, runs } from '../../helpers/property.js';

/** @import { MoveStep, PoseDoc } from '../../../src/model/document.js' */

const number = (/** @type {number} */ most) => fc.double({ min: -most, max: most, noNaN: true });
const three = (/** @type {number} */ most) => fc.array(number(most), { minLength: 3, maxLength: 3 });
/** @type {fc.Arbitrary<PoseDoc>} */
const anyPose = fc.record({ xyz: three(500), rpy: three(80) });

/** @type {MoveStep} */
const LINE = {
  ...{ id: 's1', kind: 'circular', speed: 100, speedUnit: 'length/s', acceleration: 100, ending: { kind: 'fine' } },
  ...{ target: { kind: 'pose', xyz: [500, 0, 600], rpy: [0, 90, 0], configuration: 'N U T' } },
  ...{ via: { kind: 'pose', xyz: [480, 50, 600], rpy: [0, 90, 0] } },
};

test('a move stays where it is in another user frame, and comes back to its numbers', () => {
  fc.assert(
    fc.property(anyPose, anyPose, (one, other) => {
      let doc = newDocument(LIBRARY.puma560);
      for (const pose of [one, other]) doc = applyCommand(doc, { type: 'add-frame', kind: 'user', pose });
      const [first, second] = doc.frames.map(({ id }) => id);
      const steps = [LINE, { ...LINE, ...inFrame(doc, LINE, first) }];
      steps.push({ ...LINE, ...inFrame(doc, steps[1], second) });
      steps.push({ ...LINE, ...inFrame(doc, steps[2], undefined) });
      expect(steps.map(({ frame }) => frame)).toEqual([undefined, first, second, undefined]);
      doc = applyCommand(doc, { type: 'add-motion-program', name: '', steps });
      const { moves } = motionMoves(doc, doc.motionPrograms[0]);
      for (const move of moves) {
        if (move.kind !== 'circular' || moves[0].kind !== 'circular') throw new Error('They are arcs.');
        for (const part of /** @type {const} */ (['T_base_tcp', 'via']))
          move[part].forEach((value, i) =>
            expect(value).toBeCloseTo(Number(moves[0].kind === 'circular' && moves[0][part][i]), 9),
          );
      }
      expect(steps[2].target).toMatchObject({ configuration: 'N U T' });
      const [x] = 'xyz' in steps[3].target ? (steps[3].target.xyz ?? []) : [];
      expect(x).toBeCloseTo(500, 6);
    }),
    { seed: SEED, numRuns: runs(30) },
  );
});

test('the numbers of a pose are its own, also of one that a file gave as a quaternion; typing one keeps the others', () => {
  const doc = newDocument(LIBRARY.puma560);
  const half = Math.SQRT1_2;
  const target = /** @type {const} */ ({
    kind: 'pose',
    xyz: [1, 2, 3],
    quaternion: [0, 0, half, half],
    configuration: 'N U T',
  });
  const numbers = poseNumbers(doc, target);
  [1, 2, 3, 0, 0, 90].forEach((value, i) => expect(numbers[i]).toBeCloseTo(value, 9));
  const moved = atNumbers(target, numbers.with(0, 7));
  expect(moved).toMatchObject({ kind: 'pose', xyz: [7, 2, 3], configuration: 'N U T' });
  const [before, after] = [target, moved].map((pose) => compilePose(pose, doc.robot.units));
  after.forEach((value, i) => expect(value).toBeCloseTo(i === 12 ? 0.007 : before[i], 9));
});
