/**
 * How far the joints are from a singular posture: a bar, and in words what kind it is, how far off, and which joint goes there.
 * The posture itself is looked at as a ghost, and gone to by a click.
 *
 * @import { Page } from '../page.js'
 * @import { RobotDoc } from '../../model/document.js'
 * @import { NearestSingularity } from '../../model/numbers/singularityNumbers.js'
 */
import { nearestSingularity, singularityQuestion } from '../../model/numbers/singularityNumbers.js';
import { fill, h } from '../parts/dom.js';
import { fixed, jointNumber, unitOf, withUnit } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { createSingularityApart } from './singularityApart.js';
import { travelTo } from '../travel.js';
import { JACOBIAN } from '../words/jacobian.js';

const { gauge: WORDS } = JACOBIAN;

/** Nearer than this share of a right angle is called close: 9°. */
const CLOSE = 0.9;

/** @param {Page} page */
export function createSingularityGauge(page) {
  const { store, derived, announce, messages } = page;
  const bar = h('i', {});
  const meter = h(
    'span',
    {
      class: 'meter',
      role: 'meter',
      'aria-label': WORDS.label,
      'aria-valuemin': 0,
      'aria-valuemax': 90,
      'aria-valuenow': 0,
    },
    bar,
  );
  const mark = h('span', { class: 'warn' }, icon('exclamation'));
  const text = h('span', { class: 'b' }, WORDS.searching);
  const go = h('button', { type: 'button', class: 'btn btn-outline btn-small' }, WORDS.goThere);
  const way = h('p', { class: 'sm soft' });
  go.hidden = mark.hidden = true;

  const apart = createSingularityApart(messages.fault);
  /** @type {{ near: NearestSingularity, robot: RobotDoc } | null} */
  let shown = null;

  const kindsInWords = (/** @type {NearestSingularity} */ { kinds }) =>
    kinds.map((kind) => WORDS.kind[kind]).join(' and ');

  /** @param {boolean} isLooked */
  function look(isLooked) {
    const at = isLooked && shown?.robot === store.state.doc.robot ? shown.near : null;
    const ghost = at?.posture && !at.isHere ? { posture: at.posture, label: WORDS.ghost(kindsInWords(at)) } : null;
    store.dispatch({ type: 'show', change: { ghost } });
  }
  go.addEventListener('pointerenter', () => look(true));
  go.addEventListener('pointerleave', () => look(false));
  go.addEventListener('focus', () => go.matches(':focus-visible') && look(true));
  go.addEventListener('blur', () => look(false));
  go.addEventListener('click', () => {
    if (!shown?.near.posture || shown.robot !== store.state.doc.robot) return;
    const { near } = shown;
    look(false);
    travelTo(page, /** @type {number[]} */ (near.posture));
    announce(WORDS.went(kindsInWords(near)));
  });

  /** @param {RobotDoc} robot @param {NearestSingularity} near */
  function draw(robot, near) {
    shown = { near, robot };
    const { units } = robot;
    const kinds = kindsInWords(near);
    const distance = withUnit(fixed(near.distance, units.angle === 'deg' ? 1 : 3), units.angle);
    const isClose = near.isFound && near.nearness > CLOSE;
    const whole = !near.isFound
      ? WORDS.none
      : near.isHere
        ? WORDS.here(kinds)
        : (isClose ? WORDS.close : WORDS.away)(kinds, distance);
    text.textContent = whole[0].toUpperCase() + whole.slice(1);
    mark.hidden = !isClose;
    meter.classList.toggle('is-close', isClose);
    bar.style.width = `${100 * (1 - near.nearness)}%`;
    meter.setAttribute('aria-valuenow', fixed(90 * (1 - near.nearness), 1));
    meter.setAttribute('aria-valuetext', whole);
    const { joint } = near;
    const unit = joint === null ? null : unitOf(robot.joints[joint], units);
    way.textContent =
      joint === null || unit === null || near.isHere
        ? ''
        : WORDS.by(`J${joint + 1}`, withUnit(jointNumber(near.by, unit), unit));
    way.hidden = way.textContent === '';
    go.disabled = !near.isFound || near.isHere;
    go.hidden = !near.isFound;
  }

  const element = h('section', { class: 'sec' });
  fill(
    element,
    h('header', {}, h('h2', {}, WORDS.title), h('span', { class: 'grow' }), go),
    h(
      'div',
      { class: 'body' },
      h('p', { class: 'gauge-line' }, meter, mark, text),
      way,
      h('p', { class: 'sm soft' }, WORDS.foot),
    ),
  );
  return {
    element,
    /** The arm stands elsewhere, or is another one. */
    refresh() {
      const { doc } = store.state;
      apart.ask(singularityQuestion(doc, derived.chain(doc)), (found) => {
        if (store.state.doc.robot !== doc.robot) return; // its own question is on its way
        draw(doc.robot, nearestSingularity(doc.robot, doc.posture, found));
      });
    },
  };
}
