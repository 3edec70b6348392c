/**
 * A quiet bar at the foot of the page: a sentence, what can be done, and a cross. It takes no focus and waits.
 *
 * @import { Page } from '../page.js'
 *
 * @typedef {object} Note
 * @property {string | readonly string[]} text  one sentence for each thing; several are a list
 * @property {readonly { name: string, run: () => void, isUsual?: boolean, stays?: boolean }[]} [actions]  each closes the
 *   note unless it `stays`
 * @property {string} close  the name of the cross
 * @property {boolean} [isWarning]
 */
import '../css/note.css';
import { h } from './dom.js';
import { icon } from './icons.js';

/** @param {Page} page @param {Note} note @returns {() => void} take it away */
export function showNote({ messages }, { text, actions = [], close, isWarning = false }) {
  const cross = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': close, title: close },
    icon('close'),
  );
  const buttons = actions.map(({ name, run, isUsual, stays }) => {
    const button = h('button', { type: 'button', class: isUsual ? 'btn btn-outline' : 'btn' }, name);
    button.addEventListener('click', () => {
      if (!stays) element.remove();
      run();
    });
    return button;
  });
  const element = h(
    'div',
    { class: `notice note ${isWarning ? '' : 'is-quiet'}`.trim(), role: isWarning ? 'alert' : 'status' },
    isWarning && icon('exclamation'),
    typeof text === 'string'
      ? h('p', {}, text)
      : h(
          'ul',
          { class: 'note-list', tabindex: 0 }, // a long one scrolls
          text.map((one) => h('li', {}, one)),
        ),
    h('div', { class: 'note-actions' }, buttons),
    cross,
  );
  cross.addEventListener('click', () => element.remove());
  messages.room.append(element);
  return () => element.remove();
}
