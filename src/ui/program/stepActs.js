/**
 * What can be done with the steps that are chosen: put in, moved, copied, passed over, deleted; one, or all of a range at once, and
 * each as one step to undo.
 *
 * @import { Page } from '../page.js'
 * @import { MotionCommand, NewStep } from '../../model/program/motionCommands.js'
 */
import { readSteps, stepsText } from '../../io/stepsText.js';
import { shownProgram } from '../../model/program/shownProgram.js';
import { chosenSteps, extendedTo } from '../../model/program/stepRange.js';
import { copyText } from '../parts/clipboard.js';
import { attempt } from '../page.js';
import { PROGRAM } from '../words/program.js';
import { STEP_RANGE } from '../words/stepRange.js';

/**
 * @param {Page} page
 * @param {object} told
 * @param {(reason: string | null) => void} told.refuse
 * @param {(index: number) => void} told.focus  the row of a step, once it is drawn
 */
export function createStepActs(page, { refuse, focus }) {
  const { store, announce } = page;
  /** What was copied here, for pages that may not read the clipboard. */
  let copied = '';

  /** @param {MotionCommand} command @param {() => string} [done]  in words @returns {boolean} */
  function carryOut(command, done) {
    const reason = attempt(page, command);
    refuse(reason);
    if (reason === null && done) announce(done());
    return reason === null;
  }

  const stepsNow = () => shownProgram(store.state).program?.steps ?? [];

  /** @param {string | null} step */
  const choose = (step) => store.dispatch({ type: 'show', change: { step, stepRange: null } });

  /** Steps that follow each other, by index, the last of them as the one that is chosen. @param {number} first @param {number} count */
  function chooseRange(first, count) {
    const [from, to] = [stepsNow()[first], stepsNow()[first + count - 1]];
    if (!from || !to) return choose(null);
    store.dispatch({
      type: 'show',
      change: { step: to.id, stepRange: count > 1 ? { from: from.id, to: to.id } : null },
    });
  }

  /** The steps that are chosen, and the program that they are of. */
  function chosen() {
    const { program, index } = shownProgram(store.state);
    const range = chosenSteps(store.state);
    if (!program || !range) return null;
    return { ...range, program: index, steps: program.steps.slice(range.first, range.first + range.count) };
  }

  /** After the chosen ones, or at the end; in a program that is made for them where there is none. @param {readonly NewStep[]} steps */
  function insert(steps) {
    const { program, index } = shownProgram(store.state);
    const range = chosenSteps(store.state);
    const at = program === null ? 0 : range ? range.first + range.count : program.steps.length;
    const isDone = carryOut(
      program === null
        ? { type: 'add-motion-program', name: PROGRAM.newName(1), steps }
        : { type: 'insert-steps', program: index, at, steps },
    );
    if (!isDone) return null;
    chooseRange(at, steps.length);
    return at + 1;
  }

  /** The step in a row, and all that are chosen with it. @param {number} index */
  function withIts(index) {
    const range = chosenSteps(store.state);
    const isIn = range !== null && index >= range.first && index < range.first + range.count;
    return isIn ? range : { first: index, count: 1 };
  }

  /** @param {{ first: number, count: number }} range @param {number} to  where the first of them is to be */
  function put({ first, count }, to) {
    const { program, index } = shownProgram(store.state);
    if (!program || to < 0 || to === first || to > program.steps.length - count) return;
    const said = () => (count === 1 ? PROGRAM.done.moved(to + 1) : STEP_RANGE.moved(to + 1, to + count));
    if (!carryOut({ type: 'move-step', program: index, step: first, to, count }, said)) return;
    chooseRange(to, count);
    focus(to + count - 1);
  }

  function remove() {
    const all = chosen();
    if (!all) return;
    const { first, count } = all;
    const said = () => (count === 1 ? PROGRAM.done.remove(first + 1) : STEP_RANGE.removed(first + 1, first + count));
    if (!carryOut({ type: 'remove-steps', program: all.program, step: first, count }, said)) return;
    const next = Math.min(first, stepsNow().length - 1);
    choose(stepsNow()[next]?.id ?? null);
    if (next >= 0) focus(next);
  }

  /** @returns {string | null} */
  function chosenText() {
    const all = chosen();
    return all && stepsText(all.steps, store.state.doc.robot.units);
  }

  /** @param {string} text */
  function sayCopied(text) {
    copied = text;
    const count = chosen()?.count ?? 0;
    announce(STEP_RANGE.copied(count));
  }

  /** @param {string} text  from the clipboard */
  function paste(text) {
    const read = readSteps(text, store.state.doc.robot.units);
    if ('against' in read) return refuse(STEP_RANGE.against[read.against]);
    const number = insert(read.steps);
    if (number === null) return;
    announce(STEP_RANGE.pasted(number, number + read.steps.length - 1));
    focus(number + read.steps.length - 2);
  }

  return {
    ...{ carryOut, choose, insert, remove, paste },
    /** One step, put in. @param {NewStep} step @returns {number | null} its number */
    insertOne: (step) => insert([step]),
    /** All from where the choice was begun. @param {number} index */
    extend(index) {
      const to = stepsNow()[index];
      if (!to || to.id === store.state.session.step) return;
      store.dispatch({ type: 'show', change: extendedTo(store.state, to.id) });
      const range = chosenSteps(store.state);
      if (range) announce(STEP_RANGE.chosen(range.first + 1, range.first + range.count));
    },
    chooseAll() {
      chooseRange(0, stepsNow().length);
      announce(STEP_RANGE.chosen(1, stepsNow().length));
    },
    /** Dragged to the place of another one. @param {number} from @param {number} to */
    move(from, to) {
      const range = withIts(from);
      const isPast = to >= range.first + range.count;
      if (isPast || to < range.first) put(range, isPast ? to - range.count + 1 : to);
    },
    /** @param {number} index @param {-1 | 1} by */
    shift(index, by) {
      const range = withIts(index);
      put(range, range.first + by);
    },
    duplicate() {
      const all = chosen();
      if (!all || insert(all.steps) === null) return;
      const { first, count } = all;
      announce(count === 1 ? PROGRAM.done.duplicate(first + 1) : STEP_RANGE.duplicated(first + 1, first + count));
    },
    /** All passed over, or, if they are, all carried out again. */
    disable() {
      const all = chosen();
      if (!all) return;
      const { first, count, steps } = all;
      const isOff = steps.every(({ disabled }) => disabled);
      const to = steps.map((step) => /** @type {NewStep} */ ({ ...step, disabled: isOff ? undefined : true }));
      const done = isOff ? 'enable' : 'disable';
      const said = () =>
        count === 1 ? PROGRAM.done[done](first + 1) : STEP_RANGE[`${done}d`](first + 1, first + count);
      carryOut({ type: 'edit-steps', program: all.program, step: first, to }, said);
    },
    async copy() {
      const text = chosenText();
      if (text === null) return;
      await copyText(text);
      sayCopied(text);
    },
    /** @param {ClipboardEvent} event  of the keys for it */
    copyBy(event) {
      const text = chosenText();
      if (text === null || !event.clipboardData) return;
      event.clipboardData.setData('text/plain', text);
      event.preventDefault();
      sayCopied(text);
      if (event.type === 'cut') remove();
    },
    /** What was copied here, or elsewhere. */
    async pasteCopied() {
      const text = await navigator.clipboard.readText().catch(() => copied);
      paste(text);
    },
  };
}

/** @typedef {ReturnType<typeof createStepActs>} StepActs */
