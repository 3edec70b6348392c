/**
 * The pendant: a button each way for every joint, or for every axis of a frame. A press is a step, or the arm moves for as
 * long as the button or its key is held. Fetched when it is first asked for.
 *
 * @import { Page } from '../page.js'
 * @import { Progress, Way } from './jogMotion.js'
 */
import '../css/jogPendant.css';
import { hasJogButtons } from '../../model/jog/jogChoices.js';
import { together } from '../../model/views.js';
import { fill, h } from '../parts/dom.js';
import { createFrameMenus } from './jogFrameMenus.js';
import { createFrameChooser } from './jogFrames.js';
import { watchJogKeys } from './jogHold.js';
import { createJogMotion } from './jogMotion.js';
import { createJogRate } from './jogRate.js';
import { jointNumber, unitOf, withUnit } from '../parts/format.js';
import { jointNumbers } from './jointNumbers.js';
import { limitsInWords } from './jogRow.js';
import { PENDANT } from '../words/jogPendant.js';

const SIGNS = /** @type {const} */ ([-1, 1]);
const AXES = [0, 1, 2, 3, 4, 5];

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createJogPendant(page, host) {
  const { store, addView } = page;
  const { joints, tool } = { joints: /** @type {const} */ ('joints'), tool: /** @type {const} */ ('tool') };
  const mode = () => store.state.session.jog.mode;
  const frames = createFrameChooser(page);
  const rate = createJogRate(page);
  const keys = h('div', { class: 'jog-keys', role: 'group', 'aria-label': PENDANT.keys });
  const word = h('p', { class: 'jog-word sm', role: 'status' });
  fill(
    host,
    h(
      'div',
      { class: 'body jog-pendant' },
      frames,
      createFrameMenus(page),
      rate,
      keys,
      word,
      h('p', { class: 'soft sm jog-foot' }, PENDANT.keysNote),
    ),
  );

  let saidOf = store.state.doc.posture;
  const motion = createJogMotion(page, (progress) => {
    saidOf = store.state.doc.posture;
    say(inWords(progress));
  });
  // What was said of a posture is not true of the next, wherever that came from.
  addView(
    ({ doc }) => doc.posture,
    (posture) => {
      if (!motion.isHeld && posture !== saidOf) say(['', false]);
    },
  );

  /** @param {Progress} progress @returns {[text: string, isStop: boolean]} */
  function inWords({ stop, isSlow, isTilting }) {
    if (!stop) return [isSlow ? PENDANT.slow : isTilting ? PENDANT.tilting : '', false];
    if (stop.why !== 'limit' && stop.why !== 'outside') return [PENDANT.stop[stop.why], true];
    const { doc } = store.state;
    const numbers = jointNumbers(store.state);
    const robot = numbers.robot(doc);
    const index = stop.joint ?? 0;
    const tell = stop.why === 'limit' ? PENDANT.atLimit : PENDANT.outside;
    const limits = limitsInWords(robot.joints[index], robot.units) + numbers.condition(doc, index);
    return [tell(`J${index + 1}`, limits), true];
  }

  let said = '';
  /** @param {[text: string, isStop: boolean]} words */
  function say([text, isStop]) {
    if (text === said) return;
    said = word.textContent = text;
    word.classList.toggle('is-stop', isStop);
  }

  /** What each row moves, in the order of the keys 1 to 6. @type {Way[]} */
  let ways = [];
  /** @type {HTMLElement[]} where a joint's value stands */
  let values = [];

  /** @param {Way} way @param {number} row @param {1 | -1} sign */
  function key(way, row, sign) {
    const label = 'axis' in way ? PENDANT.axisLabel(way.axis, sign) : PENDANT.jointLabel(way.joint + 1, sign);
    return h(
      'button',
      {
        type: 'button',
        class: 'jog-key',
        'aria-label': label,
        title: PENDANT.key(row + 1, sign),
        'data-row': row,
        'data-sign': sign,
      },
      sign > 0 ? '+' : '−',
    );
  }

  function build() {
    const count = store.state.doc.robot.joints.length;
    const isTool = mode() === tool;
    ways = isTool ? AXES.map((axis) => ({ axis })) : Array.from({ length: count }, (_, joint) => ({ joint }));
    values = ways.map(() => h('output', { class: 'jog-value' }));
    keys.classList.toggle('is-tool', isTool);
    fill(
      keys,
      ways.map((way, row) => {
        const name =
          'joint' in way
            ? h('span', { class: 'name' }, `J${row + 1}`)
            : h(
                'b',
                { class: `axis-${'xyz'[way.axis % 3]}` },
                (way.axis < 3 ? PENDANT.axis : PENDANT.turn)[way.axis % 3],
              );
        const [minus, plus] = SIGNS.map((sign) => key(way, row, sign));
        return h('div', { class: 'jog-pair' }, name, minus, 'joint' in way && values[row], plus);
      }),
    );
  }

  watchJogKeys(keys, {
    isOpen: () => hasJogButtons(store.state.session.jog) && host.checkVisibility(),
    isMoving: () => motion.isHeld,
    press: (row, sign, isByStep) => ways[row] && motion.press(ways[row], sign, isByStep),
    stop: motion.stop,
  });

  let shape = '';
  addView(
    together(({ doc, session }) => [doc.robot, session.jog]),
    ([robot, jog]) => {
      const wanted = [jog.mode, robot.joints.length].join();
      if (wanted === shape) return;
      motion.stop();
      say(['', false]);
      shape = wanted;
      if (hasJogButtons(jog)) build();
    },
  );
  addView(
    together(({ doc, session }) => [doc.robot, doc.posture, session.jog.mode === joints, session.numbers.isPendant]),
    ([, , isJoints]) => {
      if (!isJoints) return;
      const numbers = jointNumbers(store.state);
      const robot = numbers.robot(store.state.doc);
      const shown = numbers.values(store.state.doc);
      values.forEach((value, i) => {
        const unit = unitOf(robot.joints[i], robot.units);
        value.textContent = withUnit(jointNumber(shown[i], unit), unit);
      });
    },
  );
}
