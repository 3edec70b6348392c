/**
 * The ways to write an orientation as sections of a menu: each with what is multiplied, or who writes it so.
 *
 * @import { Section } from '../parts/poseMenu.js'
 * @import { OrientationForm } from '../../model/numbers/orientationNumbers.js'
 */
import { ORIENTATION_FORMS, usersOf } from '../../model/numbers/orientationForms.js';
import { NUMBERS } from '../words/numbers.js';

/**
 * @param {OrientationForm['group']} group
 * @param {string | null} chosen  the id of the one that holds
 * @param {(id: string) => void} choose
 * @returns {Section}
 */
export const formSection = (group, chosen, choose) => ({
  heading: NUMBERS.group[group],
  items: ORIENTATION_FORMS.filter((form) => form.group === group).map((form) => ({
    title: form.name,
    detail: detailOf(form),
    isChosen: form.id === chosen,
    run: () => choose(form.id),
  })),
});

/** @param {OrientationForm} form */
function detailOf(form) {
  if (!form.product) return /** @type {Record<string, string>} */ (NUMBERS.formDetail)[form.id];
  const users = form.group === 'moving' || form.group === 'fixed' ? usersOf(form) : [];
  return [form.product, ...users].join('; ');
}
