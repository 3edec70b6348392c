/**
 * Where the tool is: X Y Z and W P R, in a frame and a convention that stand in the panel's own head.
 *
 * @import { Page } from './page.js'
 */
import $ from 'jquery/slim';
import { copyText } from './clipboard.js';
import { fill, h } from './dom.js';
import { copyable, poseNumber, unitSign, withUnit } from './format.js';
import { icon } from './icons.js';
import { TEXT } from './strings.js';

export const POSE_NAMES = ['X', 'Y', 'Z', 'W', 'P', 'R'];
const ROWS = [0, 3, 1, 4, 2, 5]; // X W, Y P, Z R: read across, copied down

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createPosePanel({ store, addView, derived, announce }, host) {
  const copy = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': TEXT.pose.copy, title: TEXT.pose.copy },
    icon('copy'),
  );
  const outputs = POSE_NAMES.map(() => h('output', {}));
  const unitMarks = POSE_NAMES.map(() => h('span', { class: 'unit' }));
  fill(
    host,
    h(
      'header',
      {},
      h('h2', {}, TEXT.pose.title),
      h('span', { class: 'soft' }, TEXT.pose.frame),
      h('span', { class: 'grow' }),
      h('span', { class: 'soft', title: TEXT.pose.conventionDetail }, TEXT.pose.convention),
      copy,
    ),
    h(
      'div',
      { class: 'body pose' },
      ROWS.map((k) =>
        h('div', {}, h('b', { class: k < 3 ? `axis-${'xyz'[k]}` : 'soft' }, POSE_NAMES[k]), outputs[k], unitMarks[k]),
      ),
    ),
  );

  const shown = () => derived.xyzwpr(store.state.doc);
  const unitFor = (/** @type {number} */ k) => store.state.doc.robot.units[k < 3 ? 'length' : 'angle'];

  $(copy).on('click', async () => {
    const text = copyable(shown());
    announce((await copyText(text)) ? TEXT.pose.copied : TEXT.pose.copyFailed);
  });

  addView(
    ({ doc }) => derived.xyzwpr(doc),
    (numbers) =>
      numbers.forEach((value, k) => {
        outputs[k].value = poseNumber(value, unitFor(k));
        unitMarks[k].textContent = unitSign(unitFor(k));
      }),
  );

  return {
    /** The pose in words, for the view's text twin. */
    inWords: () =>
      TEXT.pose.spoken(
        shown()
          .map((value, k) => `${POSE_NAMES[k]} ${withUnit(poseNumber(value, unitFor(k)), unitFor(k))}`)
          .join(', '),
      ),
  };
}
