/**
 * Below the tools of the view while the workspace is in the picture and its panel is not open: that it is there, and the button
 * that hides it. The line of picking points takes its place.
 *
 * @import { Page } from '../page.js'
 */
import '../css/workspaceLine.css';
import { together } from '../../model/views.js';
import { h } from '../parts/dom.js';
import { WORKSPACE } from '../words/workspace.js';
import { look } from './look.js';
import { createPickLine } from './pickLine.js';

/** @param {Page} page @param {HTMLElement} view */
export function createSceneLine(page, view) {
  const words = h('span', {});
  const hide = h('button', { type: 'button', class: 'btn' }, WORKSPACE.hideFromScene);
  const line = h(
    'div',
    { class: 'float workspace-line', role: 'group', 'aria-label': WORKSPACE.sceneLine.label, hidden: true },
    words,
    hide,
  );
  view.append(line);
  hide.addEventListener('click', () => {
    look(page, { hasVolume: false, hasSection: false });
    page.announce(WORKSPACE.hidden);
  });
  page.addView(
    together(({ session: { maps, workspace, tab } }) => [
      Boolean(workspace?.hasVolume && maps.volume),
      Boolean(workspace?.hasSection && maps.section),
      tab === 'workspace',
    ]),
    ([hasVolume, hasSection, isOpen]) => {
      line.hidden = isOpen || !(hasVolume || hasSection);
      const { both, volume, section } = WORKSPACE.sceneLine;
      words.textContent = hasVolume && hasSection ? both : hasVolume ? volume : section;
    },
  );
  createPickLine(page, view);
}
