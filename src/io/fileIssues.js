/**
 * What can be wrong with a file as a file; what can be wrong with the document in it is in model/issues.js. Codes are
 * stable: tests and translations use them. A message is one sentence and begins with the line, where there is one.
 *
 * @import { Issue } from '../model/issues.js'
 * @typedef {keyof typeof FILE_ISSUES} FileIssueCode
 */
export const FILE_ISSUES = Object.freeze({
  // bytes and text
  empty: 'error',
  'too-large': 'error',
  'not-text': 'error', // bytes that are no text in UTF-8, or in UTF-16 with a byte order mark
  encoding: 'warning', // declared otherwise than it is
  utf16: 'warning',
  // XML
  doctype: 'error',
  'too-many-elements': 'error',
  'too-deep': 'error',
  'too-many-attributes': 'error',
  'attribute-length': 'error',
  'not-xml': 'error', // not well-formed
  namespace: 'error', // a prefix that is not declared, or declared wrongly
  // which file this is
  'not-a-robot': 'error', // another root element, or namespace
  version: 'error',
  'newer-version': 'warning',
  // its structure
  'unknown-element': 'error',
  'missing-element': 'error',
  'too-many-of-element': 'error',
  'unexpected-text': 'error',
  'unknown-attribute': 'error',
  'missing-attribute': 'error',
  'older-name': 'warning',
  // its values
  'id-taken': 'error',
  'joint-count': 'error',
  number: 'error',
  choice: 'error',
  pattern: 'error', // ids and colours
  'text-length': 'error',
  'quaternion-rounded': 'warning', // brought to length 1
  'not-finite': 'error', // the arm has no computable pose
  // what only other formats can have
  xacro: 'error', // macros from which a URDF is yet to be made
  'not-a-tree': 'error',
  'unknown-link': 'error',
  'joint-type': 'error', // one that no table has: planar, floating
  mimic: 'error', // a joint of the chain that follows another
  'limits-crossed': 'error',
  'not-exact': 'error', // no table that is the same arm was found
  'axis-length': 'warning',
  'limit-missing': 'warning',
  'nearly-parallel': 'warning',
  'mesh-name': 'warning',
  'not-read': 'warning', // something of another format
  // what a format will not hold when a document is written in it
  'not-kept': 'warning',
  placeholder: 'warning', // stands where the format asks for what the document does not have
  'not-writable': 'error',
  // links
  'link-cut': 'error',
  'link-damaged': 'error',
  'link-newer': 'error',
  'link-too-large': 'error',
  'link-unknown': 'error', // what follows the # is something else
  'link-look': 'warning', // panels, frames or camera
});

/**
 * @param {FileIssueCode} code
 * @param {string} message  begins with a capital or with a name; the line comes in front of it here
 * @param {{ line?: number, path?: string }} [where]
 * @returns {Issue}
 */
export function fileIssue(code, message, { line, path = '' } = {}) {
  const severity = /** @type {Issue['severity']} */ (FILE_ISSUES[code]); // Object.freeze keeps the words' types too wide
  return atLine({ severity, code, path, message }, line);
}

/**
 * An issue of a document, with the line of the file that it is about.
 * @param {Issue} issue
 * @param {number | undefined} line
 * @returns {Issue}
 */
export function atLine(issue, line) {
  if (line === undefined) return issue;
  const sentence = issue.message.replace(/^[A-Z](?=[a-z ])/, (letter) => letter.toLowerCase());
  return { ...issue, line, message: `Line ${line}: ${sentence}` };
}

/** @param {readonly Issue[]} issues */
export const hasErrors = (issues) => issues.some(({ severity }) => severity === 'error');
