/**
 * Obstacles: how near the arm comes to them and to itself, their list, and what is looked at. Fetched when it is first opened.
 *
 * @import { Child } from '../parts/dom.js'
 * @import { Page } from '../page.js'
 * @import { ObstacleRow } from './obstacleRow.js'
 * @import { NewObstacle, ObstacleKind } from '../../model/workcell/obstacles.js'
 * @import { WorkcellView } from '../../model/workcell/workcellView.js'
 * @import { Workcells } from '../../model/workcell/workcell.js'
 */
import { newObstacle } from '../../model/workcell/newObstacle.js';
import { OBSTACLE_SIZES, sizesOf } from '../../model/workcell/obstacles.js';
import { together } from '../../model/views.js';
import '../css/typedIn.css';
import '../css/frames.css';
import { withChoices } from '../parts/choices.js';
import { fill, h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { attempt } from '../page.js';
import { OBSTACLES } from '../words/obstacles.js';
import { createClearanceLine } from './clearanceLine.js';
import { createMarginField } from './marginField.js';
import { createObstacleRow } from './obstacleRow.js';

const KINDS = /** @type {readonly ObstacleKind[]} */ (Object.keys(OBSTACLE_SIZES));

/** A copy stands so far aside, in its own sizes. */
const ASIDE = 1.2;

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {Workcells} cells
 */
export function createObstaclesPanel(page, host, cells) {
  const { store, addView, derived, announce, clock } = page;
  const view = () => store.state.session.workcell;
  /** @param {Partial<WorkcellView>} change */
  const look = (change) => store.dispatch({ type: 'show', change: { workcell: { ...view(), ...change } } });
  const idAt = (/** @type {number} */ index) => store.state.doc.obstacles[index]?.id ?? null;

  const reason = h('p', { class: 'reason sm', id: 'obstacles-reason', role: 'status', hidden: true });
  /** @param {string | null} text */
  function say(text) {
    reason.textContent = text ?? '';
    reason.hidden = text === null;
  }

  /** The place in the list whose name gets the focus once it is there. @type {number | null} */
  let toName = null;
  /** Where a row was removed, and who had the focus goes on. @type {number | null} */
  let removedAt = null;

  /** @param {NewObstacle} obstacle @param {(id: string) => string} done */
  function put(obstacle, done) {
    const against = attempt(page, { type: 'add-obstacle', obstacle });
    say(against);
    if (against) return announce(against);
    toName = store.state.doc.obstacles.length - 1;
    const id = /** @type {string} */ (idAt(toName));
    look({ chosen: id });
    announce(done(id));
  }

  /** @param {ObstacleKind} kind */
  function add(kind) {
    const { doc } = store.state;
    put(newObstacle(kind, doc, derived.chain(doc), cells), (id) => OBSTACLES.added(kind, id));
  }

  /** @param {number} index */
  function duplicate(index) {
    const { id, ...obstacle } = store.state.doc.obstacles[index];
    const { width, radius = 0 } = /** @type {{ width?: number, radius?: number }} */ (sizesOf(obstacle));
    const [x, y, z] = obstacle.xyz;
    put({ ...obstacle, xyz: [x + ASIDE * (width ?? 2 * radius), y, z] }, (copy) => OBSTACLES.duplicated(id, copy));
  }

  /** @param {number} index */
  function remove(index) {
    const id = idAt(index);
    const against = attempt(page, { type: 'remove-obstacle', index });
    say(against);
    if (against || id === null) return announce(against ?? '');
    removedAt = index;
    if (view().chosen === id) look({ chosen: null });
    announce(OBSTACLES.removed(id));
  }

  /** @param {number} index */
  function toggle(index) {
    const id = idAt(index);
    if (id === null) return;
    const { hidden } = view();
    const isHidden = hidden.includes(id);
    look({ hidden: isHidden ? hidden.filter((one) => one !== id) : [...hidden, id] });
    announce((isHidden ? OBSTACLES.shown : OBSTACLES.hidden)(id));
  }

  /** What the session knows by name goes with the name. @param {string} from @param {string} to */
  function renamed(from, to) {
    const { chosen, hidden } = view();
    if (chosen !== from && !hidden.includes(from)) return;
    look({ chosen: chosen === from ? to : chosen, hidden: hidden.map((id) => (id === from ? to : id)) });
  }

  /** @param {string} className @param {Child[]} children */
  function adder(className, ...children) {
    const button = h(
      'button',
      { type: 'button', class: `btn ${className}`, 'aria-label': OBSTACLES.add, title: OBSTACLES.add },
      children,
    );
    const choices = () => ({
      groups: [
        KINDS.map((kind) => ({
          title: OBSTACLES.kinds[kind],
          detail: OBSTACLES.addDetail[kind],
          run: () => add(kind),
        })),
      ],
    });
    return { button, element: withChoices(button, choices, { className: 'frames-add' }) };
  }
  const plus = adder('btn-icon', icon('plus'));
  const firstOne = adder('btn-outline', icon('plus'), OBSTACLES.add);
  const list = h('ul', { class: 'frames-list', 'aria-label': OBSTACLES.list });
  const head = h(
    'div',
    { class: 'frames-head' },
    h('h3', {}, OBSTACLES.list),
    h('span', { class: 'grow' }),
    plus.element,
  );
  const empty = h(
    'div',
    { class: 'empty obstacles-empty' },
    h('h3', {}, OBSTACLES.empty),
    h('p', { class: 'soft' }, OBSTACLES.emptyDetail),
    firstOne.element,
  );
  const capsules = h('input', { type: 'checkbox' });
  capsules.addEventListener('change', () => look({ hasCapsules: capsules.checked }));
  const margin = createMarginField(page);
  // until the first drawing knows which of them are called for
  for (const part of [head, list, empty, margin.element]) part.hidden = true;
  fill(
    host,
    createClearanceLine(page, cells),
    head,
    list,
    reason,
    empty,
    margin.element,
    h('label', { class: 'obstacles-option' }, capsules, h('span', {}, OBSTACLES.capsules)),
    h('p', { class: 'soft sm' }, OBSTACLES.approximation),
  );

  /** In the order of the document's list. @type {ObstacleRow[]} */
  let rows = [];
  let shape = '';

  /** The places of the list have changed: other rows, and the focus where somebody expects it. */
  function build() {
    const { obstacles } = store.state.doc;
    rows.forEach((row) => row.dispose());
    rows = obstacles.map(({ kind }, index) =>
      createObstacleRow(page, kind, index, {
        choose: (at, isWanted) => look({ chosen: isWanted ? idAt(at) : null }),
        ...{ remove, duplicate, toggle, renamed, reason: say },
      }),
    );
    fill(list, ...rows.map(({ element }) => element));
    if (removedAt !== null) {
      const next = rows[Math.min(removedAt, rows.length - 1)]?.remove;
      if (!next) clock.onFrame(() => firstOne.button.focus());
      else next.focus();
    }
    removedAt = null;
    const added = toName === null ? null : rows[toName];
    toName = null;
    if (!added) return;
    clock.onFrame(() => {
      added.name.focus();
      added.name.select();
      added.element.scrollIntoView({ block: 'nearest' });
    });
  }

  let edition = -1;
  addView(
    together(({ doc, session }) => [doc.obstacles, doc.robot, doc.posture, session.workcell, session.edition]),
    ([obstacles, , , { chosen, hidden, hasCapsules, isOpen }, now]) => {
      if (!isOpen) return;
      if (now !== edition) {
        rows.forEach((row) => row.forget());
        say(null);
      }
      edition = now;
      // a row is of a kind; one more, one less, or others in their places are other rows
      const wanted = obstacles.map(({ kind }) => kind).join() + (removedAt ?? '');
      if (wanted !== shape) build();
      shape = obstacles.map(({ kind }) => kind).join();
      const touched = new Set(cells.closeness(store.state.doc).touching.map(({ obstacle }) => obstacle));
      rows.forEach((row, i) => {
        const { id } = obstacles[i];
        row.open(id === chosen);
        row.draw({ isTouched: touched.has(id), isHidden: hidden.includes(id) });
      });
      capsules.checked = hasCapsules;
      empty.hidden = obstacles.length > 0;
      head.hidden = list.hidden = margin.element.hidden = obstacles.length === 0;
    },
  );
}
