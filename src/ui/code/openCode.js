/**
 * Files of controller code that come in, chosen or dropped: programs of the document, in one step to undo. How their bytes were is
 * remembered, so that a program that nobody altered is saved as it came.
 *
 * @import { Page } from '../page.js'
 * @import { CodeBytes } from '../../io/codeText.js'
 * @import { ProgramDoc } from '../../model/document.js'
 * @import { CodeFile } from '../../karel/write/neutral.js'
 *
 * @typedef {{ name: string, language: ProgramDoc['language'], text: (id: string) => string, came?: CodeBytes }} NewProgram
 */
import { decodeCode, encodeCode } from '../../io/codeText.js';
import { freeCodeId } from '../../model/code/codeCommands.js';
import { fileName } from '../../model/controller/codeSets.js';
import { attempt } from '../page.js';
import { CODE } from '../words/code.js';

/** By the end of a file's name. @type {Readonly<Record<string, ProgramDoc['language']>>} */
const LANGUAGE_OF = { kl: 'karel', ls: 'fanuc-tp', src: 'krl', dat: 'krl' };
const LARGEST = 1_000_000;
const LONGEST_ID = 56;

/** By page, and there by the file's name as it is saved. @type {WeakMap<Page, Map<string, CodeBytes>>} */
const opened = new WeakMap();

/** @param {string} name  of a file, or what a person typed @returns {string} as a program can be called */
const idFrom = (name) =>
  name
    .replace(/\.[^.]*$/, '')
    .replace(/[^A-Za-z0-9_]+/g, '_')
    .replace(/^(?=\d|$)/, '_')
    .slice(0, LONGEST_ID);

/** In one step. @param {Page} page @param {readonly NewProgram[]} added @returns {{ ids: string[] } | { reason: string }} */
export function addPrograms(page, added) {
  const { programs } = page.store.state.doc;
  const all = [...programs];
  for (const { name, language, text } of added) {
    const id = freeCodeId({ programs: all }, name);
    all.push({ id, language, text: text(id) });
  }
  const reason = attempt(page, { type: 'set-code', programs: all });
  if (reason) return { reason };
  const fresh = all.slice(programs.length);
  const known = opened.get(page) ?? new Map();
  for (const [i, { came }] of added.entries()) if (came) known.set(fileName(fresh[i]), came);
  opened.set(page, known);
  const ids = fresh.map(({ id }) => id);
  page.announce(CODE.added(ids.join(', ')));
  return { ids };
}

/** @param {Page} page @param {readonly File[]} files @returns {Promise<{ ids: string[] } | { reason: string }>} */
export async function openCode(page, files) {
  /** @type {NewProgram[]} */
  const added = [];
  for (const file of files) {
    if (file.size > LARGEST) return { reason: CODE.tooLarge(file.name) };
    const came = decodeCode(new Uint8Array(await file.arrayBuffer()));
    if (/(?![\t\n])\p{Cc}/u.test(came.text)) return { reason: CODE.notText(file.name) };
    const end = file.name.toLowerCase().split('.').at(-1) ?? '';
    const name = `${idFrom(file.name)}${/^(dat|kl[htc])$/.test(end) ? `_${end}` : ''}`;
    added.push({ name, language: LANGUAGE_OF[end] ?? 'karel', text: () => came.text, came });
  }
  return addPrograms(page, added);
}

/** What is saved of a file. @param {Page} page @param {CodeFile} file @returns {string | Blob} */
export function savedCode(page, { name, text }) {
  const came = opened.get(page)?.get(name);
  return came ? new Blob([/** @type {BlobPart} */ (encodeCode(text, came))], { type: 'text/plain' }) : text;
}
