/**
 * One obstacle in its list: renamed, removed, and its numbers edited below it while it is the chosen one. It stays the same
 * element as long as the list has the same places, so that nobody loses the text that is being typed.
 *
 * @import { Page } from '../page.js'
 * @import { ObstacleKind } from '../../model/workcell/obstacles.js'
 *
 * @typedef {object} RowActs
 * @property {(index: number, isWanted: boolean) => void} choose
 * @property {(index: number) => void} remove
 * @property {(index: number) => void} duplicate
 * @property {(index: number) => void} toggle   whether it is drawn
 * @property {(from: string, to: string) => void} renamed
 * @property {(text: string | null) => void} reason  a text was refused, or is good again
 */
import { poseOnly } from '../../model/frames/frames.js';
import { fill, h } from '../parts/dom.js';
import { textInput } from '../parts/captioned.js';
import { icon } from '../parts/icons.js';
import { editText } from '../parts/textEditor.js';
import { poseInWords } from '../robot/poseInWords.js';
import { TEXT } from '../strings.js';
import { OBSTACLES } from '../words/obstacles.js';
import { createObstacleEditor } from './obstacleEditor.js';
import { kindIcon } from './obstacleIcons.js';

/**
 * @param {Page} page
 * @param {ObstacleKind} kind
 * @param {number} index
 * @param {RowActs} on
 */
export function createObstacleRow(page, kind, index, on) {
  const { store } = page;
  const now = () => store.state.doc.obstacles[index];
  const id = () => now()?.id ?? '';
  const name = textInput({ class: 'name-box', 'aria-describedby': 'obstacles-reason' });
  const editor = editText(page, name, {
    text: id,
    read: (typed) => ({ command: { type: 'rename-obstacle', index, id: typed } }),
    onReason: on.reason,
    onDone: () => OBSTACLES.renamed(id()),
  });
  let called = id();
  const place = h('span', { class: 'soft sm place' });
  const body = h('div', { class: 'frame-editor', id: `obstacle-editor-${index}`, hidden: true });
  const edit = h(
    'button',
    { type: 'button', class: 'btn btn-small', 'aria-expanded': 'false', 'aria-controls': body.id },
    OBSTACLES.editShort,
  );
  const remove = h('button', { type: 'button', class: 'btn btn-small', 'data-action': 'remove' }, icon('trash'));
  const row = h('div', { class: 'obstacle-row' }, kindIcon(kind), name, place, edit, remove);
  let isOpen = false;
  let close = () => {};
  edit.addEventListener('click', () => on.choose(index, !isOpen));
  remove.addEventListener('click', () => on.remove(index));

  /** @param {boolean} wanted */
  function open(wanted) {
    if (wanted === isOpen) return;
    isOpen = wanted;
    edit.setAttribute('aria-expanded', String(isOpen));
    fill(edit, isOpen ? OBSTACLES.doneShort : OBSTACLES.editShort);
    row.classList.toggle('is-active', isOpen);
    body.hidden = !isOpen;
    close();
    close = () => {};
    fill(body);
    if (!isOpen) return;
    close = createObstacleEditor(page, body, index, {
      duplicate: () => on.duplicate(index),
      toggle: () => on.toggle(index),
    });
  }

  return {
    element: h('li', {}, row, body),
    name,
    remove,
    open,
    forget: editor.forget,
    /** The row's views end with it. */
    dispose: () => close(),
    /** @param {{ isTouched: boolean, isHidden: boolean }} look */
    draw({ isTouched, isHidden }) {
      const obstacle = now();
      if (!obstacle) return;
      if (called !== obstacle.id) on.renamed(called, obstacle.id);
      called = obstacle.id;
      name.setAttribute('aria-label', OBSTACLES.name(kind, obstacle.id));
      for (const [button, text] of /** @type {const} */ ([
        [edit, OBSTACLES.edit(obstacle.id)],
        [remove, OBSTACLES.remove(obstacle.id)],
      ])) {
        button.setAttribute('aria-label', text);
        button.title = text;
      }
      row.classList.toggle('is-touched', isTouched);
      fill(
        place,
        isTouched
          ? h('b', { class: 'bad' }, icon('exclamation'), ' ', OBSTACLES.touched)
          : isHidden
            ? OBSTACLES.notDrawn
            : poseInWords(poseOnly(obstacle), store.state.doc.robot.units, TEXT.robot.noBase),
      );
      place.title = place.textContent ?? '';
      editor.refresh();
    },
  };
}

/** @typedef {ReturnType<typeof createObstacleRow>} ObstacleRow */
