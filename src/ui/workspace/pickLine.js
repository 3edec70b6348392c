/**
 * Below the tools of the view while points are picked in it: what a press means, where it would put the point, and the way out,
 * which Escape is as well.
 *
 * @import { Page } from '../page.js'
 * @import { ReachHand } from '../../model/workspace/asked.js'
 */
import '../css/workspaceLine.css';
import { together } from '../../model/views.js';
import { pickGrounds } from '../../model/workspace/pickPlace.js';
import { placeFromKernel } from '../../model/workspace/pointAnswers.js';
import { h } from '../parts/dom.js';
import { segments } from '../parts/segments.js';
import { POINTS } from '../words/workspacePoints.js';
import { isFoldOpen } from './look.js';
import { placeText } from './probes.js';

const WORDS = POINTS.picking;

/** @param {Page} page @param {HTMLElement} view */
export function createPickLine(page, view) {
  const { store, addView, announce, clock } = page;
  const hand = () => store.state.session.reachHand;
  /** @param {Partial<ReachHand>} change */
  const show = (change) => store.dispatch({ type: 'show', change: { reachHand: { ...hand(), ...change } } });
  const words = h('span', { class: 'grow' });
  const grounds = segments(WORDS.ground, ['section', 'volume'], WORDS.name, (pick) => show({ pick }));
  const done = h('button', { type: 'button', class: 'btn' }, WORDS.done);
  const line = h(
    'div',
    { class: 'float workspace-line pick-line', role: 'group', 'aria-label': WORDS.label, hidden: true },
    ...[grounds.element, done, words], // the words last: they change while a pointer comes to the buttons
  );
  view.append(line);
  const leave = () => {
    show({ pick: null, over: null });
    announce(WORDS.left);
  };
  done.addEventListener('click', leave);
  document.addEventListener(
    'keydown',
    (event) => {
      if (event.key !== 'Escape' || event.defaultPrevented || !hand().pick) return;
      event.preventDefault();
      event.stopPropagation();
      leave();
    },
    { capture: true },
  );
  addView(
    together(({ doc, session }) => [doc.robot, session.reachHand]),
    ([robot, { pick, over }]) => {
      line.hidden = pick === null;
      if (!pick) return;
      words.textContent = over ? placeText(robot, placeFromKernel(robot, over)) : WORDS.press[pick];
      grounds.element.hidden = pick === 'tool' || pickGrounds(store.state.session).length < 2;
      if (pick !== 'tool') grounds.draw(pick);
    },
  );
  // it ends with the fold that asked for it; what it lands on may go
  addView(
    together(({ session }) => [
      session.reachHand.pick,
      session.tab === 'workspace' && isFoldOpen(session, 'points'),
      pickGrounds(session).join(),
    ]),
    ([pick, isOpen]) => {
      if (!pick) return;
      clock.onFrame(() => {
        const [first, ...others] = pickGrounds(store.state.session);
        if (!isOpen) show({ pick: null, over: null });
        else if (hand().pick && ![first, ...others].includes(pick)) show({ pick: first, over: null });
      });
    },
  );
}
