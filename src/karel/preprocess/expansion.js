/**
 * Text → text with its macros expanded and its directives obeyed, by the rules of the preprocessor that `ktransw` runs (GPP,
 * in the mode that `ktransw` sets): a macro is a name anywhere, in strings and comments too; arguments are expanded before
 * they are put in; a name that stands for another name hands its arguments on.
 *
 * @import { Marked, Sources, Writer } from './marked.js'
 * @import { Mode } from './modes.js'
 *
 * @typedef {{ names: readonly string[] | null, body: Marked, mode: Mode, isAlias: boolean }} Macro
 * @typedef {{ args: readonly Marked[] | null, names: readonly string[] | null, hidden: ReadonlySet<string> }} Context
 *   what a body is expanded with: its arguments, by number and by name, and the macros that it is inside of
 * @typedef {{ isMet: boolean, wasMet: boolean, isOutsideMet: boolean }} Branch
 * @typedef {object} Expansion
 * @property {Sources} sources
 * @property {(name: string) => string | undefined} fileNamed
 * @property {(code: string, message: string, from: number, to: number, severity?: 'error' | 'warning') => void} report
 * @property {() => void} onGap            something is not at hand
 * @property {Map<string, Macro>} macros
 * @property {Mode[]} modes
 * @property {Branch[]} branches
 * @property {number} depth
 * @property {number} length               of what came out, and of what was thrown away
 * @property {(marked: Marked, at: number, context: Context, run: Expansion, out: Writer) => number | null} obey
 *   the directive at a place of a text; where the text goes on, or null if there is none
 *
 * @typedef {Pick<Expansion, 'sources' | 'fileNamed' | 'report' | 'onGap' | 'obey'>} Host
 */
import { macroArguments } from './delimiting.js';
import { createWriter, markedAs, slice } from './marked.js';
import { FIRST_MODE, stretchAt } from './modes.js';

