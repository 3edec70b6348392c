/**
 * One user frame or tool in its list: chosen, numbered, renamed, removed, and its pose edited below it. It stays the same
 * element as long as the list has the same places, so that nobody loses the text that is being typed.
 *
 * @import { Page } from '../page.js'
 * @import { FrameKind } from '../../model/frames/frames.js'
 */
import { ACTIVE, poseOnly } from '../../model/frames/frames.js';
import { poseInUnits } from '../../model/numbers/poseNumbers.js';
import { textInput } from '../parts/captioned.js';
import { fill, h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { attempt } from '../page.js';
import { createPoseEditor } from './poseEditor.js';
import { poseInWords } from './poseInWords.js';
import { framePose } from './poseSubjects.js';
import { TEXT } from '../strings.js';
import { editText } from '../parts/textEditor.js';
import { FRAMES } from '../words/frames.js';

/**
 * @param {FrameKind} kind
 * @param {string} value
 * @param {string} label
 * @param {() => void} onChoose
 */
export function chooser(kind, value, label, onChoose) {
  const radio = h('input', { type: 'radio', name: `active-${kind}`, value, 'aria-label': label });
  radio.addEventListener('change', onChoose);
  return { radio, element: h('label', { class: 'choose', title: label }, radio) };
}

/**
 * @param {Page} page
 * @param {FrameKind} kind
 * @param {number} index  in the document's list
 * @param {object} on
 * @param {(index: number) => void} on.choose
 * @param {(index: number) => void} on.remove
 * @param {(text: string | null) => void} on.reason  a text was refused, or is good again
 */
export function createFrameRow(page, kind, index, on) {
  const { store, derived, announce } = page;
  const frame = () => store.state.doc.frames[index];
  const { radio, element: choose } = chooser(kind, String(index), '', () => on.choose(index));
  const id = () => frame()?.id ?? '';

  const number = textInput({ class: 'name-box number', 'aria-describedby': 'frames-reason' });
  const numberText = () => String(frame()?.number ?? '');
  const name = textInput({ class: 'name-box', 'aria-describedby': 'frames-reason' });
  const editors = [
    editText(page, number, {
      text: numberText,
      read(typed) {
        if (typed !== '' && !/^\d+$/.test(typed)) return { reason: FRAMES.notNumber };
        return { command: { type: 'number-frame', index, number: typed === '' ? undefined : Number(typed) } };
      },
      onReason: on.reason,
      onDone: () => FRAMES.numbered(id(), numberText()),
    }),
    editText(page, name, {
      text: id,
      read: (typed) => ({ command: { type: 'rename-frame', index, id: typed } }),
      onReason: on.reason,
      onDone: () => FRAMES.renamed(id()),
    }),
  ];

  const place = h('span', { class: 'soft sm place' });
  const body = h('div', { class: 'frame-editor', id: `frame-editor-${index}`, hidden: true });
  const edit = h(
    'button',
    { type: 'button', class: 'btn btn-small', 'aria-expanded': 'false', 'aria-controls': body.id },
    FRAMES.editShort,
  );
  const remove = h('button', { type: 'button', class: 'btn btn-small', 'data-action': 'remove' }, icon('trash'));
  const row = h('div', { class: 'frame-row' }, choose, number, name, place, edit, remove);
  let isOpen = false;
  let removeView = () => {};

  /** @param {boolean} wanted */
  function open(wanted) {
    if (wanted === isOpen) return;
    isOpen = wanted;
    edit.setAttribute('aria-expanded', String(isOpen));
    body.hidden = !isOpen;
    removeView();
    removeView = () => {};
    fill(body);
    if (!isOpen) return;
    const fields = h('div', {});
    removeView = createPoseEditor(page, fields, framePose(kind, index));
    const here = h('button', { type: 'button', class: 'btn btn-small btn-outline' }, icon('crosshair'), FRAMES.here);
    here.addEventListener('click', () => {
      const { doc } = store.state;
      const pose = poseInUnits(derived.tcp(doc), doc.robot.units);
      announce(attempt(page, { type: 'edit-frame', index, pose }) ?? FRAMES.hereDone(id()));
    });
    fill(body, fields, kind === 'user' && here);
  }
  edit.addEventListener('click', () => open(!isOpen));
  remove.addEventListener('click', () => on.remove(index));

  return {
    element: h('li', {}, row, body),
    name,
    remove,
    radio,
    open,
    get isOpen() {
      return isOpen;
    },
    forget: () => editors.forEach((editor) => editor.forget()),
    /** The row's views end with it. */
    dispose: () => removeView(),
    draw() {
      const now = frame();
      if (!now) return;
      const { doc } = store.state;
      const isActive = doc[ACTIVE[kind]] === now.id;
      row.classList.toggle('is-active', isActive);
      radio.checked = isActive;
      const label = FRAMES.choose(kind, now.id);
      radio.setAttribute('aria-label', label);
      choose.title = label;
      number.setAttribute('aria-label', FRAMES.number(now.id));
      name.setAttribute('aria-label', FRAMES.name(kind, now.id));
      for (const [button, text] of /** @type {const} */ ([
        [edit, FRAMES.edit(now.id)],
        [remove, FRAMES.remove(now.id)],
      ])) {
        button.setAttribute('aria-label', text);
        button.title = text;
      }
      fill(place, ...poseInWords(poseOnly(now), doc.robot.units, TEXT.robot.noShift));
      place.title = place.textContent ?? '';
      editors.forEach((editor) => editor.refresh());
    },
  };
}

/** @typedef {ReturnType<typeof createFrameRow>} FrameRow */
