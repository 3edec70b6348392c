/**
 * Where the arm can go by name: home, zero, the middle of its limits, what a published model of it calls a posture, and
 * what was recorded. The names are fetched when somebody comes near the button.
 *
 * @import { Choice } from '../parts/choices.js'
 * @import { Page } from '../page.js'
 * @import { NamedPosture } from '../../model/namedPostures.js'
 */
import { refill, withChoices } from '../parts/choices.js';
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { TEXT } from '../strings.js';

/** @param {Page} page @returns {HTMLElement} */
export function createGoToMenu(page) {
  const { store, announce, messages } = page;
  const button = h(
    'button',
    { type: 'button', class: 'btn btn-icon go-to', 'aria-label': TEXT.robot.goTo, title: TEXT.robot.goTo },
    icon('caret', 'caret'),
  );
  /** @type {{ of: typeof import('../../model/namedPostures.js').namedPostures, words: typeof import('../words/goTo.js').GO_TO } | null} */
  let names = null;

  async function fetchNames() {
    if (names) return;
    const [{ namedPostures }, { GO_TO }] = await Promise.all([
      import('../../model/namedPostures.js'),
      import('../words/goTo.js'),
    ]);
    names = { of: namedPostures, words: GO_TO };
    refill(button);
  }
  const warm = () => void fetchNames().catch(() => {}); // who opens the menu is told
  button.addEventListener('pointerenter', warm, { once: true });
  button.addEventListener('focus', warm, { once: true });

  return withChoices(button, () => {
    if (!names) {
      fetchNames().catch(messages.fault);
      return { groups: [[{ title: TEXT.robot.fetchingNames, against: '' }]] };
    }
    const { of, words } = names;
    const { robot, posture, postures } = store.state.doc;

    /** @param {string} title @param {string} detail @param {readonly number[]} q @param {readonly number[]} [outside] @returns {Choice} */
    const choice = (title, detail, q, outside = []) => ({
      title,
      detail: outside.length === 0 ? detail : `${detail} ${words.outside(outside.map((i) => `J${i + 1}`))}`,
      isChosen: q.every((value, i) => value === posture[i]),
      run() {
        store.dispatch({ type: 'set-posture', posture: q });
        announce(words.went(title));
      },
    });
    /** @param {NamedPosture} named */
    const fromName = ({ name, source, note, q, outside }) => {
      const known = /** @type {keyof typeof words.name} */ (name);
      return source === null
        ? choice(words.name[known], words.detail[known], q, outside)
        : choice(name[0].toUpperCase() + name.slice(1), words.published(note ?? '', source), q, outside);
    };
    const named = of(robot);
    return {
      groups: [
        named.filter(({ source }) => source === null).map(fromName),
        named.filter(({ source }) => source !== null).map(fromName),
        postures.map(({ id, q }) => choice(id, words.recorded, q)),
      ].filter((group) => group.length > 0),
    };
  });
}
