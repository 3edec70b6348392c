/** What a plan assumes and changes is said, in the document's units. */
import { expect, test } from 'vitest';
import { planNotes } from '../../../src/ui/program/planNotes.js';

/** @import { Planned } from '../../../src/model/program/planned.js' */

const MM = /** @type {const} */ ({ length: 'mm', angle: 'deg' });

/** @param {Partial<Planned> & { parts?: object[] }} given */
const planned = ({ assumptions = [], steps = [0, 1, 3], parts = [] }) =>
  /** @type {Planned} */ (/** @type {unknown} */ ({ plan: { parts }, steps, assumptions, moves: [], limits: null }));

test('what nobody has said is told with what is assumed in its place', () => {
  const given = planned({
    assumptions: [
      { what: 'joint-rate', joints: [0, 1, 2, 4] },
      { what: 'joint-acceleration', joints: [5] },
      { what: 'tool-turn', steps: [1, 3] },
      { what: 'input', steps: [2] },
    ],
  });
  expect(planNotes(given, MM)).toEqual([
    'No greatest rate is stated for J1–J3 and J5: 180 °/s is assumed for a joint that turns, 500 mm/s for one that slides.',
    'No greatest acceleration is stated for J6: from rest to the greatest rate in 0.25 s is assumed.',
    'How fast the tool may turn is not said in steps 2 and 4: at most 180 °/s is assumed.',
    'The input of step 3 is taken to come at once.',
  ]);
  expect(
    planNotes(planned({ assumptions: [{ what: 'tool-acceleration', steps: [0] }] }), { length: 'm', angle: 'rad' }),
  ).toEqual(['No robot file states an acceleration of the tool: 100 % of it in step 1 is taken for 4 m/s².']);
});

test('where a move is slower than asked, and where it stops instead of going on, is told by step', () => {
  const parts = [
    { move: 0, slowed: [{ from: 0.2, to: 0.456, joint: 4 }], notBlended: null, instead: null },
    { move: 1, slowed: [{ from: 0, to: 1, joint: null }], notBlended: 'wait', instead: null },
    { move: 2, slowed: [{ from: 0, to: 0.004, joint: 1 }], notBlended: 'last', instead: null },
  ];
  expect(planNotes(planned({ parts }), MM)).toEqual([
    'Step 1 is slower than asked from 20 % to 46 % of its way, because J5 is at its greatest rate, acceleration or jerk.',
    'Step 2 is slower than asked from 0 % to 100 % of its way, because of how its way bends.',
    'Step 2 stops at its end all the same: a wait follows.',
  ]);
});

test('a law that is not kept is told, with what it goes by instead', () => {
  const parts = [
    { move: 0, slowed: [], timing: 'trapezoid', instead: 'cubic', notBlended: null },
    { move: 1, slowed: [], timing: 'trapezoid', instead: 'cubic', notBlended: null },
    { move: 2, slowed: [{ from: 0, to: 0.5, joint: 0 }], timing: 'doubleS', instead: null, notBlended: 'law' },
    { move: 3, slowed: [], timing: 'doubleS', instead: 'trapezoid', notBlended: null },
  ];
  expect(planNotes(planned({ parts, steps: [0, 1, 2, 3] }), MM)).toEqual([
    'The cubic of steps 1, 2 is not kept: without a stop at both ends it goes by constant accelerations.',
    'The trapezoid of step 4 is not kept: it goes on, without a stop, from or into a move by the S-curve, and with its limited jerk.',
    'Step 3 is slower than asked from 0 % to 50 % of its way, because J1 is at its greatest rate, acceleration or jerk.',
    'Step 3 stops at its end all the same: the time law of it, or of the step that follows, goes on only into its own.',
  ]);
});
