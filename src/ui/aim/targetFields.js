/**
 * The numbers of the target, in the form that is chosen: three lengths and three angles to begin with, and whatever else is
 * fetched when it is asked for (targetForms.js). Until someone types, they follow the tool.
 *
 * @import { Change, Page } from '../page.js'
 * @import { CellEditor } from '../robot/cellEditor.js'
 * @import { AppState } from '../../model/session.js'
 * @import { LengthFault, OrientationForm } from '../../model/numbers/orientationNumbers.js'
 *
 * @typedef {Pick<CellEditor, 'forget' | 'refresh'>} Editor
 * @typedef {{ elements: readonly HTMLElement[], editors: readonly Editor[] }} Built
 *
 * @typedef {object} TargetForm  a way to write the target
 * @property {string} id
 * @property {string} name
 * @property {string} title
 * @property {(tools: TargetTools) => Built} build
 */
import { WPR } from '../../model/numbers/angleForm.js';
import { memo } from '../../model/memo.js';
import { targetFrom, targetNumbers } from '../../model/aim/targetForm.js';
import { targetGivenIn, targetSeenFrom } from '../../model/aim/targetFrame.js';
import { together } from '../../model/views.js';
import { fill, h } from '../parts/dom.js';
import { poseNumber, roundedPose, unitSign } from '../parts/format.js';
import { numberField } from '../parts/numberField.js';
import { createReasons } from '../parts/reasons.js';
import { TEXT } from '../strings.js';

const PLACE = 3;

/** X Y Z and three angles. @param {OrientationForm} form @returns {TargetForm} */
export const angleFields = (form) => ({
  id: form.id,
  name: form.name,
  title: form.product ?? form.name,
  build(tools) {
    const fields = [
      ...placeFields(tools, form),
      ...form.labels.map((label, k) => tools.number(form, PLACE + k, label)),
    ];
    return {
      elements: [h('div', { class: 'aim-fields' }, ...fields.map(({ element }) => element))],
      editors: fields.map(({ editor }) => editor),
    };
  },
});

