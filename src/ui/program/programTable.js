/**
 * The steps of a motion program as a table: chosen by pointer or focus, dragged by their number, their speed typed in place
 * with the keys of a spreadsheet. The elements stay for as long as the steps are the same ones.
 *
 * @import { CellEditor } from '../robot/cellEditor.js'
 * @import { Page } from '../page.js'
 * @import { Reasons } from '../parts/reasons.js'
 * @import { MotionCommand } from '../../model/program/motionCommands.js'
 * @import { Doc, StepDoc } from '../../model/document.js'
 *
 * @typedef {object} TableActs
 * @property {(index: number) => void} choose
 * @property {(index: number | null) => void} look   at where it ends; null: no more
 * @property {(index: number, to: number) => void} move
 * @property {(index: number) => void} remove
 */
import $ from 'jquery/slim';
import { isMove } from '../../model/program/motionProgram.js';
import { stepNow } from '../../model/program/planning.js';
import { editCell } from '../robot/cellEditor.js';
import { fill, h, keepFocus, spoken } from '../parts/dom.js';
import { compact, editable } from '../parts/format.js';
import { textInput } from '../parts/captioned.js';
import { icon } from '../parts/icons.js';
import { hasNumber, endText, speedUnitInWords, speedUnitText, stepIcon, stepText } from './stepText.js';
import { watchStepDrag } from './stepDrag.js';
import { watchTableKeys } from '../robot/tableKeys.js';
import { PROGRAM } from '../words/program.js';

const WIDEST_SPEED = 6;

/**
 * @param {Page} page
 * @param {Reasons} reasons
 * @param {TableActs} acts
 */
export function createStepTable(page, reasons, acts) {
  const body = h('tbody');
  const { heads } = PROGRAM;
  const table = h(
    'table',
    { class: 'steps' },
    h(
      'thead',
      {},
      h(
        'tr',
        {},
        h('td', { class: 'step-no' }),
        h('td', { class: 'step-kind' }),
        h('th', { scope: 'col' }, heads.step),
        h('th', { scope: 'col', class: 'step-speed' }, heads.speed),
        h('th', { scope: 'col', class: 'step-end' }, heads.end),
      ),
    ),
    body,
  );
  const element = h('div', { class: 'steps-room' }, table);
  /** @type {{ program: number, doc: Doc } | null} */
  let shown = null;
  /** @type {ReturnType<typeof createRow>[]} */
  let rows = [];
  let shape = '';
  /** The step that is being played. @type {number | null} */
  let under = null;

  const indexOf = (/** @type {HTMLElement} */ within) => Number(within.closest('tr')?.dataset.row ?? -1);
  const stepAt = (/** @type {number} */ index) =>
    /** @type {{ program: number, doc: Doc }} */ (shown).doc.motionPrograms[shown?.program ?? 0].steps[index];

  $(body)
    .on('click', 'tr', ({ currentTarget }) => acts.choose(indexOf(currentTarget)))
    .on('focusin', 'tr', ({ currentTarget }) => {
      acts.choose(indexOf(currentTarget));
      acts.look(indexOf(currentTarget));
    })
    .on('focusout', () => acts.look(null))
    .on('pointerenter', 'tr', (event) => event.pointerType !== 'touch' && acts.look(indexOf(event.currentTarget)))
    .on('pointerleave', 'tr', () => acts.look(null))
    .on('keydown', 'tr', (event) => {
      const { key, altKey, target } = event;
      const down = key === 'ArrowDown' ? 1 : key === 'ArrowUp' ? -1 : 0;
      const index = indexOf(event.currentTarget);
      if (down !== 0 && altKey) acts.move(index, index + down);
      else if (target instanceof HTMLInputElement) return;
      else if (down !== 0) rows[index + down]?.name.focus();
      else if (key === 'ArrowRight') rows[index].editor?.input.focus();
      else if (key === 'Delete' || key === 'Backspace') acts.remove(index);
      else return;
      event.preventDefault();
    });
  const cells = () => rows.flatMap(({ editor }) => (editor ? [[editor.input]] : []));
  watchTableKeys(table, cells, () => false);
  watchStepDrag(body, acts.move);

  page.addView(
    (state) => stepNow(state),
    (index) => {
      under = index;
      markRunning();
    },
  );
  function markRunning() {
    for (const [i, { row }] of rows.entries()) row.classList.toggle('is-running', i === under);
  }

  return {
    element,
    /**
     * @param {Doc} doc @param {number} program @param {number} chosen
     * @param {ReadonlyMap<number, string>} faults   of steps that cannot be moves
     * @param {ReadonlyMap<number, string>} touches  what steps come too near to
     */
    draw(doc, program, chosen, faults, touches) {
      shown = { doc, program };
      const { name, steps } = doc.motionPrograms[program];
      table.setAttribute('aria-label', PROGRAM.steps(name));
      const { length, angle } = doc.robot.units;
      const now = [...steps.map(({ id, kind }) => `${id} ${kind}`), program, length, angle].join();
      if (now !== shape) {
        shape = now;
        keepFocus(body, '[data-action=step]', () => {
          rows = steps.map((step, i) => createRow(page, reasons, step, i, () => stepAt(i), program));
          fill(
            body,
            rows.map(({ row }) => row),
          );
        });
      }
      markRunning();
      for (const [i, row] of rows.entries())
        row.refresh(doc, steps[i], i === chosen, faults.get(i) ?? null, touches.get(i) ?? null);
    },
    /** @param {number} index */
    focus: (index) => rows[index]?.name.focus(),
    forget: () => rows.forEach(({ editor }) => editor?.forget()),
  };
}

