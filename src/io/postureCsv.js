/**
 * Postures as CSV: a row for each, its name and then a value for each joint, under a head with the joints' names and units.
 * The row "current" is where the arm stands.
 *
 * @import { Doc, JointDoc, Units } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 * @import { Separator } from './csv.js'
 *
 * @typedef {{ line: number, name: string, q: readonly number[] | null, reason: string | null }} PostureRow  name: '' for none
 *
 * @typedef {object} PostureReading
 * @property {readonly PostureRow[]} rows
 * @property {string | null} fault     why there are none
 * @property {boolean} hasHead
 * @property {readonly string[]} unused  heads of columns that are no joint's
 */
import { isSliding } from '../model/document.js';
import { ANGLE_UNITS, LARGEST_NUMBER, LENGTH_UNITS, PRESENT_POSTURE_ID } from '../model/documentRules.js';
import { shownText } from '../model/shownText.js';
import { convertAngle, convertLength } from '../model/units.js';
import { readCsv, writeCsv } from './csv.js';
import { fileIssue } from './fileIssues.js';

const MAX_ROWS = 1001;
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;
const UNIT = /[\s_]*[([]?\s*(deg|degrees|°|rad|radians|mm|cm|m)\s*[)\]]?$/i;
const SAME_UNIT = /** @type {Record<string, string>} */ ({ degrees: 'deg', '°': 'deg', radians: 'rad' });
const NAME_HEAD = /^(name|posture|id|label|point)?$/i;

/** @param {JointDoc} joint @param {Units} units */
const unitOf = (joint, units) => (isSliding(joint) ? units.length : units.angle);

/**
 * A joint's name in the head: one cell whatever a spreadsheet takes for the end of one.
 * @param {JointDoc} joint
 */
