/**
 * What can be said against the options of code before it is written, each in a sentence.
 *
 * @import { CodeFormat, CodeOptions } from './writeCode.js'
 *
 * @typedef {'programName' | 'firstRegister' | 'speed'} OptionField
 */
import { fanucNameFault } from '../../karel/fanucNames.js';
import { NAMES } from '../../karel/write/karelMove.js';
import { OWN } from '../../karel/write/karelParts.js';
import { krlNameFault } from '../../karel/write/krl.js';
import { shown } from '../refusalParts.js';
import { MAX_REGISTERS } from './writeCode.js';

const OWN_NAMES = [...Object.values(OWN), ...Object.values(NAMES)];

/** Of user frames and tools; how many a controller really has, it says itself. */
const MAX_FRAME = 99;

/** @param {CodeFormat} format @param {OptionField} field @param {string} text  as it was typed @returns {{ value: string | number } | { message: string }} */
export function readOption(format, field, text) {
  const trimmed = text.trim();
  if (field === 'programName') {
    const message = format === 'krl' ? krlNameFault(trimmed) : fanucNameFault(trimmed, OWN_NAMES);
    return message === null ? { value: trimmed } : { message };
  }
  const [what, most] =
    field === 'speed' ? ['a speed in % from 1', 100] : ['a position register, a whole number from 1', MAX_REGISTERS];
  const value = Number(trimmed);
  const isFine =
    /^\d+(\.\d+)?$/.test(trimmed) && value >= 1 && value <= most && (field === 'speed' || Number.isInteger(value));
  return isFine ? { value } : { message: `Expected ${what} to ${most}, got ${shown(trimmed)}.` };
}

/**
 * @param {string} text
 * @param {readonly number[]} taken  by other frames of its kind
 * @returns {{ value: number } | { message: string }}
 */
export function readFrameNumber(text, taken) {
  const value = Number(text);
  if (!/^\d+$/.test(text.trim()) || value < 1 || value > MAX_FRAME)
    return { message: `Expected a frame's number, a whole number from 1 to ${MAX_FRAME}, got ${shown(text.trim())}.` };
  return taken.includes(value) ? { message: `Another frame has the number ${value} already.` } : { value };
}

/** Options that a form of code has no use for are left out. @param {CodeFormat} format @param {CodeOptions} options @returns {CodeOptions} */
export function optionsFor(format, { firstRegister, ...others }) {
  return format === 'pair' && firstRegister !== undefined ? { ...others, firstRegister } : others;
}