/**
 * @param {Page} page
 * @param {Reasons} reasons
 * @param {StepDoc} first
 * @param {number} index
 * @param {() => StepDoc} now  the step as it is now
 * @param {number} program  its index
 */
function createRow(page, reasons, first, index, now, program) {
  const name = h('button', { type: 'button', class: 'step-name', 'data-action': 'step', 'data-index': index });
  const unit = h('span', { class: 'unit', 'aria-hidden': 'true' });
  const end = h('td', { class: 'step-end' });
  const editor = hasNumber(first) ? speedEditor(page, reasons, index, now, program) : null;
  const row = h(
    'tr',
    { 'data-row': index },
    h('td', { class: 'step-no', 'data-grip': true, title: PROGRAM.grip }, String(index + 1)),
    h('td', { class: 'step-kind' }, stepIcon(first.kind)),
    h('td', {}, name),
    h('td', { class: 'step-speed' }, editor && h('span', { class: 'step-number' }, editor.input, unit)),
    end,
  );
  /** @param {Doc} doc @param {StepDoc} step @param {boolean} isChosen @param {string | null} fault @param {string | null} touch */
  function refresh(doc, step, isChosen, fault, touch) {
    const { units } = doc.robot;
    const text = stepText(doc, step);
    const comment = 'comment' in step ? step.comment : undefined;
    const isNamed = isMove(step) && comment; // numbers say less than what somebody called them
    fill(
      name,
      spoken(`${index + 1}, ${PROGRAM.kindOf[step.kind]}, `),
      h('b', {}, isNamed ? comment : text),
      comment && !isNamed && [' ', h('span', { class: 'soft sm' }, comment)],
      step.disabled && spoken(`, ${PROGRAM.disabled}`),
      fault !== null && spoken(`, ${fault}`),
      touch !== null && [h('span', { class: 'step-touch' }, icon('octagon'), h('span', {}, ` ${touch}`))],
    );
    name.title = [text, comment, fault, touch].filter(Boolean).join('\n');
    if (isChosen) name.setAttribute('aria-current', 'true');
    else name.removeAttribute('aria-current');
    row.classList.toggle('is-chosen', isChosen);
    row.classList.toggle('is-off', step.disabled === true);
    row.classList.toggle('has-fault', fault !== null);
    unit.textContent = isMove(step) ? speedUnitText(step.speedUnit, units) : 's';
    end.textContent = isMove(step) ? endText(step.ending, units) : '';
    if (!editor) return;
    const label = isMove(step)
      ? PROGRAM.speedOf(index + 1, speedUnitInWords(step.speedUnit, units))
      : PROGRAM.secondsOf(index + 1);
    editor.input.setAttribute('aria-label', label);
    editor.refresh();
  }
  return { row, name, editor, refresh };
}

/**
 * @param {Page} page @param {Reasons} reasons @param {number} index @param {() => StepDoc} now @param {number} program
 * @returns {CellEditor}
 */
function speedEditor(page, reasons, index, now, program) {
  const input = textInput({ 'data-action': 'speed', 'data-index': index });
  const numberOf = (/** @type {StepDoc} */ step) =>
    'speed' in step ? step.speed : 'seconds' in step ? step.seconds : 0;
  return editCell(page, input, {
    command: (/** @type {number} */ value) => {
      const step = now();
      const to = isMove(step) ? { ...step, speed: value } : { ...step, seconds: value };
      return /** @type {MotionCommand} */ ({ type: 'edit-step', program, step: index, to });
    },
    onDone: (value) => PROGRAM.done.field(input.getAttribute('aria-label') ?? '', editable(value)),
    onReason: (reason, refused) => reasons.set(input, reason, refused),
    text: () => editable(numberOf(now())),
    resting: () => compact(numberOf(now()), WIDEST_SPEED).text,
  });
}
