/**
 * In the place of a step's card while several steps are chosen: what can be done with all of them.
 *
 * @import { Doc } from '../../model/document.js'
 *
 * @typedef {'copy' | 'duplicate' | 'disable' | 'remove'} RangeAct
 */
import clipboard from 'bootstrap-icons/icons/clipboard.svg?raw';
import { fill, h } from '../parts/dom.js';
import { icon, iconOf } from '../parts/icons.js';
import { STEP_RANGE } from '../words/stepRange.js';

/** @param {(act: RangeAct) => void} act */
export function createRangeCard(act) {
  const element = h('section', { class: 'step-card', hidden: true });
  let shape = '';

  return {
    element,
    /** @param {Doc} doc @param {number} program @param {{ first: number, count: number } | null} range */
    draw(doc, program, range) {
      element.hidden = !range || range.count < 2;
      if (!range || element.hidden) return;
      const [from, to] = [range.first + 1, range.first + range.count];
      const isOff = doc.motionPrograms[program].steps.slice(from - 1, to).every(({ disabled }) => disabled);
      const wanted = [from, to, isOff].join();
      if (wanted === shape) return;
      shape = wanted;
      const had = element.contains(document.activeElement) ? document.activeElement : null;
      /** @param {RangeAct} name @param {keyof typeof STEP_RANGE.act} label @param {SVGElement} picture */
      const button = (name, label, picture) => {
        const words = STEP_RANGE.act[label];
        const control = h(
          'button',
          {
            type: 'button',
            class: 'btn btn-icon',
            'data-action': name,
            'aria-label': STEP_RANGE.actOn(words, from, to),
            title: words,
          },
          picture,
        );
        control.addEventListener('click', () => act(name));
        return control;
      };
      const title = STEP_RANGE.card(from, to);
      element.setAttribute('aria-label', title);
      fill(
        element,
        h(
          'div',
          { class: 'step-card-head' },
          h('h2', {}, title),
          h('span', { class: 'soft sm step-card-kind' }, STEP_RANGE.cardDetail(range.count)),
          h('span', { class: 'grow' }),
          button('copy', 'copy', iconOf(clipboard)),
          button('duplicate', 'duplicate', icon('copy')),
          button('disable', isOff ? 'enable' : 'disable', icon(isOff ? 'check' : 'slash')),
          button('remove', 'remove', icon('trash')),
        ),
      );
      const action = had instanceof HTMLElement ? had.dataset.action : undefined;
      const again = action && element.querySelector(`[data-action="${action}"]`);
      if (again instanceof HTMLElement) again.focus();
    },
  };
}
