/**
 * Motion instructions: `J P[1] 100% FINE`, `L PR[2:home] 250mm/sec CNT50 ACC80 Offset,PR[3]`, `C P[3] P[4] 100mm/sec FINE`.
 *
 * @import { TpCursor } from './cursor.js'
 * @import { TpMotion, TpMotionType, TpOption, TpSpeed, TpSpeedUnit, TpTermination } from './tree.js'
 */
import { readExpression, readOperand, readRegister } from './operands.js';
import { number } from './tree.js';

const PLACES = ['P', 'PR'];
const UNIT = /%|msec\b|sec\b|mm\/sec\b|cm\/min\b|inch\/min\b|deg\/sec\b/y;

/** An option's name, glued to its number or followed by a comma. */
const OPTION =
  /(ACC|Tool_Offset|TOOL_OFFSET|Offset|OFFSET|Skip|SKIP|INC|Wjnt|RTCP|PTH|BREAK|COORD|MROT|RT_LD|AP_LD|EV|TB|TA|DB)(?![A-Za-z_])/y;

/** What is known of options: whether a value follows, and how. */
const WITH_NUMBER = new Set(['ACC', 'EV', 'RT_LD', 'AP_LD']);
const WITH_REGISTER = new Set(['OFFSET', 'TOOL_OFFSET']);

/** Whether a motion begins here. @param {TpCursor} cursor */
export const isMotion = (cursor) => cursor.look(/[JLCA](?=\s+PR?\[)/y) !== null;

/** @param {TpCursor} cursor @returns {TpMotion} */
export function readMotion(cursor) {
  const motion = /** @type {TpMotionType} */ (cursor.need(/[JLCA]/y, 'J, L, C or A')[0]);
  const first = readRegister(cursor, PLACES);
  const second = motion === 'C' ? readRegister(cursor, PLACES) : null;
  const speed = readSpeed(cursor);
  const termination = readTermination(cursor);
  /** @type {TpOption[]} */
  const options = [];
  while (!cursor.isAtEnd()) options.push(readOption(cursor));
  return {
    ...{ kind: 'motion', motion, ...(second ? { via: first, target: second } : { target: first }) },
    ...{ speed, termination, options },
  };
}

/** @param {TpCursor} cursor @returns {TpSpeed} */
function readSpeed(cursor) {
  // WELD_SPEED and the like: a process has the speed.
  const process = cursor.take(/[A-Z]+_SPEED\b|max_speed\b/y);
  if (process) return { value: { kind: 'word', word: process[0] }, unit: 'mm/sec' };
  const value = readOperand(cursor);
  const unit = cursor.need(UNIT, 'a unit of speed: %, sec, mm/sec, cm/min, inch/min or deg/sec')[0];
  return { value, unit: /** @type {TpSpeedUnit} */ (unit) };
}

/** @param {TpCursor} cursor @returns {TpTermination} */
function readTermination(cursor) {
  const match = cursor.need(/FINE\b|CNT|CR(?=\s*[\dR])|CD(?=\s*[\dR])/y, 'FINE or CNT');
  if (match[0] === 'FINE') return { kind: 'FINE' };
  return { kind: /** @type {'CNT'} */ (match[0]), value: readOperand(cursor) };
}

/** @param {TpCursor} cursor @returns {TpOption} */
function readOption(cursor) {
  cursor.takeSign(',');
  const from = cursor.position();
  const match = cursor.take(OPTION);
  if (!match) return { name: '', text: cursor.rest() };
  const [name] = match;
  const upper = name.toUpperCase();
  if (WITH_NUMBER.has(upper)) return { name, value: readOperand(cursor) };
  if (WITH_REGISTER.has(upper))
    return cursor.takeSign(',') ? { name, value: readRegister(cursor, ['PR', 'VR']) } : { name };
  if (upper === 'SKIP' && cursor.look(/,\s*LBL\[/y)) {
    cursor.takeSign(',');
    const value = readRegister(cursor, ['LBL']);
    // Skip,LBL[1],PR[2]=LPOS: what is kept of where it was.
    if (!cursor.look(/,\s*PR\[/y)) return { name, value };
    cursor.takeSign(',');
    return { name, value, text: cursor.rest() };
  }
  if (['TB', 'TA', 'DB'].includes(upper)) {
    const value = readExpression(cursor);
    cursor.take(/sec\b|mm\b/y);
    return { name, value, text: cursor.rest().replace(/^,/, '').trim() };
  }
  if (['INC', 'WJNT', 'RTCP', 'PTH', 'BREAK', 'MROT', 'COORD'].includes(upper)) return { name };
  cursor.goTo(from);
  return { name: '', text: cursor.rest() };
}

/** @param {number} value */
export const percent = (value) => ({ value: number(value), unit: /** @type {const} */ ('%') });
