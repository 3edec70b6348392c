/**
 * Where the arguments of a directive and of a macro begin and end, by characters alone: nothing is expanded here.
 *
 * @import { Mode } from './modes.js'
 */
import { stretchAt } from './modes.js';

/**
 * What follows the name of a directive: up to the end of the line, except that a line end inside of a stretch is none.
 * Null if what follows is no argument at all.
 * @param {string} text @param {number} at  behind the name @param {Mode} mode
 */
export function directiveArguments(text, at, mode) {
  if (at < text.length && !/[ \t\n]/.test(text[at])) return null;
  let from = at;
  while (text[from] === ' ' || text[from] === '\t') from++;
  let to = from;
  while (to < text.length && text[to] !== '\n') to = stretchAt(text, to, mode)?.end ?? to + 1;
  return { from, to: Math.min(to, text.length), end: Math.min(to + 1, text.length) };
}

/** The first of two arguments, by the blank behind it. @param {string} text @param {number} from @param {number} to @param {Mode} mode */
export function firstArgument(text, from, to, mode) {
  let end = from;
  while (end < to && text[end] !== ' ' && text[end] !== '\t') end = stretchAt(text, end, mode)?.end ?? end + 1;
  let rest = end;
  while (rest < to && (text[rest] === ' ' || text[rest] === '\t')) rest++;
  return { end, rest };
}

/** The arguments of a macro, from its opening parenthesis; null if it is never closed. @param {string} text @param {number} open @param {Mode} mode */
export function macroArguments(text, open, mode) {
  /** @type {{ from: number, to: number }[]} */
  const args = [];
  let from = open + 1;
  let depth = 0;
  for (let at = from; at < text.length;) {
    const stretch = stretchAt(text, at, mode);
    if (stretch) {
      at = stretch.end;
      continue;
    }
    // What is quoted neither opens nor closes.
    if (mode.quote && text[at] === mode.quote) {
      at += 2;
      continue;
    }
    if (depth === 0 && (text[at] === ')' || text[at] === ',')) {
      args.push({ from, to: at });
      if (text[at] === ')') return { args, end: at + 1 };
      from = at + 1;
    } else if (text[at] === '(') depth++;
    else if (text[at] === ')') depth--;
    at++;
  }
  return null;
}
