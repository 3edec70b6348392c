/**
 * What belongs to the handle on the tool beside the picture: the axes that it has, whether it snaps, and a calm line that
 * says what stands in the tool's way.
 *
 * @import { Page } from './page.js'
 * @import { RobotDoc } from '../model/document.js'
 * @import { HandleAxes } from '../model/handleAxes.js'
 * @import { Session } from '../model/session.js'
 */
import $ from 'jquery/slim';
import { handleStep } from '../model/handleAxes.js';
import { isHandleShown } from '../model/handleShown.js';
import { fromKernel } from '../model/units.js';
import { together } from '../model/views.js';
import { fill, h } from './dom.js';
import { fixed, plain, poseNumber, withUnit } from './format.js';
import { icon } from './icons.js';
import { TEXT } from './strings.js';

const words = TEXT.drag;

/** @type {readonly HandleAxes[]} */
const AXES = ['base', 'tool', 'world', 'user'];

const DECIMALS = { mm: 0, cm: 1, m: 3, deg: 0, rad: 2 };

/**
 * What is short of a wish needs no hundredths, unless there is nothing else of it.
 * @param {RobotDoc} robot
 * @param {'length' | 'angle'} quantity
 * @param {number} value  metres or radians
 */
function roughly({ units }, quantity, value) {
  const unit = units[quantity];
  const number = fromKernel(quantity, value, units);
  const rough = fixed(number, DECIMALS[unit]);
  return withUnit(Number(rough) === 0 ? poseNumber(number, unit) : rough, unit);
}

/**
 * @param {RobotDoc} robot
 * @param {NonNullable<NonNullable<Session['drag']>['hindrance']>} hindrance
 */
export function hindranceInWords(robot, { kind, joint, metres, radians }) {
  const name = `J${(joint ?? 0) + 1}`;
  const turn = roughly(robot, 'angle', radians);
  // where the place is met, what is missing is a turn
  const short = metres > 1e-5 ? roughly(robot, 'length', metres) : turn;
  if (kind === 'limit') return words.limit(name);
  if (kind === 'singularity') return words.singularity(name);
  if (kind === 'orientation') return words.orientation(turn);
  if (kind === 'part') return words.part(turn);
  return robot.joints.length < 6 ? words.fewReach(short) : words.reach(short);
}

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {{ isWide: () => boolean, poseInWords: () => string }} given
 */
export function createHandleBar({ store, addView, derived, announce }, host, { isWide, poseInWords }) {
  const line = h('p', { class: 'float drag-line', hidden: true });
  const axisButtons = AXES.map((axes) => h('button', { type: 'button', 'data-axes': axes }, words.axes[axes]));
  const snap = h('button', { type: 'button', class: 'btn snap', title: words.snapTitle });
  const bar = h(
    'div',
    { class: 'float', role: 'toolbar', 'aria-label': words.bar },
    h('div', { class: 'seg', role: 'group', 'aria-label': words.axesLabel }, axisButtons),
    snap,
  );
  host.append(h('div', { class: 'handle-bar' }, line, bar));

  /** @param {Partial<Session['handle']>} change */
  const change = (change) =>
    store.dispatch({ type: 'show', change: { handle: { ...store.state.session.handle, ...change } } });
  $(bar).on('click', '[data-axes]', ({ currentTarget }) => change({ axes: currentTarget.dataset.axes }));
  $(snap).on('click', () => change({ snaps: !store.state.session.handle.snaps }));

  addView(
    ({ session }) => isHandleShown(session, isWide()),
    (isShown) => (bar.hidden = !isShown),
  );
  addView(
    together(({ doc, session }) => [session.handle, doc.robot, doc.activeUser]),
    ([{ axes, snaps }, { units }, user]) => {
      for (const button of axisButtons) {
        button.setAttribute('aria-pressed', String(button.dataset.axes === axes));
        if (button.dataset.axes === 'user') button.hidden = user === undefined;
      }
      const step = (/** @type {'length' | 'angle'} */ quantity, /** @type {number} */ value) =>
        withUnit(plain(Number(fromKernel(quantity, value, units).toPrecision(3))), units[quantity]);
      const { metres, radians } = handleStep(derived.chain(store.state.doc));
      snap.textContent = words.snap(step('length', metres), step('angle', radians));
      snap.setAttribute('aria-pressed', String(snaps));
    },
  );

  let said = ''; // of what stands in the way: once, however the numbers change
  addView(
    together(({ doc, session }) => [doc.robot, session.drag, session.toolKeys, session.handle.across]),
    ([robot, drag, toolKeys, across]) => {
      const hindrance = drag?.hindrance;
      const text = hindrance ? hindranceInWords(robot, hindrance) : toolKeys ? words.takenShort[toolKeys](across) : '';
      line.hidden = text === '';
      line.classList.toggle('is-stopped', Boolean(hindrance));
      fill(line, hindrance && icon('slash'), h('span', {}, text));
      const now = hindrance ? `${hindrance.kind} ${hindrance.joint}` : '';
      if (now !== said && hindrance) announce(text);
      said = now;
    },
  );
  /** @type {Session['toolKeys']} */
  let taken = null;
  addView(
    together(({ session }) => [session.toolKeys, session.handle.axes, session.handle.across]),
    ([toolKeys, axes, across]) => {
      if (toolKeys) announce(words.taken[toolKeys](words.inAxes[axes], across));
      else if (taken) announce(words.givenBack);
      taken = toolKeys;
    },
  );
  /** @type {readonly number[] | null} */
  let heard = null;
  addView(
    together(({ doc, session, gesture }) => [session.toolKeys, gesture === null, doc.posture]),
    ([toolKeys, isAtRest, posture]) => {
      if (toolKeys && !isAtRest) return;
      const isNew = toolKeys !== null && heard !== null && heard !== posture;
      heard = toolKeys ? posture : null;
      if (isNew) announce(poseInWords());
    },
  );
}

/**
 * @param {Page} page
 * @param {() => boolean} isWide
 */
export function createHandleButton({ store, addView }, isWide) {
  const button = h(
    'button',
    { type: 'button', class: 'btn btn-icon handle-toggle', 'aria-label': words.handle, title: words.handle },
    icon('handle'),
  );
  const isShown = (/** @type {Session} */ { handle }) => handle.isShown ?? isWide();
  $(button).on('click', () => {
    const { session } = store.state;
    store.dispatch({ type: 'show', change: { handle: { ...session.handle, isShown: !isShown(session) } } });
  });
  addView(
    ({ session }) => isShown(session),
    (isOn) => button.setAttribute('aria-pressed', String(isOn)),
  );
  return button;
}
