/**
 * Files dropped anywhere on the page, and files or robot files' text pasted where no field has the focus; in a field a robot
 * file's text is offered to be opened. What a person drags about inside the page, and other text on its way into a field, is
 * left alone.
 *
 * @import { Files } from './files.js'
 * @import { Page } from '../page.js'
 */
import { looksLikeRobotFile } from './robotFileText.js';
import { TEXT_FIELDS } from '../shortcuts.js';

/** While something is held over the page, the browser says so at least this often; not every end of it is told. */
const TOLD_SECONDS = 1;

/** A dialog that has nothing to do with files: what is being done there comes first. */
const isBarred = () => document.querySelector('.modal:not(.takes-files)') !== null;

/** @param {EventTarget | null} target */
const isField = (target) => target instanceof Element && target.closest(TEXT_FIELDS) !== null;

/** @param {Page} page @param {Files} files */
export function watchDropAndPaste(page, files) {
  const { clock, messages } = page;
  let isOwn = false; // a drag that began in the page
  window.addEventListener('dragstart', () => (isOwn = true), true);
  // Its end is not always told; but while anything is dragged there are no pointer's events.
  for (const type of ['dragend', 'pointerdown', 'pointermove']) {
    window.addEventListener(type, () => (isOwn = false), { capture: true, passive: true });
  }

  /** @param {DragEvent} event @returns {'files' | 'text' | null} null: nothing to do with us */
  function kindOf({ dataTransfer, target }) {
    if (isOwn || !dataTransfer) return null;
    if (dataTransfer.types.includes('Files')) return 'files';
    const isText = dataTransfer.types.some((type) => type === 'text/plain' || type === 'text/uri-list');
    return isText && !isField(target) && !isBarred() ? 'text' : null;
  }

  /** @type {Promise<typeof import('./dropTarget.js')> | null} */
  let fetched = null;
  let isOver = false;
  let cancel = () => {};
  /** @param {boolean} over @param {DataTransfer} [dataTransfer] */
  function showTarget(over, dataTransfer) {
    cancel();
    if (over) cancel = clock.after(TOLD_SECONDS, () => showTarget(false));
    if (over === isOver) return;
    isOver = over;
    if (!over && !fetched) return;
    const state = isBarred() ? 'barred' : dataTransfer && dataTransfer.items.length > 1 ? 'several' : 'here';
    fetched ??= import('./dropTarget.js');
    fetched.then(
      (target) => (isOver ? target.showDropTarget(state) : target.hideDropTarget()),
      () => (fetched = null), // dropping works without it, and says so if that cannot be fetched either
    );
  }

  for (const type of /** @type {const} */ (['dragenter', 'dragover'])) {
    window.addEventListener(type, (event) => {
      const kind = kindOf(event);
      if (!kind || !event.dataTransfer) return;
      event.preventDefault(); // or the browser would leave the page for the file
      event.dataTransfer.dropEffect = kind === 'files' && isBarred() ? 'none' : 'copy';
      showTarget(kind === 'files', event.dataTransfer);
    });
  }
  window.addEventListener('dragleave', ({ relatedTarget }) => {
    if (relatedTarget === null) showTarget(false);
  });
  window.addEventListener('drop', (event) => {
    const kind = kindOf(event);
    showTarget(false);
    if (!kind || !event.dataTransfer) return;
    event.preventDefault();
    const { dataTransfer } = event;
    if (kind === 'text') void files.take({ files: [], text: dataTransfer.getData('text/plain'), way: 'dropped' });
    else if (!isBarred()) {
      const isFolder = [...dataTransfer.items].some((item) => item.webkitGetAsEntry?.()?.isDirectory);
      void files.take({ files: [...dataTransfer.files], isFolder, way: 'dropped' });
    }
  });

  document.addEventListener('paste', (event) => {
    const { clipboardData: data, target } = event;
    if (!data || event.defaultPrevented || isBarred()) return;
    const text = data.getData('text/plain');
    if (isField(target) || isField(document.activeElement)) {
      if (!looksLikeRobotFile(text)) return;
      import('./offerPasted.js').then(({ offerPasted }) => offerPasted(page, files, text), messages.fault);
    } else if (data.files.length > 0) void files.take({ files: [...data.files], way: 'pasted' });
    else if (/^\s*(?:<|\/PROG\s|PROGRAM\s|&ACCESS\s|DEF\s)|#model=/i.test(text))
      void files.take({ files: [], text, way: 'pasted' });
    else return;
    event.preventDefault();
  });
}