const nameOf = ({ label, id }) => (label ?? id).replace(/[\s,;"]+/g, ' ').trim() || id;

/** @param {Doc} doc @returns {string} */
export function writePostures({ robot, posture, postures }) {
  const head = ['name', ...robot.joints.map((joint) => `${nameOf(joint)} (${unitOf(joint, robot.units)})`)];
  const rows = [{ id: PRESENT_POSTURE_ID, q: posture }, ...postures].map(({ id, q }) => [id, ...q]);
  return writeCsv([head, ...rows]);
}

/** As a format beside those of robots (exportFormats.js). */
export const POSTURE_CSV = Object.freeze({
  id: 'csv',
  extension: 'csv',
  mediaType: 'text/csv',
  write: writePostures,
  /** @param {Doc} doc @returns {Issue[]} */
  losses: ({ robot }) => [
    fileIssue(
      'not-kept',
      `A table of postures has joint values only: not the arm, ${shownText(robot.name) || 'robot'}.`,
    ),
  ],
});

/**
 * @param {string} text
 * @param {Doc['robot']} robot
 * @returns {PostureReading}
 */
export function readPostures(text, robot) {
  const { separator, rows } = readCsv(text);
  /** @param {string} fault @returns {PostureReading} */
  const refused = (fault) => ({ rows: [], fault, hasHead: false, unused: [] });
  if (rows.length === 0) return refused('The file is empty; expected a row for each posture.');
  if (rows.length > MAX_ROWS)
    return refused(`The file has ${rows.length} rows; expected at most ${MAX_ROWS - 1} postures and a head.`);
  const count = robot.joints.length;
  const hasHead = rows[0].cells.every((cell) => numberIn(cell, separator) === null);
  const found = hasHead ? columnsByHead(rows[0].cells, robot) : null;
  if (typeof found === 'string') return refused(found);
  const body = hasHead ? rows.slice(1) : rows;
  if (body.length === 0) return refused('There is a head but no posture below it; expected a row for each.');
  /** @type {Set<string>} */
  const taken = new Set();
  const read = body.map(({ line, cells }) => {
    const row = rowOf({ line, cells, separator, count, columns: found });
    const again = row.name !== '' && taken.has(row.name);
    taken.add(row.name);
    if (!again) return row;
    return { ...row, q: null, reason: `The name "${shownText(row.name)}" stands in an earlier row already.` };
  });
  const converted = read.map((row) => ({ ...row, q: row.q && inDocument(row.q, robot, found?.units ?? null) }));
  return { rows: converted, fault: null, hasHead, unused: found?.unused ?? [] };
}

/** @typedef {{ name: number | null, joints: readonly number[], units: readonly string[], unused: readonly string[] }} Columns */

/**
 * @param {{ line: number, cells: readonly string[], separator: Separator, count: number, columns: Columns | null }} row
 * @returns {PostureRow}
 */
function rowOf({ line, cells, separator, count, columns }) {
  const hasName = cells.length > count || numberIn(cells[0], separator) === null;
  const name = columns ? (columns.name === null ? '' : (cells[columns.name] ?? '')) : hasName ? cells[0] : '';
  const values = columns ? columns.joints.map((column) => cells[column] ?? '') : cells.slice(hasName ? 1 : 0);
  const refused = (/** @type {string} */ reason) => ({ line, name, q: null, reason });
  if (values.length !== count)
    return refused(
      `The row has ${values.length} joint values; expected ${count}${columns ? '' : ', with or without a name before them'}.`,
    );
  const q = values.map((value) => numberIn(value, separator));
  const wrong = q.findIndex((value) => value === null || !(Math.abs(value) <= LARGEST_NUMBER));
  if (wrong < 0) return { line, name, q: q.map(Number), reason: null };
  const came = values[wrong] === '' ? 'nothing' : `"${shownText(values[wrong])}"`;
  return refused(
    `Joint ${wrong + 1} has ${came}; expected a number${q[wrong] === null ? '' : ` up to ${LARGEST_NUMBER}`}.`,
  );
}

/** @param {string} cell @param {Separator} separator */
function numberIn(cell, separator) {
  const plain = cell.replace(/^[−–]/, '-');
  const text = separator !== ',' && /^[+-]?\d*,\d+$/.test(plain) ? plain.replace(',', '.') : plain;
  return NUMBER.test(text) ? Number(text) : null;
}

/**
 * Which column is which joint's, by what its head says.
 * @param {readonly string[]} heads
 * @param {Doc['robot']} robot
 * @returns {Columns | string} or the reason why not
 */
function columnsByHead(heads, { joints, units }) {
  const parts = heads.map((head) => {
    const unit = UNIT.exec(head)?.[1]?.toLowerCase() ?? null;
    const bare = head.replace(UNIT, '').trim();
    return {
      head,
      bare: bare === '' ? head.trim() : bare,
      unit: unit && bare !== '' ? (SAME_UNIT[unit] ?? unit) : null,
    };
  });
  const name = parts.findIndex(({ bare }) => NAME_HEAD.test(bare));
  /** @type {Set<number>} */
  const used = new Set(name < 0 ? [] : [name]);
  const columns = [];
  const found = [];
  for (const [i, joint] of joints.entries()) {
    const names = [nameOf(joint), joint.id, `J${i + 1}`, `q${i + 1}`, `joint ${i + 1}`, `joint_${i + 1}`];
    const at = names
      .map((one) => parts.findIndex(({ bare, head }, k) => !used.has(k) && (isSame(bare, one) || isSame(head, one))))
      .find((k) => k >= 0);
    if (at === undefined)
      return `No column is named after joint ${i + 1}; expected a head such as "${shownText(nameOf(joint))} (${unitOf(joint, units)})".`;
    used.add(at);
    columns.push(at);
    const unit = isSame(parts[at].head, nameOf(joint)) ? null : parts[at].unit;
    const fit = isSliding(joint) ? LENGTH_UNITS : ANGLE_UNITS;
    if (unit !== null && !fit.some((one) => one === unit))
      return `The column "${shownText(parts[at].head)}" is in ${unit}; expected ${fit.join(' or ')}, as joint ${i + 1} ${isSliding(joint) ? 'slides' : 'turns'}.`;
    found.push(unit ?? unitOf(joint, units));
  }
  const unused = heads.filter((_, k) => !used.has(k)).map(shownText);
  return { name: name < 0 ? null : name, joints: columns, units: found, unused };
}

/** @param {string} one @param {string} other */
const isSame = (one, other) => one.trim().toLowerCase() === other.trim().toLowerCase();

/** @param {readonly number[]} q @param {Doc["robot"]} robot @param {readonly string[] | null} given  units of the columns */
const inDocument = (q, { joints, units }, given) =>
  q.map((value, i) => {
    if (given === null) return value;
    return isSliding(joints[i])
      ? convertLength(value, /** @type {Units['length']} */ (given[i]), units.length)
      : convertAngle(value, /** @type {Units['angle']} */ (given[i]), units.angle);
  });
