/**
 * Robot files in and out. A file is chosen here, dropped on the page or pasted (dropAndPaste.js); what reads it, with its
 * parser, is fetched when the first one arrives.
 *
 * @import { Source } from './arrival.js'
 * @import { Page } from '../page.js'
 * @import { TakePicture } from './pictureChoice.js'
 */
import { writeRobotXml } from '../../io/robotXmlWriter.js';
import { download } from '../parts/download.js';
import { h } from '../parts/dom.js';
import { TEXT } from '../strings.js';

/** @param {Page} page */
export function createFiles(page) {
  const { store, opener, announce, clock, messages } = page;
  const input = h('input', {
    type: 'file',
    accept: '.xml,.urdf,.sdf,.csv,.tsv,application/xml,text/xml,text/csv',
    hidden: true,
    'aria-hidden': 'true',
    tabindex: -1,
    class: 'file-input',
  });
  document.body.append(input);
  input.addEventListener('change', () => {
    const files = [...(input.files ?? [])];
    input.value = '';
    if (files.length > 0) void take({ files, way: 'dropped' });
  });
  const choose = () => input.click();

  /** Of two that are under way the one that came last wins. @param {Source} source */
  async function take(source) {
    const isWanted = opener.begin();
    try {
      const { receive } = await import('./arrival.js');
      if (isWanted()) await receive(page, source, { isWanted, again: choose });
    } catch (error) {
      messages.fault(error);
    }
  }

  /** @type {TakePicture | null} */
  let takePicture = null;
  return {
    choose,
    take,
    /** @param {TakePicture} take */
    offerPicture: (take) => void (takePicture = take),
    async saveAs() {
      const { openSaveAs } = await import('./saveAs.js'); // messages.js says it when that fails
      openSaveAs(page, { robotFile: fileNameOf(store.state.doc.robot.name), takePicture });
    },
    save() {
      const { doc } = store.state;
      const name = `${fileNameOf(doc.robot.name)}.xml`;
      download(name, writeRobotXml(doc), 'application/xml', clock);
      announce(TEXT.files.saved(name));
    },
  };
}

/** @typedef {ReturnType<typeof createFiles>} Files */

/** A file's name from a robot's: letters, digits and hyphens. @param {string} name */
export const fileNameOf = (name) =>
  name
    .normalize('NFKD')
    .replace(/\p{M}/gu, '')
    .replace(/[^\p{L}\p{N}_-]+/gu, '-')
    .replace(/^-+|-+$/g, '')
    .slice(0, 60) || 'robot';
