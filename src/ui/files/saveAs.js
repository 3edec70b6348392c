/**
 * Saving in any format that can be written here: what it does not hold of this document is listed before anything is saved,
 * and its text can be copied instead. Postures as CSV and a picture of the scene leave by the same door. Fetched when opened.
 *
 * @import { TakePicture } from './pictureChoice.js'
 * @import { Page } from '../page.js'
 * @import { Issue } from '../../model/issues.js'
 *
 * @typedef {object} Ware    what can be saved, but pictures
 * @property {string} id
 * @property {string} file    its name
 * @property {string} mediaType
 * @property {() => string} write
 * @property {() => readonly Issue[]} losses
 */
import '../css/saveAs.css';
import { EXPORT_FORMATS } from '../../io/exportFormats.js';
import { POSTURE_CSV } from '../../io/postureCsv.js';
import { copyText } from '../parts/clipboard.js';
import { DISMISSES, dialogFoot, dialogHead, openDialog } from '../parts/dialog.js';
import { fill, h } from '../parts/dom.js';
import { download } from '../parts/download.js';
import { fixed } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { createPictureChoice } from './pictureChoice.js';
import { TEXT } from '../strings.js';
import { FORMATS, SAVE_AS } from '../words/saveAs.js';

const PICTURE = 'png';
const KILOBYTE = 1024;
const FEW_BYTES = 1000;

/** The words for a format, or its id where there are none yet. @param {string} id */
const wordsOf = (id) =>
  /** @type {Record<string, { name: string, detail: string }>} */ (FORMATS)[id] ?? { name: id, detail: '' };

/**
 * @param {Page} page
 * @param {{ robotFile: string, takePicture: TakePicture | null }} given  robotFile: the name of the robot as a file's
 */
export function openSaveAs(page, { robotFile, takePicture }) {
  const { store, announce, clock, messages } = page;
  /** @type {Ware[]} */
  const wares = [];
  for (const { id, extension, mediaType, write, losses } of [...EXPORT_FORMATS, POSTURE_CSV]) {
    const plain = `${robotFile}.${extension}`;
    wares.push({
      id,
      file: wares.some(({ file }) => file === plain) ? `${robotFile}.${id}.${extension}` : plain,
      mediaType,
      write: () => write(store.state.doc),
      losses: () => losses(store.state.doc),
    });
  }
  const picture = takePicture && createPictureChoice(takePicture, messages);
  const pictureFile = `${robotFile}.${PICTURE}`;
  /** @type {Ware | null} null: the picture */
  let chosen = wares[0];

  const about = h('div', { class: 'save-about', role: 'status' });
  const name = h('span', { class: 'b save-file' });
  const size = h('span', { class: 'soft' });
  const copy = h('button', { type: 'button', class: 'btn' }, icon('copy'), SAVE_AS.copy);
  const save = h('button', { type: 'button', class: 'btn btn-primary' }, icon('download'), SAVE_AS.save);

  function draw() {
    const file = chosen?.file ?? pictureFile;
    name.textContent = file;
    const label = chosen ? SAVE_AS.copyName(file) : SAVE_AS.copyPicture;
    copy.title = label;
    copy.setAttribute('aria-label', label);
    if (!chosen) {
      fill(about, picture?.element);
      size.textContent = '';
      save.disabled = copy.disabled = false;
      picture?.take((text) => (size.textContent = chosen ? size.textContent : text));
      return;
    }
    const losses = chosen.losses();
    const isRefused = losses.some(({ severity }) => severity === 'error');
    save.disabled = copy.disabled = isRefused;
    size.textContent = isRefused ? '' : sizeOf(chosen.write());
    fill(about, aboutLosses(losses, isRefused));
  }

  /** @returns {Promise<boolean>} */
  async function copied() {
    if (chosen) return copyText(chosen.write());
    const blob = await picture?.blob();
    if (!blob) return false;
    try {
      await navigator.clipboard.write([new ClipboardItem({ [blob.type]: blob })]);
      return true;
    } catch {
      return false;
    }
  }

  copy.addEventListener('click', async () => {
    const what = chosen ? chosen.file : SAVE_AS.picture;
    if (await copied()) {
      announce(SAVE_AS.copied(what));
      fill(copy, icon('check'), SAVE_AS.copy);
      clock.after(1.5, () => fill(copy, icon('copy'), SAVE_AS.copy));
    } else messages.warn(TEXT.pose.copyFailed);
  });
  save.addEventListener('click', async () => {
    try {
      const [file, type] = chosen ? [chosen.file, chosen.mediaType] : [pictureFile, 'image/png'];
      const content = chosen ? chosen.write() : await picture?.blob();
      if (content === undefined || content === null) return;
      download(file, content, type, clock);
      announce(TEXT.files.saved(file));
      dialog.hide();
    } catch (error) {
      messages.fault(error);
    }
  });

  const choices = [...wares.map(({ id }) => id), ...(picture ? [PICTURE] : [])].map((id, i) => {
    const { name: title, detail } = wordsOf(id);
    const radio = h('input', { type: 'radio', name: 'save-format', value: id, checked: i === 0 });
    radio.addEventListener('change', () => {
      chosen = wares.find((ware) => ware.id === id) ?? null;
      draw();
    });
    return h('label', {}, radio, h('span', {}, title, h('small', {}, detail)));
  });
  draw();
  const dialog = openDialog({
    name: 'save-as',
    title: 'save-title',
    fit: 'modal-dialog-centered modal-fullscreen-sm-down',
    content: [
      dialogHead('save-title', SAVE_AS.title),
      h(
        'div',
        { class: 'save-body' },
        h('div', { class: 'save-formats', role: 'radiogroup', 'aria-label': SAVE_AS.format }, choices),
        about,
      ),
      dialogFoot(
        h('span', { class: 'save-name grow' }, name, ' ', size),
        copy,
        h('button', { ...DISMISSES, class: 'btn btn-outline' }, SAVE_AS.cancel),
        save,
      ),
    ],
    onShown: () => dialogFirst(choices)?.focus(),
  });
  return dialog;
}

/** @param {readonly HTMLElement[]} choices */
const dialogFirst = ([first]) => first?.querySelector('input');

/** @param {string} text */
function sizeOf(text) {
  const bytes = new TextEncoder().encode(text).length;
  return bytes < FEW_BYTES ? SAVE_AS.bytes(fixed(bytes, 0)) : SAVE_AS.kilobytes(fixed(bytes / KILOBYTE, 1));
}

/** @param {readonly Issue[]} losses @param {boolean} isRefused */
function aboutLosses(losses, isRefused) {
  if (losses.length === 0) {
    return h('p', { class: 'save-all' }, icon('checkCircle', 'good'), SAVE_AS.keepsAll);
  }
  return [
    h('p', { class: 'soft' }, isRefused ? SAVE_AS.refused : SAVE_AS.lost),
    h(
      'ul',
      { class: 'issues' },
      losses.map(({ severity, message }) =>
        h(
          'li',
          {},
          icon(severity === 'error' ? 'octagon' : 'exclamation', severity === 'error' ? 'bad' : 'warn'),
          h('p', { class: 'issue-text' }, message),
        ),
      ),
    ),
  ];
}
