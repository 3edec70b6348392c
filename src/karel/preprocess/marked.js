/**
 * Text whose characters know where they were typed: for each, the offsets `from` and `to` of what it stands for, counted
 * through all sources one behind the other. A character of a macro's body stands for the call.
 *
 * @typedef {{ text: string, from: Int32Array, to: Int32Array }} Marked
 * @typedef {{ name: string | undefined, text: string, base: number, starts: readonly number[], marked: Marked }} Source
 * @typedef {ReturnType<typeof createSources>} Sources
 * @typedef {{ add: (marked: Marked, start?: number, end?: number) => void, done: () => Marked }} Writer
 */
import { lineStarts, placeOf } from '../scan/places.js';

/** The texts that take part, each with its place in the common count of offsets. */
export function createSources() {
  /** @type {Source[]} */
  const sources = [];
  return {
    /** Without carriage returns, of which the preprocessor knows nothing. @param {string | undefined} name @param {string} text @returns {Marked} */
    read(name, text) {
      const known = sources.find((one) => one.name === name && one.text === text);
      if (known) return known.marked;
      const last = sources.at(-1);
      const base = last ? last.base + last.text.length + 1 : 0;
      const bare = text.replaceAll('\r', '');
      const marked = { text: bare, from: new Int32Array(bare.length), to: new Int32Array(bare.length) };
      for (let i = 0, at = 0; i < bare.length; i++) {
        while (text[at] !== bare[i]) at++;
        marked.from[i] = base + at++;
        marked.to[i] = base + at;
      }
      sources.push({ name, text, base, starts: lineStarts(text), marked });
      return marked;
    },
    /** The place of what was typed between two offsets, in the source of the first. @param {number} from @param {number} to */
    span(from, to) {
      const source = sources.findLast(({ base }) => base <= from) ?? sources[0];
      const start = from - source.base;
      const end = Math.min(Math.max(to - source.base, start), source.text.length);
      return { start, end, ...placeOf(source.starts, start), ...(source.name !== undefined && { file: source.name }) };
    },
  };
}

/** @param {Marked} marked @param {number} start @param {number} [end] @returns {Marked} */
export function slice(marked, start, end = marked.text.length) {
  const { text, from, to } = marked;
  if (start === 0 && end === text.length) return marked;
  return { text: text.slice(start, end), from: from.subarray(start, end), to: to.subarray(start, end) };
}

/** The same characters, standing for something else. @param {string} text @param {number} from @param {number} to @returns {Marked} */
export const markedAs = (text, from, to) => ({
  text,
  from: new Int32Array(text.length).fill(from),
  to: new Int32Array(text.length).fill(to),
});

/** What a text is put together in. @returns {Writer} */
export function createWriter() {
  /** @type {{ marked: Marked, start: number, end: number }[]} */
  const parts = [];
  let length = 0;
  return {
    /** A part of a text. */
    add(marked, start = 0, end = marked.text.length) {
      const last = parts[parts.length - 1];
      length += end - start;
      if (last?.marked === marked && last.end === start) last.end = end;
      else if (end > start) parts.push({ marked, start, end });
    },
    done() {
      if (parts.length === 1) return slice(parts[0].marked, parts[0].start, parts[0].end);
      const [from, to] = [new Int32Array(length), new Int32Array(length)];
      let at = 0;
      for (const { marked, start, end } of parts) {
        for (let i = start; i < end; i++, at++) {
          from[at] = marked.from[i];
          to[at] = marked.to[i];
        }
      }
      return { text: parts.map(({ marked, start, end }) => marked.text.slice(start, end)).join(''), from, to };
    },
  };
}
