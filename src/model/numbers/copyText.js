/**
 * Numbers as text for other programs: plain, Python, MATLAB, LaTeX, JSON. Every number has all its digits, so that reading
 * it again gives the same number; what it is, its frame, convention and units stand beside it.
 *
 * @typedef {'text' | 'python' | 'matlab' | 'latex' | 'json'} CopyFormat
 *
 * @typedef {object} CopyItem
 * @property {string} name     an identifier: T_world_tool
 * @property {string} latex    the same in TeX
 * @property {string} about    what it is, with units, in one line
 * @property {readonly string[]} [labels]  of a vector's numbers
 * @property {readonly number[]} [values]  a vector
 * @property {readonly (readonly number[])[]} [rows]  or a matrix
 *
 * @typedef {object} CopySheet
 * @property {string} title    what all of it is, in one line
 * @property {readonly CopyItem[]} items
 * @property {Readonly<Record<string, unknown>>} facts  for JSON: title, frames, units, …
 */

/** @type {readonly CopyFormat[]} */
export const COPY_FORMATS = ['text', 'python', 'matlab', 'latex', 'json'];

/** The shortest decimal that is read as the same number; zero has no sign. @param {number} value */
export const digits = (value) => String(value + 0);

/** @param {number} value */
function texDigits(value) {
  const [mantissa, exponent] = digits(value).split('e');
  return exponent === undefined ? mantissa : `${mantissa} \\cdot 10^{${Number(exponent)}}`;
}

/** One line, whatever a robot is called: a line break in a name must not end a comment. @param {string} text */
const oneLine = (text) => text.replace(/\s+/g, ' ').trim();

/** @param {CopySheet} sheet @param {string} mark @param {(item: CopyItem) => string} statement */
const commented = ({ title, items }, mark, statement) =>
  [`${mark} ${oneLine(title)}`, ...items.flatMap((item) => [`${mark} ${oneLine(item.about)}`, statement(item)])].join(
    '\n',
  );

/** @param {CopySheet} sheet */
const asText = ({ title, items }) =>
  [
    oneLine(title),
    ...items.flatMap(({ about, labels, values, rows }) => [
      oneLine(about),
      ...(labels ? [labels.join('\t')] : []),
      ...(rows ?? [values ?? []]).map((row) => row.map(digits).join('\t')),
    ]),
  ].join('\n');

/** @param {readonly number[]} row */
const list = (row) => `[${row.map(digits).join(', ')}]`;

/** @param {CopySheet} sheet */
const asPython = (sheet) =>
  `import numpy as np\n\n${commented(sheet, '#', ({ name, values, rows }) =>
    rows
      ? `${name} = np.array([\n${rows.map((row) => `    ${list(row)},`).join('\n')}\n])`
      : `${name} = np.array(${list(values ?? [])})`,
  )}`;

/** @param {CopySheet} sheet */
const asMatlab = (sheet) =>
  commented(sheet, '%', ({ name, values, rows }) =>
    rows
      ? `${name} = [\n${rows.map((row) => `    ${row.map(digits).join(' ')}`).join('\n')}\n];`
      : `${name} = [${(values ?? []).map(digits).join(' ')}];`,
  );

/** @param {CopySheet} sheet */
const asLatex = (sheet) =>
  commented(sheet, '%', ({ latex, values, rows }) => {
    const lines = (rows ?? (values ?? []).map((value) => [value])).map((row) => `  ${row.map(texDigits).join(' & ')}`);
    return `\\[ ${latex} = \\begin{pmatrix}\n${lines.join(' \\\\\n')}\n\\end{pmatrix} \\]`;
  });

/** @param {CopySheet} sheet */
const asJson = ({ title, facts, items }) => {
  const numbers = items.map(({ name, labels, values, rows }) => [
    name,
    rows
      ? rows.map((row) => row.map((value) => value + 0))
      : { names: labels, values: values?.map((value) => value + 0) },
  ]);
  return JSON.stringify({ title: oneLine(title), ...facts, ...Object.fromEntries(numbers) }, null, 2);
};

/** @type {Record<CopyFormat, (sheet: CopySheet) => string>} */
const WRITERS = { text: asText, python: asPython, matlab: asMatlab, latex: asLatex, json: asJson };

/**
 * @param {CopySheet} sheet
 * @param {CopyFormat} format
 * @returns {string} lines, the last one ended
 */
export const copyText = (sheet, format) => `${WRITERS[format](sheet)}\n`;
