/** Motion programs in the document: what commands do, what they refuse, and what happens to steps when other things change. */
import { describe, expect, test } from 'vitest';
import { applyCommand } from '../../../src/model/commands.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { refusal } from '../../../src/model/refusals.js';
import { validateDocument } from '../../../src/model/validate.js';

/** @typedef {import('../../../src/model/commands.js').Command} Command */
/** @typedef {import('../../../src/model/document.js').Doc} Doc */
/** @typedef {import('../../../src/model/program/motionCommands.js').NewStep} NewStep */

const manner = /** @type {const} */ ({ acceleration: 100, ending: { kind: 'fine' } });
/** @param {import('../../../src/model/document.js').StepTarget} target @returns {NewStep} */
const joint = (target) => ({ kind: 'joint', target, speed: 50, speedUnit: '%', ...manner });
/** @param {import('../../../src/model/document.js').StepTarget} target @returns {Omit<import('../../../src/model/document.js').MoveStep, 'id'>} */
const line = (target) => ({ kind: 'linear', target, speed: 250, speedUnit: 'length/s', ...manner });
const here = /** @type {const} */ ({ kind: 'posture', values: [10, 20] });

/** @param {Doc} doc @param {...Command} commands */
function after(doc, ...commands) {
  return commands.reduce((now, command) => {
    expect(refusal(now, command)?.message ?? null).toBe(null);
    const next = applyCommand(now, command);
    expect(validateDocument(next)).toEqual([]);
    return next;
  }, doc);
}
const planar = newDocument(LIBRARY.planar2r);
const reason = (/** @type {Doc} */ doc, /** @type {Command} */ command) => refusal(doc, command)?.message ?? null;
const idsOf = (/** @type {Doc} */ { motionPrograms }) => motionPrograms.map(({ steps }) => steps.map(({ id }) => id));
const begin = () =>
  after(planar, { type: 'add-motion-program', name: 'Main', steps: [joint(here), { kind: 'wait', seconds: 1 }] });

describe('steps', () => {
  test('are put in, copied, moved and taken out; each keeps its id, and a new one gets the first that is free', () => {
    const doc = begin();
    expect(idsOf(doc)).toEqual([['s1', 's2']]);
    const copied = after(doc, { type: 'insert-steps', program: 0, at: 1, steps: [doc.motionPrograms[0].steps[0]] });
    expect(idsOf(copied)).toEqual([['s1', 's3', 's2']]);
    const moved = after(copied, { type: 'move-step', program: 0, step: 2, to: 0 });
    expect(idsOf(moved)).toEqual([['s2', 's1', 's3']]);
    const fewer = after(moved, { type: 'remove-steps', program: 0, step: 0, count: 2 });
    expect(idsOf(fewer)).toEqual([['s3']]);
    expect(idsOf(after(fewer, { type: 'insert-steps', program: 0, at: 0, steps: [joint(here)] }))).toEqual([
      ['s1', 's3'],
    ]);
  });

  test('an edit that says the same changes nothing, whatever the order of its fields; a minus before a zero is another number', () => {
    const doc = begin();
    const { id, ...rest } = doc.motionPrograms[0].steps[0];
    const same = { ...Object.fromEntries(Object.entries(rest).reverse()), comment: undefined };
    const command = {
      type: 'edit-step',
      program: 0,
      step: 0,
      to: /** @type {NewStep} */ (/** @type {unknown} */ (same)),
    };
    expect(applyCommand(doc, /** @type {Command} */ (command))).toBe(doc);
    const zero = after(doc, { type: 'edit-step', program: 0, step: 0, to: joint({ kind: 'posture', values: [0, 0] }) });
    const minus = joint({ kind: 'posture', values: [0, -0] });
    expect(applyCommand(zero, { type: 'edit-step', program: 0, step: 0, to: minus })).not.toBe(zero);
    expect(id).toBe('s1');
  });

  test('are the document’s own: what was given is neither kept nor frozen', () => {
    const values = [1, 2];
    const doc = after(begin(), {
      type: 'insert-steps',
      program: 0,
      at: 0,
      steps: [joint({ kind: 'posture', values })],
    });
    values[0] = 99;
    expect(doc.motionPrograms[0].steps[0]).toMatchObject({ target: { values: [1, 2] } });
  });

  test.each(
    /** @type {[unknown, string][]} */ ([
      [{ ...joint(here), speed: 101 }, 'speed; expected a number above 0 and up to 100'],
      [{ ...joint(here), speedUnit: 'length/s' }, 'speedUnit; expected %'],
      [{ ...line(here), speedUnit: '%' }, 'speedUnit; expected length/s or angle/s'],
      [{ ...line(here), acceleration: 0 }, 'acceleration'],
      [{ ...line(here), kind: 'circular' }, 'undefined as via'],
      [{ ...line(here), via: here }, 'has no field "via"'],
      [{ ...line(here), ending: { kind: 'percent', value: 101 } }, 'ending'],
      [{ ...line(here), ending: { kind: 'fine', value: 1 } }, 'ending'],
      [{ ...line(here), tool: 'gripper' }, '"gripper" as tool; expected the name of a tool'],
      [{ ...line(here), law: 'linear' }, 'law'],
      [{ ...line(here), law: 'cubicSpline' }, 'law; expected trapezoid'],
      [joint({ kind: 'posture', values: [1, 2, 3] }), 'a posture of 2 joint values'],
      [joint({ kind: 'target', id: 'aim_1' }), 'the name of a target'],
      [{ kind: 'wait', seconds: 0 }, 'seconds'],
      [{ kind: 'set-output', output: 1.5, value: 'on' }, 'a whole number above 0'],
      [{ kind: 'call', program: 'two words' }, 'program'],
      [{ kind: 'comment', text: 'x'.repeat(201) }, 'at most 200 characters'],
      [{ kind: 'comment', text: '', comment: '' }, 'has no field "comment"'],
      [{ kind: 'loop' }, '"loop" as kind'],
      [null, 'Expected steps as objects'],
    ]),
  )('what a step cannot be is refused with a sentence that names it: %j', (step, words) => {
    const steps = [/** @type {NewStep} */ (step)];
    const against = reason(begin(), { type: 'insert-steps', program: 0, at: 1, steps });
    expect(against).toContain(words);
    if (step) expect(against).toMatch(/^Step 2 of "Main"/);
  });

  test('there are at most 1000 in all programs together, and 20 programs', () => {
    const many = Array.from({ length: 999 }, () => /** @type {NewStep} */ ({ kind: 'wait', seconds: 1 }));
    const full = after(
      planar,
      { type: 'add-motion-program', name: 'A', steps: many },
      { type: 'add-motion-program', name: 'B' },
    );
    const two = /** @type {const} */ ([joint(here), joint(here)]);
    expect(reason(full, { type: 'insert-steps', program: 1, at: 0, steps: two })).toContain('at most 1000 steps');
    expect(reason(full, { type: 'insert-steps', program: 1, at: 0, steps: [two[0]] })).toBe(null);
    const names = Array.from(
      { length: 20 },
      (_, i) => /** @type {Command} */ ({ type: 'add-motion-program', name: `${i}` }),
    );
    expect(reason(after(planar, ...names), names[0])).toContain('at most 20 motion programs');
  });
});

