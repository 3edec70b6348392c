/**
 * The button that opens the dialog in which a map is saved, which is fetched then.
 *
 * @import { Page } from '../page.js'
 */
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { WORKSPACE } from '../words/workspace.js';

/** @param {Page} page @param {'saveSection' | 'saveVolume'} name  what opens it */
export function createSaveButton(page, name) {
  const button = h('button', { type: 'button', class: 'btn btn-outline' }, icon('download'), WORKSPACE.save);
  button.addEventListener('click', async () => {
    try {
      const dialogs = await import('./saveMap.js');
      dialogs[name](page);
    } catch (error) {
      page.messages.fault(error);
    }
  });
  return button;
}
