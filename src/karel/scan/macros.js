/**
 * Macros: names that stand for text, with or without parameters, and what becomes of a line in which they are used. Strings
 * and comments are left alone; a macro is not expanded inside of itself.
 *
 * @typedef {{ parameters: readonly string[] | null, body: string }} Macro
 * @typedef {{ text: string, start: number, end: number }} Piece  text, and the characters of the line that it came from
 */

/** Longer text comes from macros that call each other, and from nothing that anybody wants. */
const MAX_TEXT = 100_000;

const PART = /'(?:[^'\r\n]|'')*'|--.*|[A-Za-z_][A-Za-z0-9_]*|[^'A-Za-z_-]+|./gs;

/** @param {string} line @param {ReadonlyMap<string, Macro>} macros @returns {Piece[]} */
export function expandLine(line, macros) {
  /** @type {Piece[]} */
  const pieces = [];
  PART.lastIndex = 0;
  for (let at = 0; at < line.length;) {
    PART.lastIndex = at;
    const [part] = PART.exec(line) ?? [line.slice(at)];
    const macro = macros.get(part);
    const use = macro && useOf(line, at + part.length, macro);
    if (macro && use) {
      pieces.push({ text: bodyOf(macro, use.args, macros, new Set([part])), start: at, end: use.end });
      at = use.end;
    } else {
      pieces.push({ text: part, start: at, end: at + part.length });
      at += part.length;
    }
  }
  return pieces;
}

/** @param {string} text @param {ReadonlyMap<string, Macro>} macros @param {ReadonlySet<string>} [hidden] @returns {string} */
export function expandText(text, macros, hidden = new Set()) {
  let out = '';
  for (let at = 0; at < text.length && out.length < MAX_TEXT;) {
    PART.lastIndex = at;
    const [part] = PART.exec(text) ?? [text.slice(at)];
    const macro = hidden.has(part) ? undefined : macros.get(part);
    const use = macro && useOf(text, at + part.length, macro);
    if (macro && use) out += bodyOf(macro, use.args, macros, new Set([...hidden, part]));
    else out += part;
    at = use?.end ?? at + part.length;
  }
  return out;
}

/** @param {Macro} macro @param {readonly string[]} args @param {ReadonlyMap<string, Macro>} macros @param {ReadonlySet<string>} hidden */
function bodyOf({ parameters, body }, args, macros, hidden) {
  if (!parameters) return expandText(body, macros, hidden);
  const values = new Map(parameters.map((name, i) => [name, expandText(args[i] ?? '', macros, hidden)]));
  const filled = body.replace(/[A-Za-z_][A-Za-z0-9_]*/g, (word) => values.get(word) ?? word).replaceAll('##', '');
  return filled.length > MAX_TEXT ? '' : expandText(filled, macros, hidden);
}

/** The arguments of a macro, if it is used here. @param {string} text @param {number} at behind its name @param {Macro} macro */
function useOf(text, at, { parameters }) {
  if (!parameters) return { args: [], end: at };
  if (text[at] !== '(') return null;
  const args = [''];
  let depth = 0;
  for (let i = at + 1; i < text.length; i++) {
    const character = text[i];
    if (character === ')' && depth === 0) return { args: args.map((arg) => arg.trim()), end: i + 1 };
    if (character === ',' && depth === 0) args.push('');
    else args[args.length - 1] += character;
    if (character === '(') depth++;
    if (character === ')') depth--;
  }
  return null;
}
