/**
 * What `ktransw` adds to KAREL, expanded: macros, conditions, files, templates of programs. A text that uses none of it passes
 * unchanged. The expanded text remembers where each of its characters came from, so that a fault is shown in the text that
 * was typed.
 *
 * @import { Diagnostic, Locate } from '../parse/cursor.js'
 * @import { Generated } from './classes.js'
 * @import { Host } from './expansion.js'
 * @import { Marked, Sources } from './marked.js'
 *
 * @typedef {{ text: string, macros: boolean, locate: Locate }} Preprocessed  with macros: whether the text is one for a preprocessor
 */
import { lineStarts, placeOf } from '../scan/places.js';
import { expandProgram } from './classes.js';
import { obeyDirective } from './directives.js';
import { fileNamed } from './files.js';
import { createSources } from './marked.js';

const WORDS = 'define|defeval|undef|ifdef|ifndef|ifeq|ifneq|if|elif|else|endif|eval|mode|error|warning|class|from|exec';
const USES_IT = new RegExp(String.raw`^%[ \t]*(?:(?:${WORDS})\b|include[ \t]+["'<]?\S+\.(?!kl\b)\w+)`, 'im');

/**
 * @param {string} text
 * @param {Readonly<Record<string, string>>} files
 * @param {Diagnostic[]} diagnostics
 * @param {string} [name]  of the text, where it is in another file than the one that is looked at
 * @returns {Preprocessed & { hasGaps: boolean, generated: (Preprocessed & { name: string })[] }}  whether something that the
 *   text wants is not at hand; the programs that `%class` makes
 */
export function preprocess(text, files, diagnostics, name) {
  if (!USES_IT.test(text)) {
    const starts = lineStarts(text);
    const locate = (/** @type {number} */ start, /** @type {number} */ end) => ({
      start,
      end,
      ...placeOf(starts, start),
      ...(name !== undefined && { file: name }),
    });
    return { text, macros: false, locate, hasGaps: false, generated: [] };
  }
  const sources = createSources();
  let hasGaps = false;
  /** Passes and headers that are read again tell a thing once. */
  const told = new Set();
  /** @type {Host} */
  const host = {
    sources,
    obey: obeyDirective,
    fileNamed: (name) => fileNamed(files, name),
    onGap: () => void (hasGaps = true),
    report(code, message, from, to, severity = 'warning') {
      const key = `${from} ${message}`;
      if (told.has(key)) return;
      told.add(key);
      diagnostics.push({ severity, code, message, span: sources.span(from, to) });
    },
  };
  /** @type {Generated[]} */
  const generated = [];
  const whole = expandProgram(sources.read(name, text), host, generated);
  const done = (/** @type {Marked} */ marked) => ({
    text: marked.text,
    macros: true,
    locate: locator(marked, sources),
  });
  return { ...done(whole), hasGaps, generated: generated.map(({ name, marked }) => ({ name, ...done(marked) })) };
}

/** @param {Marked} marked @param {Sources} sources @returns {Locate} */
function locator({ text, from, to }, sources) {
  const last = text.length - 1;
  return (start, end) => {
    if (last < 0) return sources.span(0, 0);
    if (start > last) return sources.span(to[last], to[last]);
    return sources.span(from[start], end > start ? to[Math.min(end - 1, last)] : from[start]);
  };
}
