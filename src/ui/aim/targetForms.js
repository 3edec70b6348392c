/**
 * The forms of the target of which one number alone says nothing: quaternions, axis and angle, the matrix.
 *
 * @import { TargetForm, TargetTools } from './targetFields.js'
 * @import { LengthFault, OrientationForm } from '../../model/numbers/orientationNumbers.js'
 * @import { Units } from '../../model/document.js'
 * @import { MatrixFault } from '../../model/aim/targetMatrix.js'
 */
import { orientationForm } from '../../model/numbers/orientationForms.js';
import { targetFromMatrix, targetRows } from '../../model/aim/targetMatrix.js';
import { textInput } from '../parts/captioned.js';
import { h } from '../parts/dom.js';
import { compact, fixed, plain, poseNumber } from '../parts/format.js';
import { severalField } from '../parts/severalField.js';
import { angleFields, placeFields } from './targetFields.js';
import { TARGET } from '../words/target.js';

const PURE_DECIMALS = 5;
const MATRIX_DECIMALS = 4;
const BRIEF = 7;

export const MATRIX = 'matrix';

/** @param {LengthFault} fault */
export const lengthInWords = ({ of, length }) => TARGET.length[of](compact(length, BRIEF).text);

/** @param {MatrixFault} fault */
export const matrixInWords = ({ kind, by }) => TARGET.matrixFault[kind](by.toPrecision(2));

/** @param {string} id @returns {TargetForm} */
export function targetForm(id) {
  if (id === MATRIX) return matrixFields();
  const form = orientationForm(id);
  return form.quantities.includes('none') ? severalFields(form) : angleFields(form);
}

/** Exact zeros and ones have no decimals. @param {number} value @param {number} decimals */
const pure = (value, decimals) => (Number.isInteger(value) ? plain(value) : fixed(value, decimals));

/** @param {OrientationForm} form @returns {TargetForm} */
const severalFields = (form) => ({
  id: form.id,
  name: form.name,
  title: form.name,
  build(tools) {
    const { page, reasons, numbers, ask } = tools;
    const unitNow = () => page.store.state.doc.robot.units.angle;
    const turn = () => numbers(form).slice(3);
    const all = (/** @type {readonly number[]} */ wanted) => [...numbers(form).slice(0, 3), ...wanted];
    const text = () => turn().map(plain).join('  ');
    const names = form.labels.join(' ');
    const place = placeFields(tools, form);
    const { input, button, editor } = severalField(
      page,
      reasons,
      textInput({ 'aria-label': TARGET.several(form.name, names) }),
      {
        counts: [form.labels.length],
        wrongCount: (came) => TARGET.wrongCount(form.name, names, form.labels.length, came),
        text,
        resting: () =>
          turn()
            .map((value, k) =>
              form.quantities[k] === 'angle' ? poseNumber(value, unitNow()) : pure(value, PURE_DECIMALS),
            )
            .join('  '),
        take(wanted) {
          const { command, fault } = ask(form, all(wanted));
          return fault ? { reason: lengthInWords(fault) } : { command };
        },
        mend(wanted) {
          const { fault } = ask(form, all(wanted));
          return fault?.mended?.slice() ?? null;
        },
        mendLabel: TARGET.scale,
        done: () => TARGET.set(form.name, text()),
      },
    );
    const row = h(
      'label',
      { class: 'aim-several' },
      h('span', { class: 'caption', 'aria-hidden': 'true' }, form.labels.join('  ')),
      h('span', { class: 'field' }, input),
    );
    return {
      elements: [h('div', { class: 'aim-fields is-place' }, ...place.map(({ element }) => element)), row, button],
      editors: [...place.map((field) => field.editor), editor],
    };
  },
});

/** @returns {TargetForm} */
const matrixFields = () => ({
  id: MATRIX,
  name: TARGET.matrix,
  title: TARGET.matrixTitle,
  build(/** @type {TargetTools} */ tools) {
    const { page, reasons, target, aimAt } = tools;
    const robot = () => page.store.state.doc.robot;
    const rows = () => targetRows(robot(), target());
    const text = () => rows().map((row) => row.map(plain).join('  ')).join('\n'); // prettier-ignore
    const { input, button, editor } = severalField(
      page,
      reasons,
      h('textarea', {
        ...{ rows: 4, autocomplete: 'off', spellcheck: 'false', wrap: 'off', class: 'aim-matrix' },
        'aria-label': TARGET.matrixTitle,
      }),
      {
        counts: [12, 16],
        wrongCount: TARGET.matrixCount,
        text,
        resting: () => columns(rows(), robot().units.length),
        take(wanted) {
          const { target: asked, fault } = targetFromMatrix(robot(), wanted);
          return fault ? { reason: matrixInWords(fault) } : { command: aimAt(asked) };
        },
        mend: (wanted) => targetFromMatrix(robot(), wanted).fault?.mended ?? null,
        mendLabel: TARGET.nearestRotation,
        done: () => TARGET.set(TARGET.matrix, ''),
      },
    );
    return {
      elements: [h('label', { class: 'aim-several' }, h('span', { class: 'field' }, input)), button],
      editors: [editor],
    };
  },
});

/** Rounded, in columns. @param {number[][]} rows @param {Units['length']} unit */
function columns(rows, unit) {
  const texts = rows.map((row, i) =>
    row.map((value, j) => (i === 3 ? plain(value) : j === 3 ? poseNumber(value, unit) : pure(value, MATRIX_DECIMALS))),
  );
  const widths = texts[0].map((_, j) => Math.max(...texts.map((row) => row[j].length)));
  return texts.map((row) => row.map((text, j) => text.padStart(widths[j])).join(' ')).join('\n');
}
