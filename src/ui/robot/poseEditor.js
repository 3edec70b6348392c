/**
 * A pose of the document (base, tool, a user frame): a shift and an orientation, the latter written as the person likes. Choosing how it is written changes
 * what is shown, and never the document; the document keeps what was typed.
 *
 * @import { Page } from '../page.js'
 * @import { CellEditor } from './cellEditor.js'
 * @import { PoseDoc } from '../../model/document.js'
 * @import { Notation } from '../../model/numbers/orientationNotation.js'
 * @import { PoseSubject } from './poseSubjects.js'
 */
import { isNoPose } from '../../model/noPose.js';
import { NOTATIONS, orientationOf, withOrientation } from '../../model/numbers/orientationNotation.js';
import { identityPose } from '../../model/document.js';
import { isSamePose } from '../../model/samePose.js';
import { together } from '../../model/views.js';
import { captioned, captionedSelect, select, textInput } from '../parts/captioned.js';
import '../css/robotDetails.css';
import { fill, h } from '../parts/dom.js';
import { plain, unitSign } from '../parts/format.js';
import { numberField } from '../parts/numberField.js';
import { attempt } from '../page.js';
import { createReasons } from '../parts/reasons.js';
import { severalField } from '../parts/severalField.js';
import { TEXT } from '../strings.js';
import { DETAILS } from '../words/robotDetails.js';

const LENGTH_OF_QUATERNION = 4;

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {PoseSubject} subject
 * @returns {() => void} removes what keeps it up to date
 */
export function createPoseEditor(page, host, subject) {
  const { store, addView, announce } = page;
  const robot = () => store.state.doc.robot;
  const pose = () => subject.pose(store.state.doc);
  const what = () => subject.name(store.state.doc);
  const { command } = subject;
  const reasons = createReasons(`${subject.id}-reason`);
  /** @type {Notation} */
  let notation = pose().quaternion ? 'quaternion' : 'rpy';

  /**
   * Angles that the document does not keep are computed from what it does, and near gimbal lock that may give others than
   * were typed. While the pose is the one that came of the typing, the typed ones are shown.
   * @type {{ pose: PoseDoc, notation: Notation, numbers: readonly number[] } | null}
   */
  let typed = null;
  const numbers = () =>
    typed && isSamePose(typed.pose, pose()) && typed.notation === notation
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
  const notationSelect = select(DETAILS.orientationAs(what()), NOTATIONS, DETAILS.notation, (wanted) => {
    notation = wanted;
    build();
    refresh();
  });
  const reset = h('button', { type: 'button', class: 'btn btn-small' }, DETAILS.reset);
  reset.addEventListener('click', () => {
    if (isNoPose(pose())) return announce(DETAILS.resetNeedless);
    typed = null;
    attempt(page, command(identityPose()));
    announce(subject.resetDone);
  });
  fill(
    host,
    h('p', { class: 'soft sm' }, subject.meaning),
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
      captionedField(h('b', { class: `axis-${'xyz'[k]}` }, 'XYZ'[k]), unitSign(length), {
        quantity: 'length',
        label: DETAILS.shift(what(), 'XYZ'[k], TEXT.table.unitName[length]),
        value: () => pose().xyz[k],
        command: (value) => command({ ...pose(), xyz: pose().xyz.with(k, value) }),
      }),
    );
    const angleFields =
      notation === 'quaternion'
        ? [quaternionField()]
        : DETAILS.angles[notation].map((name, k) =>
            captionedField(name, unitSign(angle), {
              quantity: 'angle',
              label: DETAILS.shift(what(), name, TEXT.table.unitName[angle]),
              value: () => numbers()[k],
              command: (value) => turned(numbers().with(k, value)),
            }),
          );
    editors = [...shiftFields, ...angleFields].map(({ editor }) => editor);
    fill(shifts, ...shiftFields.map(({ element }) => element));
    fill(angles, ...angleFields.map(({ element }) => element));
    meaning.textContent = DETAILS.meaning[notation];
    notationSelect.value = notation;
    notationSelect.setAttribute('aria-label', DETAILS.orientationAs(what()));
  }

  /**
   * @param {Node | string} caption
   * @param {string} unit
   * @param {Pick<Parameters<typeof numberField>[2], 'quantity' | 'label' | 'value' | 'command'>} given
   */
  function captionedField(caption, unit, given) {
    const again = () => command(pose());
    const { input, editor } = numberField(page, reasons, { ...given, again, done: DETAILS.set });
    return { element: captioned(caption, input, unit), editor };
  }

  /** Four numbers in one field, since one of them alone is no orientation. */
  function quaternionField() {
    const text = () => numbers().map(plain).join('  ');
    const { input, button, editor } = severalField(
      page,
      reasons,
      textInput({ 'aria-label': DETAILS.quaternion(what()) }),
      {
        counts: [LENGTH_OF_QUATERNION],
        wrongCount: DETAILS.fourNumbers,
        text,
        take: (wanted) => ({ command: turned(wanted) }),
        mend(wanted) {
          const length = Math.hypot(...wanted);
          return length === 0 ? null : wanted.map((value) => value / length);
        },
        mendLabel: DETAILS.scale,
        done: () => DETAILS.set(DETAILS.notation.quaternion, text()),
      },
    );
    return { element: h('div', { class: 'quaternion' }, captioned('x  y  z  w', input), button), editor };
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
  return addView(
    together(({ doc, session }) => [doc.robot.units, subject.pose(doc), session.edition, subject.name(doc)]),
    ([{ length, angle }, , now, name]) => {
      if (now !== edition) editors.forEach((editor) => editor.forget());
      edition = now;
      const wanted = [length, angle, name].join();
      if (wanted !== shape) build();
      shape = wanted;
      refresh();
    },
  );
}
