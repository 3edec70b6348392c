/**
 * Free text as controllers can show it: one line of printable ASCII. What a person called something never becomes a
 * statement.
 */

/** Letters that do not come apart into a letter and an accent, and signs that people type. */
const SPELLED = new Map(
  Object.entries({
    ...{
      ß: 'ss',
      æ: 'ae',
      Æ: 'AE',
      œ: 'oe',
      Œ: 'OE',
      ø: 'o',
      Ø: 'O',
      ł: 'l',
      Ł: 'L',
      đ: 'd',
      Đ: 'D',
      þ: 'th',
      Þ: 'Th',
    },
    ...{ ð: 'd', Ð: 'D', ı: 'i', '–': '-', '—': '-', '−': '-', '‘': "'", '’': "'", '“': '"', '”': '"', '°': 'deg' },
  }),
);

/**
 * @example
 * plainText('Größe\nABORT') // → 'Grosse ABORT'
 * plainText('ロボット 2') // → '? 2'
 * @param {string} text
 * @param {number} [longest]  characters
 */
export function plainText(text, longest = Infinity) {
  const ascii = Array.from(text, (character) => SPELLED.get(character) ?? character)
    .join('')
    .normalize('NFKD')
    .replace(/\p{M}/gu, '')
    .replace(/[\s\p{C}]+/gu, ' ')
    .replace(/[^ -~]+/g, '?')
    .trim();
  return ascii.length > longest ? ascii.slice(0, longest).trimEnd() : ascii;
}

/**
 * Text in lines of at most so many characters, broken between words. A longer word is cut.
 * @param {string} text   plain
 * @param {number} width
 * @returns {string[]}
 */
export function wrapped(text, width) {
  /** @type {string[]} */
  const lines = [];
  for (const word of text.split(' ').flatMap((long) => long.match(new RegExp(`.{1,${width}}`, 'g')) ?? [])) {
    const last = lines.at(-1);
    if (last !== undefined && last.length + 1 + word.length <= width) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines;
}
