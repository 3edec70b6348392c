/**
 * What a pasted table will do to the document: the command, every cell of it with the number it comes to or the reason
 * why it comes to none, and what changes. Pure; the dialog draws it.
 *
 * @import { ColumnGuess, ColumnRole, PastedCell, PastedUnits } from '../../io/tableTextColumns.js'
 * @import { Convention, DhField, RobotDoc, Units } from '../../model/document.js'
 * @import { TableCommand, TableRow } from '../../model/robot/tableCommand.js'
 *
 * @typedef {object} PlanCell
 * @property {string} raw
 * @property {number | null} value   in the document's units
 * @property {string} [text]         to be kept
 * @property {string | null} reason  why there is no value
 * @property {boolean} isNew         another number than now
 *
 * @typedef {{ joint: number, type: 'revolute' | 'prismatic' | null, isRetyped: boolean, cells: Partial<Record<DhField, PlanCell>> }} PlanRow
 *
 * @typedef {object} Plan
 * @property {readonly PlanRow[]} rows
 * @property {readonly string[]} faults  none of them: the command can be carried out
 * @property {boolean} hasPi
 * @property {number} changes
 * @property {number} longest  of the lengths that are given, in the document's unit
 * @property {TableCommand} command
 */
import { readPastedRow } from '../../io/tableTextColumns.js';
import { DH_FIELDS, MAX_JOINTS, MIN_JOINTS, isSliding } from '../../model/document.js';
import { convertAngle, convertLength } from '../../model/units.js';
import { evaluate } from '../parts/expression.js';
import { readNumber } from '../parts/numberText.js';
import { PASTE } from '../words/pasteTable.js';

/**
 * @param {RobotDoc} robot
 * @param {object} given
 * @param {readonly (readonly string[])[]} given.rows  without the head
 * @param {readonly ColumnRole[]} given.roles
 * @param {PastedUnits} given.units
 * @param {ColumnGuess['others']} [given.others]
 * @param {Convention} given.convention
 * @param {number | null} given.from  the joint that the first row goes to; null: the rows are the whole table
 * @returns {Plan}
 */
export function planPaste(robot, { rows, roles, units, others = {}, convention, from }) {
  const first = from ?? 0;
  const faults = [];
  let hasPi = false;
  const planned = rows.map((row, i) => {
    const { type, cells } = readPastedRow(row, roles);
    const old = robot.joints.at(first + i);
    /** @type {PlanRow['cells']} */
    const plan = {};
    for (const field of DH_FIELDS) {
      const cell = cells[field];
      if (!cell) continue;
      const read = readCell(cell, field, { ...units, ...others[field] }, robot.units);
      hasPi ||= read.hasPi;
      plan[field] = {
        raw: cell.raw,
        ...read.cell,
        isNew: read.cell.value !== null && read.cell.value !== (old?.[field] ?? 0),
      };
    }
    const isRetyped = type !== null && isSliding(old ?? { type: 'revolute' }) !== isSliding({ type });
    return { joint: first + i, type, isRetyped, cells: plan };
  });
  if (from === null && (rows.length < MIN_JOINTS || rows.length > MAX_JOINTS)) faults.push(PASTE.joints(rows.length));
  if (from !== null && from + rows.length > robot.joints.length) {
    faults.push(PASTE.overflow(from + 1, robot.joints.length - from));
  }
  if (!roles.some((role) => role !== 'none' && role !== 'offset')) faults.push(PASTE.noColumns);
  for (const { joint, cells } of planned) {
    for (const field of DH_FIELDS) {
      const reason = cells[field]?.reason;
      if (reason) faults.push(`${PASTE.at(joint + 1, PASTE.role[field])} ${reason}`);
    }
  }
  const changed = planned.flatMap(({ cells }) => DH_FIELDS.filter((field) => cells[field]?.isNew));
  const command = commandOf(robot, planned, from === null ? convention : robot.convention, from);
  const longest = Math.max(
    0,
    ...planned.flatMap(({ cells: { a, d } }) => [a, d].map((cell) => Math.abs(cell?.value ?? 0))),
  );
  return { rows: planned, faults, hasPi, changes: changed.length, longest, command };
}

/**
 * @param {PastedCell} cell @param {DhField} field @param {PastedUnits} pasted @param {Units} target
 * @returns {{ cell: { value: number | null, text?: string, reason: string | null }, hasPi: boolean }}
 */
function readCell({ raw, text: typed, fault }, field, pasted, target) {
  const against = (/** @type {string} */ reason) => ({ cell: { value: null, reason }, hasPi: false });
  if (fault) return against(PASTE.cell[fault](raw));
  if (typed === '') return against(PASTE.cell.empty);
  const quantity = field === 'a' || field === 'd' ? 'length' : 'angle';
  const isInches = quantity === 'length' && pasted.length === 'in';
  const units = /** @type {Units} */ ({ ...pasted, ...(pasted.length === 'in' && { length: target.length }) });
  const convert = (/** @type {number} */ value, /** @type {Units['angle']} */ angle) =>
    quantity === 'length'
      ? convertLength(value, units.length, target.length)
      : convertAngle(value, angle, target.angle);
  const plain = readNumber(typed);
  if (plain.reason === null && (!isInches || plain.value === 0)) {
    return { cell: { value: convert(plain.value, units.angle), reason: null }, hasPi: false };
  }
  const isBareInches = isInches && (plain.reason === null || evaluate(typed, quantity, units).found?.isBare);
  const text = !isBareInches ? typed : `${plain.reason === null ? typed : `(${typed})`} in`;
  const { found, reason } = evaluate(text, quantity, units);
  if (reason !== null) return against(`“${raw}”: ${reason}`);
  const angle = found.isUnclear ? 'rad' : units.angle;
  const value = convert(found.value, angle);
  const own = quantity === 'length' ? units.length : angle;
  const isSame = !found.isBare || own === target[quantity];
  const whole = /[-+−]/.test(text.slice(1)) ? `(${text})` : text;
  const kept = isSame ? text : found.hasBareTurns ? undefined : `${whole} ${own}`;
  return { cell: { value, reason: null, ...(kept !== undefined && { text: kept }) }, hasPi: found.isUnclear };
}

/** @param {RobotDoc} robot @param {readonly PlanRow[]} planned @param {Convention} convention @param {number | null} from @returns {TableCommand} */
function commandOf(robot, planned, convention, from) {
  const rows = planned.map(({ type, cells }) => {
    /** @type {TableRow} */
    const row = { ...(type && { type }), numbers: {}, texts: {} };
    for (const field of DH_FIELDS) {
      const { value, text } = cells[field] ?? {};
      if (value === undefined || value === null) continue;
      row.numbers[field] = value;
      if (text !== undefined && row.texts) row.texts[field] = text;
    }
    return row;
  });
  const untouched = (/** @type {number} */ count) =>
    Array.from({ length: Math.max(0, count) }, () => ({ numbers: {} }));
  const all =
    from === null ? rows : [...untouched(from), ...rows, ...untouched(robot.joints.length - from - rows.length)];
  return { type: 'set-table', rows: all, convention };
}
