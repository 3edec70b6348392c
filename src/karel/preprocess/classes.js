/**
 * `%class name('file.klc', 'file.klh', 'type.klt')`: a program made of a template under a new name, and what others have to
 * know of it. The text goes through the preprocessor as `ktransw` has it go: expanded, its %class and %from replaced,
 * expanded again, the headers of its classes put in, expanded twice more, the last time without backquotes, so that
 * directives that macros have written are obeyed.
 *
 * @import { Host } from './expansion.js'
 * @import { Marked } from './marked.js'
 *
 * @typedef {{ name: string, template: string, header: string, type: string | undefined, from: number, to: number }} ClassUse
 * @typedef {{ name: string, marked: Marked }} Generated
 */
import { expandText } from './expansion.js';
import { createWriter, markedAs, slice } from './marked.js';
import { linesOf, withSelections } from './selected.js';

const FILE = String.raw`'([\w.]+)'`;
const CLASS = new RegExp(String.raw`^%class\s*(\w+)\s*\(\s*${FILE}\s*,\s*${FILE}(?:\s*,\s*${FILE})?\s*\)`);
/** A comment until the header comes in its place. */
const MARKER = /^--\u00a7(\d+)$/;
const MAX_CLASSES = 100;

/** @param {Marked} marked @param {Host} host @param {Generated[]} generated  filled with the programs that the text brings @returns {Marked} */
export function expandProgram(marked, host, generated) {
  /** @type {ClassUse[]} */
  const uses = [];
  const first = withoutBackquotes(expandText(marked, host));
  const second = expandText(withSelections(withMarkers(first, uses, host), host), host);
  for (const use of uses) {
    if (generated.some(({ name }) => name.toUpperCase() === use.name.toUpperCase())) continue;
    if (generated.length >= MAX_CLASSES) {
      host.report('preprocessor', `%class: more than ${MAX_CLASSES} programs come of one text.`, use.from, use.to);
      break;
    }
    const program = { name: use.name, marked: markedAs('', 0, 0) };
    generated.push(program);
    program.marked = expandProgram(classText(use, use.template), host, generated);
  }
  const third = expandText(withHeaders(second, uses), host);
  return expandText(withoutBackquotes(third), host);
}

/** What the file of a class is read with. @param {ClassUse} use @param {string} file @returns {Marked} */
const classText = ({ name, type, from, to }, file) =>
  markedAs(`%defeval class_name ${name}\n${type ? `%include ${type}\n` : ''}%include ${file}\n`, from, to);

/** @param {Marked} marked @param {ClassUse[]} uses @param {Host} host @returns {Marked} */
function withMarkers(marked, uses, host) {
  return byLines(marked, (line, from, to) => {
    if (!line.startsWith('%class')) return null;
    const [, name, template, header, type] = CLASS.exec(line) ?? [];
    if (name === undefined) {
      host.onGap();
      host.report('preprocessor', `Expected %class name('file', 'header'), got "${line.trim()}".`, from, to);
      return markedAs('', from, to);
    }
    const missing = [template, header, type].find((file) => file !== undefined && host.fileNamed(file) === undefined);
    if (missing !== undefined) {
      host.onGap();
      const message = `%class ${name} of "${missing}": no such file is at hand; what it would bring is missing.`;
      host.report('include', message, from, to);
      return markedAs('', from, to);
    }
    uses.push({ name, template, header, type, from, to });
    return markedAs(`--\u00a7${uses.length - 1}\n`, from, to);
  });
}

/** @param {Marked} marked @param {readonly ClassUse[]} uses */
const withHeaders = (marked, uses) =>
  byLines(marked, (line) => {
    const use = uses[Number(MARKER.exec(line)?.[1] ?? -1)];
    return use ? classText(use, use.header) : null;
  });

/** @param {Marked} marked @param {(line: string, from: number, to: number) => Marked | null} replace */
function byLines(marked, replace) {
  const out = createWriter();
  for (const { start, end, line } of linesOf(marked.text)) {
    out.add(replace(line, marked.from[start], marked.to[end - 1]) ?? slice(marked, start, end));
  }
  return out.done();
}

/** @param {Marked} marked @returns {Marked} */
function withoutBackquotes(marked) {
  const out = createWriter();
  for (const match of marked.text.matchAll(/[^`]+/g)) out.add(marked, match.index, match.index + match[0].length);
  return out.done();
}
