/**
 * Robot files in and out: choose one, read it, open it as one undoable change or refuse it in words; save as XML.
 * The reader, with its parser, is loaded when the first file arrives.
 *
 * @import { Page } from './page.js'
 * @import { Doc } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 */
import { writeRobotXml } from '../io/robotXmlWriter.js';
import { download } from './download.js';
import { h } from './dom.js';
import { fixed } from './format.js';
import { TEXT } from './strings.js';

/** Far more than a robot file may have in any encoding: not even looked at. */
const LARGEST_BYTES = 16 * 1024 * 1024;
const MEGABYTE = 1024 * 1024;

/** @param {Page} page */
export function createFiles(page) {
  const { store, opener, announce, clock, messages } = page;
  const input = h('input', {
    type: 'file',
    accept: '.xml,.urdf,application/xml,text/xml',
    hidden: true,
    'aria-hidden': 'true',
    tabindex: -1,
    class: 'file-input',
  });
  document.body.append(input);
  input.addEventListener('change', async () => {
    const [file] = input.files ?? [];
    input.value = '';
    if (file) await read(file);
  });

  /** @param {File} file */
  async function read(file) {
    const isWanted = opener.begin();
    try {
      const { text, issues } = await readText(file);
      const answer = text === null ? { doc: null, issues } : await readDocument(text, issues);
      if (isWanted()) await arrive(file.name, answer, text);
    } catch (error) {
      messages.fault(error);
    }
  }

  /** @param {string} name @param {{ doc: Doc | null, issues: Issue[] }} answer @param {string | null} text */
  async function arrive(name, { doc, issues }, text) {
    if (doc) {
      opener.open(doc);
      announce(TEXT.files.opened(name));
    }
    if (issues.length > 0) {
      const { showReport } = await import('./fileReport.js');
      showReport({
        name,
        robotName: store.state.doc.robot.name || TEXT.unnamedRobot,
        announce,
        isOpened: doc !== null,
        issues,
        text,
        again: () => input.click(),
      });
    }
  }

  return {
    choose: () => input.click(),
    save() {
      const { doc } = store.state;
      const name = `${fileNameOf(doc.robot.name)}.xml`;
      download(name, writeRobotXml(doc), 'application/xml', clock);
      announce(TEXT.files.saved(name));
    },
  };
}

/** @typedef {ReturnType<typeof createFiles>} Files */

/** @param {string} text @param {Issue[]} earlier */
async function readDocument(text, earlier) {
  const { readRobotFile } = await import('../io/robotFile.js');
  const { doc, issues } = readRobotFile(text);
  return { doc, issues: [...earlier, ...issues] };
}

/**
 * @param {File} file
 * @returns {Promise<{ text: string | null, issues: Issue[] }>}
 */
async function readText(file) {
  /** @param {string} code @param {string} message @returns {{ text: null, issues: Issue[] }} */
  const refuse = (code, message) => ({ text: null, issues: [{ severity: 'error', code, path: '', message }] });
  if (file.size > LARGEST_BYTES) {
    return refuse('file-too-large', TEXT.files.tooLarge(TEXT.files.megabytes(fixed(file.size / MEGABYTE, 0))));
  }
  const { decodeText } = await import('../io/decodeText.js');
  try {
    return decodeText(new Uint8Array(await file.arrayBuffer()));
  } catch (error) {
    return refuse('unreadable', TEXT.files.unreadable(error instanceof Error ? error.message : String(error)));
  }
}

/** A file's name from a robot's: letters, digits and hyphens. @param {string} name */
const fileNameOf = (name) =>
  name
    .normalize('NFKD')
    .replace(/\p{M}/gu, '')
    .replace(/[^\p{L}\p{N}_-]+/gu, '-')
    .replace(/^-+|-+$/g, '')
    .slice(0, 60) || 'robot';
