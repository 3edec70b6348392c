/** The target panel's own elements, which stay whatever they show. */
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { TEXT } from '../strings.js';

export function createTargetParts() {
  const caret = () => icon('caret', 'caret');
  /** @param {string} ask @param {string} name @param {string} className @param {...Node} content */
  const button = (ask, name, className, ...content) =>
    h(
      'button',
      { type: 'button', class: `btn ${className}`, 'data-ask': ask, 'aria-label': name, title: name },
      content,
    );
  const formText = h('span', {}, TEXT.pose.convention);
  const form = h(
    'button',
    { type: 'button', class: 'btn quiet soft', 'data-ask': 'form', title: TEXT.pose.conventionDetail },
    formText,
    caret(),
  );
  const fromText = h('span', {}, TEXT.pose.frame);
  const from = h('button', { type: 'button', class: 'btn quiet soft aim-from', 'data-ask': 'from' }, fromText, caret());
  const world = h('span', { class: 'soft' }, TEXT.pose.frame);
  const copy = button('copy', TEXT.aim.copy, 'btn-icon', icon('copy'));
  const copyMore = button('copyMore', TEXT.pose.copyMore, 'split', caret());
  const paste = h('button', { type: 'button', class: 'btn quiet', 'data-ask': 'paste' }, TEXT.aim.paste);
  const helpers = h('button', { type: 'button', class: 'btn quiet', 'data-ask': 'helpers' }, TEXT.aim.helpers, caret());
  const follow = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': TEXT.aim.follow, title: TEXT.aim.follow },
    icon('crosshair'),
  );
  /** @param {Element} one */
  const dropdown = (one) => h('div', { class: 'dropdown' }, one);
  return {
    ...{ form, formText, from, fromText, world, copy, copyMore, paste, helpers, follow },
    header: h(
      'header',
      {},
      h('h2', {}, TEXT.aim.title),
      world,
      dropdown(from),
      h('span', { class: 'grow' }),
      h('div', { class: 'split-pair' }, copy, dropdown(copyMore)),
      follow,
    ),
    bar: h('div', { class: 'aim-bar' }, paste, dropdown(helpers), h('span', { class: 'grow' }), dropdown(form)),
    /** Where the text to paste, and the point to look at, are typed. */
    apart: h('div', { class: 'aim-apart', hidden: true }),
  };
}

/** @typedef {ReturnType<typeof createTargetParts>} TargetParts */
