/**
 * One hint at the first visit, in the view: three ways to move the arm. Gone at the first drag, key or "Got it", and it does
 * not come back where the browser may remember that.
 */
import { recall, remember } from './browserStorage.js';
import { h, symbol } from './parts/dom.js';
import { icon } from './parts/icons.js';
import { TEXT } from './strings.js';

const KEY = 'denavit.hint';

/** @param {HTMLElement} view */
export function showFirstVisit(view) {
  if (recall(KEY) === 'seen') return;
  const close = h('button', { type: 'button', class: 'btn btn-icon', 'aria-label': TEXT.close }, icon('close'));
  const done = h('button', { type: 'button', class: 'btn btn-primary' }, TEXT.firstVisit.done);
  const pictures = [
    icon('sliders'),
    icon('target'),
    h('span', { class: 'hint-cell' }, symbol('a', 2), h('b', {}, '17 in')),
  ];
  const hint = h(
    'aside',
    { class: 'hint', 'aria-label': TEXT.firstVisit.title },
    h('p', { class: 'line' }, TEXT.firstVisit.line),
    h('div', { class: 'row-flex' }, h('h2', { class: 'grow' }, TEXT.firstVisit.title), close),
    h(
      'ol',
      {},
      TEXT.firstVisit.ways.map(({ title, detail }, i) =>
        h(
          'li',
          {},
          h('span', { class: 'pic', 'aria-hidden': 'true' }, pictures[i]),
          h('b', {}, title),
          h('span', {}, detail),
        ),
      ),
    ),
    h(
      'div',
      { class: 'row-flex' },
      h(
        'span',
        { class: 'soft sm grow' },
        `${TEXT.firstVisit.undo} `,
        h('kbd', {}, TEXT.firstVisit.control),
        h('kbd', {}, 'Z'),
      ),
      done,
    ),
  );
  view.append(hint);

  const gone = new AbortController();
  const { signal } = gone;
  function leave() {
    gone.abort();
    hint.remove();
    remember(KEY, 'seen');
  }
  close.addEventListener('click', leave);
  done.addEventListener('click', leave);
  /** @param {Event} event */
  const isElsewhere = ({ target }) => !(target instanceof Node && hint.contains(target));
  // A Tab leads to the hint, or past it, and Enter presses its button: neither is a wish to have it gone.
  const onKey = (/** @type {KeyboardEvent} */ event) => {
    if (event.key === 'Escape' || (isElsewhere(event) && !['Tab', 'Shift'].includes(event.key))) leave();
  };
  document.addEventListener('keydown', onKey, { signal, capture: true });
  const onPointer = (/** @type {Event} */ event) => void (isElsewhere(event) && leave());
  document.addEventListener('pointerdown', onPointer, { signal, capture: true });
}
