/** Columns of text for a terminal. */

/**
 * @param {readonly (readonly string[])[]} rows the first is the heading
 * @param {readonly number[]} [rightAligned] columns of numbers
 * @returns {string}
 */
export function formatTable(rows, rightAligned = []) {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  const line = (/** @type {readonly string[]} */ row) =>
    row
      .map((cell, column) =>
        rightAligned.includes(column) ? cell.padStart(widths[column]) : cell.padEnd(widths[column]),
      )
      .join('  ')
      .trimEnd();
  const rule = widths.map((width) => '─'.repeat(width)).join('  ');
  const [heading, ...body] = rows.map(line);
  return [heading, rule, ...body].join('\n');
}
