/**
 * "Build it": a row of the table carried out in the view, motion by motion. This file is the transport and the words; what
 * moves is drawn by the scene, which sees the same state.
 *
 * @import { Page } from '../page.js'
 * @import { BuildUp } from '../../model/session.js'
 */
import $ from 'jquery/slim';
import {
  MOTIONS,
  after,
  back,
  buildOf,
  forward,
  isMoving,
  motionAmount,
  motionNow,
  pause,
  play,
  stepped,
} from '../../model/robot/buildUp.js';
import { quantityOf } from '../../model/document.js';
import { together } from '../../model/views.js';
import { fill, h } from '../parts/dom.js';
import { jointNumber, editable, withUnit } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { LETTER, asText } from '../view/sceneText.js';
import { BUILD } from '../words/build.js';

const LONGEST_FRAME = 0.1; // seconds: a page that was hidden goes on where it was
const READING = 1.5; // seconds for a step, where nothing moves

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {{ isCalm: () => boolean, onClose: () => void }} given  `onClose`: the focus needs another place
 */
export function createBuildPlayer({ store, addView, clock, announce }, host, { isCalm, onClose }) {
  const rows = h('select', { class: 'form-select form-select-sm', 'aria-label': BUILD.row });
  const caption = h('p', { class: 'caption' });
  /** @param {string} name @param {Parameters<typeof icon>[0]} drawing @param {string} action */
  const button = (name, drawing, action) =>
    h(
      'button',
      { type: 'button', class: 'btn btn-icon', 'aria-label': name, title: name, 'data-action': action },
      icon(drawing),
    );
  const [stepBack, playPause, stepForward, close] = [
    button(BUILD.back, 'skipBack', 'back'),
    button(BUILD.play, 'play', 'play'),
    button(BUILD.forward, 'skipForward', 'forward'),
    button(BUILD.close, 'close', 'close'),
  ];
  const element = h(
    'section',
    { class: 'float build', 'aria-label': BUILD.title },
    rows,
    h('div', { class: 'transport' }, stepBack, playPause, stepForward),
    caption,
    close,
  );

  const now = () => store.state.session.build;
  /** @param {BuildUp | null} build */
  const show = (build) => store.dispatch({ type: 'show', change: { build } });

  /** @param {BuildUp} build @param {number} index */
  const motion = (build, index) => motionAmount(store.state.doc.robot, store.state.doc.posture, build.joint, index);

  /** What happens, in a sentence. @param {BuildUp} build */
  function sentence(build) {
    const index = motionNow(build);
    const names = [build.joint, build.joint + 1].map(String);
    if (index === null) return BUILD.start(names[0], names[1]);
    const { robot } = store.state.doc;
    const { field, turns, axis, number, isVariable, amount } = motion(build, index);
    const unit = robot.units[quantityOf(robot.joints[build.joint], field)];
    const along = asText([[axis, names[number]]]);
    const symbol = asText([
      [LETTER[field], names[1]],
      ...(isVariable ? [' + ', /** @type {const} */ (['q', names[1]])] : []),
    ]);
    const words = withUnit(isVariable ? jointNumber(amount, unit) : editable(amount), unit);
    const said =
      amount === 0
        ? (turns ? BUILD.noTurn : BUILD.noSlide)(along, symbol)
        : (turns ? BUILD.turn : BUILD.slide)(words, along, symbol);
    const end = build.at >= MOTIONS ? ` ${BUILD.end(names[1])}` : '';
    return BUILD.step(index + 1, said) + end;
  }

  let isRunning = false;
  /** Goes on as long as there is a way to go. */
  function run() {
    if (isRunning) return;
    isRunning = true;
    let last = clock.now();
    const goOn = () => {
      const build = now();
      if (!build || !isMoving(build)) {
        isRunning = false;
        return;
      }
      if (isCalm()) {
        show(stepped(build));
        clock.after(READING, goOn);
        return;
      }
      const seconds = Math.min(LONGEST_FRAME, clock.now() - last);
      last = clock.now();
      show(after(build, seconds, (index) => motion(build, index).amount));
      clock.onFrame(goOn);
    };
    if (isCalm()) goOn();
    else clock.onFrame(goOn);
  }

  $(element)
    .on('click', '[data-action]', ({ currentTarget }) => act(currentTarget.dataset.action))
    .on('keydown', (event) => {
      if (event.key === 'Escape') act('close');
      else if (event.target !== rows && event.key === 'ArrowLeft') act('back');
      else if (event.target !== rows && event.key === 'ArrowRight') act('forward');
      else return;
      event.preventDefault();
    });
  $(rows).on('change', () => show(buildOf(Number(rows.value))));

  /** @param {string} action */
  function act(action) {
    const build = now();
    if (!build) return;
    if (action === 'back') show(back(build));
    if (action === 'forward' && build.goal < MOTIONS) show(forward(build));
    if (action === 'play') show(isMoving(build) ? pause(build) : play(build));
    if (action === 'close') {
      show(null);
      announce(BUILD.closed);
      return;
    }
    run();
  }

  addView(
    ({ doc }) => doc.robot.joints.length,
    (count) =>
      fill(
        rows,
        Array.from({ length: count }, (_, i) => h('option', { value: i }, BUILD.rowOption(i + 1))),
      ),
  );
  let said = '';
  addView(
    together(({ doc, session }) => [session.build && sentence(session.build), session.build, doc]),
    ([words, build]) => {
      if (!build) {
        said = '';
        const hadFocus = element.contains(document.activeElement);
        element.remove();
        if (hadFocus) onClose();
        return;
      }
      if (!element.isConnected) {
        host.append(element);
        playPause.focus();
      }
      rows.value = String(build.joint);
      const isOn = isMoving(build);
      const name = isOn ? BUILD.pause : BUILD.play;
      if (playPause.getAttribute('aria-label') !== name) {
        playPause.setAttribute('aria-label', name);
        playPause.title = name;
        fill(playPause, icon(isOn ? 'pause' : 'play'));
      }
      // not `disabled`, which would lose the focus
      stepBack.setAttribute('aria-disabled', String(build.at === 0));
      stepForward.setAttribute('aria-disabled', String(build.goal >= MOTIONS));
      if (words === said) return;
      said = words ?? '';
      caption.textContent = said;
      announce(said);
    },
  );
}
