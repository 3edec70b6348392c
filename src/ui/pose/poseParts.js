/** The pose panel's own elements, which stay whatever they show. */
import { h, symbol } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { TEXT } from '../strings.js';

export function createPoseParts() {
  const caret = () => icon('caret', 'caret');
  const frameText = h('span', { class: 'soft' }, TEXT.pose.frame);
  const titleText = h('span', {}, TEXT.pose.title);
  const frames = h(
    'button',
    { type: 'button', class: 'btn quiet', 'data-ask': 'frames', title: TEXT.pose.chooseFrames },
    titleText,
    ' ',
    frameText,
    caret(),
  );
  const formText = h('span', {}, TEXT.pose.convention);
  const form = h(
    'button',
    { type: 'button', class: 'btn quiet soft', 'data-ask': 'form', title: TEXT.pose.conventionDetail },
    formText,
    caret(),
  );
  const copy = h(
    'button',
    {
      type: 'button',
      class: 'btn btn-icon',
      'data-ask': 'copy',
      'aria-label': TEXT.pose.copy,
      title: TEXT.pose.copy,
    },
    icon('copy'),
  );
  const copyMore = h(
    'button',
    {
      type: 'button',
      class: 'btn split',
      'data-ask': 'copyMore',
      'aria-label': TEXT.pose.copyMore,
      title: TEXT.pose.copyMore,
    },
    caret(),
  );
  const tabs = /** @type {const} */ (['pose', 'matrix', 'links']).map((tab) =>
    h(
      'button',
      {
        type: 'button',
        'data-ask': tab,
        'aria-pressed': String(tab === 'pose'),
        'aria-label': tab === 'links' ? TEXT.pose.tabDetail.links : null,
        title: TEXT.pose.tabDetail[tab],
      },
      tab === 'links' ? symbol('A', 'i') : TEXT.pose.tab[tab],
    ),
  );
  /** @param {Element} button */
  const dropdown = (button) => h('div', { class: 'dropdown' }, button);
  return {
    ...{ frames, titleText, frameText, form, formText, copy, copyMore, tabs },
    header: h(
      'header',
      {},
      h('h2', {}, dropdown(frames)),
      h('span', { class: 'grow' }),
      h('div', { class: 'split-pair' }, copy, dropdown(copyMore)),
    ),
    bar: h(
      'div',
      { class: 'pose-bar' },
      h('div', { class: 'seg', role: 'group', 'aria-label': TEXT.pose.tabs }, tabs),
      h('span', { class: 'grow' }),
      dropdown(form),
    ),
    body: h('div', { class: 'body' }),
    note: h('p', { class: 'pose-note sm soft', hidden: true }),
  };
}

/** @typedef {ReturnType<typeof createPoseParts>} PoseParts */
