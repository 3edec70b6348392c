/**
 * Rows of cells as CSV (RFC 4180), in and out. What is written can be opened in a spreadsheet without any text of it being
 * taken for a formula; reading takes commas, semicolons or tabs between cells.
 */

/** What spreadsheets take for the beginning of a formula, the wide forms of East Asian fonts included. */
const FORMULA = /^\s*[=+\-@＝＋－＠]/;

/** @param {string | number} cell  a number is written as it is; a text that looks like a formula gets an apostrophe */
function written(cell) {
  if (typeof cell === 'number') return String(cell);
  const safe = FORMULA.test(cell) || /^[\t\r\n']/.test(cell) ? `'${cell}` : cell;
  return /[",;\t\r\n]|^\s|\s$/.test(safe) ? `"${safe.replace(/"/g, '""')}"` : safe;
}

/** @param {readonly (readonly (string | number)[])[]} rows */
export const writeCsv = (rows) => rows.map((row) => `${row.map(written).join(',')}\r\n`).join('');

/** @typedef {',' | ';' | '\t'} Separator */

/** The one of which there are most in the first line outside quotes. @param {string} text @returns {Separator} */
function separatorOf(text) {
  const line = text.replace(/"[^"]*"/g, '').split(/\r\n?|\n/, 1)[0];
  const counted = /** @type {const} */ ([';', '\t', ',']).map((sign) => ({ sign, count: line.split(sign).length }));
  return counted.reduce((most, one) => (one.count > most.count ? one : most)).sign;
}

/**
 * @param {string} text
 * @returns {{ separator: Separator, rows: { line: number, cells: string[] }[] }} rows without any text are left out; the
 *   apostrophe that guards a text from being a formula, too
 */
export function readCsv(text) {
  const plain = text.replace(/^\uFEFF/, '');
  const separator = separatorOf(plain);
  /** @type {{ line: number, cells: string[] }[]} */
  const rows = [];
  let [line, start] = [1, 1];
  /** @type {string[]} */
  let cells = [];
  let cell = '';
  let isQuoted = false;
  const endCell = () => {
    cells.push(cell.trim().replace(/^'(?=['\s]*[=+\-@＝＋－＠]|')/, ''));
    cell = '';
  };
  const endRow = () => {
    endCell();
    if (cells.some((content) => content !== '')) rows.push({ line: start, cells });
    cells = [];
    start = line;
  };
  for (let i = 0; i < plain.length; i++) {
    const character = plain[i];
    const isBreak = character === '\n' || (character === '\r' && plain[i + 1] !== '\n');
    if (isBreak) line++;
    if (isQuoted) {
      if (character !== '"') cell += character;
      else if (plain[i + 1] === '"') cell += plain[i++];
      else isQuoted = false;
    } else if (character === '"' && cell.trim() === '') isQuoted = true;
    else if (character === separator) endCell();
    else if (isBreak) endRow();
    else if (character !== '\r') cell += character;
  }
  endRow();
  return { separator, rows };
}
