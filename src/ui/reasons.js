/**
 * The line that says why texts of several fields were refused, as long as they stand.
 */
import { h } from './dom.js';

/** @param {string} id */
export function createReasons(id) {
  const element = h('p', { class: 'reason sm', id, role: 'note', hidden: true });
  /** @type {Map<HTMLElement, string>} */
  const refused = new Map();
  const say = () => {
    for (const field of refused.keys()) if (!field.isConnected) refused.delete(field);
    element.textContent = [...refused.values()].join(' ');
    element.hidden = refused.size === 0;
  };
  return {
    element,
    /** @param {HTMLElement} field @param {string | null} reason */
    set(field, reason) {
      field.parentElement?.classList.toggle('is-invalid', reason !== null);
      if (reason === null) {
        refused.delete(field);
        field.removeAttribute('aria-describedby');
      } else {
        refused.set(field, reason);
        field.setAttribute('aria-describedby', id);
      }
      say();
    },
  };
}

/** @typedef {ReturnType<typeof createReasons>} Reasons */
