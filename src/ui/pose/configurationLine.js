/**
 * What controllers call the posture, as it changes. A screen reader hears it when the arm has come to rest with another one.
 *
 * @import { Page } from '../page.js'
 */
import { memo } from '../../model/memo.js';
import { configurationAt } from '../../model/aim/solutions.js';
import { together } from '../../model/views.js';
import '../css/controller.css';
import { createAnnouncer } from '../announce.js';
import { h } from '../parts/dom.js';
import { CONTROLLER } from '../words/controller.js';
import { SOLUTIONS } from '../words/solutions.js';

/** Later than the pose itself is said, so that one is heard after the other. */
const REST_SECONDS = 1.2;

/** @param {Page} page @param {HTMLElement} host  folded away, nothing is said */
export function createConfigurationLine({ store, addView, derived, clock }, host) {
  const fanucText = h('dd', {});
  const kukaText = h('dd', {});
  const list = h(
    'dl',
    { class: 'configuration', 'aria-label': CONTROLLER.configuration },
    h('div', {}, h('dt', {}, CONTROLLER.fanuc), fanucText),
    h('div', {}, h('dt', {}, CONTROLLER.kuka), kukaText),
  );
  host.append(list);
  const configuration = memo(configurationAt);
  const say = createAnnouncer();
  let said = '';
  let cancel = () => {};
  addView(
    together(({ doc, gesture, session }) => [doc.robot, doc.posture, gesture === null && session.heldJoint === null]),
    ([robot, posture, isAtRest]) => {
      cancel();
      const { fanuc, kuka } = configuration(robot, derived.chain(store.state.doc), posture);
      const fanucWords = fanuc.text ?? SOLUTIONS.noCode[fanuc.reason];
      const kukaWords =
        kuka.status === null ? SOLUTIONS.noCode[kuka.reason] : CONTROLLER.kukaCode(kuka.status, kuka.turn);
      fanucText.textContent = fanucWords;
      kukaText.textContent = kukaWords;
      kukaText.title = kuka.status === null ? '' : CONTROLLER.kukaBits(kuka.status, kuka.turn);
      const words = CONTROLLER.spoken(fanucWords, kukaWords);
      if (!isAtRest || words === said) return;
      cancel = clock.after(REST_SECONDS, () => {
        if (host.hidden) return;
        said = words;
        say(words);
      });
    },
  );
}
