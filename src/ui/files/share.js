/**
 * The dialog with the link: what is in it, how long it is, and copying it. Fetched when it is first opened.
 *
 * @import { Files } from './files.js'
 * @import { Page } from '../page.js'
 */
import '../css/typedIn.css';
import '../css/share.css';
import { copyText } from '../parts/clipboard.js';
import { dialogFoot, dialogHead, openDialog } from '../parts/dialog.js';
import { fill, h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { shareAddress } from './shareAddress.js';
import { TEXT } from '../strings.js';
import { SHARE } from '../words/share.js';

/** The last choice, for the next time on this page. */
let choice = { view: true, panels: false };

/** @param {Page} page @param {Files} files */
export function openShare(page, files) {
  if (document.querySelector('.share')) return;
  const { robot } = page.store.state.doc;
  const text = h('textarea', {
    class: 'text-box',
    rows: 4,
    readonly: true,
    spellcheck: 'false',
    'aria-label': SHARE.link,
  });
  const length = h('p', { class: 'sm share-length', role: 'status' });
  const copy = h('button', { type: 'button', class: 'btn btn-primary' });
  const file = h('button', { type: 'button', class: 'btn' }, icon('download'), SHARE.saveFile);
  const [view, panels] = /** @type {const} */ (['view', 'panels']).map((name) => {
    const box = h('input', { type: 'checkbox', role: 'switch', checked: choice[name] });
    box.addEventListener('change', () => {
      choice = { ...choice, [name]: box.checked };
      write();
    });
    return h('label', { class: 'switch' }, box, SHARE.with[name]);
  });

  function write() {
    const link = shareAddress(page, choice);
    text.value = link ?? '';
    text.hidden = copy.disabled = link === null;
    const [words, isLong] = link === null ? [SHARE.tooLarge, true] : SHARE.length(link.length);
    fill(length, isLong ? icon('exclamation', 'warn') : null, h('span', {}, words));
    fill(copy, icon('copy'), SHARE.copy);
  }
  text.addEventListener('focus', () => text.select());
  file.addEventListener('click', () => files.save());
  copy.addEventListener('click', async () => {
    if (!(await copyText(text.value))) {
      text.focus();
      fill(length, icon('exclamation', 'warn'), h('span', {}, SHARE.copyFailed));
      return;
    }
    fill(copy, icon('check'), SHARE.copied);
    page.announce(SHARE.copied);
  });

  write();
  openDialog({
    name: 'share',
    title: 'share-title',
    content: [
      dialogHead('share-title', SHARE.title(robot.name || TEXT.unnamedRobot)),
      h('p', { class: 'soft' }, SHARE.what),
      h('div', { class: 'share-body' }, text, length, h('div', { class: 'share-with' }, view, panels)),
      dialogFoot(file, h('span', { class: 'grow' }), copy),
    ],
    onShown: () => copy.focus(),
  });
}
