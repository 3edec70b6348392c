/**
 * How near the arm is to something where it stands, as it moves; said aloud when it begins to touch, and when it is clear again.
 *
 * @import { Page } from '../page.js'
 * @import { Units } from '../../model/document.js'
 * @import { Clearance, Workcells } from '../../model/workcell/workcell.js'
 */
import { together } from '../../model/views.js';
import { fill, h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { OBSTACLES } from '../words/obstacles.js';
import { bodiesText, closenessText } from './closenessText.js';

/** More touches than these are only counted. */
const MOST = 4;

/** @param {Page} page @param {Workcells} cells */
export function createClearanceLine({ store, addView, announce }, cells) {
  const element = h('div', { class: 'clearances' });
  let touched = '';

  /** @param {string} name @param {Clearance | null} near @param {Units} units */
  function line(name, near, units) {
    if (!near) return null;
    const isTouching = near.distance <= 0;
    return h(
      'p',
      { class: isTouching ? 'clearance-line is-touching' : 'clearance-line' },
      icon(isTouching ? 'octagon' : 'checkCircle'),
      h('span', { class: 'soft' }, name),
      h('span', {}, closenessText(near, units)),
    );
  }

  addView(
    together(({ doc, session, gesture }) => [
      doc.obstacles,
      doc.robot,
      doc.posture,
      session.workcell.isOpen,
      gesture === null,
    ]),
    ([, { units }, , isOpen, isAtRest]) => {
      if (!isOpen) return;
      const { around, itself, touching } = cells.closeness(store.state.doc);
      const unlike = [...new Set(touching.map((near) => OBSTACLES.touch(...bodiesText(near))))];
      fill(
        element,
        line(OBSTACLES.toObstacles, around, units),
        line(OBSTACLES.toItself, itself, units),
        !around && !itself && h('p', { class: 'soft sm' }, OBSTACLES.nothingNear),
        unlike.length > 1 &&
          h('p', { class: 'sm' }, OBSTACLES.inAll(unlike.slice(0, MOST).join(', '), unlike.length - MOST)),
      );
      if (!isAtRest) return; // a hand on the arm is not talked to at every step
      const now = unlike.join(', ');
      if (now !== touched) announce(now === '' ? OBSTACLES.nowClear : OBSTACLES.nowTouches(now));
      touched = now;
    },
  );
  return element;
}
