/**
 * Base or tool: a shift and an orientation, the latter written as the person likes. Choosing how it is written changes
 * what is shown, and never the document; the document keeps what was typed.
 *
 * @import { Page } from './page.js'
 * @import { Command } from '../model/commands.js'
 * @import { CellEditor } from './cellEditor.js'
 * @import { PoseDoc } from '../model/document.js'
 * @import { Notation } from '../model/orientationNotation.js'
 * @import { Reasons } from './reasons.js'
 */
import { isNoPose } from '../model/noPose.js';
import { NOTATIONS, orientationOf, withOrientation } from '../model/orientationNotation.js';
import { identityPose } from '../model/document.js';
import { together } from '../model/views.js';
import { captioned, captionedSelect, select, textInput } from './captioned.js';
import { editCell } from './cellEditor.js';
import './css/robotDetails.css';
import { fill, h } from './dom.js';
import { compact, copyable, editable, plain, unitSign } from './format.js';
import { readNumber } from './numberText.js';
import { attempt } from './page.js';
import { createReasons } from './reasons.js';
import { TEXT } from './strings.js';
import { editText } from './textEditor.js';
import { DETAILS } from './words/robotDetails.js';

const WIDEST = 9;
const LENGTH_OF_QUATERNION = 4;

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {'base' | 'tool'} which
 */
export function createPoseEditor(page, host, which) {
  const { store, addView, announce } = page;
  const what = TEXT.robot[which];
  const type = /** @type {const} */ ({ base: 'set-base', tool: 'set-tool' })[which];
  const robot = () => store.state.doc.robot;
  const pose = () => robot()[which];
  const command = (/** @type {PoseDoc} */ wanted) => ({ type, pose: wanted });
  const reasons = createReasons(`${which}-reason`);
  /** @type {Notation} */
  let notation = pose().quaternion ? 'quaternion' : 'rpy';

  /**
   * Angles that the document does not keep are computed from what it does, and near gimbal lock that may give others than
   * were typed. While the pose is the one that came of the typing, the typed ones are shown.
   * @type {{ pose: PoseDoc, notation: Notation, numbers: readonly number[] } | null}
   */
  let typed = null;
  const numbers = () =>
    typed?.pose === pose() && typed.notation === notation
      ? typed.numbers
      : orientationOf(pose(), notation, robot().units).numbers;

  /** @param {readonly number[]} wanted */
  function turned(wanted) {
    const next = withOrientation(pose(), notation, wanted, robot().units);
    typed = { pose: next, notation, numbers: wanted };
    return command(next);
  }

  /** @type {Pick<CellEditor, 'forget' | 'refresh'>[]} */
  let editors = [];
  const shifts = h('div', { class: 'captioned-row' });
  const angles = h('div', { class: 'captioned-row' });
  const meaning = h('p', { class: 'soft sm' });
  const computed = h('p', { class: 'soft sm' });
  const notationSelect = select(DETAILS.orientationAs(what), NOTATIONS, DETAILS.notation, (wanted) => {
    notation = wanted;
    build();
    refresh();
  });
  const reset = h('button', { type: 'button', class: 'btn btn-small' }, DETAILS.reset);
  reset.addEventListener('click', () => {
    if (isNoPose(pose())) return announce(DETAILS.resetNeedless);
    typed = null;
    attempt(page, command(identityPose()));
    announce(DETAILS.resetDone[which]);
  });
  fill(
    host,
    h('p', { class: 'soft sm' }, DETAILS.pose[which]),
    shifts,
    h('div', { class: 'captioned-row' }, captionedSelect(notationSelect, DETAILS.orientation), reset),
    angles,
    reasons.element,
    meaning,
    computed,
  );

  function build() {
    const { length, angle } = robot().units;
    const shiftFields = [0, 1, 2].map((k) =>
      numberField(page, reasons, {
        quantity: 'length',
        caption: h('b', { class: `axis-${'xyz'[k]}` }, 'XYZ'[k]),
        label: DETAILS.shift(what, 'XYZ'[k], TEXT.table.unitName[length]),
        unit: unitSign(length),
        value: () => pose().xyz[k],
        command: (value) => command({ ...pose(), xyz: pose().xyz.with(k, value) }),
        again: () => command(pose()),
      }),
    );
    const angleFields =
      notation === 'quaternion'
        ? [quaternionField()]
        : DETAILS.angles[notation].map((name, k) =>
            numberField(page, reasons, {
              quantity: 'angle',
              caption: name,
              label: DETAILS.shift(what, name, TEXT.table.unitName[angle]),
              unit: unitSign(angle),
              value: () => numbers()[k],
              command: (value) => turned(numbers().with(k, value)),
              again: () => command(pose()),
            }),
          );
    editors = [...shiftFields, ...angleFields].map(({ editor }) => editor);
    fill(shifts, ...shiftFields.map(({ element }) => element));
    fill(angles, ...angleFields.map(({ element }) => element));
    meaning.textContent = DETAILS.meaning[notation];
    notationSelect.value = notation;
  }

  /** Four numbers in one field, since one of them alone is no orientation. */
  function quaternionField() {
    const input = textInput({ 'aria-label': DETAILS.quaternion(what) });
    const scale = h('button', { type: 'button', class: 'btn btn-small btn-outline', hidden: true }, DETAILS.scale);
    const text = () => numbers().map(plain).join('  ');
    const editor = editText(page, input, {
      text,
      read(typedText) {
        const read = readFour(typedText);
        return 'reason' in read ? read : { command: turned(read.numbers) };
      },
      onReason(reason) {
        reasons.set(input, reason);
        const read = readFour(input.value);
        scale.hidden = reason === null || 'reason' in read || Math.hypot(...read.numbers) === 0;
      },
      onDone: () => DETAILS.set(DETAILS.notation.quaternion, text()),
    });
    scale.addEventListener('click', () => {
      const read = readFour(input.value);
      if ('reason' in read) return;
      const length = Math.hypot(...read.numbers);
      input.focus(); // the button goes with the reason
      editor.type(copyable(read.numbers.map((value) => value / length)));
    });
    const element = h('div', { class: 'quaternion' }, captioned('x  y  z  w', input), scale);
    return { element, editor };
  }

  function refresh() {
    editors.forEach((editor) => editor.refresh());
    const isKept = orientationOf(pose(), notation, robot().units).isKept;
    computed.textContent = isKept ? '' : DETAILS.computed[pose().quaternion ? 'quaternion' : 'rpy'];
    computed.hidden = isKept;
    reset.classList.toggle('is-needless', isNoPose(pose()));
  }

  let shape = '';
  let edition = -1;
  addView(
    together(({ doc, session }) => [doc.robot.units, doc.robot[which], session.edition]),
    ([{ length, angle }, , now]) => {
      if (now !== edition) editors.forEach((editor) => editor.forget());
      edition = now;
      const wanted = [length, angle].join();
      if (wanted !== shape) build();
      shape = wanted;
      refresh();
    },
  );
}

