/**
 * The pose panel once more than the tool's pose is asked of it: any frame seen from any other, in every convention, as a
 * matrix or link by link, and copied. Fetched when it is first needed.
 *
 * @import { Page } from '../page.js'
 * @import { PoseParts } from './poseParts.js'
 * @import { Doc } from '../../model/document.js'
 * @import { AppState } from '../../model/session.js'
 * @import { CopySheet } from '../../model/numbers/copyText.js'
 * @import { FrameId } from '../../model/numbers/frameNumbers.js'
 * @import { OrientationForm, Reading } from '../../model/numbers/orientationNumbers.js'
 */
import '../css/numbers.css';
import { jointsSheet, KERNEL_UNITS, linksSheet, matrixSheet, poseSheet } from '../../model/numbers/copySheets.js';
import { frameSeenFrom, framesOf, linkFramesOf } from '../../model/numbers/frameNumbers.js';
import { memo } from '../../model/memo.js';
import { orientationForm } from '../../model/numbers/orientationForms.js';
import { rowsOf } from '../../model/numbers/poseRows.js';
import { fromKernel } from '../../model/units.js';
import { together } from '../../model/views.js';
import { runCopyMenu } from '../parts/copyMenu.js';
import { fill, h } from '../parts/dom.js';
import { fixed, poseNumber, unitSign } from '../parts/format.js';
import { createLinksView } from './linksView.js';
import { createMatrix, matrixTexts } from './matrixView.js';
import { formSection } from './formMenu.js';
import { addMenu } from '../parts/poseMenu.js';
import { createPoseGrid } from './poseGrid.js';
import { TEXT } from '../strings.js';
import { NUMBERS } from '../words/numbers.js';

const PURE_DECIMALS = 5;

/** @param {FrameId} frame @param {Doc} doc */
function nameOf(frame, { activeUser }) {
  if (frame === 'user' && activeUser !== undefined) return activeUser;
  if (typeof frame !== 'number') return NUMBERS.frameName[frame];
  return frame === 0 ? NUMBERS.frameName.base : NUMBERS.frame(frame);
}

/** @param {FrameId} frame @param {Doc} doc */
const nameAtStart = (frame, doc) => (frame === 'user' ? nameOf(frame, doc) : NUMBERS.atStart(nameOf(frame, doc)));

/** What is said of numbers that are not the only ones. @param {OrientationForm} form @param {Reading} reading */
function freedomInWords({ labels }, { freedom, setToZero }) {
  if (freedom === null) return '';
  return setToZero === null || freedom !== 'locked'
    ? NUMBERS[freedom === 'halfTurn' ? 'halfTurn' : 'noTurn']
    : TEXT.pose.locked(labels[0], labels[2], labels[setToZero]);
}

/**
 * @param {Page} page
 * @param {PoseParts} parts  of the panel that stands
 */
