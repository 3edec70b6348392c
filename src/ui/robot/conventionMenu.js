/**
 * Which convention the table follows; what can be done about it is fetched when somebody comes near.
 *
 * @import { Page } from '../page.js'
 */
import { refill, withChoices } from '../parts/choices.js';
import { fill, h, spoken } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { TEXT } from '../strings.js';

/**
 * @param {Page} page
 * @param {(text: string) => void} say
 */
export function createConventionMenu(page, say) {
  const button = h('button', { type: 'button', class: 'btn btn-outline' });
  /** @type {typeof import('./conventionChoices.js').conventionChoices | null} */
  let choices = null;

  async function fetchChoices() {
    if (choices) return;
    choices = (await import('./conventionChoices.js')).conventionChoices;
    refill(button);
  }
  const warm = () => void fetchChoices().catch(() => {}); // who opens the menu is told
  button.addEventListener('pointerenter', warm, { once: true });
  button.addEventListener('focus', warm, { once: true });

  page.addView(
    ({ doc }) => doc.robot.convention,
    (convention) =>
      fill(
        button,
        spoken(TEXT.structure.convention),
        ' ',
        TEXT.table.conventionName[convention],
        icon('caret', 'caret'),
      ),
  );
  return withChoices(
    button,
    () => {
      if (choices) return { groups: choices(page, say) };
      fetchChoices().catch(page.messages.fault);
      return { groups: [[{ title: TEXT.fetching, against: '' }]] };
    },
    { className: 'is-wide' },
  );
}
