/** One cell of a table as text → as a person would type it here: no LaTeX, no Markdown, a decimal point. */

/** @type {readonly (readonly [RegExp, string])[]} */
const LATEX = [
  // one number, not a product: the power of ten would be rounded, and what it is multiplied with again
  [
    /(^\W*|[\w)}]\s+[-+]\s*)(\d+(?:[.,]\d+)?)\s*\\(?:cdot|times)\s*10\s*\^\s*(?:\{\s*([-+]?\d+)\s*\}|(\d))/g,
    '$1$2e$3$4',
  ],
  [/\\(left|right|displaystyle|mathrm|mathit|mathbf|text|textbf|rm|bm|boldsymbol)(?![A-Za-z])/g, ''],
  [/\\[,;:! ]|~|\\q?quad(?![A-Za-z])/g, ' '],
  [/\^\s*\{?\s*\\circ\s*\}?|\\degree(?![A-Za-z])|\\textdegree(?![A-Za-z])|&deg;/g, '°'],
  [/\^\s*\{?\s*(\*|\\ast|\\star)\s*\}?|\\ast(?![A-Za-z])/g, '*'],
  [/\\(cdot|times)(?![A-Za-z])/g, '*'],
  [/\\pi(?![A-Za-z])/g, 'π'],
  [/\\(var)?theta(?![A-Za-z])/g, 'θ'],
  [/\\alpha(?![A-Za-z])/g, 'α'],
  [/\\#/g, '#'],
  [/\\[()[\]]|\$/g, ''],
];

/**
 * @param {string} text
 * @param {boolean} hasCommas  whether a comma between digits is a decimal one
 */
export function plainCell(text, hasCommas) {
  let cell = text.replace(/[\u00a0\u2000-\u200a\u202f]/g, ' ').replace(/[\u200b-\u200f\u2060\ufeff]/g, '');
  for (const [sign, plain] of LATEX) cell = cell.replace(sign, plain);
  // From the inside out, so that fractions of fractions are read; each turn takes one pair of braces away.
  for (let turns = 0; turns < 8 && cell.includes('\\'); turns++) {
    cell = cell
      .replace(/\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g, (_, over, under) => `${whole(over)}/${whole(under)}`)
      .replace(/\\[dt]?frac\s*(\d)\s*(\d)/g, '$1/$2')
      .replace(/\\sqrt\s*\{([^{}]*)\}/g, 'sqrt($1)');
  }
  cell = cell.replace(/[{}]/g, '');
  cell = cell
    .trim()
    .replace(/^(\*\*|__|`)(.*)\1$/, '$2')
    .replace(/\\([*_|])/g, '$1');
  if (hasCommas) cell = cell.replace(/(\d),(\d)/g, '$1.$2');
  return cell.replace(/\s+/g, ' ').trim();
}

/** In brackets, if it is more than one word. @param {string} part */
const whole = (part) => (/^[\w.π\\]+$/.test(part.trim()) ? part.trim() : `(${part.trim()})`);
