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
 * @property {(index: number) => void} extend   the choice to there
 * @property {() => void} chooseAll
 * @property {(index: number | null) => void} look   at where it ends; null: no more
 * @property {(index: number, to: number) => void} move
 * @property {(index: number, by: -1 | 1) => void} shift
 * @property {() => void} remove    what is chosen
 * @property {(event: ClipboardEvent) => void} copy   or cut
 * @property {(text: string) => void} paste
 */
import several from 'bootstrap-icons/icons/check2-square.svg?raw';
import $ from 'jquery/slim';
import { isMove } from '../../model/program/motionProgram.js';
import { stepNow } from '../../model/program/planning.js';
import { shownProgram } from '../../model/program/shownProgram.js';
import { chosenSteps } from '../../model/program/stepRange.js';
import { editCell } from '../robot/cellEditor.js';
import { fill, h, keepFocus, spoken } from '../parts/dom.js';
import { compact, editable } from '../parts/format.js';
import { textInput } from '../parts/captioned.js';
import { icon, iconOf } from '../parts/icons.js';
import { hasNumber, endText, speedUnitInWords, speedUnitText, stepIcon, stepText } from './stepText.js';
import { watchStepDrag } from './stepDrag.js';
import { watchTableKeys } from '../robot/tableKeys.js';
import { PROGRAM } from '../words/program.js';
import { STEP_RANGE } from '../words/stepRange.js';

const WIDEST_SPEED = 6;

/**
 * @param {Page} page
 * @param {Reasons} reasons
 * @param {TableActs} acts
 */