/**
 * @param {Page} page
 * @param {Reasons} reasons
 * @param {object} given
 * @param {'length' | 'angle'} given.quantity
 * @param {Node | string} given.caption
 * @param {string} given.label
 * @param {string} given.unit
 * @param {() => number} given.value
 * @param {(value: number) => Command} given.command
 * @param {() => Command} given.again  what brings back what the document has now
 */
function numberField(page, reasons, { quantity, caption, label, unit, value, command, again }) {
  const input = textInput({ 'aria-label': label });
  const editor = editCell(page, input, {
    measure: () => ({ quantity, units: page.store.state.doc.robot.units }),
    command,
    again,
    onDone: () => DETAILS.set(label, editable(value())),
    onReason: (reason, refused) => reasons.set(input, reason, refused, (way) => editor.settle(way)),
    text: () => editable(value()),
    resting() {
      const { text, isRounded } = compact(value(), WIDEST);
      input.title = isRounded ? plain(value()) : '';
      return text;
    },
  });
  return { element: captioned(caption, input, unit), editor };
}

/** @param {string} text @returns {{ numbers: number[] } | { reason: string }} */
function readFour(text) {
  const parts = text
    .trim()
    .split(/[\s,;]+/)
    .filter(Boolean);
  if (parts.length !== LENGTH_OF_QUATERNION) return { reason: DETAILS.fourNumbers(parts.length) };
  const numbers = [];
  for (const part of parts) {
    const { value, reason } = readNumber(part);
    if (reason !== null) return { reason };
    numbers.push(value);
  }
  return { numbers };
}
