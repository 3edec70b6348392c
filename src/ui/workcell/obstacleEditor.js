/**
 * The numbers of one obstacle, below its row: its sizes, its place and turn, and what else is done with it.
 *
 * @import { CellEditor } from '../robot/cellEditor.js'
 * @import { Page } from '../page.js'
 * @import { ObstacleDoc } from '../../model/document.js'
 * @import { NewObstacle, ObstacleSize } from '../../model/workcell/obstacles.js'
 */
import { identityPose } from '../../model/document.js';
import { poseInUnits } from '../../model/numbers/poseNumbers.js';
import { OBSTACLE_SIZES, sizesOf } from '../../model/workcell/obstacles.js';
import { together } from '../../model/views.js';
import { captioned } from '../parts/captioned.js';
import { fill, h } from '../parts/dom.js';
import { unitSign } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { numberField } from '../parts/numberField.js';
import { createReasons } from '../parts/reasons.js';
import { attempt } from '../page.js';
import { createPoseEditor } from '../robot/poseEditor.js';
import { TEXT } from '../strings.js';
import { OBSTACLES } from '../words/obstacles.js';

const NO_POSE = Object.freeze(identityPose());

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {number} index  in the document's list
 * @param {{ duplicate: () => void, toggle: () => void }} acts
 * @returns {() => void} removes what keeps it up to date
 */
export function createObstacleEditor(page, host, index, acts) {
  const { store, addView, derived, announce } = page;
  const now = () => /** @type {ObstacleDoc | undefined} */ (store.state.doc.obstacles[index]);
  const kind = now()?.kind ?? 'box';
  const reasons = createReasons('obstacle-reason');
  /** @param {object} change */
  const changed = (change) =>
    /** @type {const} */ ({
      type: 'edit-obstacle',
      index,
      obstacle: /** @type {NewObstacle} */ ({ ...now(), ...change }),
    });

  const row = h('div', { class: 'captioned-row' });
  /** @type {CellEditor[]} */
  let editors = [];
  /** @param {ObstacleSize} size @param {string} id */
  function sizeField(size, id) {
    const { length } = store.state.doc.robot.units;
    const value = () => /** @type {Partial<Record<ObstacleSize, number>>} */ (sizesOf(now() ?? first))[size] ?? 0;
    const { input, editor } = numberField(page, reasons, {
      quantity: 'length',
      label: OBSTACLES.field(id, OBSTACLES.size[size], TEXT.table.unitName[length]),
      value,
      command: (typed) => changed({ [size]: typed }),
      again: () => changed({}),
      done: OBSTACLES.set,
    });
    editors.push(editor);
    return captioned(OBSTACLES.size[size], input, unitSign(length));
  }
  const first = /** @type {ObstacleDoc} */ (now());

  const place = h('div', { class: 'obstacle-place' });
  const removePose = createPoseEditor(page, place, {
    id: `obstacle-${index}`,
    name: () => now()?.id ?? '',
    pose: () => now() ?? NO_POSE,
    command: (pose) => changed({ rpy: undefined, quaternion: undefined, ...pose }), // one of both at most
    meaning: OBSTACLES.meaning[kind],
    resetDone: OBSTACLES.resetDone,
  });

  /** @param {string} text @param {string} action @param {Parameters<typeof icon>[0] | null} drawing */
  const button = (text, action, drawing) =>
    h(
      'button',
      { type: 'button', class: 'btn btn-small btn-outline', 'data-action': action },
      drawing && icon(drawing),
      h('span', {}, text),
    );
  const here = button(OBSTACLES.atTool, 'at-tool', 'crosshair');
  here.addEventListener('click', () => {
    const { doc } = store.state;
    const { xyz } = poseInUnits(derived.tcp(doc), doc.robot.units);
    announce(attempt(page, changed({ xyz })) ?? OBSTACLES.atToolDone(now()?.id ?? ''));
  });
  const duplicate = button(OBSTACLES.duplicate, 'duplicate', 'copy');
  duplicate.addEventListener('click', acts.duplicate);
  const toggle = button(OBSTACLES.hide, 'toggle', null);
  toggle.addEventListener('click', acts.toggle);
  fill(host, row, reasons.element, place, h('div', { class: 'obstacle-acts' }, here, duplicate, toggle));

  let shape = '';
  let edition = -1;
  const removeView = addView(
    together(({ doc, session }) => [
      doc.obstacles[index],
      doc.robot.units,
      session.edition,
      session.workcell.hidden.includes(doc.obstacles[index]?.id),
    ]),
    ([obstacle, { length }, next, isHidden]) => {
      if (!obstacle) return;
      if (next !== edition) editors.forEach((editor) => editor.forget());
      edition = next;
      const wanted = `${length} ${obstacle.id}`;
      if (wanted !== shape) {
        shape = wanted;
        editors = [];
        fill(row, ...OBSTACLE_SIZES[kind].map((size) => sizeField(size, obstacle.id)));
        row.hidden = OBSTACLE_SIZES[kind].length === 0;
      }
      editors.forEach((editor) => editor.refresh());
      fill(toggle, h('span', {}, isHidden ? OBSTACLES.show : OBSTACLES.hide));
    },
  );
  return () => {
    removeView();
    removePose();
  };
}
