/**
 * User frames and tools of the document, each with a number, one of each active, as on a controller. Another tool keeps the
 * flange or the TCP, by choice. Fetched when it is first opened.
 *
 * @import { Page } from '../page.js'
 * @import { FrameRow } from './frameRow.js'
 * @import { PoseDoc } from '../../model/document.js'
 * @import { FrameKind } from '../../model/frames/frames.js'
 */
import { ACTIVE, agree, poseOnly, targetsIn } from '../../model/frames/frames.js';
import { identityPose } from '../../model/document.js';
import { poseInUnits } from '../../model/numbers/poseNumbers.js';
import { together } from '../../model/views.js';
import '../css/typedIn.css';
import '../css/frames.css';
import { chooseFrame } from './chooseFrame.js';
import { fill, h } from '../parts/dom.js';
import { frameAdders } from './frameAdders.js';
import { createFramePoints } from './framePoints.js';
import { chooser, createFrameRow } from './frameRow.js';
import { attempt } from '../page.js';
import { poseInWords } from './poseInWords.js';
import { segments } from '../parts/segments.js';
import { FRAMES } from '../words/frames.js';

/** @type {readonly FrameKind[]} */
const KINDS = ['user', 'tool'];

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createFramesPanel(page, host) {
  const { store, addView, derived, announce } = page;
  const reasonText = h('span', {});
  const instead = h('button', { type: 'button', class: 'btn btn-small btn-outline', hidden: true }, FRAMES.keepFlange);
  const reason = h(
    'p',
    { class: 'reason sm frames-reason', id: 'frames-reason', role: 'status', hidden: true },
    reasonText,
    instead,
  );
  /** @type {number | null | undefined} the tool that could not be chosen; null: the flange itself */
  let refusedTool;

  /** @param {string | null} text @param {number | null} [tool] */
  function say(text, tool) {
    reasonText.textContent = text ?? '';
    reason.hidden = text === null;
    refusedTool = tool;
    instead.hidden = tool === undefined;
  }

  /** @param {FrameKind} kind @param {number | null} index @param {'flange'} [keeps] */
  function choose(kind, index, keeps) {
    const against = chooseFrame(page, kind, index, keeps);
    say(against?.reason ?? null, against?.isStuck ? index : undefined);
    draw(); // a radio button that was refused goes back
  }
  instead.addEventListener('click', () => {
    if (refusedTool !== undefined) choose('tool', refusedTool, 'flange');
  });

  /** @param {number} index */
  function remove(index) {
    const { doc } = store.state;
    const { kind, id } = doc.frames[index];
    const count = kind === 'user' ? targetsIn(doc, id).length : 0;
    const against = attempt(page, { type: 'remove-frame', index });
    say(against);
    if (against) return announce(against);
    removedAt = index;
    const wasInUse = doc.activeTool === id && kind === 'tool';
    announce(
      count > 0 ? FRAMES.removedWithTargets(id, count) : wasInUse ? FRAMES.removedInUse(id) : FRAMES.removed(id),
    );
  }

  /** Where a row was removed, and who had the focus goes on. @type {number | null} */
  let removedAt = null;
  /** The place in the list whose row is opened, once it is there. @type {number | null} */
  let toOpen = null;

  /** @param {FrameKind} kind @param {PoseDoc} pose @returns {string | null} the reason why not */
  function add(kind, pose) {
    const against = attempt(page, { type: 'add-frame', kind, pose });
    say(against);
    if (against) {
      announce(against);
      return against;
    }
    const { frames, activeTool } = store.state.doc;
    const { id } = frames[frames.length - 1];
    toOpen = frames.length - 1;
    announce(kind === 'tool' && activeTool === id ? FRAMES.addedInUse(id) : FRAMES.added(kind, id));
    return null;
  }

  const tcp = () => poseInUnits(derived.tcp(store.state.doc), store.state.doc.robot.units);
  const points = createFramePoints(page, {
    make: (pose) => add('user', pose),
    cancel: () => adders.user.button.focus(),
  });

  const adders = frameAdders({
    add: (kind, pose) => void add(kind, pose),
    openPoints: () => page.clock.onFrame(points.open),
    tcp,
    tool: () => store.state.doc.robot.tool,
  });

  /** @param {FrameKind} kind */
  function noneRow(kind) {
    const { radio, element } = chooser(kind, 'none', FRAMES.chooseNone[kind], () => choose(kind, null));
    const row = h(
      'div',
      { class: 'frame-row' },
      element,
      h('span', { class: 'soft number' }, '0'),
      h('span', {}, FRAMES.none[kind]),
      h('span', { class: 'soft sm grow' }, FRAMES.noneDetail[kind]),
    );
    return { radio, row, item: h('li', {}, row) };
  }
  const none = { user: noneRow('user'), tool: noneRow('tool') };

  const own = chooser('tool', 'own', FRAMES.own, () => {});
  const ownPlace = h('span', { class: 'soft sm place' });
  const keepOwn = h('button', { type: 'button', class: 'btn btn-small' }, FRAMES.keepOwn);
  const ownRow = h(
    'li',
    {},
    h(
      'div',
      { class: 'frame-row is-active is-own' },
      own.element,
      h('span', {}),
      h('span', {}, FRAMES.own),
      ownPlace,
      keepOwn,
    ),
  );
  keepOwn.addEventListener('click', () => void add('tool', poseOnly(store.state.doc.robot.tool)));

  const lists = {
    user: h('ul', { class: 'frames-list', 'aria-label': FRAMES.title.user }),
    tool: h('ul', { class: 'frames-list', 'aria-label': FRAMES.title.tool }),
  };
  const keeps = segments(FRAMES.keepsLabel, /** @type {const} */ (['flange', 'tcp']), FRAMES.keep, (toolKeeps) =>
    store.dispatch({ type: 'show', change: { toolKeeps } }),
  );
  const keepNote = h('p', { class: 'soft sm' });

  /** @param {FrameKind} kind */
  const head = (kind) =>
    h(
      'div',
      { class: 'frames-head' },
      h('h3', {}, FRAMES.title[kind]),
      h('span', { class: 'soft sm' }, FRAMES.note[kind]),
      h('span', { class: 'grow' }),
      adders[kind].element,
    );
  fill(
    host,
    head('user'),
    lists.user,
    points.element,
    head('tool'),
    lists.tool,
    h('div', { class: 'frames-keep' }, h('span', {}, FRAMES.keeps), keeps.element),
    keepNote,
    reason,
  );

  /** In the order of the document's list. @type {FrameRow[]} */
  let rows = [];
  /** The kinds in the list, in their order. @type {string | null} */
  let shape = null;

  /** The places of the list have changed: other rows, the one with the focus again if it is there. */
  function build() {
    const { frames } = store.state.doc;
    const wereOpen = new Set(rows.flatMap((row, i) => (row.isOpen ? [ids[i]] : [])));
    rows.forEach((row) => row.dispose());
    rows = frames.map(({ kind }, index) =>
      createFrameRow(page, kind, index, { choose: (at) => choose(kind, at), remove, reason: say }),
    );
    ids = frames.map(({ id }) => id);
    for (const kind of KINDS) {
      const own = rows.filter((_, i) => frames[i].kind === kind).map(({ element }) => element);
      fill(lists[kind], none[kind].item, own, kind === 'tool' && ownRow);
    }
    rows.forEach((row, i) => row.open(wereOpen.has(ids[i])));
    if (removedAt !== null) (rows[Math.min(removedAt, rows.length - 1)]?.remove ?? adders.user.button).focus();
    removedAt = null;
    const added = toOpen === null ? null : rows[toOpen];
    toOpen = null;
    if (!added) return;
    added.open(true);
    page.clock.onFrame(() => {
      added.name.focus();
      added.name.select();
    });
  }
  /** @type {string[]} */
  let ids = [];

  function draw() {
    const { doc } = store.state;
    rows.forEach((row) => row.draw());
    ids = doc.frames.map(({ id }) => id);
    const hasOwn = doc.activeTool === undefined && !agree(doc.robot.tool, identityPose());
    ownRow.hidden = !hasOwn;
    own.radio.checked = hasOwn;
    fill(ownPlace, ...poseInWords(doc.robot.tool, doc.robot.units, ''));
    for (const kind of KINDS) {
      const isNone = doc[ACTIVE[kind]] === undefined && !(kind === 'tool' && hasOwn);
      none[kind].radio.checked = isNone;
      none[kind].row.classList.toggle('is-active', isNone);
    }
  }

  let edition = -1;
  addView(
    together(({ doc, session }) => [
      doc.frames,
      doc.activeUser,
      doc.activeTool,
      doc.robot.tool,
      doc.robot.units,
      session.edition,
    ]),
    ([frames, , , , , now]) => {
      if (now !== edition) {
        rows.forEach((row) => row.forget());
        say(null);
      }
      edition = now;
      const wanted = frames.map(({ kind }) => kind).join();
      if (wanted !== shape) build();
      shape = wanted;
      draw();
    },
  );
  addView(
    ({ session }) => session.toolKeeps,
    (chosen) => {
      keeps.draw(chosen);
      keepNote.textContent = FRAMES.keepNote[chosen];
    },
  );
}
