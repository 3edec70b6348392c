/**
 * The edge between the left panel and the view: pulled or moved by keys, it makes the panel wider. A double click gives it its own
 * width back. Each tab has its width, remembered where the browser may.
 *
 * @import { Page } from './page.js'
 * @import { Tab } from '../model/session.js'
 */
import { recall, remember } from './browserStorage.js';
import { h } from './parts/dom.js';
import { readWidths, widthAfterKey, withinEdge } from './leftWidth.js';
import { TEXT } from './strings.js';

const KEY = 'denavit.left';

/**
 * @param {Page} page
 * @param {HTMLElement} app
 */
export function createLeftEdge({ store, addView }, app) {
  const widths = readWidths(recall(KEY));
  const edge = h('div', {
    class: 'left-edge',
    role: 'separator',
    'aria-orientation': 'vertical',
    'aria-label': TEXT.panels.leftEdge,
    'aria-controls': 'left-side',
    tabindex: 0,
  });
  const left = /** @type {HTMLElement} */ (app.querySelector('.left'));
  left.id = 'left-side';

  const widthNow = () => Math.round(left.getBoundingClientRect().width);
  /** The view keeps its share of the page. */
  const limits = () => {
    const right = app.querySelector('.right')?.getBoundingClientRect().width ?? 0;
    return withinEdge(app.clientWidth, right);
  };

  function say() {
    const { least, most } = limits();
    const value = widthNow();
    const numbers = { valuemin: least, valuemax: Math.max(most, value), valuenow: value };
    for (const [name, number] of Object.entries(numbers)) edge.setAttribute(`aria-${name}`, String(number));
  }

  /** @param {Tab} tab */
  function show(tab) {
    const width = widths[tab];
    if (width === undefined) app.style.removeProperty('--left');
    else app.style.setProperty('--left', `${Math.min(width, limits().most)}px`);
    say();
  }

  /** @param {number | null} width  null: its own */
  function set(width) {
    const { tab } = store.state.session;
    const { least, most } = limits();
    if (width === null) delete widths[tab];
    else widths[tab] = Math.round(Math.min(most, Math.max(least, width)));
    show(tab);
  }
  const keep = () => void remember(KEY, JSON.stringify(widths));

  edge.addEventListener('keydown', (event) => {
    const width = widthAfterKey(event, widthNow(), limits());
    if (width === undefined) return;
    event.preventDefault();
    set(width);
    keep();
  });
  edge.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    const before = widths[store.state.session.tab] ?? null;
    const offset = widthNow() - event.clientX;
    const gone = new AbortController();
    const { signal } = gone;
    edge.setPointerCapture(event.pointerId);
    edge.addEventListener('pointermove', ({ clientX }) => set(clientX + offset), { signal });
    const leave = () => {
      gone.abort();
      keep();
    };
    edge.addEventListener('lostpointercapture', leave, { signal });
    document.addEventListener(
      'keydown',
      (key) => {
        if (key.key !== 'Escape') return;
        set(before);
        leave();
      },
      { signal },
    );
  });
  edge.addEventListener('dblclick', () => {
    set(null);
    keep();
  });
  edge.addEventListener('focus', say);
  window.addEventListener('resize', () => show(store.state.session.tab));
  addView(({ session }) => session.tab, show);
  // a landmark of its own, so that all of the page is in one; it takes no room (css/tablet.css)
  return h('section', { class: 'edge-room', 'aria-label': TEXT.panels.leftEdge }, edge);
}
