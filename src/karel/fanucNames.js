/**
 * Names that every controller takes: at most 8 characters (old file systems), a letter first, then letters, digits and _,
 * no word of the language. KAREL and TP programs share one list on the controller, so the two differ.
 */
import { plainText } from './plainText.js';
import { isTakenWord } from './words.js';

const MAX_LENGTH = 8;
const FALLBACK = 'denavit';
const TP_SUFFIXES = ['_mv', '_go'];

/**
 * @example
 * fanucNames('Puma 560') // → { karel: 'puma_560', tp: 'PUMA_MV' }
 * fanucNames('Cobra 600') // → { karel: 'cobra600', tp: 'COBRA_MV' }
 * @param {string} wanted                what a person called it
 * @param {readonly string[]} [avoided]  names that mean something else in the program
 */
export function fanucNames(wanted, avoided = []) {
  const isFine = fanucNameFault(wanted, avoided) === null;
  const word = isFine
    ? wanted.toLowerCase()
    : plainText(wanted)
        .toLowerCase()
        .replace(/[^a-z0-9]+/g, '_')
        .replace(/^_+|_+$/g, '');
  const base = /^[0-9]/.test(word) ? `p${word}` : word || FALLBACK;
  const short = base.length > MAX_LENGTH ? cut(base.replaceAll('_', ''), MAX_LENGTH) : base;
  const karel = isTakenWord(short) || avoided.includes(short) ? `${cut(base, MAX_LENGTH - 2)}_p` : short;
  const candidates = TP_SUFFIXES.map((suffix) => cut(base, MAX_LENGTH - suffix.length) + suffix);
  const tp = candidates[0] === karel ? candidates[1] : candidates[0];
  return { karel, tp: tp.toUpperCase() };
}

/** What is against a name that somebody has typed; null: nothing. @param {string} name @param {readonly string[]} [avoided] @returns {string | null} */
export function fanucNameFault(name, avoided = []) {
  if (!/^[A-Za-z][A-Za-z0-9_]*$/.test(name) || name.length > MAX_LENGTH)
    return `Expected a name of at most ${MAX_LENGTH} letters, digits and _, a letter first: older controllers take no others. Got "${name}".`;
  if (avoided.includes(name.toLowerCase())) return `"${name}" is what the program calls something of its own.`;
  if (isTakenWord(name)) return `"${name}" is a word of KAREL, and no name for a program.`;
  return null;
}

const cut = (/** @type {string} */ text, /** @type {number} */ length) => text.slice(0, length).replace(/_+$/, '');
