/**
 * What came in, by whichever way (chosen, dropped, pasted): read by one pipeline, then opened as one undoable change or
 * refused in words. Fetched, with the parser, when the first file arrives.
 *
 * @import { Page } from '../page.js'
 * @import { FileChain } from '../../io/robotFile.js'
 * @import { ChainChoices } from '../../io/urdf/armDocument.js'
 * @import { Doc } from '../../model/document.js'
 * @import { Issue } from '../../model/issues.js'
 *
 * @typedef {object} Source   what came in
 * @property {readonly File[]} files
 * @property {boolean} [isFolder]    the one file is a folder
 * @property {string} [text]         text instead of files
 * @property {'dropped' | 'pasted'} way   that the text came
 *
 * @typedef {{ name: string, text: string | null, issues: readonly Issue[] }} Arrived  text: null when it was refused already
 */
import { decodeText } from '../../io/decodeText.js';
import { fileIssue } from '../../io/fileIssues.js';
import { readRobotFile } from '../../io/robotFile.js';
import { openPanel } from '../page.js';
import { showReport } from './fileReport.js';
import { h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { TEXT } from '../strings.js';
import { ARRIVAL } from '../words/arrival.js';

/** Far more than a robot file may have in any encoding: not even looked at. */
const LARGEST_BYTES = 16 * 1024 * 1024;
const MEGABYTE = 1024 * 1024;
/** The address of a model (io/shareLink.js), as text. */
const SHARE_LINK = /^\s*[a-z]+:[^\s#]*(#model=\S*)\s*$/i;

/** The names of files that are no robots but tables. */
const TABLE_NAME = /\.(csv|tsv|txt)$/i;

/** So long a note stays that nobody has to read. */
const NOTE_SECONDS = 12;

/** The dialog of what arrived last; the next one closes it. @type {{ hide: () => void } | null} */
let open = null;

/**
 * @param {Page} page
 * @param {Source} source
 * @param {object} given
 * @param {() => boolean} given.isWanted  nothing else was asked for since
 * @param {() => void} given.again        choose another file
 */
export async function receive(page, source, { isWanted, again }) {
  open?.hide();
  open = null;
  const [, hash] = SHARE_LINK.exec(source.text ?? '') ?? [];
  if (hash) {
    const { followLink } = await import('./linked.js');
    if (isWanted()) followLink(page, hash);
    return;
  }
  const code = codeOf(source);
  if (code.length > 0) {
    const { openCode } = await import('../code/openCode.js');
    if (!isWanted()) return;
    const done = await openCode(page, code);
    if ('ids' in done) return openPanel(page, 'code');
    return end(page, { name: code[0].name, text: '', doc: null, issues: [fileIssue('not-text', done.reason)], again });
  }
  const { name, text, issues: earlier } = await arrived(source);
  if (!isWanted()) return;
  if (text !== null && TABLE_NAME.test(name) && !text.trimStart().startsWith('<')) {
    await postures(page, { name, text, earlier, again });
    return;
  }
  /** @param {Doc | null} doc @param {readonly Issue[]} issues */
  const finish = (doc, issues) => end(page, { name, text, doc, issues: [...earlier, ...issues], again });
  if (text === null) {
    finish(null, []);
    return;
  }
  const { doc, issues, chain } = readRobotFile(text);
  if (chain && leavesChoice(chain, doc, issues)) {
    await choose(chain);
    return;
  }
  finish(doc, issues);
  if (doc && chain?.choices) offerOther(page, name, chain.choices, () => void choose(chain));

  /** @param {FileChain} chain */
  async function choose({ read }) {
    const { chooseChain } = await import('./chainDialog.js');
    open?.hide();
    open = chooseChain({ name, readChain: read, onOpen: finish });
  }
}

const CODE_NAME = /\.(kl[htc]?|ls|src|dat)$/i;
/** Remarks, then its first word and its name. */
const CODE_TEXT = /^(?:[ \t]*(?:(?:--|[;&]).*)?\r?\n)*[ \t]*(\/PROG|PROGRAM|(?:GLOBAL\s+)?DEF(?:DAT)?)\s+([\w-]+)/i;

/** Controller code: files by their names, a text by its first word. @param {Source} source @returns {readonly File[]} */
function codeOf({ files, isFolder, text = '' }) {
  if (!isFolder && files.length > 0 && files.every(({ name }) => CODE_NAME.test(name))) return files;
  const [, word = '', name] = CODE_TEXT.exec(text) ?? [];
  const end = word.startsWith('/') ? 'ls' : /PROGRAM/i.test(word) ? 'kl' : /DAT$/i.test(word) ? 'dat' : 'src';
  return name === undefined ? [] : [new File([text], `${name}.${end}`)];
}

/**
 * Which chain was taken without asking, and the way to another one.
 * @param {Page} page
 * @param {string} name
 * @param {ChainChoices} choices
 * @param {() => void} choose
 */
function offerOther({ clock, store }, name, { base, tip }, choose) {
  const other = h('button', { type: 'button', class: 'btn btn-outline' }, ARRIVAL.other);
  const close = h('button', { type: 'button', class: 'btn btn-icon', 'aria-label': TEXT.close }, icon('close'));
  const text = h('p', {}, ARRIVAL.chain(name, base, tip ?? ''));
  const note = h('div', { class: 'notice is-good', role: 'status' }, icon('checkCircle'), text, other, close);
  const { edition } = store.state.session;
  other.addEventListener('click', () => {
    note.remove();
    if (store.state.session.edition === edition) choose();
  });
  close.addEventListener('click', () => note.remove());
  clock.after(NOTE_SECONDS, () => note.remove());
  document.querySelector('.notices')?.append(note);
}

/**
 * A table of joint values.
 * @param {Page} page
 * @param {{ name: string, text: string, earlier: readonly Issue[], again: () => void }} given
 */
async function postures(page, { name, text, earlier, again }) {
  const [{ readPostures }, { openPostureTable }] = await Promise.all([
    import('../../io/postureCsv.js'),
    import('./postureTable.js'),
  ]);
  open?.hide();
  const reading = readPostures(text, page.store.state.doc.robot);
  if (reading.fault === null) {
    open = openPostureTable(page, name, reading);
    return;
  }
  const issue = /** @type {const} */ ({ severity: 'error', code: 'postures', path: '', message: reading.fault });
  end(page, { name, text: null, doc: null, issues: [...earlier, issue], again });
}

/** What another chain of the file, or snapping, may mend. */
const MENDED = ['joint-count', 'joint-type', 'mimic', 'not-exact'];

/**
 * Whether a person should say which chain of a file it is, or what becomes of axes that are nearly parallel.
 * @param {FileChain} chain
 * @param {Doc | null} doc
 * @param {readonly Issue[]} issues
 */
function leavesChoice({ choices, snaps }, doc, issues) {
  if (!choices) return false;
  if (doc) return choices.isOpen || snaps.length > 0;
  return issues.every(({ severity, code }) => severity === 'warning' || MENDED.includes(code));
}

/**
 * @param {Page} page
 * @param {{ name: string, text: string | null, doc: Doc | null, issues: readonly Issue[], again: () => void }} given
 */
function end({ store, opener, announce }, { name, text, doc, issues, again }) {
  if (doc) {
    opener.open(doc);
    announce(ARRIVAL.opened(name));
  }
  if (issues.length === 0) return;
  const robotName = store.state.doc.robot.name || TEXT.unnamedRobot;
  open = showReport({ name, robotName, announce, isOpened: doc !== null, issues, text, again });
}

/** @param {Source} source @returns {Promise<Arrived>} */
async function arrived({ files, text, isFolder, way }) {
  if (text !== undefined) {
    const name = ARRIVAL[way];
    if (text.trimStart().startsWith('<')) return { name, text, issues: [] };
    return refused(name, 'not-text', /^[a-z]+:\S*$/i.test(text.trim()) ? ARRIVAL.link : ARRIVAL.plainText);
  }
  if (files.length === 0) return refused(ARRIVAL.what, 'unreadable', ARRIVAL.nothing);
  if (files.length > 1) return refused(ARRIVAL.several(files.length), 'several', ARRIVAL.severalFiles(files.length));
  const [file] = files;
  if (isFolder) return refused(file.name, 'folder', ARRIVAL.folder);
  return { name: file.name, ...(await readText(file)) };
}

/** @param {string} name @param {string} code @param {string} message @returns {Arrived} */
const refused = (name, code, message) => ({
  name,
  text: null,
  issues: [{ severity: 'error', code, path: '', message }],
});

/** @param {File} file @returns {Promise<Pick<Arrived, 'text' | 'issues'>>} */
async function readText(file) {
  if (file.size > LARGEST_BYTES) {
    const size = ARRIVAL.megabytes(fixed(file.size / MEGABYTE, 0));
    return refused(file.name, 'file-too-large', ARRIVAL.tooLarge(size));
  }
  try {
    return decodeText(new Uint8Array(await file.arrayBuffer()));
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    return refused(file.name, 'unreadable', ARRIVAL.unreadable(reason));
  }
}