/** @param {TargetTools} tools @param {OrientationForm} form */
export const placeFields = (tools, form) => ['X', 'Y', 'Z'].map((label, k) => tools.number(form, k, label));

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createTargetFields(page, host) {
  const { store, addView, derived, announce } = page;
  const reasons = createReasons('aim-reason');
  const room = h('div', {});
  fill(host, room, reasons.element);

  /** The target someone asked for, or the tool while nobody aims. @param {AppState} state */
  const target = ({ doc, session }) => session.target ?? derived.xyzwpr(doc);
  /** What the fields are seen from; null: the world. @param {AppState} state */
  const from = ({ doc, session }) => (session.targetFrom === 'user' ? derived.user(doc) : null);
  const seenFrom = memo(targetSeenFrom);
  /** What the fields say. */
  const seen = () => seenFrom(store.state.doc.robot, from(store.state), target(store.state));
  /** @param {readonly number[]} wanted  in the frame of the fields @returns {Extract<Change, { type: 'show' }>} */
  const aimAt = (wanted) => ({
    type: 'show',
    change: { target: targetGivenIn(store.state.doc.robot, from(store.state), wanted), answer: null },
  });
  const units = () => store.state.doc.robot.units;

  /**
   * Numbers that the session does not keep are computed from what it does, and may be others than were typed (a half turn
   * about the opposite axis is the same). While the target is the one that came of the typing, the typed ones are shown.
   * @type {{ target: readonly number[] | null | undefined, id: string, from: Float64Array | null, numbers: readonly number[] } | null}
   */
  let typed = null;

  /** @param {OrientationForm} form */
  const numbers = (form) =>
    typed && typed.target === store.state.session.target && typed.id === form.id && typed.from === from(store.state)
      ? typed.numbers
      : targetNumbers(form, store.state.doc.robot, seen());

  /**
   * @param {OrientationForm} form
   * @param {readonly number[]} wanted  X Y Z and the numbers of the form
   * @returns {{ command: Change, fault: null } | { command: null, fault: LengthFault }}
   */
  function ask(form, wanted) {
    const { target: asked, fault } = targetFrom(form, store.state.doc.robot, wanted);
    if (fault) return { command: null, fault };
    const command = aimAt(asked);
    typed = { target: command.change.target, id: form.id, from: from(store.state), numbers: wanted };
    return { command, fault: null };
  }

  /** What brings back the target as it is now. @returns {Change} */
  function again() {
    const { target: asked, answer } = store.state.session;
    return { type: 'show', change: { target: asked, answer } };
  }

  /**
   * Where nobody has aimed yet, the numbers beside the typed one are what their fields show.
   * @param {OrientationForm} form
   * @param {number} k  the typed one
   */
  function others(form, k) {
    const now = numbers(form);
    if (store.state.session.target !== null) return now;
    return now.map((value, i) => {
      const quantity = i < PLACE ? 'length' : form.quantities[i - PLACE];
      return i === k || quantity === 'none' ? value : roundedPose(value, units()[quantity]);
    });
  }

  /** @type {TargetTools} */
  const tools = {
    page,
    reasons,
    target: seen,
    aimAt,
    numbers,
    ask,
    again,
    number(form, k, name) {
      const quantity = k < PLACE ? 'length' : 'angle';
      const unit = units()[quantity];
      const { input, editor } = numberField(page, reasons, {
        quantity,
        label: TEXT.aim.field(name, TEXT.table.unitName[unit]),
        value: () => numbers(form)[k],
        command(value) {
          const { command } = ask(form, others(form, k).with(k, value));
          return command ?? again(); // a form of which one number can be typed has no fault
        },
        again,
        done: TEXT.aim.set,
        resting: () => (store.state.session.target ? null : poseNumber(numbers(form)[k], unit)),
      });
      const mark = h('b', { class: k < PLACE ? `axis-${'xyz'[k]}` : 'soft' }, name);
      const sign = h('span', { class: 'unit', 'aria-hidden': 'true' }, unitSign(unit));
      return { element: h('label', { class: 'field' }, mark, input, sign), editor };
    },
  };

  /** @type {TargetForm} */
  let form = angleFields(WPR);
  /** @type {readonly Editor[]} */
  let editors = [];
  let shape = '';
  let edition = -1;
  /** @type {Float64Array | null} */
  let fromThen = null;

  function build() {
    const built = form.build(tools);
    editors = built.editors;
    fill(room, ...built.elements);
  }
  addView(
    together((state) => [
      state.doc.robot.units,
      target(state),
      state.session.target,
      state.session.edition,
      from(state),
    ]),
    ([{ length, angle }, , , now, T_world_from]) => {
      if (now !== edition || T_world_from !== fromThen) editors.forEach((editor) => editor.forget());
      edition = now;
      fromThen = T_world_from;
      const wanted = [form.id, length, angle].join();
      if (wanted !== shape) build();
      shape = wanted;
      editors.forEach((editor) => editor.refresh());
    },
  );

  const inputs = () => [...room.querySelectorAll('input, textarea')].filter((one) => one instanceof HTMLElement);

  return {
    target,
    from,
    seen,
    aimAt,
    room,

    /** @param {TargetForm} next */
    choose(next) {
      if (next.id === form.id) return;
      form = next;
      shape = [form.id, units().length, units().angle].join();
      build();
      editors.forEach((editor) => editor.refresh());
    },

    /** What was typed and refused is let go of. */
    forget() {
      typed = null;
      editors.forEach((editor) => (editor.forget(), editor.refresh()));
    },

    /**
     * Whether all of them can be taken as they stand; if not, that is said, and the first that cannot has the focus. What
     * still waits for its answer is asked again when it has come.
     * @param {() => void} later
     */
    areReady(later) {
      const waiting = inputs().find((input) => input.hasAttribute('aria-busy'));
      if (waiting) {
        waiting.addEventListener('settled', later, { once: true });
        return false;
      }
      const refused = inputs().find((input) => input.getAttribute('aria-invalid') === 'true');
      if (!refused) return true;
      announce(reasons.element.textContent ?? '');
      refused.focus();
      return false;
    },
  };
}

/** @typedef {ReturnType<typeof createTargetFields>} TargetFields */
/**
 * @typedef {object} TargetTools  what fields of the target are made with
 * @property {Page} page
 * @property {ReturnType<typeof createReasons>} reasons
 * @property {() => readonly number[]} target  X Y Z W P R as they stand, in the frame of the fields
 * @property {(wanted: readonly number[]) => Change} aimAt
 * @property {(form: OrientationForm) => readonly number[]} numbers  X Y Z and those of the form, as they stand
 * @property {(form: OrientationForm, wanted: readonly number[]) =>
 *   { command: Change, fault: null } | { command: null, fault: LengthFault }} ask
 * @property {() => Change} again
 * @property {(form: OrientationForm, k: number, name: string) => { element: HTMLElement, editor: Editor }} number
 */
