/** Chance for motion programs: steps that a two- to six-joint arm could have, steps that nothing could, and the commands. */
import fc from 'fast-check';

/** @typedef {import('../../../src/model/program/motionCommands.js').MotionCommand} MotionCommand */
/** @typedef {import('../../../src/model/program/motionCommands.js').NewStep} NewStep */
/** @typedef {import('../../../src/model/document.js').StepTarget} StepTarget */

const anyIndex = fc.integer({ min: -1, max: 3 });
const anyText = fc.oneof(fc.constantFrom('', 'approach', '__proto__'), fc.string({ maxLength: 220 }));
const sound = fc.double({ min: 0.01, max: 100, noNaN: true });
const anyNumber = fc.oneof({ weight: 9, arbitrary: sound }, { weight: 1, arbitrary: fc.constantFrom(0, -1, NaN, 2e9) });
const anyValues = fc.oneof(...[2, 3, 6].map((n) => fc.array(sound, { minLength: n, maxLength: n })));

/** @type {fc.Arbitrary<StepTarget>} */
const anyTarget = fc.oneof(
  fc.record({ kind: fc.constant(/** @type {const} */ ('posture')), values: anyValues }),
  fc.record({ kind: fc.constant(/** @type {const} */ ('target')), id: fc.constantFrom('aim_1', 'aim_2', 'pick') }),
  fc.record({
    kind: fc.constant(/** @type {const} */ ('pose')),
    xyz: fc.array(anyNumber, { minLength: 3, maxLength: 3 }),
    rpy: fc.constant([0, 0, 90]),
  }),
);

const move = {
  target: anyTarget,
  speed: anyNumber,
  acceleration: anyNumber,
  ending: fc.oneof(
    fc.constant(/** @type {const} */ ({ kind: 'fine' })),
    fc.record({
      kind: fc.constantFrom(/** @type {const} */ ('percent'), /** @type {const} */ ('distance')),
      value: anyNumber,
    }),
  ),
  law: fc.constantFrom(undefined, /** @type {const} */ ('cubic'), /** @type {const} */ ('cubicSpline')),
  tool: fc.constantFrom(undefined, undefined, 'tool_1'),
  frame: fc.constantFrom(undefined, undefined, 'user_1', 'table'),
  comment: fc.option(anyText, { nil: undefined }),
  disabled: fc.constantFrom(undefined, true, false),
};
const anySignal = fc.constantFrom(/** @type {const} */ ('on'), /** @type {const} */ ('off'));
const anyCount = fc.constantFrom(1, 7, 1.5, 0);

/** @type {fc.Arbitrary<NewStep>} */
export const anyStep = fc.oneof(
  fc.record({
    kind: fc.constant(/** @type {const} */ ('joint')),
    speedUnit: fc.constant(/** @type {const} */ ('%')),
    ...move,
  }),
  fc.record({
    kind: fc.constant(/** @type {const} */ ('linear')),
    speedUnit: fc.constantFrom(
      /** @type {const} */ ('length/s'),
      /** @type {const} */ ('angle/s'),
      /** @type {const} */ ('%'),
    ),
    ...move,
  }),
  fc.record({
    kind: fc.constant(/** @type {const} */ ('circular')),
    speedUnit: fc.constant(/** @type {const} */ ('length/s')),
    via: fc.option(anyTarget, { nil: undefined }),
    ...move,
  }),
  fc.record({ kind: fc.constant(/** @type {const} */ ('wait')), seconds: anyNumber }),
  fc.record({ kind: fc.constant(/** @type {const} */ ('set-output')), output: anyCount, value: anySignal }),
  fc.record({ kind: fc.constant(/** @type {const} */ ('wait-input')), input: anyCount, value: anySignal }),
  fc.record({
    kind: fc.constant(/** @type {const} */ ('call')),
    program: fc.constantFrom('program_1', 'program_2', 'OPEN', ''),
  }),
  fc.record({ kind: fc.constant(/** @type {const} */ ('label')), label: anyText }),
  fc.record({ kind: fc.constant(/** @type {const} */ ('comment')), text: anyText }),
  fc
    .constantFrom(...[null, {}, { kind: 'joint' }, { kind: '__proto__' }, { kind: 'wait', seconds: 1, speed: 3 }])
    .map((senseless) => /** @type {NewStep} */ (/** @type {unknown} */ (senseless))),
);
const anySteps = fc.array(anyStep, { maxLength: 2 });

/** @type {fc.Arbitrary<MotionCommand & { gesture?: string }>} */
export const anyMotionCommand = fc.oneof(
  fc.record(
    { type: fc.constant(/** @type {const} */ ('add-motion-program')), name: anyText, steps: anySteps },
    { requiredKeys: ['type', 'name'] },
  ),
  fc.record({ type: fc.constant(/** @type {const} */ ('rename-motion-program')), program: anyIndex, name: anyText }),
  fc.record({ type: fc.constant(/** @type {const} */ ('remove-motion-program')), program: anyIndex }),
  ...[0, 1].map(() =>
    fc.record({
      type: fc.constant(/** @type {const} */ ('insert-steps')),
      program: fc.constantFrom(0, 0, 1),
      at: fc.constantFrom(0, 0, 1, -1),
      steps: anySteps,
    }),
  ),
  fc.record({
    type: fc.constant(/** @type {const} */ ('edit-step')),
    program: fc.constantFrom(0, 1),
    step: anyIndex,
    to: anyStep,
    gesture: fc.option(fc.constantFrom('a', 'b'), { nil: undefined }),
  }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('edit-steps')),
    program: fc.constantFrom(0, 1),
    step: anyIndex,
    to: anySteps,
  }),
  fc.record(
    {
      type: fc.constant(/** @type {const} */ ('move-step')),
      program: fc.constantFrom(0, 1),
      step: anyIndex,
      to: anyIndex,
      count: fc.constantFrom(0, 1, 2, 1.5),
    },
    { requiredKeys: ['type', 'program', 'step', 'to'] },
  ),
  fc.record({
    type: fc.constant(/** @type {const} */ ('remove-steps')),
    program: fc.constantFrom(0, 1),
    step: anyIndex,
    count: fc.constantFrom(0, 1, 2, 1.5),
  }),
);
