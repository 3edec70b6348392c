/**
 * What the target panel offers beyond typing: the form of its numbers, copying, pasting, and the helpers. Fetched when one of
 * them is first asked for.
 *
 * @import { Page } from '../page.js'
 * @import { TargetFields } from './targetFields.js'
 * @import { TargetParts } from './targetParts.js'
 */
import '../css/typedIn.css';
import '../css/target.css';
import { poseFromXyzwpr } from '../../model/aim/aim.js';
import { KERNEL_UNITS, matrixSheet, poseSheet } from '../../model/numbers/copySheets.js';
import { orientationForm } from '../../model/numbers/orientationForms.js';
import { together } from '../../model/views.js';
import { runCopyMenu } from '../parts/copyMenu.js';
import { fill } from '../parts/dom.js';
import { formSection } from '../pose/formMenu.js';
import { addMenu } from '../parts/poseMenu.js';
import { TEXT } from '../strings.js';
import { MATRIX, targetForm } from './targetForms.js';
import { createTargetHelp } from './targetHelp.js';
import { createTargetPaste } from './targetPaste.js';
import { NUMBERS } from '../words/numbers.js';
import { TARGET } from '../words/target.js';

/**
 * @param {Page} page
 * @param {TargetParts} parts
 * @param {TargetFields} fields
 */
export function runTargetMenus(page, parts, fields) {
  const { store, addView, announce } = page;
  const chosen = () => store.state.session.targetForm;

  /** @param {string} id */
  function choose(id) {
    store.dispatch({ type: 'show', change: { targetForm: id } });
    announce(TARGET.form.now(targetForm(id).name));
  }
  /** @param {'world' | 'user'} from */
  const seenFrom = (from) => TARGET.from[from](store.state.doc.activeUser);
  addMenu(parts.from, () => {
    const { targetFrom } = store.state.session;
    const items = /** @type {const} */ (['world', 'user']).map((from) => ({
      title: seenFrom(from),
      detail: from === 'user' ? TARGET.fromUser : undefined,
      isChosen: from === targetFrom,
      run() {
        store.dispatch({ type: 'show', change: { targetFrom: from } });
        announce(TARGET.fromNow(seenFrom(from)));
      },
    }));
    return [{ heading: TARGET.fromHeading, items }];
  });
  addView(
    together(({ doc, session }) => [session.targetFrom, doc.activeUser]),
    ([from]) => {
      parts.fromText.textContent = seenFrom(from);
      parts.from.title = `${TARGET.fromHeading} (${seenFrom(from)})`;
    },
  );
  addMenu(parts.form, () => {
    const now = chosen();
    const section = (/** @type {'named' | 'other' | 'moving' | 'fixed'} */ group) => formSection(group, now, choose);
    const matrix = { title: TARGET.matrix, isChosen: now === MATRIX, run: () => choose(MATRIX) };
    const whole = { heading: NUMBERS.group.whole, items: [matrix] };
    return [section('named'), section('other'), whole, section('moving'), section('fixed')];
  });
  addView(
    ({ session }) => session.targetForm,
    (id) => {
      const form = targetForm(id);
      parts.formText.textContent = form.name;
      parts.form.title = form.title;
      fields.choose(form);
    },
  );

  runCopyMenu(page, parts, {
    /** @param {'pose' | 'matrix'} what */
    sheetOf(what) {
      const { robot } = store.state.doc;
      const units = store.state.session.numbers.isKernelUnits ? KERNEL_UNITS : robot.units;
      const T = poseFromXyzwpr(robot, fields.seen());
      const place = /** @type {const} */ ({ robot, frame: 'target', from: store.state.session.targetFrom, T, units });
      return what === 'matrix' ? matrixSheet(place) : poseSheet(place, orientationForm(chosen()));
    },
    main: () => (chosen() === MATRIX ? 'matrix' : 'pose'),
    others: ['pose', 'matrix'],
    names: TARGET.copied,
    titles: TARGET.copyOther,
    title: TEXT.aim.copy,
  });

  const { apart } = parts;
  const help = createTargetHelp(page, fields);
  /** @param {HTMLElement} back  where the focus goes then */
  const close = (back) => () => {
    fill(apart);
    apart.hidden = true;
    back.focus();
  };
  addMenu(parts.helpers, () =>
    help.sections(() => {
      apart.hidden = false;
      page.clock.onFrame(() => help.askPoint(apart, close(parts.helpers))); // the menu gives the focus back first
    }),
  );
  function openPaste(pasted = '') {
    apart.hidden = false;
    createTargetPaste(page, fields, apart, close(parts.paste)).open(pasted);
  }
  parts.paste.addEventListener('click', () => openPaste());
  return { openPaste };
}
