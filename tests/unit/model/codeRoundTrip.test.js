/**
 * Programs → code → read again → run: the same moves. Numbers in the text are compared with the program's by this file's own
 * reading of the effects; where the arm goes, by the verification that a person is shown.
 */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { runCode } from '../../../src/model/controller/runCode.js';
import { verifyCode } from '../../../src/model/controller/verifyCode.js';
import { runs, SEED } from '../../helpers/property.js';
import { anyStep, ARMS, documentOf, madeOf, WRITERS } from './codePrograms.js';

/** @import { MadeProgram } from '../../../src/model/controller/neutralProgram.js' */

/** What the text says of a target must be the program's numbers, but for the third decimal and 24 bits. @param {MadeProgram} made @param {ReturnType<typeof runCode>['effects']} effects */
function expectNumbers(made, effects) {
  expect(effects).toHaveLength(made.moves.length);
  for (const [i, { position, isJoint, userFrame, toolFrame, motion }] of effects.entries()) {
    const { move } = made.moves[i];
    expect(motion).toBe({ joint: 'J', linear: 'L', circular: 'C' }[move.motion]);
    expect([userFrame, toolFrame]).toEqual([move.userFrame, move.tool]);
    const wanted = isJoint ? move.target.joints : move.target.position;
    const far = wanted.filter((value, k) => {
      const found = /** @type {number[]} */ (position)[k];
      return !(Math.abs(found - value) < 0.0005 + 1e-9 + Math.abs(value) * 2 ** -23);
    });
    expect(far).toEqual([]);
  }
}

test('the same moves come back, in every language, on twelve arms', () => {
  /** @type {Record<string, number>} */
  const seen = {};
  let turn = 0;
  fc.assert(
    fc.property(fc.array(anyStep, { minLength: 2, maxLength: 5 }), (wanted) => {
      const arm = ARMS[turn++ % ARMS.length];
      const doc = documentOf(arm, wanted);
      for (const brand of /** @type {const} */ (['fanuc', 'kuka'])) {
        const tried = madeOf(doc, brand);
        if (!tried) continue;
        seen[arm] = (seen[arm] ?? 0) + tried.made.moves.length;
        for (const [write, own] of WRITERS) {
          if (own !== brand) continue;
          const { files } = write(tried.made.program);
          expectNumbers(tried.made, runCode(files).effects);
          const { moves, matches, findings } = verifyCode(tried.doc, tried.made, files);
          const errors = findings.filter(({ severity }) => severity === 'error');
          expect(errors, arm).toEqual([]);
          expect(matches).toBe(true);
          for (const { deviation, rounding } of moves) {
            expect(deviation?.millimetres).toBeLessThanOrEqual(Math.max(0.01, rounding.millimetres));
            expect(deviation?.degrees).toBeLessThanOrEqual(Math.max(0.01, rounding.degrees));
          }
        }
      }
    }),
    // 20 programs, or 200: a longer run is ten times as many and not twenty. A smaller program would be tried on another arm
    { seed: SEED, numRuns: Math.max(20, runs(10)), endOnFailure: true },
  );
  expect(Object.keys(seen).sort()).toEqual([...ARMS].sort());
});
