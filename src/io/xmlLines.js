/**
 * From offsets to lines, for messages. The text has line feeds only (the XML reader sees to that).
 */

/**
 * @param {string} text
 * @returns {(offset: number) => number} the line, from 1
 */
export function createLineIndex(text) {
  const starts = [0];
  for (let at = text.indexOf('\n'); at !== -1; at = text.indexOf('\n', at + 1)) starts.push(at + 1);
  return function lineAt(offset) {
    let [low, high] = [0, starts.length];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (starts[middle] <= offset) low = middle;
      else high = middle;
    }
    return low + 1;
  };
}

const TAG_NAME = /<[^\s/>]+/y;
const ATTRIBUTE = /\s+([^\s=]+)\s*=\s*(?:"[^"]*"|'[^']*')/y;

/**
 * Where an attribute stands in a start tag that the parser accepted.
 * @param {string} text
 * @param {number} start  offset of the tag
 * @param {string} name   with its prefix
 * @returns {number} its offset, or that of the tag when it has no such attribute
 */
export function attributeOffset(text, start, name) {
  TAG_NAME.lastIndex = start;
  TAG_NAME.test(text);
  ATTRIBUTE.lastIndex = TAG_NAME.lastIndex;
  for (let match = ATTRIBUTE.exec(text); match; match = ATTRIBUTE.exec(text)) {
    if (match[1] === name) return match.index + match[0].indexOf(name);
  }
  return start;
}
