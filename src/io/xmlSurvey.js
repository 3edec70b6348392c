/**
 * A first look at XML text that builds nothing and expands nothing: is there a document type declaration, how many
 * elements, how deep, how many attributes? Whatever the parser takes for markup is seen as such here; text that is not well-formed may be
 * counted wrongly, and is refused by the parser.
 *
 * @typedef {object} Survey
 * @property {number} doctypeAt   offset of a <!DOCTYPE or <!ENTITY in any spelling, or −1
 * @property {number} elements
 * @property {number} depth       of the deepest element; the root has 1
 * @property {number} deepestAt   offset of its start tag
 * @property {number} attributes  of the element that has most, namespace declarations included
 * @property {number} attributesAt  offset of its start tag
 */

/** What is skipped as a whole, because a < in it is no markup. */
const OPAQUE = [
  { begin: '<!--', end: '-->' },
  { begin: '<![CDATA[', end: ']]>' },
  { begin: '<?', end: '?>' },
];
const DECLARATION = /<!(?:doctype|entity)/iy;

/**
 * @param {string} text
 * @returns {Survey}
 */
export function surveyMarkup(text) {
  const survey = { doctypeAt: -1, elements: 0, depth: 0, deepestAt: 0, attributes: 0, attributesAt: 0 };
  let open = 0;
  let at = text.indexOf('<');
  while (at !== -1) {
    const opaque = OPAQUE.find(({ begin }) => text.startsWith(begin, at));
    DECLARATION.lastIndex = at;
    let end = at + 1;
    if (opaque) {
      end = after(text, opaque.end, at + opaque.begin.length);
    } else if (DECLARATION.test(text)) {
      if (survey.doctypeAt === -1) survey.doctypeAt = at;
    } else if (text[at + 1] === '/') {
      open--;
    } else {
      const tag = scanTag(text, at + 1);
      end = tag.end;
      survey.elements++;
      if (tag.attributes > survey.attributes) Object.assign(survey, { attributes: tag.attributes, attributesAt: at });
      if (open + 1 > survey.depth) Object.assign(survey, { depth: open + 1, deepestAt: at });
      if (text[end - 1] !== '/') open++;
    }
    at = text.indexOf('<', end);
  }
  return survey;
}

/** @param {string} text @param {string} mark @param {number} from */
function after(text, mark, from) {
  const found = text.indexOf(mark, from);
  return found === -1 ? text.length : found + mark.length;
}

/**
 * Up to the > that closes a tag; what stands in quotation marks does not count. A < can stand in no tag: with one, a
 * quotation mark or > is missing, and the rest of the file must not be taken for attributes.
 * @param {string} text
 * @param {number} from
 */
function scanTag(text, from) {
  let quote = '';
  let attributes = 0;
  for (let end = from; end < text.length; end++) {
    const character = text[end];
    if (character === '<') return { end, attributes };
    if (quote) {
      if (character === quote) quote = '';
    } else if (character === '"' || character === "'") {
      quote = character;
    } else if (character === '=') {
      attributes++;
    } else if (character === '>') {
      return { end, attributes };
    }
  }
  return { end: text.length, attributes };
}
