/**
 * Text as XML 1.0 can hold it. A character that XML forbids (U+0000, most controls, a lone surrogate, U+FFFE, U+FFFF)
 * cannot be written even as a reference; it is written as U+FFFD, the replacement character, so that the file stays
 * readable and the damage visible.
 */

/** Production 2 of XML 1.0 (fifth edition), turned round. */
const FORBIDDEN = '[^\\t\\n\\r\\u{20}-\\u{D7FF}\\u{E000}-\\u{FFFD}\\u{10000}-\\u{10FFFF}]';
const ALL_FORBIDDEN = new RegExp(FORBIDDEN, 'gu');
const ONE_FORBIDDEN = new RegExp(FORBIDDEN, 'u');

/** @type {Readonly<Record<string, string>>} */
const REFERENCES = {
  '&': '&amp;',
  '<': '&lt;',
  '>': '&gt;',
  '"': '&quot;',
  '\t': '&#9;',
  '\n': '&#10;',
  '\r': '&#13;',
};
const reference = (/** @type {string} */ character) => REFERENCES[character];

/** @param {string} text */
export const toXmlCharacters = (text) => text.replace(ALL_FORBIDDEN, '\uFFFD');

/** Where the first character is that XML forbids, or −1. @param {string} text */
export const forbiddenCharacterAt = (text) => text.search(ONE_FORBIDDEN);

/** For an attribute in double quotes, or for an element whose blanks must survive a pretty-printer. @param {string} text */
export const escapeWithBlanks = (text) => toXmlCharacters(text).replace(/[&<>"\t\n\r]/g, reference);

/** For the content of an element with lines of its own; a reader turns a bare carriage return into a line feed. @param {string} text */
export const escapeLines = (text) => toXmlCharacters(text).replace(/[&<>\r]/g, reference);
