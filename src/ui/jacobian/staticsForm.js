/**
 * What the joints hold while the tool presses with a force and a moment.
 *
 * @import { Page } from '../page.js'
 * @import { JacobianView } from '../../model/numbers/jacobianView.js'
 */
import { isSliding } from '../../model/document.js';
import { jointLoads } from '../../model/numbers/statics.js';
import { fill, h } from '../parts/dom.js';
import { fixed, plain } from '../parts/format.js';
import { readNumber } from '../parts/numberText.js';
import { createReasons } from '../parts/reasons.js';
import { JACOBIAN } from '../words/jacobian.js';

const { statics: WORDS } = JACOBIAN;
const DECIMALS = 2;

/** @param {Page} page */
export function createStaticsForm({ store, derived }) {
  const view = () => store.state.session.jacobian;
  const reasons = createReasons('wrench-reason');
  const fields = WORDS.names.map((name, i) => {
    const input = h('input', { type: 'text', inputmode: 'text', autocomplete: 'off', spellcheck: 'false' });
    input.addEventListener('change', () => {
      const { value, reason } = readNumber(input.value);
      reasons.set(input, reason);
      input.setAttribute('aria-invalid', String(reason !== null));
      if (value === null) return;
      const wrench = view().wrench.with(i, value);
      store.dispatch({ type: 'show', change: { jacobian: { ...view(), wrench } } });
      input.value = plain(value);
    });
    return input;
  });
  const place = h('p', { class: 'sm soft' });
  const loads = h('dl', { class: 'loads', 'aria-label': WORDS.list });

  return {
    element: h(
      'section',
      { class: 'sec' },
      h('header', {}, h('h2', {}, WORDS.title)),
      h(
        'div',
        { class: 'body stack' },
        h('p', { class: 'sm soft' }, WORDS.about),
        h(
          'div',
          { class: 'wrench' },
          fields.map((input, i) =>
            h(
              'label',
              { class: 'field' },
              h('b', { class: `axis-${'xyz'[i % 3]}`, 'aria-hidden': 'true' }, WORDS.names[i]),
              input,
              h('span', { class: 'unit', 'aria-hidden': 'true' }, i < 3 ? WORDS.force : WORDS.torque),
            ),
          ),
        ),
        reasons.element,
        place,
        loads,
      ),
    ),
    /** @param {Float64Array} q @param {JacobianView} now */
    draw(q, { wrench, frame }) {
      const { doc } = store.state;
      const { robot } = doc;
      const axes = JACOBIAN.frame.seen[frame](doc.activeUser);
      fields.forEach((input, i) => {
        input.setAttribute('aria-label', WORDS.field(WORDS.names[i], axes));
        const isBusy = input === document.activeElement || input.getAttribute('aria-invalid') === 'true';
        if (!isBusy) input.value = plain(wrench[i]);
      });
      place.textContent = WORDS.along(axes);
      fill(
        loads,
        jointLoads(derived.chain(doc), q, wrench, frame, derived.user(doc)).map((value, i) =>
          h(
            'div',
            {},
            h('dt', {}, JACOBIAN.joint(i + 1)),
            h(
              'dd',
              {},
              fixed(value, DECIMALS),
              h('span', { class: 'unit' }, ` ${isSliding(robot.joints[i]) ? WORDS.force : WORDS.torque}`),
            ),
          ),
        ),
      );
    },
  };
}
