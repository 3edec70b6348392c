/**
 * Targets that need not be typed: straight down, at a point, turned or placed as something else is.
 *
 * @import { Page } from '../page.js'
 * @import { Section } from '../parts/poseMenu.js'
 * @import { TargetFields } from './targetFields.js'
 */
import { poseFromXyzwpr, xyzwprOf } from '../../model/aim/aim.js';
import { targetPose } from '../../model/frames/frames.js';
import { lookingAt, pointInWorld, tidy, toolDown, turnedAs } from '../../model/aim/targetHelpers.js';
import { toKernel } from '../../model/units.js';
import { textInput } from '../parts/captioned.js';
import { fill, h } from '../parts/dom.js';
import { readSeveral } from '../parts/severalField.js';
import { TARGET } from '../words/target.js';

const words = TARGET.helper;

/**
 * @param {Page} page
 * @param {TargetFields} fields
 */
export function createTargetHelp({ store, derived, announce }, fields) {
  const robot = () => store.state.doc.robot;
  const T_now = () => poseFromXyzwpr(robot(), fields.target(store.state));

  /**
   * What the pose does not say anew stays to the last digit.
   * @param {Float64Array} T
   * @param {'turn' | 'place'} what  of the target is another
   * @param {string} done
   */
  function aimAt(T, what, done) {
    const now = fields.target(store.state);
    const next = xyzwprOf(robot(), T).map(tidy);
    const target = what === 'turn' ? [...now.slice(0, 3), ...next.slice(3)] : [...next.slice(0, 3), ...now.slice(3)];
    store.dispatch({ type: 'show', change: { target, answer: null } });
    announce(done);
  }

  /** @param {readonly number[]} point  m @param {string} name @returns {string | null} why not */
  function look(point, name) {
    const T = lookingAt(T_now(), point);
    if (T) aimAt(T, 'turn', words.done.look(name));
    else announce(words.tooNear);
    return T ? null : words.tooNear;
  }

  /** @param {readonly number[]} point  in the frame and the unit of the fields */
  function inWorld(point) {
    const metres = point.map((value) => toKernel('length', value, robot().units));
    return pointInWorld(fields.from(store.state), metres);
  }

  /** Poses that have a name. */
  function named() {
    const { doc } = store.state;
    return [
      { title: words.toolNow, T: derived.tcp(doc) },
      { title: words.base, T: derived.chain(doc).base },
      ...doc.targets.map((target) => ({ title: target.id, T: targetPose(doc, target) })),
    ];
  }

  return {
    /** @param {() => void} askPoint @returns {Section[]} */
    sections(askPoint) {
      const { targets } = store.state.doc;
      return [
        {
          heading: words.orientation,
          items: [
            { title: words.down, run: () => aimAt(toolDown(T_now()), 'turn', words.done.down) },
            { title: words.atPoint, run: askPoint },
            ...named()
              .slice(-targets.length || Infinity)
              .map(({ title, T }) => ({
                title: words.at(title),
                run: () => void look([...T.subarray(12, 15)], title),
              })),
          ],
        },
        {
          heading: words.turnedAs,
          items: named().map(({ title, T }) => ({
            title,
            run: () => aimAt(turnedAs(T_now(), T), 'turn', words.done.turned(title)),
          })),
        },
        {
          heading: words.placedAs,
          items: named().map(({ title, T }) => ({
            title,
            run: () => aimAt(turnedAs(T, T_now()), 'place', words.done.placed(title)),
          })),
        },
      ];
    },

    /** The point to look at, typed. @param {HTMLElement} host @param {() => void} onClose */
    askPoint(host, onClose) {
      const input = textInput({
        'aria-label': words.point,
        placeholder: 'X  Y  Z',
        'aria-describedby': 'point-reason',
      });
      const reason = h('p', { class: 'reason sm', id: 'point-reason', role: 'status', hidden: true });
      const go = h('button', { type: 'button', class: 'btn btn-outline' }, words.look);
      const cancel = h('button', { type: 'button', class: 'btn' }, TARGET.paste.cancel);
      const caption = h('span', { class: 'caption', 'aria-hidden': 'true' }, words.point);
      const field = h('label', { class: 'aim-several' }, caption, h('span', { class: 'field' }, input));
      fill(host, field, reason, h('div', { class: 'actions' }, cancel, go));

      function run() {
        const read = readSeveral(input.value, [3], words.pointCount);
        const against = 'reason' in read ? read.reason : look(inWorld(read.numbers), words.thePoint);
        reason.textContent = against ?? '';
        reason.hidden = against === null;
        if (against === null) onClose();
        else input.setAttribute('aria-invalid', 'true');
      }
      go.addEventListener('click', run);
      cancel.addEventListener('click', onClose);
      input.addEventListener('keydown', (event) => {
        if (event.key === 'Enter') event.preventDefault(); // it does not aim yet
        if (event.key === 'Enter') run();
        if (event.key !== 'Escape') return;
        event.stopPropagation();
        onClose();
      });
      input.focus();
    },
  };
}