export function createStepTable(page, reasons, acts) {
  const body = h('tbody');
  /** For fingers: while it is pressed, the next row that is pressed is the other end of the choice. */
  const toggle = h(
    'button',
    {
      type: 'button',
      class: 'btn btn-icon steps-several',
      'aria-pressed': 'false',
      'aria-label': STEP_RANGE.several,
      title: STEP_RANGE.severalTitle,
    },
    iconOf(several),
  );
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
        h('td', { class: 'step-no' }, toggle),
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
  /** Rows are exchanged, and the focus put back: that is nobody's choice. */
  let isBuilding = false;
  /** The step that is being played. @type {number | null} */
  let under = null;

  const indexOf = (/** @type {HTMLElement} */ within) => Number(within.closest('tr')?.dataset.row ?? -1);
  const stepAt = (/** @type {number} */ index) =>
    /** @type {{ program: number, doc: Doc }} */ (shown).doc.motionPrograms[shown?.program ?? 0].steps[index];

  /** Not the one that was drawn last: keys are quicker. */
  const chosenNow = () => shownProgram(page.store.state).step;
  const isSeveral = () => toggle.getAttribute('aria-pressed') === 'true';
  toggle.addEventListener('click', () => {
    const isOn = !isSeveral();
    toggle.setAttribute('aria-pressed', String(isOn));
    if (isOn) page.announce(STEP_RANGE.severalOn);
    else acts.choose(chosenNow());
  });
  const isField = (/** @type {EventTarget | null} */ target) => target instanceof HTMLInputElement;

  $(body)
    .on('mousedown', 'tr', (event) => {
      const index = indexOf(event.currentTarget);
      if (isField(event.target) || event.button !== 0 || !(event.shiftKey || isSeveral())) return;
      event.preventDefault(); // neither text is selected, nor the row taken for the only one
      acts.extend(index);
      rows[index]?.name.focus();
    })
    .on('click', 'tr', (event) => {
      const isExtended = !isField(event.target) && (event.shiftKey || isSeveral());
      if (!isExtended) acts.choose(indexOf(event.currentTarget));
    })
    .on('focusin', 'tr', ({ currentTarget }) => {
      const index = indexOf(currentTarget);
      if (index !== chosenNow() && !isBuilding) acts.choose(index);
      acts.look(index);
    })
    .on('focusout', () => acts.look(null))
    .on('pointerenter', 'tr', (event) => event.pointerType !== 'touch' && acts.look(indexOf(event.currentTarget)))
    .on('pointerleave', 'tr', () => acts.look(null))
    .on('keydown', 'tr', (event) => {
      const { key, altKey, shiftKey, target } = event;
      const down = key === 'ArrowDown' ? 1 : key === 'ArrowUp' ? -1 : 0;
      const index = indexOf(event.currentTarget);
      if (down !== 0 && altKey) acts.shift(index, down);
      else if (isField(target)) return;
      else if (down !== 0 && shiftKey) {
        acts.extend(index + down);
        rows[index + down]?.name.focus();
      } else if (down !== 0) rows[index + down]?.name.focus();
      else if (key === 'ArrowRight') rows[index].editor?.input.focus();
      else if (key === 'Delete' || key === 'Backspace') acts.remove();
      else if (key === 'a' && (event.ctrlKey || event.metaKey)) acts.chooseAll();
      else if (key === 'Escape' && (chosenSteps(page.store.state)?.count ?? 0) > 1) acts.choose(index);
      else return;
      event.preventDefault();
    });
  for (const type of /** @type {const} */ (['copy', 'cut'])) {
    body.addEventListener(type, (event) => !isField(event.target) && acts.copy(event));
  }
  body.addEventListener('paste', (event) => {
    const text = event.clipboardData?.getData('text/plain') ?? '';
    if (isField(event.target) || !text.trimStart().startsWith('{')) return; // a robot file is for the page
    event.preventDefault();
    acts.paste(text);
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
     * @param {{ first: number, count: number } | null} range  of all that are chosen
     * @param {ReadonlyMap<number, string>} faults   of steps that cannot be moves
     * @param {ReadonlyMap<number, string>} touches  what steps come too near to
     */
    draw(doc, program, chosen, range, faults, touches) {
      shown = { doc, program };

      const { name, steps } = doc.motionPrograms[program];
      table.setAttribute('aria-label', PROGRAM.steps(name));
      const { length, angle } = doc.robot.units;
      const now = [...steps.map(({ id, kind }) => `${id} ${kind}`), program, length, angle].join();
      if (now !== shape) {
        shape = now;
        isBuilding = true;
        keepFocus(body, '[data-action=step]', () => {
          rows = steps.map((step, i) => createRow(page, reasons, step, i, () => stepAt(i), program));
          fill(
            body,
            rows.map(({ row }) => row),
          );
        });
        isBuilding = false;
      }
      markRunning();
      for (const [i, row] of rows.entries()) {
        const isIn = range !== null && i >= range.first && i < range.first + range.count;
        const choice = isIn ? (range.count > 1 ? 'together' : 'alone') : null;
        row.refresh(doc, steps[i], choice, faults.get(i) ?? null, touches.get(i) ?? null);
        row.setCurrent(i === chosen);
      }
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
  let written = '';
  /** @param {Doc} doc @param {StepDoc} step @param {'alone' | 'together' | null} choice @param {string | null} fault @param {string | null} touch */
  function refresh(doc, step, choice, fault, touch) {
    const { units } = doc.robot;
    const text = stepText(doc, step);
    const comment = 'comment' in step ? step.comment : undefined;
    const ending = isMove(step) ? endText(step.ending, units) : '';
    const speedUnit = isMove(step) ? step.speedUnit : null; // that of lengths and angles goes with the shape of the table
    const now = JSON.stringify([text, comment, ending, speedUnit, choice, step.disabled, fault, touch]);
    if (now !== written) {
      written = now; // of hundreds of rows only those are laid out anew that say something else
      write(step, text, comment, choice, fault, touch);
      end.textContent = ending;
      unit.textContent = speedUnit ? speedUnitText(speedUnit, units) : 's';
      const label = speedUnit
        ? PROGRAM.speedOf(index + 1, speedUnitInWords(speedUnit, units))
        : PROGRAM.secondsOf(index + 1);
      editor?.input.setAttribute('aria-label', label);
    }
    editor?.refresh();
  }
  /**
   * @param {StepDoc} step @param {string} text @param {string | undefined} comment @param {'alone' | 'together' | null} choice
   * @param {string | null} fault @param {string | null} touch
   */
  function write(step, text, comment, choice, fault, touch) {
    const isNamed = isMove(step) && comment; // numbers say less than what somebody called them
    fill(
      name,
      spoken(`${index + 1}, ${PROGRAM.kindOf[step.kind]}, `),
      h('b', {}, isNamed ? comment : text),
      comment && !isNamed && [' ', h('span', { class: 'soft sm' }, comment)],
      choice === 'together' && spoken(`, ${STEP_RANGE.together}`),
      step.disabled && spoken(`, ${PROGRAM.disabled}`),
      fault !== null && spoken(`, ${fault}`),
      touch !== null && [h('span', { class: 'step-touch' }, icon('octagon'), h('span', {}, ` ${touch}`))],
    );
    name.title = [text, comment, fault, touch].filter(Boolean).join('\n');
    row.classList.toggle('is-chosen', choice !== null);
    row.classList.toggle('is-off', step.disabled === true);
    row.classList.toggle('has-fault', fault !== null);
  }
  /** @param {boolean} isCurrent */
  function setCurrent(isCurrent) {
    if (isCurrent) name.setAttribute('aria-current', 'true');
    else name.removeAttribute('aria-current');
  }
  return { row, name, editor, refresh, setCurrent };
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
