/**
 * `%from header %import a, b`: of a header, only the lines that name what is wanted, with those in which a declaration goes on
 * and those that say what the header's program is called.
 *
 * @import { Host } from './expansion.js'
 * @import { Marked, Writer } from './marked.js'
 */
import { createWriter, markedAs, slice } from './marked.js';

const FROM = /^%from[ \t]*([\w.]*)[ \t]*%import[ \t]*(\w+(?:[ \t]*,[ \t]*\w+)*)/;
/** The macros that declarations of headers are written with. */
const NAMES_FILE = 'namespace.m';

/** @param {Marked} marked @param {Host} host @returns {Marked} */
export function withSelections(marked, host) {
  if (!/^%from\b/m.test(marked.text)) return marked;
  const out = createWriter();
  for (const { start, end, line } of linesOf(marked.text)) {
    const [, name, list] = FROM.exec(line) ?? [];
    if (name === undefined) out.add(marked, start, end);
    else
      select(
        name,
        list.split(',').map((one) => one.trim()),
        marked.from[start],
        marked.to[end - 1],
        host,
        out,
      );
  }
  return out.done();
}

/** @param {string} name @param {string[]} wanted @param {number} from @param {number} to @param {Host} host @param {Writer} out */
function select(name, wanted, from, to, host, out) {
  const text = host.fileNamed(name);
  if (text === undefined) {
    host.onGap();
    host.report('include', `%from "${name}": no such file is at hand; what it would bring is missing.`, from, to);
    return;
  }
  if (host.fileNamed(NAMES_FILE) !== undefined) out.add(markedAs(`%include ${NAMES_FILE}\n`, from, to));
  const header = host.sources.read(name, text);
  const words = wanted.map((word) => new RegExp(`(?:\\b|_)${word}\\b`, 'i'));
  let goesOn = false;
  for (const { start, end, line } of linesOf(text)) {
    const isHead = line.includes('%define prog_name');
    if (!goesOn && !isHead && !words.some((word) => word.test(line))) continue;
    out.add(slice(header, start, end));
    if (!/\n$/.test(header.text.slice(start, end))) out.add(markedAs('\n', from, to));
    goesOn = line.trimEnd().endsWith('&');
  }
}

/** @param {string} text */
export function* linesOf(text) {
  for (const match of text.matchAll(/[^\n]*\n|[^\n]+$/g)) {
    const [whole] = match;
    yield { start: match.index, end: match.index + whole.length, line: whole.replace(/\r?\n$/, '') };
  }
}
