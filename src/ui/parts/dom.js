/**
 * Elements from data. Text becomes text nodes, never markup, so a robot called "<img onerror=…>" is only a strange name.
 *
 * @typedef {Node | string | null | undefined | false} Child
 */

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, string | number | boolean | null | undefined>} [attributes]  true: present without a value;
 *   false, null and undefined: absent
 * @param {...(Child | readonly Child[])} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === true) element.setAttribute(name, '');
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, String(value));
  }
  element.append(...present(children.flat()));
  return element;
}

/**
 * Show these children instead of what is there.
 * @param {Element} parent
 * @param {...(Child | readonly Child[])} children
 */
export const fill = (parent, ...children) => parent.replaceChildren(...present(children.flat()));

/** @param {readonly Child[]} children */
const present = (children) => children.flatMap((child) => (child ? [child] : []));

/**
 * A symbol of the field with its index: a₂, set as in a book.
 * @param {string} letter
 * @param {number | string} [index]
 */
export const symbol = (letter, index) =>
  h('span', { class: 'm' }, letter, index === undefined ? null : h('sub', {}, String(index)));

/** Words for those who listen, not for those who look. @param {string} text */
export const spoken = (text) => h('span', { class: 'visually-hidden' }, text);

/**
 * Redraw without losing the keyboard's place: the same control (by `data-action` and `data-index`) has the focus after, or
 * else the first that `fallback` finds.
 * @param {HTMLElement} host
 * @param {string} fallback  selector
 * @param {() => void} redraw
 */
export function keepFocus(host, fallback, redraw) {
  const { activeElement } = document;
  const had = activeElement instanceof HTMLElement && host.contains(activeElement) ? activeElement : null;
  redraw();
  if (!had) return;
  // what stands where it stood, but was taken out meanwhile, has lost it too
  if (had.isConnected) return document.activeElement === document.body ? had.focus({ preventScroll: true }) : undefined;
  const { action, index } = had.dataset;
  const again = [...host.querySelectorAll('[data-action]')].find(
    (element) => element instanceof HTMLElement && element.dataset.action === action && element.dataset.index === index,
  );
  const next = again ?? [...host.querySelectorAll(fallback)].find((element) => element.checkVisibility());
  if (next instanceof HTMLElement) next.focus();
}
