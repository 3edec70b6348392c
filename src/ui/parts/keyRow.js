/**
 * A row of keys above the on-screen keyboard, while a field that takes expressions has the focus: the signs and units that
 * such a keyboard hides behind two taps. A key never takes the focus, so the keyboard stays. While the keyboard is up, the
 * page is as high as what is left of the screen.
 *
 * @import { Page } from '../page.js'
 * @import { KeyName } from './keyText.js'
 */
import '../css/keyRow.css';
import { fill, h } from './dom.js';
import { icon } from './icons.js';
import { keyText } from './keyText.js';
import { KEY_ROW } from '../words/keyRow.js';

/** @type {Record<string, readonly KeyName[]>} */
const KEYS = {
  length: ['minus', 'pi', 'root', 'brackets', 'divide', 'mm', 'inch'],
  angle: ['minus', 'pi', 'root', 'brackets', 'divide', 'deg', 'rad'],
};

/** So long the row outlives the focus: what a finger is coming down on must not move away under it. */
const LINGERS_SECONDS = 0.2;

/** What covers less of the screen is a bar of the browser, not a keyboard. */
const LEAST_KEYBOARD = 120; // px

/** @param {Page} page @param {HTMLElement} app */
export function createKeyRow({ clock }, app) {
  const row = h('div', { class: 'key-row', role: 'toolbar', 'aria-label': KEY_ROW.label, hidden: true });
  app.append(row);
  /** @type {HTMLInputElement | null} */
  let field = null;
  let cancel = () => {};

  /** @param {KeyName} name */
  function keyButton(name) {
    const [sign, called] = KEY_ROW[name];
    const button = h('button', { type: 'button', tabindex: -1, 'aria-label': called }, sign);
    button.addEventListener('click', () => press(name));
    return button;
  }

  /** @param {KeyName} name */
  function press(name) {
    if (!field) return;
    const { value, selectionStart, selectionEnd } = field;
    const { text, start, end } = keyText(name, value, selectionStart ?? value.length, selectionEnd ?? value.length);
    field.focus();
    field.setRangeText(text, start, end, 'end');
    field.dispatchEvent(new InputEvent('input', { bubbles: true }));
  }

  /** @param {EventTarget | null} target */
  function show(target) {
    if (!(target instanceof HTMLInputElement) || !target.dataset.takes) return;
    cancel();
    field = target;
    const done = h(
      'button',
      { type: 'button', tabindex: -1, class: 'done', 'aria-label': KEY_ROW.done },
      icon('check'),
    );
    done.addEventListener('click', () => field?.blur());
    fill(row, KEYS[target.dataset.takes].map(keyButton), done);
    row.hidden = false;
    app.dataset.keys = '';
    makeRoom();
    target.scrollIntoView({ block: 'nearest' });
  }

  function hide() {
    const panel = field?.closest('[data-room]');
    field = null;
    row.hidden = true;
    delete app.dataset.keys;
    makeRoom();
    // A refusal or a question of what was typed was in sight above the keys, and stays so.
    panel?.querySelector('.cellbar:is(.ask, .bad-n)')?.scrollIntoView({ block: 'nearest' });
  }

  /** The page ends where the keyboard begins. */
  function makeRoom() {
    const seen = window.visualViewport;
    const covered = field && seen ? window.innerHeight - seen.height * seen.scale : 0;
    const isUp = covered >= LEAST_KEYBOARD;
    app.toggleAttribute('data-keyboard', isUp);
    app.style.setProperty('--covered', isUp ? `${covered}px` : '0px');
    app.style.setProperty('--scrolled', isUp && seen ? `${seen.offsetTop}px` : '0px');
    if (isUp) field?.scrollIntoView({ block: 'nearest' });
  }

  row.addEventListener('pointerdown', (event) => event.preventDefault());
  row.addEventListener('mousedown', (event) => event.preventDefault());
  document.addEventListener('focusin', ({ target }) => show(target));
  document.addEventListener('focusout', () => {
    cancel();
    cancel = clock.after(LINGERS_SECONDS, hide);
  });
  window.visualViewport?.addEventListener('resize', makeRoom);
  window.visualViewport?.addEventListener('scroll', makeRoom);
  show(document.activeElement);
}
