/**
 * Bytes → text: UTF-8, or UTF-16 where a byte order mark (or a first "<" of two bytes) says so. What is neither is
 * refused, never guessed; a declaration that says otherwise than the bytes is a warning.
 *
 * @import { Issue } from '../model/issues.js'
 */
import { fileIssue } from './fileIssues.js';
import { MAX_TEXT_LENGTH } from './fileLimits.js';
import { shownText } from '../model/shownText.js';

/** UTF-8 takes at most 4 bytes for a character. */
const MAX_BYTES = 4 * MAX_TEXT_LENGTH;

const DECLARED = /^<\?xml\s[^>]*?\bencoding\s*=\s*["']([^"'>]*)["']/;
const NAMES = {
  'UTF-8': /^(utf-?8|us-ascii|ascii)$/i,
  'UTF-16': /^(utf-?16(le|be)?|ucs-?2|iso-10646-ucs-2)$/i,
};

/**
 * @param {Uint8Array} bytes
 * @returns {{ text: string | null, issues: Issue[] }} null when refused
 */
export function decodeText(bytes) {
  const refused = (/** @type {Issue} */ issue) => ({ text: null, issues: [issue] });
  if (bytes.length > MAX_BYTES) {
    return refused(
      fileIssue('too-large', `The file has ${bytes.length} bytes; expected at most ${MAX_TEXT_LENGTH} characters.`),
    );
  }
  const { name, label } = encodingOf(bytes);
  let text;
  try {
    text = new TextDecoder(label, { fatal: true }).decode(bytes);
  } catch {
    return refused(notTextIssue(bytes, name, label));
  }
  return { text, issues: encodingIssues(text, name) };
}

/** @param {Uint8Array} bytes @returns {{ name: 'UTF-8' | 'UTF-16', label: string }} */
function encodingOf([first, second]) {
  if ((first === 0xff && second === 0xfe) || (first === 0x3c && second === 0))
    return { name: 'UTF-16', label: 'utf-16le' };
  if ((first === 0xfe && second === 0xff) || (first === 0 && second === 0x3c))
    return { name: 'UTF-16', label: 'utf-16be' };
  return { name: 'UTF-8', label: 'utf-8' };
}

/** @param {string} text @param {'UTF-8' | 'UTF-16'} name @returns {Issue[]} */
function encodingIssues(text, name) {
  const declared = DECLARED.exec(text)?.[1];
  /** @type {Issue[]} */
  const issues = [];
  if (name === 'UTF-16')
    issues.push(fileIssue('utf16', 'The file is encoded as UTF-16; saving it will make it UTF-8.'));
  if (declared !== undefined && !NAMES[name].test(declared)) {
    const message = `The file says encoding="${shownText(declared)}" but is ${name}, as which it was read.`;
    issues.push(fileIssue('encoding', message, { line: 1 }));
  }
  return issues;
}

/** @param {Uint8Array} bytes @param {'UTF-8' | 'UTF-16'} name @param {string} label @returns {Issue} */
function notTextIssue(bytes, name, label) {
  if (name === 'UTF-8' && bytes.includes(0))
    return fileIssue('not-text', 'The file is not text; expected a robot file.');
  const good = goodBytes(bytes, label);
  const line = new TextDecoder(label).decode(bytes.subarray(0, good)).split(/\r\n?|\n/).length;
  return fileIssue('not-text', `The file has bytes here that are not ${name}; expected it to be saved as UTF-8.`, {
    line,
  });
}

/** How many bytes at the beginning are good. @param {Uint8Array} bytes @param {string} label */
function goodBytes(bytes, label) {
  let [good, bad] = [0, bytes.length];
  while (bad - good > 1) {
    const middle = (good + bad) >> 1;
    try {
      new TextDecoder(label, { fatal: true }).decode(bytes.subarray(0, middle), { stream: true });
      good = middle;
    } catch {
      bad = middle;
    }
  }
  return good;
}
