/**
 * What keptWork.js wrote, or what became of it.
 *
 * @import { Doc } from '../model/document.js'
 * @import { Look } from './readLook.js'
 *
 * @typedef {{ key: string, state: 'work', at: string, doc: Doc, look: Look, file: string }} KeptWork
 * @typedef {{ key: string, state: 'newer' | 'damaged', file: string }} SpoiltWork  `file`: what there is of it
 */
import { fingerprint } from '../model/fingerprint.js';
import { readLook } from './readLook.js';
import { readRobotXml } from './robotXml.js';
import { writeRobotXml } from './robotXmlWriter.js';

const VERSION = 1;
const FIRST_LINE = /^denavit-work (\d{1,6}) ([0-9a-f]{8})\n/;
const SECOND_LINE = /^[^\n]*\n/;
/** As many are kept as anyone looks through. */
const MOST = 10;

/** @param {string} key @param {string} text @returns {KeptWork | SpoiltWork} */
export function readKeptWork(key, text) {
  const [line, version, print] = FIRST_LINE.exec(text) ?? [''];
  const rest = text.slice(line.length);
  const file = rest.replace(SECOND_LINE, '');
  if (Number(version) > VERSION) return { key, state: 'newer', file };
  const damaged = /** @type {const} */ ({ key, state: 'damaged', file: line === '' ? text : file });
  if (Number(version) !== VERSION || fingerprint(rest) !== print) return damaged;
  const head = headOf(rest);
  const { doc } = readRobotXml(file);
  return head && doc ? { key, state: 'work', file, doc, at: head.at, look: readLook(head.look) } : damaged;
}

/** @param {string} rest @returns {{ at: string, look: string } | null} */
function headOf(rest) {
  try {
    const { at, look } = JSON.parse(rest.slice(0, rest.indexOf('\n')));
    return typeof at === 'string' && typeof look === 'string' ? { at, look } : null;
  } catch {
    return null;
  }
}

/**
 * What of all that is kept is worth offering.
 * @param {readonly { key: string, text: string }[]} all
 * @param {Doc} open  what is open anyway
 * @returns {{ works: KeptWork[], spoilt: SpoiltWork[], idle: string[] }} the newest work first; `idle`: keys of what is open
 *   anyway or kept twice, and of the oldest
 */
export function sortKeptWork(all, open) {
  const read = all.map(({ key, text }) => readKeptWork(key, text));
  const works = read
    .filter((one) => one.state === 'work')
    .sort((one, other) => (one.at < other.at ? 1 : one.at > other.at ? -1 : 0));
  const seen = new Set([writeRobotXml(open)]);
  const worth = works.filter(({ doc }) => {
    const file = writeRobotXml(doc);
    return !seen.has(file) && seen.add(file);
  });
  const offered = worth.slice(0, MOST);
  return {
    works: offered,
    spoilt: read.filter((one) => one.state !== 'work'),
    idle: works.filter((work) => !offered.includes(work)).map(({ key }) => key),
  };
}
