/**
 * The line that says why texts of several fields were refused, as long as they stand, with the ways out as buttons.
 *
 * @import { Refused, Way } from './numberText.js'
 */
import { fill, h } from './dom.js';

/** @typedef {{ reason: string, ways: readonly Way[], settle?: (text: string) => void }} Fault */

/** @param {string} id */
export function createReasons(id) {
  const element = h('div', { class: 'reason sm', id, role: 'note', hidden: true });
  /** @type {Map<HTMLElement, Fault>} */
  const refused = new Map();

  function say() {
    for (const field of refused.keys()) if (!field.isConnected) refused.delete(field);
    fill(
      element,
      [...refused.values()].flatMap(({ reason, ways, settle }) => [
        h('p', {}, reason),
        ...ways.map(({ label, text }) => {
          const button = h('button', { type: 'button', class: 'btn btn-small btn-outline' }, label);
          button.addEventListener('click', () => settle?.(text));
          return button;
        }),
      ]),
    );
    element.hidden = refused.size === 0;
  }

  return {
    element,
    /**
     * @param {HTMLElement} field
     * @param {string | null} reason
     * @param {Refused | null} [answer]  with ways out, which `settle` takes
     * @param {(text: string) => void} [settle]
     */
    set(field, reason, answer, settle) {
      field.parentElement?.classList.toggle('is-invalid', reason !== null);
      if (reason === null) {
        refused.delete(field);
        field.removeAttribute('aria-describedby');
      } else {
        // Said again as the field is left, it stays as it is: a button of it may be what the hand is on.
        if (refused.get(field)?.reason === reason) return;
        refused.set(field, { reason, ways: answer?.ways ?? [], ...(settle && { settle }) });
        field.setAttribute('aria-describedby', id);
      }
      say();
    },
  };
}

/** @typedef {ReturnType<typeof createReasons>} Reasons */
