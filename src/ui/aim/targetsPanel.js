/**
 * The named targets of the document: kept, renamed, aimed at, put elsewhere in the list or in the world, and removed. Fetched
 * when it is first opened.
 *
 * @import { Page } from '../page.js'
 */
import $ from 'jquery/slim';
import { poseFromXyzwpr, xyzwprOf } from '../../model/aim/aim.js';
import { seenFromUser, targetPose } from '../../model/frames/frames.js';
import { poseInUnits } from '../../model/numbers/poseNumbers.js';
import { configurationAt } from '../../model/aim/solutions.js';
import { together } from '../../model/views.js';
import '../css/typedIn.css';
import '../css/targets.css';
import { fill, h, keepFocus } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { attempt } from '../page.js';
import { TARGETS } from '../words/targets.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createTargetsPanel(page, host) {
  const { store, addView, derived, announce } = page;
  const keep = h('button', { type: 'button', class: 'btn btn-outline' }, icon('plus'), TARGETS.keep);
  const list = h('ul', { class: 'targets', 'aria-label': TARGETS.list });
  const inFrame = h('p', { class: 'soft sm', hidden: true });
  const none = h('p', { class: 'soft sm' }, TARGETS.none);
  const reason = h('p', { class: 'reason sm', id: 'target-reason', role: 'status', hidden: true });
  fill(host, none, list, reason, inFrame, keep);

  /** @param {string | null} text */
  function say(text) {
    reason.textContent = text ?? '';
    reason.hidden = text === null;
  }

  /**
   * What the target fields say now, as the document keeps it; with the configuration, where the arm stands there. As on a
   * pendant it is kept in the user frame that is active, and then moves with it.
   * @param {string | undefined} frame  the user frame that it is given in
   */
  function present(frame) {
    const { doc, session } = store.state;
    const [x, y, z, ...rpy] = session.target ?? derived.xyzwpr(doc);
    const isInWorld = frame === undefined;
    const T = () => (session.target ? poseFromXyzwpr(doc.robot, session.target) : derived.tcp(doc));
    const pose = isInWorld ? { xyz: [x, y, z], rpy } : poseInUnits(seenFromUser(doc, frame, T()), doc.robot.units);
    const given = { pose, ...(!isInWorld && { frame }) };
    if (session.target) return given;
    const { text } = configurationAt(doc.robot, derived.chain(doc), doc.posture).fanuc;
    return { ...given, ...(text !== null && { configuration: text }) };
  }

  keep.addEventListener('click', () => {
    const against = attempt(page, { type: 'add-target', ...present(store.state.doc.activeUser) });
    say(against);
    announce(against ?? TARGETS.kept(store.state.doc.targets.at(-1)?.id ?? ''));
  });

  $(list)
    .on('click', '[data-action]', ({ currentTarget }) => {
      const { action, index: text } = currentTarget.dataset;
      const index = Number(text);
      const { robot, targets } = store.state.doc;
      const { id } = targets[index];
      if (action === 'aim') {
        const target = xyzwprOf(robot, targetPose(store.state.doc, targets[index]));
        store.dispatch({ type: 'show', change: { target, answer: null } });
        announce(TARGETS.aimed(id));
      } else if (action === 'set') {
        say(attempt(page, { type: 'edit-target', index, ...present(targets[index].frame) }));
        announce(TARGETS.setDone(id));
      } else if (action === 'up') {
        say(attempt(page, { type: 'move-target', index, to: index - 1 }));
      } else if (action === 'remove') {
        const against = attempt(page, { type: 'remove-target', index });
        say(against);
        announce(against ?? TARGETS.removed(id));
      }
    })
    .on('change', 'input', ({ currentTarget: field }) => {
      const against = attempt(page, {
        type: 'rename-target',
        index: Number(field.dataset.index),
        id: field.value.trim(),
      });
      say(against);
      if (against) field.setAttribute('aria-invalid', 'true');
      else field.removeAttribute('aria-invalid');
      if (against) announce(against);
    });

  addView(
    together(({ doc }) => [doc.targets, doc.activeUser]),
    ([targets, user]) => {
      none.hidden = targets.length > 0;
      inFrame.hidden = user === undefined;
      inFrame.textContent = user === undefined ? '' : TARGETS.inFrame(user);
      keepFocus(list, 'button', () =>
        fill(
          list,
          targets.map(({ id, frame }, i) => row(id, i, frame)),
        ),
      );
    },
  );
}

/** @param {string} id @param {number} index @param {string} [frame]  that it is given in */
function row(id, index, frame) {
  /** @param {string} action @param {string} label @param {...(Node | string)} content */
  const button = (action, label, ...content) =>
    h(
      'button',
      {
        type: 'button',
        class: 'btn btn-small',
        'data-action': action,
        'data-index': index,
        'aria-label': label,
        title: label,
      },
      content,
    );
  return h(
    'li',
    {},
    h('input', {
      ...{
        type: 'text',
        class: 'name-box',
        value: id,
        autocomplete: 'off',
        spellcheck: 'false',
        'aria-label': TARGETS.name(id),
      },
      ...{ 'data-index': index, 'aria-describedby': 'target-reason' },
    }),
    frame !== undefined && h('span', { class: 'soft sm', title: TARGETS.givenIn(frame) }, frame),
    button('aim', TARGETS.aim(id), TARGETS.aimShort),
    button('set', TARGETS.set(id), TARGETS.setShort),
    index > 0 && button('up', TARGETS.up(id), TARGETS.upShort),
    button('remove', TARGETS.remove(id), icon('trash')),
  );
}
