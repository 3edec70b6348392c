/**
 * A table as text, from a spreadsheet, a CSV file, Markdown, LaTeX or a console → its cells as plain text. Whatever the text
 * is, reading does not throw; what is too much is refused.
 *
 * @typedef {'tabs' | 'semicolons' | 'commas' | 'bars' | 'latex' | 'blanks'} TableFormat
 * @typedef {{ readonly format: TableFormat, readonly rows: readonly (readonly string[])[] }} TextTable  every row as long as the longest
 * @typedef {{ table: TextTable, fault: null } | { table: null, fault: 'too-long' | 'too-many' | 'no-table' }} TableReading
 */
import { plainCell } from './tableTextCell.js';

export const MAX_TABLE_TEXT = 20_000;
const MAX_ROWS = 40;
const MAX_COLUMNS = 16;

/**
 * @param {string} text
 * @returns {TableReading}
 */
export function readTableText(text) {
  if (text.length > MAX_TABLE_TEXT) return { table: null, fault: 'too-long' };
  const lines = text
    .replace(/\r\n?/g, '\n')
    .split('\n')
    .filter((line) => line.trim() !== '');
  const format = formatOf(text, lines);
  const rows = (
    format === 'latex' ? latexRows(text) : lines.filter((line) => !isRule(line)).map((line) => cellsOf(line, format))
  )
    .map((row) => row.map((cell) => plainCell(cell, format !== 'commas')))
    .filter((row) => row.some((cell) => cell !== ''));
  const width = rows.reduce((most, row) => Math.max(most, row.length), 0);
  if (rows.length > MAX_ROWS || width > MAX_COLUMNS) return { table: null, fault: 'too-many' };
  if (rows.length * width < 2) return { table: null, fault: 'no-table' };
  const full = rows.map((row) => [...row, ...Array(width - row.length).fill('')]);
  return { table: { format, rows: withoutEmptyColumns(full) }, fault: null };
}

/** @param {string} text @param {readonly string[]} lines @returns {TableFormat} */
function formatOf(text, lines) {
  if (/\\begin\s*\{|\\\\|(^|[^\\])&/.test(text)) return 'latex';
  if (lines.some((line) => line.includes('\t'))) return 'tabs';
  if (lines.filter((line) => /[|│┃║]/.test(line)).length >= Math.min(2, lines.length)) return 'bars';
  if (lines.every((line) => line.includes(';'))) return 'semicolons';
  // One comma in a line may be a decimal one; two are a list.
  if (lines.every((line) => line.includes(',')) && lines.some((line) => line.split(',').length > 2)) return 'commas';
  return 'blanks';
}

/** A line that only draws: of Markdown's head, or of a box. @param {string} line */
const isRule = (line) => /^[\s|:+=\u2500-\u257f-]*$/.test(line) && /[-=\u2500-\u257f]{2}/.test(line);

const SIGNS = { tabs: '\t', semicolons: ';', commas: ',' };

/** @param {string} line @param {Exclude<TableFormat, 'latex'>} format @returns {string[]} */
function cellsOf(line, format) {
  if (format === 'blanks')
    return line
      .trim()
      .replace(/^\[|\]$/g, '')
      .split(/\s{2,}|(?<=[\w)°π])\s+(?=[-+−]?[\d.πpqθ])/);
  if (format === 'bars')
    return line
      .trim()
      .replace(/^[|│┃║]|[|│┃║]$/g, '')
      .split(/[|│┃║]/);
  return quotedCells(line, SIGNS[format]);
}

/** Cells that may stand in quotes, with the sign between cells or a doubled quote in them. @param {string} line @param {string} sign */
function quotedCells(line, sign) {
  const cells = [];
  let cell = '';
  let isQuoted = false;
  for (let i = 0; i < line.length; i++) {
    const character = line[i];
    if (isQuoted && character === '"' && line[i + 1] === '"') cell += line[i++];
    else if (character === '"' && (isQuoted || cell.trim() === '')) isQuoted = !isQuoted;
    else if (character === sign && !isQuoted) {
      cells.push(cell);
      cell = '';
    } else cell += character;
  }
  return [...cells, cell];
}

/** @param {string} text @returns {string[][]} */
function latexRows(text) {
  const begin = /\\begin\s*\{(tabular|array|[bpv]?matrix|table)\*?\}/g;
  let body = text;
  for (const match of text.matchAll(begin)) body = text.slice((match.index ?? 0) + match[0].length); // the innermost
  return body
    .replace(/\\end\s*\{[\s\S]*$/, '')
    .replace(/^\s*(\[[^\]]*\])?\s*\{[^&]*?\}\s*(?=[\\\n$\w])/, (columns) =>
      /^[\s{}|lcrpmS@!<>.\d[\]]*$/.test(columns) ? '' : columns,
    )
    .replace(/(^|[^\\])%.*$/gm, '$1')
    .replace(/\\(hline|toprule|midrule|bottomrule|cline\s*\{[^}]*\}|centering|caption\s*\{[^}]*\})/g, ' ')
    .split(/\\\\(?:\s*\[[^\]]*\])?/)
    .map((row) => row.split(/(?<!\\)&/));
}

/** @param {string[][]} rows */
function withoutEmptyColumns(rows) {
  const kept = rows[0].map((_, column) => rows.some((row) => row[column] !== ''));
  return rows.map((row) => row.filter((__, column) => kept[column]));
}