describe('what steps use', () => {
  const pose = { xyz: [1000, 500, 0] };
  const used = () =>
    after(
      begin(),
      { type: 'add-target', pose },
      { type: 'add-frame', kind: 'user', pose },
      { type: 'add-frame', kind: 'tool', pose },
      {
        ...{ type: 'insert-steps', program: 0, at: 2 },
        steps: [
          { ...line({ kind: 'target', id: 'aim_1' }), tool: 'tool_1' },
          {
            ...line({ kind: 'pose', ...pose }),
            kind: 'circular',
            via: { kind: 'target', id: 'aim_1' },
            frame: 'user_1',
          },
        ],
      },
    );

  test('stays while it is used, and the sentence names the steps', () => {
    const doc = used();
    expect(reason(doc, { type: 'remove-target', index: 0 })).toBe(
      'Target aim_1 is used by step 3, 4 of "Main"; it stays while it is.',
    );
    expect(reason(doc, { type: 'remove-frame', index: 0 })).toContain(
      'The user frame user_1 is used by step 4 of "Main"',
    );
    expect(reason(doc, { type: 'remove-frame', index: 1 })).toContain('The tool tool_1 is used by step 3 of "Main"');
    const free = after(doc, { type: 'remove-steps', program: 0, step: 2, count: 2 });
    after(
      free,
      { type: 'remove-target', index: 0 },
      { type: 'remove-frame', index: 1 },
      { type: 'remove-frame', index: 0 },
    );
  });

  test('is followed to its new name', () => {
    const doc = after(
      used(),
      { type: 'rename-target', index: 0, id: 'pick' },
      { type: 'rename-frame', index: 0, id: 'table' },
      { type: 'rename-frame', index: 1, id: 'gripper' },
    );
    expect(doc.motionPrograms[0].steps.slice(2)).toMatchObject([
      { target: { kind: 'target', id: 'pick' }, tool: 'gripper' },
      { via: { kind: 'target', id: 'pick' }, frame: 'table' },
    ]);
  });

  test('a program that is called stays; calling itself does not keep it', () => {
    const call = /** @type {const} */ ({ kind: 'call', program: 'program_1' });
    const doc = after(begin(), { type: 'add-motion-program', name: 'Other', steps: [call] });
    expect(reason(doc, { type: 'remove-motion-program', program: 0 })).toContain('used by step 1 of "Other"');
    const own = after(begin(), { type: 'insert-steps', program: 0, at: 0, steps: [call] });
    expect(after(own, { type: 'remove-motion-program', program: 0 }).motionPrograms).toEqual([]);
  });

  test('postures in steps go with the joints', () => {
    const doc = begin();
    const values = (/** @type {Command[]} */ ...commands) => {
      const [step] = after(doc, ...commands).motionPrograms[0].steps;
      return 'target' in step && step.target.kind === 'posture' ? step.target.values : null;
    };
    expect(values({ type: 'add-joint', after: 0 })).toEqual([10, 0, 20]);
    expect(values({ type: 'move-joint', joint: 0, to: 1 })).toEqual([20, 10]);
    expect(values({ type: 'add-joint', after: 1 }, { type: 'remove-joint', joint: 0 })).toEqual([20, 0]);
    expect(values({ type: 'set-joint-type', joint: 1, jointType: 'prismatic' })).toEqual([10, 0]);
  });
});
