/**
 * The commands that change motion programs. What can be said against them is in motionRefusals.js. Whoever puts steps in says
 * nothing of their ids: each gets one that no other of its program has.
 *
 * @import { Doc, MotionProgramDoc, StepDoc } from '../document.js'
 *
 * @typedef {StepDoc extends infer Step ? Step extends StepDoc ? Omit<Step, 'id'> & { readonly id?: string } : never : never} NewStep
 *
 * @typedef {{ type: 'add-motion-program', name: string, steps?: readonly NewStep[] }
 *   | { type: 'rename-motion-program', program: number, name: string }
 *   | { type: 'remove-motion-program', program: number }
 *   | { type: 'insert-steps', program: number, at: number, steps: readonly NewStep[] }
 *   | { type: 'edit-step', program: number, step: number, to: NewStep }
 *   | { type: 'edit-steps', program: number, step: number, to: readonly NewStep[] }
 *   | { type: 'move-step', program: number, step: number, to: number, count?: number }
 *   | { type: 'remove-steps', program: number, step: number, count: number }} MotionCommand
 */

/**
 * @param {Doc} doc
 * @param {MotionCommand} command  that `motionRefusal` has nothing against
 * @returns {Doc} the same object when nothing changed
 */
export function applyMotionCommand(doc, command) {
  const { motionPrograms } = doc;
  if (command.type === 'add-motion-program') {
    const empty = { id: freeIds(motionPrograms, 'program_')(), name: command.name, steps: [] };
    return { ...doc, motionPrograms: [...motionPrograms, withNew(empty, 0, command.steps ?? [])] };
  }
  if (command.type === 'remove-motion-program') {
    return { ...doc, motionPrograms: motionPrograms.toSpliced(command.program, 1) };
  }
  const old = motionPrograms[command.program];
  const next = changed(old, command);
  return next === old ? doc : { ...doc, motionPrograms: motionPrograms.with(command.program, next) };
}

/**
 * @param {MotionProgramDoc} program
 * @param {Exclude<MotionCommand, { type: 'add-motion-program' | 'remove-motion-program' }>} command
 * @returns {MotionProgramDoc}
 */
function changed(program, command) {
  const { steps } = program;
  switch (command.type) {
    case 'rename-motion-program':
      return program.name === command.name ? program : { ...program, name: command.name };
    case 'insert-steps':
      return command.steps.length === 0 ? program : withNew(program, command.at, command.steps);
    case 'edit-step':
      return edited(program, command.step, [command.to]);
    case 'edit-steps':
      return edited(program, command.step, command.to);
    case 'move-step': {
      const { step, to, count = 1 } = command;
      const moved = steps.slice(step, step + count);
      return step === to ? program : { ...program, steps: steps.toSpliced(step, count).toSpliced(to, 0, ...moved) };
    }
    case 'remove-steps':
      return { ...program, steps: steps.toSpliced(command.step, command.count) };
    default: {
      /** @type {never} */
      const unknown = command;
      throw new TypeError(`Unknown command: ${JSON.stringify(unknown)}`);
    }
  }
}

/** @param {MotionProgramDoc} program @param {number} first @param {readonly NewStep[]} to  from there on, one by one @returns {MotionProgramDoc} */
function edited(program, first, to) {
  const { steps } = program;
  const next = to.map((step, i) => {
    const old = steps[first + i];
    const made = stepOf(step, old.id);
    return isSame(old, made) ? old : made;
  });
  const isOther = next.some((step, i) => step !== steps[first + i]);
  return isOther ? { ...program, steps: steps.toSpliced(first, next.length, ...next) } : program;
}

/** @param {MotionProgramDoc} program @param {number} at @param {readonly NewStep[]} added @returns {MotionProgramDoc} */
function withNew(program, at, added) {
  const freeId = freeIds(program.steps, 's');
  return { ...program, steps: program.steps.toSpliced(at, 0, ...added.map((step) => stepOf(step, freeId()))) };
}

/**
 * A step of its own, in nobody else's hands, and without fields that say nothing.
 * @param {NewStep} given
 * @param {string} id
 */
const stepOf = (given, id) => /** @type {StepDoc} */ (copied({ ...given, id }));

/** @param {unknown} value  plain @returns {unknown} */
function copied(value) {
  if (Array.isArray(value)) return value.map(copied);
  if (!isObject(value)) return value;
  const said = Object.entries(value).filter(([, one]) => one !== undefined);
  return Object.fromEntries(said.map(([name, one]) => [name, copied(one)]));
}

/** @param {unknown} value @returns {value is Record<string, unknown>} */
const isObject = (value) => typeof value === 'object' && value !== null;

/** One after the other, the first of s1, s2, … that none of these has. @param {readonly { id: string }[]} list @param {string} letters */
function freeIds(list, letters) {
  const taken = new Set(list.map(({ id }) => id));
  let number = 0;
  return () => {
    do number++;
    while (taken.has(letters + number));
    return letters + number;
  };
}

/**
 * Whether two plain values say the same, whatever the order of their fields.
 * @param {unknown} one
 * @param {unknown} other
 * @returns {boolean}
 */
export function isSame(one, other) {
  if (!isObject(one) || !isObject(other)) return Object.is(one, other);
  const names = Object.keys(one);
  return names.length === Object.keys(other).length && names.every((name) => isSame(one[name], other[name]));
}