const NAME = /[A-Za-z0-9_]+/y;
/** What no directive, no reference and no name begins with. */
const PLAIN = /[^A-Za-z0-9_%#]+/y;
const REFERENCE = /#[1-9]/;
/** Deeper, and longer, than any text that anybody wants. */
const MAX_DEPTH = 200;
const MAX_LENGTH = 400_000;
/** A file counts for so many characters more, so that files without any come to an end, too. */
const FILE_LENGTH = 100;
/** @type {Context} */
const OUTSIDE = { args: null, names: null, hidden: new Set() };

/**
 * One run of the preprocessor over one text; macros are those of this run.
 * @param {Marked} marked @param {Host} host @returns {Marked}
 */
export function expandText(marked, host) {
  /** @type {Expansion} */
  const run = { ...host, macros: new Map(), modes: [FIRST_MODE], branches: [], depth: 0, length: 0 };
  const out = createWriter();
  expandInto(marked, OUTSIDE, run, out);
  if (run.length <= MAX_LENGTH) return out.done();
  const message = `Expected at most ${MAX_LENGTH} characters when all macros are expanded, got more.`;
  host.report('macro', message, marked.from[0], marked.to[0], 'error');
  return slice(marked, 0, 0);
}

/** @param {Marked} marked @param {Context} context @param {Expansion} run @returns {Marked} */
export function expanded(marked, context, run) {
  const out = createWriter();
  expandInto(marked, context, run, out);
  return out.done();
}

/** Whether what is read now counts. @param {Expansion} run */
export const isActive = ({ branches }) => branches.length === 0 || branches[branches.length - 1].isMet;

/** A file in place of its name, with the macros of the run. @param {Marked} marked @param {Expansion} run @param {Writer} out */
export function expandFile(marked, run, out) {
  run.length += FILE_LENGTH;
  run.modes.push(run.modes[run.modes.length - 1]);
  expandInto(marked, OUTSIDE, run, out);
  if (run.modes.length > 1) run.modes.pop();
}

/** @param {Marked} marked @param {Context} context @param {Expansion} run @param {Writer} out */
function expandInto(marked, context, run, out) {
  if (run.depth >= MAX_DEPTH || run.length > MAX_LENGTH) return;
  run.depth++;
  const { text } = marked;
  for (let at = 0; at < text.length && run.length <= MAX_LENGTH;) {
    const mode = run.modes[run.modes.length - 1];
    const character = text[at];
    const put = (/** @type {number} */ start, /** @type {number} */ end) => {
      run.length += end - start;
      if (isActive(run)) out.add(marked, start, end);
    };
    if (mode === FIRST_MODE && context === OUTSIDE && !isActive(run) && character !== '%') {
      const line = text.indexOf('\n%', at);
      at = line < 0 ? text.length : line + 1;
      continue;
    }
    if (mode === FIRST_MODE) {
      PLAIN.lastIndex = at;
      const [plain] = PLAIN.exec(text) ?? [''];
      if (plain) {
        put(at, (at += plain.length));
        continue;
      }
    }
    const stretch = stretchAt(text, at, mode);
    if (stretch) {
      expandInto(slice(marked, stretch.from, stretch.to), context, run, out);
      at = stretch.end;
      continue;
    }
    if (character === '%' && (at === 0 || text[at - 1] === '\n')) {
      const end = run.obey(marked, at, context, run, out);
      if (end !== null) {
        at = end;
        continue;
      }
    }
    if (character === '#' && context.args && REFERENCE.test(text.slice(at, at + 2))) {
      const arg = context.args[Number(text[at + 1]) - 1];
      if (arg && isActive(run)) out.add(arg);
      at += 2;
      continue;
    }
    if (mode.quote && character === mode.quote) {
      put(at + 1, Math.min(at + 2, text.length));
      at += 2;
      continue;
    }
    NAME.lastIndex = at;
    const [name] = NAME.exec(text) ?? [''];
    if (name) at = expandName(name, marked, at, context, run, out, put);
    else put(at, ++at);
  }
  run.depth--;
}

/**
 * @param {string} name @param {Marked} marked @param {number} at @param {Context} context @param {Expansion} run @param {Writer} out
 * @param {(start: number, end: number) => void} put @returns {number} behind what was used
 */
function expandName(name, marked, at, context, run, out, put) {
  const end = at + name.length;
  const own = context.args ? (context.names?.indexOf(name) ?? -1) : -1;
  if (own >= 0) {
    const arg = context.args?.[own];
    if (arg && isActive(run)) out.add(arg);
    return end;
  }
  // What does not count is expanded too: it may end its condition.
  const macro = context.hidden.has(name) ? undefined : run.macros.get(name);
  if (!macro) {
    put(at, end);
    return end;
  }
  const { text } = marked;
  const mode = run.modes[run.modes.length - 1];
  const call = text[end] === '(' ? macroArguments(text, end, mode) : null;
  const [from, to] = [marked.from[at], marked.to[end - 1]];
  if (text[end] === '(' && !call) {
    if (isActive(run)) run.report('macro', `Expected ")" behind the arguments of the macro "${name}".`, from, to);
    put(at, end);
    return end;
  }
  run.length++;
  if (macro.body.text === '') return call?.end ?? end;
  const args = call?.args.map((arg) => expanded(slice(marked, arg.from, arg.to), context, run)) ?? [];
  const hidden = new Set([...context.hidden, name]);
  run.modes.push(macro.mode);
  if (macro.isAlias) {
    const body = createWriter();
    body.add(markedAs(macro.body.text, from, to));
    if (call) {
      for (const [i, arg] of args.entries()) {
        const before = call.args[i].from - 1;
        body.add(marked, before, before + 1);
        body.add(arg);
      }
      body.add(marked, call.end - 1, call.end);
    }
    expandInto(body.done(), { args: null, names: null, hidden }, run, out);
  } else {
    const last = call ? Math.max(to, marked.to[call.end - 1]) : to;
    expandInto(markedAs(macro.body.text, from, last), { args, names: macro.names, hidden }, run, out);
  }
  if (run.modes.length > 1) run.modes.pop();
  return call?.end ?? end;
}

/** @param {readonly string[] | null} names @param {Marked} body @param {Expansion} run @returns {Macro} */
export const macroOf = (names, body, run) => ({
  names,
  body,
  mode: run.modes[run.modes.length - 1],
  isAlias: !names && !REFERENCE.test(body.text),
});
