/**
 * What the preprocessor's directives do: definitions, conditions, files, modes. A directive begins its line with %; KAREL's
 * own, and those that nobody knows, are left in the text for the translator. Public packages write them in small and in
 * capital letters.
 *
 * @import { Context, Expansion } from './expansion.js'
 * @import { Marked, Writer } from './marked.js'
 */
import { calculated } from './arithmetic.js';
import { directiveArguments, firstArgument } from './delimiting.js';
import { expanded, expandFile, isActive, macroOf } from './expansion.js';
import { markedAs, slice } from './marked.js';
import { changeMode } from './modes.js';

const DIRECTIVE = /%[ \t]*([A-Za-z_][A-Za-z0-9_]*)/y;
const CONDITIONS = new Set(['ifdef', 'ifndef', 'ifeq', 'ifneq', 'if', 'elif', 'else', 'endif']);
const OTHERS = new Set(['define', 'defeval', 'undef', 'include', 'eval', 'mode', 'error', 'warning']);
/** What depends on the clock or on another program has no place here. */
const REFUSED = new Set(['exec', 'date', 'line', 'file']);
const MAX_INCLUDES = 40;

/** @typedef {{ text: string, written: string, from: number, to: number, all: Marked, context: Context, run: Expansion, out: Writer, first: () => { first: Marked, rest: Marked } }} Use */

/**
 * @param {Marked} marked @param {number} at  of the % @param {Context} context @param {Expansion} run @param {Writer} out
 * @returns {number | null} where the text goes on; null if this is none of the preprocessor's directives
 */
export function obeyDirective(marked, at, context, run, out) {
  const { text } = marked;
  DIRECTIVE.lastIndex = at;
  const [whole = '', written = ''] = DIRECTIVE.exec(text) ?? [];
  const word = written.toLowerCase();
  if (!CONDITIONS.has(word) && !OTHERS.has(word) && !REFUSED.has(word)) return null;
  const mode = run.modes[run.modes.length - 1];
  const place = directiveArguments(text, at + whole.length, mode);
  if (!place) return null;
  const last = Math.max(at, Math.max(place.to, at + whole.length) - 1);
  /** @type {Use} */
  const use = {
    text: text.slice(place.from, place.to),
    written,
    from: marked.from[at],
    to: marked.to[last],
    all: slice(marked, place.from, place.to),
    context,
    run,
    out,
    first() {
      const { end, rest } = firstArgument(text, place.from, place.to, mode);
      return { first: slice(marked, place.from, end), rest: slice(marked, rest, place.to) };
    },
  };
  if (CONDITIONS.has(word)) obeyCondition(word, use);
  else if (isActive(run)) {
    if (REFUSED.has(word)) refuse(`%${word}`, use);
    else OBEY[word](use);
  }
  return place.end;
}

/** @param {string} what @param {Use} use */
function refuse(what, { run, from, to }) {
  run.onGap();
  run.report(
    'preprocessor',
    `${what} of the preprocessor is not expanded here; what it would bring is missing.`,
    from,
    to,
  );
}

/** @type {Readonly<Record<string, (use: Use) => void>>} */
const OBEY = {
  define: (use) => define(use, false),
  defeval: (use) => define(use, true),
  undef: ({ text, run }) => void run.macros.delete(text.trim()),
  include,
  eval({ all, context, run, out, from, to }) {
    const { text } = expandedCondition(all, context, run);
    out.add(markedAs(calculated(text), from, to));
  },
  mode(use) {
    const unknown = changeMode(use.run.modes, use.text);
    if (unknown) refuse(`%mode ${unknown}`, use);
  },
  error: ({ text, run, from, to }) => run.report('preprocessor', `%error: ${text.trim()}`, from, to, 'error'),
  warning: ({ text, run, from, to }) => run.report('preprocessor', `%warning: ${text.trim()}`, from, to),
};

/** @param {Use} use @param {boolean} atOnce  whether the body is expanded now */
function define({ all, text, run, context, from, to }, atOnce) {
  const match = /^([A-Za-z0-9_]+)(?:\(([^()]*)\))?(?=\s|$)[ \t]*/.exec(text);
  if (!match) {
    run.report('preprocessor', 'Expected a name, and a blank, behind %define.', from, to);
    return;
  }
  const [head, name, list] = match;
  const names = list === undefined ? null : list.split(',').map((one) => one.trim());
  const body = slice(all, head.length);
  run.macros.set(name, macroOf(names, atOnce ? expanded(body, context, run) : body, run));
}

/** @param {Use} use */
function include({ text, written, run, out, from, to }) {
  const name = text
    .replace(/\s+--.*$/, '')
    .trim()
    .replace(/^(["'<])(.*)["'>]$/, '$2');
  const found = run.fileNamed(name);
  // The translator includes files too: those without an ending, and .kl.
  const isForTranslator = /^[^.]*$|\.kl$/i.test(name);
  if (isForTranslator && (found === undefined || written === 'INCLUDE'))
    out.add(markedAs(`%INCLUDE ${name}\n`, from, to));
  else if (found === undefined) {
    run.onGap();
    run.report('include', `%include of "${name}": no such file is at hand; what it would bring is missing.`, from, to);
  } else if (run.depth > MAX_INCLUDES)
    run.report('include', `%include of "${name}": more than ${MAX_INCLUDES} files inside each other.`, from, to);
  else expandFile(run.sources.read(name, withLastLineEnded(found)), run, out);
}

/** What follows a file begins a line. @param {string} text */
const withLastLineEnded = (text) => (/(^|[\r\n])$/.test(text) ? text : `${text}\n`);

/** @param {string} word @param {Use} use */
function obeyCondition(word, use) {
  const { branches, report } = use.run;
  const last = branches[branches.length - 1];
  if ((word === 'else' || word === 'elif' || word === 'endif') && !last) {
    report('preprocessor', `%${word} without %if.`, use.from, use.to);
  } else if (word === 'endif') branches.pop();
  else if (word === 'else') {
    last.isMet = last.isOutsideMet && !last.wasMet;
    last.wasMet = true;
  } else if (word === 'elif') {
    last.isMet = last.isOutsideMet && !last.wasMet && isMet('if', use);
    last.wasMet ||= last.isMet;
  } else {
    const isOutsideMet = isActive(use.run);
    const met = isOutsideMet && isMet(word, use);
    branches.push({ isMet: met, wasMet: met, isOutsideMet });
  }
}

/** @param {string} word @param {Use} use */
function isMet(word, use) {
  const { all, context, run } = use;
  const { first, rest } = use.first();
  if (word === 'ifdef') return run.macros.has(first.text);
  if (word === 'ifndef') return !run.macros.has(first.text);
  if (word === 'if') return calculated(expandedCondition(all, context, run).text).trim() !== '0';
  if (rest.text.trim() === '')
    run.report('preprocessor', `Expected two texts to compare behind %${word}, got "${use.text}".`, use.from, use.to);
  const [left, right] = [first, rest].map((one) => expanded(one, context, run).text.trim());
  return (left === right) === (word === 'ifeq');
}

/** `defined(x)` looks at the name and not at what it stands for. @param {Marked} all @param {Context} context @param {Expansion} run */
function expandedCondition(all, context, run) {
  const text = all.text.replace(/\bdefined\s*\(\s*([A-Za-z0-9_]+)\s*\)/g, (_, name) =>
    run.macros.has(name) ? '1' : '0',
  );
  return expanded(
    text === all.text ? all : markedAs(text, all.from[0] ?? 0, all.to[all.to.length - 1] ?? 0),
    context,
    run,
  );
}
