/**
 * `%mode`: which characters quote, and what delimits a stretch that is expanded although it looks like one argument. Modes
 * lie on a stack; a macro is expanded in the mode in which it was defined.
 *
 * @typedef {{ start: string, end: string, escape: string }} Stretch
 * @typedef {{ quote: string, stretches: readonly Stretch[] }} Mode  the latest stretch first
 */

/** @type {Mode} */
export const FIRST_MODE = Object.freeze({ quote: '', stretches: [] });

const ARGUMENT = /"((?:[^"\\]|\\.)*)"|(\S+)/g;

/** Another mode on top of the stack. @param {Mode[]} modes @param {string} text what follows %mode @returns {string} what is not known of it, or nothing */
export function changeMode(modes, text) {
  const [keyword = '', ...rest] = [...text.matchAll(ARGUMENT)].map(([, quoted, word]) =>
    quoted === undefined ? word : `"${quoted.replace(/\\(["\\])/g, '$1')}`,
  );
  const strings = rest.filter((one) => one.startsWith('"')).map((one) => one.slice(1));
  const [modifier] = rest.filter((one) => !one.startsWith('"'));
  const mode = modes[modes.length - 1];
  const put = (/** @type {Partial<Mode>} */ change) => void (modes[modes.length - 1] = { ...mode, ...change });
  switch (keyword) {
    case 'push':
    case 'save':
      modes.push(mode);
      return '';
    case 'pop':
    case 'restore':
      if (modes.length < 2) return `${keyword} without push`;
      modes.pop();
      return '';
    case 'quote':
      put({ quote: strings[0]?.[0] ?? '' });
      return '';
    case 'string': {
      const [start, end, escape = ''] = strings;
      // Stretches that are not expanded, or keep their delimiters, are not met in public programs.
      if (modifier !== 'QQQ' || !start || !end) return `string ${modifier ?? ''}`.trim();
      put({ stretches: [{ start, end, escape: escape[0] ?? '' }, ...mode.stretches] });
      return '';
    }
    case 'nostring':
      put({ stretches: strings.length ? mode.stretches.filter(({ start }) => start !== strings[0]) : [] });
      return '';
    default:
      return keyword;
  }
}

/** The stretch that begins here, and where it ends. @param {string} text @param {number} at @param {Mode} mode */
export function stretchAt(text, at, { stretches }) {
  if (stretches.length === 0) return null;
  const stretch = stretches.find(({ start }) => text.startsWith(start, at));
  if (!stretch) return null;
  const from = at + stretch.start.length;
  for (let end = text.indexOf(stretch.end, from); end >= 0; end = text.indexOf(stretch.end, end + 1)) {
    let escapes = 0;
    while (stretch.escape && text[end - 1 - escapes] === stretch.escape && end - escapes > from) escapes++;
    if (escapes % 2 === 0) return { from, to: end, end: end + stretch.end.length };
  }
  return null;
}
