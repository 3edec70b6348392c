/**
 * What the parser has against a text, in words for someone who does not write XML every day.
 *
 * @import { XmlError } from '@rgrove/parse-xml'
 * @import { Issue } from '../model/issues.js'
 */
import { shownText } from '../model/shownText.js';
import { fileIssue } from './fileIssues.js';
import { forbiddenCharacterAt } from './xmlText.js';

/**
 * The parser's messages (their beginnings) and ours. `$` stands for what follows in the parser's message, the name of
 * an element or attribute.
 * @type {readonly (readonly [string, string])[]}
 */
const SENTENCES = [
  ['Attribute value expected', 'An attribute has no value in quotation marks; expected name="value".'],
  ['Duplicate attribute: ', 'The attribute "$" is there twice in one element; expected it once.'],
  ['Value of the `xml:space`', 'The attribute xml:space has a wrong value; expected "default" or "preserve".'],
  [
    'Unescaped `<` is not allowed in an attribute',
    'A "<" stands in the value of an attribute; expected &lt; there, or a quotation mark before it.',
  ],
  ['Unclosed attribute', 'The value of an attribute does not end; expected a quotation mark.'],
  ['Unclosed CDATA', 'A CDATA section does not end; expected "]]>".'],
  ['The string `--`', 'The characters "--" stand in a comment; expected "-->" or nothing of the kind.'],
  ['Unclosed comment', 'A comment does not end; expected "-->".'],
  ['Unclosed start tag for element ', 'The tag <$ does not end properly; expected more attributes, or ">".'],
  ['Unclosed end tag for element ', 'The tag </$ does not end properly; expected ">".'],
  ["XML declaration isn't allowed here", 'The XML declaration stands here; expected it at the very start of the file.'],
  ['Invalid processing instruction', 'A "<?" stands here without a name; expected <?name …?>.'],
  ['Whitespace is required after a processing', 'A "<?" with a wrong name stands here; expected <?name …?>.'],
  ['Unterminated processing instruction', 'A processing instruction does not end; expected "?>".'],
  ['Unterminated reference', 'A "&" stands here by itself; expected &amp;.'],
  ['Invalid character reference', 'A reference such as &#65; is misspelt; expected digits and a semicolon.'],
  ['Character reference resolves', 'A reference stands for a character that XML forbids; expected another.'],
  ["Named entity isn't defined: ", 'The reference $ is not known; expected &amp;, &lt;, &gt;, &quot; or &apos;.'],
  ['Extra content at the end', 'There is more after the end of the root element; expected the end of the file.'],
];
const STRAY_CDATA_END = 'The characters "]]>" stand in a text; expected "]]&gt;".';
const OTHER = 'The file is not well-formed XML here; expected elements such as <chain> … </chain>.';
const XML_DECLARATION = 'The XML declaration is misspelt; expected <?xml version="1.0" encoding="UTF-8"?>.';
const IS_DECLARATION = /XML declaration|XML version|version number|encoding name|of `standalone`/;

/**
 * @param {XmlError} error
 * @param {string} text  what was parsed
 * @param {(offset: number) => number} lineAt
 * @returns {Issue}
 */
export function wellFormednessIssue(error, text, lineAt) {
  const said = error.message.split('\n', 1)[0].replace(/ \(line \d+, column \d+\)$/, '');
  const at = said === 'Invalid character' ? forbiddenCharacterAt(text) : offsetOf(text, error.pos);
  return fileIssue('not-xml', sentence(said, text, at), { line: lineAt(at) });
}

/** @param {string} said @param {string} text @param {number} at @returns {string} */
function sentence(said, text, at) {
  if (said === 'Invalid character') {
    const code = text.codePointAt(at)?.toString(16).toUpperCase().padStart(4, '0');
    return `The character U+${code} stands here, which XML forbids; expected it to be taken out.`;
  }
  if (said === 'Root element is missing or invalid') {
    return `The file has ${found(text, at)} where its root element must begin; expected an element such as <robotModel>.`;
  }
  // The parser sees "]]>" only after another character, and else misses an end tag where it stands.
  if (text.startsWith(']]>', at)) return STRAY_CDATA_END;
  const end = /^Missing end tag for element (.*)$/.exec(said);
  if (end)
    return `The element <${shownText(end[1])}> is not closed: expected </${shownText(end[1])}>, found ${found(text, at)}.`;
  for (const [beginning, ours] of SENTENCES) {
    if (said.startsWith(beginning))
      return ours.replace('$', () => shownText(said.slice(beginning.length).replaceAll('`', '')));
  }
  return IS_DECLARATION.test(said) ? XML_DECLARATION : OTHER;
}

/** What stands at an offset: one tag, or text up to the next. @param {string} text @param {number} at */
function found(text, at) {
  const rest = text.slice(at).trim();
  if (!rest.includes('<')) return 'the end of the file';
  return `"${shownText((/^(?:<[^<>]*>?|[^<]+)/.exec(rest)?.[0] ?? rest).trim())}"`;
}

/** The parser counts characters; JavaScript counts an emoji as two. @param {string} text @param {number} count */
function offsetOf(text, count) {
  let offset = 0;
  for (const character of text) {
    if (count-- <= 0) break;
    offset += character.length;
  }
  return offset;
}
