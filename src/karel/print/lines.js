/**
 * Lines of KAREL text: a comment behind what it speaks of, indentation, and where a long line is broken.
 *
 * @import { Comment } from '../tree.js'
 */
import { BREAK } from '../expressionPrinter.js';
import { oneLine } from '../words.js';

const LINE_LENGTH = 96;
const INDENT = '  ';

/** Begins a comment that belongs to the line before; nothing that comes in can hold one. */
const TRAILING = '\x01';

export const indented = (/** @type {string[]} */ lines) =>
  lines.map((line) => (line.startsWith(TRAILING) ? line : INDENT + line));

/** @param {Comment} comment */
export function commentText({ text, trailing }) {
  const line = `-- ${oneLine(text)}`.trimEnd();
  return trailing ? TRAILING + line : line;
}

/** Printed lines → text. @param {string[]} lines */
export function joinedLines(lines) {
  /** @type {string[]} */
  const text = [];
  for (const line of lines) {
    if (!line.startsWith(TRAILING)) text.push(folded(line));
    else if (text.length === 0 || text.at(-1) === '') text.push(line.slice(1));
    else text[text.length - 1] += `  ${line.slice(1)}`;
  }
  return text.map((line) => `${line}\n`).join('');
}

/** Break a line where it may be, only if it must be; what cannot be broken, a long string, stays whole. @param {string} line */
function folded(line) {
  if (line.replaceAll(BREAK, '').length <= LINE_LENGTH) return line.replaceAll(BREAK, '');
  const further = `${line.slice(0, line.search(/\S/))}${INDENT}${INDENT}`;
  const [first, ...rest] = line.split(BREAK);
  const lines = [first];
  for (const piece of rest) {
    const last = lines[lines.length - 1];
    if (`${last}${piece} &`.trimEnd().length <= LINE_LENGTH) lines[lines.length - 1] = last + piece;
    else lines.push(further + piece);
  }
  return lines.map((text, i) => (i < lines.length - 1 ? `${text.trimEnd()} &` : text)).join('\n');
}
