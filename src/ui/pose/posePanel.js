/**
 * Where the tool is: X Y Z and W P R, in a frame and a convention that stand in the panel's own head. Whatever else can be
 * asked of it (another frame, another convention, the matrix, a copy) is fetched when it is first asked for, and from then
 * on draws in this panel's place (numbersPanel.js).
 *
 * @import { Page } from '../page.js'
 * @import { Units } from '../../model/document.js'
 */
import $ from 'jquery/slim';
import { eulerNumbers } from '../../model/numbers/eulerNumbers.js';
import { memo } from '../../model/memo.js';
import { together } from '../../model/views.js';
import { createAnnouncer } from '../announce.js';
import { createConfigurationFold } from './configurationFold.js';
import { fill } from '../parts/dom.js';
import { poseNumber, unitSign, withUnit } from '../parts/format.js';
import { createPoseGrid } from './poseGrid.js';
import { createPoseParts } from './poseParts.js';
import { TEXT } from '../strings.js';

export const POSE_NAMES = ['X', 'Y', 'Z', 'W', 'P', 'R'];

/** So long an arm has rested when a screen reader says where it is. */
const REST_SECONDS = 0.8;

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createPosePanel(page, host) {
  const { store, addView, derived } = page;
  const parts = createPoseParts();
  fill(host, parts.header, parts.bar, parts.body, parts.note);
  host.after(createConfigurationFold(page, !host.hidden)); // on a phone it comes after the sliders

  const unitsNow = () => store.state.doc.robot.units;
  const unitFor = (/** @type {number} */ k) => unitsNow()[k < 3 ? 'length' : 'angle'];
  const freeAngle = memo((/** @type {Float64Array} */ T) => eulerNumbers('xyz', T, unitsNow()).setToZero);

  const gridInUnits = memo((/** @type {Units} */ { length, angle }) => {
    const grid = createPoseGrid(POSE_NAMES.map((label, k) => ({ label, unit: unitSign(k < 3 ? length : angle) })));
    fill(parts.body, grid.element);
    return grid;
  });
  gridInUnits(unitsNow());
  const removeViews = [
    addView(
      together(({ doc }) => [doc.robot.units, derived.xyzwpr(doc)]),
      ([units, numbers]) => gridInUnits(units).draw(numbers.map((value, k) => poseNumber(value, unitFor(k)))),
    ),
    addView(
      ({ doc }) => freeAngle(derived.tcp(doc)),
      (free) => {
        parts.note.hidden = free === null;
        parts.note.textContent = free === null ? '' : TEXT.pose.locked('W', 'R', 'R');
      },
    ),
  ];

  /** @type {Promise<typeof import('./numbersPanel.js')> | null} */
  let fetched = null;
  /** What failed to come once may come the next time. */
  const fetchPanel = () =>
    (fetched ??= import('./numbersPanel.js').catch((error) => {
      fetched = null;
      throw error;
    }));
  // What is under the hand may be wanted next; if it does not come, that is said when it is asked for.
  $(host).on('pointerover focusin', () => void fetchPanel().catch(() => {}));
  $(host).on('click', '[data-ask]', async ({ currentTarget }) => {
    try {
      const { runNumbersPanel } = await fetchPanel();
      if (!removeViews.length) return; // a second click while the first was fetching
      $(host).off();
      for (const remove of removeViews.splice(0)) remove();
      runNumbersPanel(page, parts);
      currentTarget.click();
    } catch (error) {
      page.messages.fault(error);
    }
  });

  /** The pose in words. */
  const inWords = () =>
    TEXT.pose.spoken(
      derived
        .xyzwpr(store.state.doc)
        .map((value, k) => `${POSE_NAMES[k]} ${withUnit(poseNumber(value, unitFor(k)), unitFor(k))}`)
        .join(', '),
    );
  sayAtRest(page, inWords);
  return { inWords };
}

/**
 * A screen reader hears where the tool has come to, once the arm rests; in a region of its own, so that it does not talk
 * over what the command itself had to say.
 * @param {Page} page
 * @param {() => string} inWords
 */
function sayAtRest({ addView, derived, clock }, inWords) {
  const say = createAnnouncer();
  /** @type {readonly number[] | undefined} */
  let said;
  let cancel = () => {};
  addView(
    together(({ doc, gesture, session }) => [derived.xyzwpr(doc), gesture === null && session.heldJoint === null]),
    ([pose, isAtRest]) => {
      cancel();
      said ??= pose; // where it stands at first is no news
      if (!isAtRest || pose.every((value, k) => value === said?.[k])) return;
      cancel = clock.after(REST_SECONDS, () => {
        said = pose;
        say(inWords());
      });
    },
  );
}
