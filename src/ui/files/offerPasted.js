/**
 * A robot file that was pasted into a field: it fills none, and may have been meant to be opened. Fetched when it happens.
 *
 * @import { Files } from './files.js'
 * @import { Page } from '../page.js'
 */
import { showNote } from '../parts/note.js';
import { TEXT } from '../strings.js';
import { ARRIVAL } from '../words/arrival.js';

let takeAway = () => {};

/** @param {Page} page @param {Files} files @param {string} text */
export function offerPasted(page, files, text) {
  takeAway();
  const open = {
    name: ARRIVAL.openPasted,
    isUsual: true,
    run: () => void files.take({ files: [], text, way: 'pasted' }),
  };
  takeAway = showNote(page, { text: ARRIVAL.intoField, actions: [open], close: TEXT.close });
}
