/**
 * Which tool and which user frame are active, chosen on the pendant as on a controller's.
 *
 * @import { Choice } from '../parts/choices.js'
 * @import { Page } from '../page.js'
 * @import { FrameKind } from '../../model/frames/frames.js'
 */
import { identityPose } from '../../model/document.js';
import { activeFrame, agree } from '../../model/frames/frames.js';
import { together } from '../../model/views.js';
import { withChoices } from '../parts/choices.js';
import { chooseFrame } from '../robot/chooseFrame.js';
import { fill, h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { openPanel } from '../page.js';
import { FRAMES } from '../words/frames.js';
import { PENDANT } from '../words/jogPendant.js';

/** @type {readonly FrameKind[]} */
const KINDS = ['tool', 'user'];

/** @param {Page} page @returns {HTMLElement} */
export function createFrameMenus(page) {
  const { store, addView, clock } = page;
  const reasonText = h('span', {});
  const instead = h('button', { type: 'button', class: 'btn btn-small btn-outline' }, FRAMES.keepFlange);
  const reason = h('p', { class: 'reason sm', role: 'status', hidden: true }, reasonText, ' ', instead);
  /** @type {number | null} the tool that could not be chosen */
  let refused = null;

  /** @param {FrameKind} kind @param {number | null} index @param {'flange'} [keeps] */
  function choose(kind, index, keeps) {
    const against = chooseFrame(page, kind, index, keeps);
    reasonText.textContent = against?.reason ?? '';
    reason.hidden = against === null;
    instead.hidden = !against?.isStuck;
    refused = index;
  }
  instead.addEventListener('click', () => choose('tool', refused, 'flange'));

  const hasOwnTool = () => {
    const { activeTool, robot } = store.state.doc;
    return activeTool === undefined && !agree(robot.tool, identityPose());
  };

  /** @param {FrameKind} kind @returns {Choice[]} */
  function listed(kind) {
    const { doc } = store.state;
    const active = activeFrame(doc, kind);
    const isOwn = kind === 'tool' && hasOwnTool();
    return [
      ...(isOwn ? [{ title: FRAMES.own, isChosen: true }] : []),
      {
        title: FRAMES.none[kind],
        detail: FRAMES.noneDetail[kind],
        isChosen: active === null && !isOwn,
        run: () => choose(kind, null),
      },
      ...doc.frames.flatMap((frame, index) =>
        frame.kind === kind
          ? [{ title: nameOf(frame), isChosen: frame === active, run: () => choose(kind, index) }]
          : [],
      ),
    ];
  }

  /** Where they are made and typed; a page may have been asked to leave that out. @returns {Choice[]} */
  function elsewhere() {
    const head = document.getElementById('fold-frames');
    if (!head || !document.querySelector('[data-opens=robot]')) return [];
    const run = () => {
      openPanel(page, 'robot');
      // when the panel is there, and the menu has given the focus back
      clock.onFrame(() => {
        if (head.getAttribute('aria-expanded') !== 'true') head.click();
        head.focus();
      });
    };
    return [{ title: PENDANT.editFrames, detail: PENDANT.editFramesDetail, run }];
  }

  const menus = KINDS.map((kind) => {
    const name = h('span', { class: 'b' });
    const button = h(
      'button',
      { type: 'button', class: 'btn quiet', title: PENDANT.chooseFrame[kind] },
      h('span', { class: 'soft' }, FRAMES.one[kind]),
      ' ',
      name,
      icon('caret', 'caret'),
    );
    const choices = () => ({
      head: kind === 'tool' ? PENDANT.keeps[store.state.session.toolKeeps] : undefined,
      groups: [listed(kind), elsewhere()].filter((group) => group.length > 0),
    });
    return { kind, name, element: withChoices(button, choices) };
  });

  const element = h(
    'div',
    { class: 'jog-frame-menus' },
    menus.map((menu) => menu.element),
    reason,
  );
  addView(
    together(({ doc, session }) => [doc.frames, doc.activeTool, doc.activeUser, doc.robot.tool, session.jog.mode]),
    ([, , , , mode]) => {
      element.hidden = mode !== 'tool';
      for (const { kind, name } of menus) {
        const active = activeFrame(store.state.doc, kind);
        const none = kind === 'tool' && hasOwnTool() ? FRAMES.own : PENDANT.noFrame[kind];
        fill(name, active ? nameOf(active) : none);
        name.title = name.textContent ?? ''; // a long one is clipped
      }
      reason.hidden = true;
    },
  );
  return element;
}

/** @param {{ number?: number, id: string }} frame */
const nameOf = ({ number, id }) => (number === undefined ? id : `${number} ${id}`);
