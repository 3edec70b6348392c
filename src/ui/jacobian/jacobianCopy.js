/**
 * Copying what the Jacobian panel shows, in the languages that all numbers are copied in.
 *
 * @import { Page } from '../page.js'
 * @import { JacobianSheet } from '../../model/numbers/jacobianSheets.js'
 */
import { COPY_FORMATS, copyText as writeCopy } from '../../model/numbers/copyText.js';
import { jacobianSheet } from '../../model/numbers/jacobianSheets.js';
import { copyText } from '../parts/clipboard.js';
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { addMenu } from '../parts/poseMenu.js';
import { TEXT } from '../strings.js';
import { JACOBIAN } from '../words/jacobian.js';
import { NUMBERS } from '../words/numbers.js';

const WHAT = /** @type {readonly JacobianSheet[]} */ (['geometric', 'numeric', 'measures', 'statics']);

/** @param {Page} page @returns {HTMLElement} */
export function createJacobianCopy({ store, derived, announce, messages }) {
  const numbers = () => store.state.session.numbers;
  const button = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': JACOBIAN.copy.button, title: JACOBIAN.copy.button },
    icon('copy'),
  );
  const element = h('div', { class: 'dropdown' }, button);

  /** @param {JacobianSheet} what */
  async function carryOut(what) {
    const { doc, session } = store.state;
    const { format } = numbers();
    const [chain, q, user] = [derived.chain(doc), derived.posture(doc), derived.user(doc)];
    const sheet = jacobianSheet(what, doc, chain, q, session.jacobian, user);
    const isDone = await copyText(writeCopy(sheet, format));
    if (isDone) announce(JACOBIAN.copy.copied(JACOBIAN.copy.what[what], NUMBERS.format[format]));
    else messages.warn(TEXT.pose.copyFailed);
  }

  addMenu(button, () => [
    {
      heading: JACOBIAN.copy.as(NUMBERS.format[numbers().format]),
      items: WHAT.map((what) => ({ title: JACOBIAN.copy.what[what], run: () => void carryOut(what) })),
    },
    {
      heading: JACOBIAN.copy.chooseFormat,
      items: COPY_FORMATS.map((format) => ({
        title: NUMBERS.format[format],
        isChosen: format === numbers().format,
        run: () => store.dispatch({ type: 'show', change: { numbers: { ...numbers(), format } } }),
      })),
    },
  ]);
  return element;
}