export function runNumbersPanel(page, parts) {
  const { store, addView, derived } = page;
  const { body, note } = parts;
  const numbers = () => store.state.session.numbers;
  /** @param {Partial<ReturnType<typeof numbers>>} change */
  const choose = (change) => store.dispatch({ type: 'show', change: { numbers: { ...numbers(), ...change } } });

  const framesFor = memo(linkFramesOf);
  const seen = memo(frameSeenFrom);
  /** @param {AppState} state @returns {Float64Array} T_from_frame */
  const pose = ({ doc, session }) =>
    seen(
      session.numbers.frame,
      session.numbers.from,
      framesFor(derived.chain(doc), derived.posture(doc)),
      derived.tcp(doc),
      derived.user(doc),
    );

  const matrix = createMatrix();
  const matrixFoot = h('p', { class: 'sm soft' });
  const matrixPage = h('div', {}, matrix.element, matrixFoot);
  const links = createLinksView(page);

  addMenu(parts.frames, () => {
    const { frame: now, from } = numbers();
    const { doc } = store.state;
    const all = framesOf(doc.robot, doc.activeUser !== undefined);
    /** @param {'frame' | 'from'} key @param {FrameId} frame */
    const item = (key, frame) => ({
      title: nameAtStart(frame, doc),
      detail: frame === 'user' ? NUMBERS.userFrame : undefined,
      isChosen: frame === (key === 'frame' ? now : from),
      run: () => choose({ [key]: frame }),
    });
    return [
      { heading: NUMBERS.of, items: all.filter((frame) => frame !== 'world').map((frame) => item('frame', frame)) },
      { heading: NUMBERS.from, items: all.toReversed().map((frame) => item('from', frame)) },
    ];
  });
  addMenu(parts.form, () => {
    const { form: chosen, tab: open } = numbers();
    /** @param {OrientationForm['group']} group */
    const section = (group) =>
      formSection(group, open === 'pose' ? chosen : null, (form) => choose({ form, tab: 'pose' }));
    const whole = {
      heading: NUMBERS.group.whole,
      items: /** @type {const} */ (['matrix', 'links']).map((tab) => ({
        title: TEXT.pose.tabDetail[tab],
        isChosen: open === tab,
        run: () => choose({ tab }),
      })),
    };
    return [section('named'), section('other'), whole, section('moving'), section('fixed')];
  });
  for (const tab of parts.tabs)
    tab.addEventListener('click', () => choose({ tab: /** @type {'pose' | 'matrix' | 'links'} */ (tab.dataset.ask) }));

  /** @param {'pose' | 'matrix' | 'links' | 'allLinks' | 'joints'} what @returns {CopySheet} */
  function sheetOf(what) {
    const { doc } = store.state;
    const { robot } = doc;
    const { frame, from, form, isKernelUnits } = numbers();
    const units = isKernelUnits ? KERNEL_UNITS : robot.units;
    const place = { robot, frame, from, T: pose(store.state), units };
    if (what === 'pose') return poseSheet(place, orientationForm(form));
    if (what === 'matrix') return matrixSheet(place);
    if (what === 'joints') return jointsSheet(doc, units);
    return linksSheet(robot, what === 'links' ? links.shown() : links.all(), units);
  }
  runCopyMenu(page, parts, {
    sheetOf,
    main: () => numbers().tab,
    others: ['pose', 'matrix', 'joints', 'allLinks'],
    names: NUMBERS.what,
    titles: NUMBERS.also,
    title: TEXT.pose.copy,
  });

  addView(
    together(({ doc, session }) => [session.numbers, doc.activeUser]),
    ([{ frame, from, form: id, tab }]) => {
      const { doc } = store.state;
      const form = orientationForm(id);
      parts.titleText.textContent = NUMBERS.poseOf(nameAtStart(frame, doc));
      parts.frameText.textContent = NUMBERS.seenFrom(nameOf(from, doc));
      parts.formText.textContent = tab === 'pose' ? form.name : TEXT.pose.tabDetail[tab];
      parts.form.title = tab === 'pose' ? (form.product ?? form.name) : TEXT.pose.chooseForm;
      parts.bar.dataset.tab = tab;
      for (const button of parts.tabs) button.setAttribute('aria-pressed', String(button.dataset.ask === tab));
    },
  );

  /** @type {ReturnType<typeof createPoseGrid>} */
  let grid;
  let shape = '';
  let noteText = '';
  /** @param {string} text */
  function say(text) {
    if (text === noteText) return;
    noteText = note.textContent = text;
    note.hidden = text === '';
  }
  note.hidden = true;

  addView(
    together((state) => [state.doc.robot.units, state.session.numbers, pose(state)]),
    ([units, { tab, form: id, frame, from }, T]) => {
      const form = orientationForm(id);
      const wanted = [tab, id, units.length, units.angle].join();
      const isNew = wanted !== shape;
      shape = wanted;
      if (tab === 'links') {
        if (isNew) fill(body, links.element);
        say('');
        return;
      }
      const lengths = [T[12], T[13], T[14]].map((value) => fromKernel('length', value, units));
      if (tab === 'matrix') {
        if (isNew) fill(body, matrixPage);
        const rows = rowsOf(T).map((row, i) => (i < 3 ? row.with(3, lengths[i]) : row));
        const { doc } = store.state;
        matrix.draw(NUMBERS.matrix(nameOf(frame, doc), nameOf(from, doc)), matrixTexts(rows, units.length));
        matrixFoot.textContent = NUMBERS.lengths(unitSign(units.length));
        say('');
        return;
      }
      const reading = form.read(T, units);
      if (isNew) {
        grid = createPoseGrid([
          ...['X', 'Y', 'Z'].map((label) => ({ label, unit: unitSign(units.length) })),
          ...form.labels.map((label, k) => ({
            label,
            unit: form.quantities[k] === 'angle' ? unitSign(units.angle) : '',
          })),
        ]);
        fill(body, grid.element);
      }
      grid.draw([
        ...lengths.map((value) => poseNumber(value, units.length)),
        ...reading.values.map((value, k) =>
          form.quantities[k] === 'angle' ? poseNumber(value, units.angle) : fixed(value, PURE_DECIMALS),
        ),
      ]);
      say(freedomInWords(form, reading));
    },
  );
}
