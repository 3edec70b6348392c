/**
 * How code is to be written: what the model keeps of it, and what can be said against it as it is typed, each in a sentence.
 *
 * @import { CodeFormat, Doc } from '../document.js'
 * @import { CodeSource } from './codeSource.js'
 * @import { CodeOptions } from './writeCode.js'
 *
 * @typedef {'programName' | 'firstRegister' | 'speed'} OptionField
 */
import { MAX_REGISTERS } from '../../karel/tp/run/memory.js';
import { fanucNameFault } from '../../karel/fanucNames.js';
import { NAMES } from '../../karel/write/karelMove.js';
import { OWN } from '../../karel/write/karelParts.js';
import { krlNameFault } from '../../karel/write/krl.js';
import { shown } from '../refusalParts.js';
import { sourceKey } from './codeSource.js';
import { frameKey } from './frameNumbers.js';

const OWN_NAMES = [...Object.values(OWN), ...Object.values(NAMES)];

/** Of user frames and tools; how many a controller really has, it says itself. */
const MAX_FRAME_NUMBER = 99;

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
  if (!/^\d+$/.test(text.trim()) || value < 1 || value > MAX_FRAME_NUMBER)
    return {
      message: `Expected a frame's number, a whole number from 1 to ${MAX_FRAME_NUMBER}, got ${shown(text.trim())}.`,
    };
  return taken.includes(value) ? { message: `Another frame has the number ${value} already.` } : { value };
}

const ID = '[A-Za-z_]\\w{0,63}';

/** What the model keeps of it is a text: each option with its value, and blanks between them. */
const OPTION = RegExp(
  `^(format=(pair|tp|karel-move|krl)|source=(postures|targets|program:${ID})|programName=${ID}|firstRegister=([1-9]\\d{0,2}|1\\d{3}|2000)|speed=([1-9]\\d?(\\.\\d+)?|100)|userFrame=(0|${ID})|toolNumber=[1-9]\\d?)$`,
);

/**
 * What is chosen, and makes sense.
 * @param {Pick<Doc, 'codeOptions'>} doc
 * @returns {Partial<Record<'format' | 'source' | 'programName' | 'firstRegister' | 'speed' | 'userFrame' | 'toolNumber', string>>}
 */
export const keptOptions = ({ codeOptions = '' }) =>
  Object.fromEntries(
    codeOptions
      .split(/\s+/)
      .filter((word) => OPTION.test(word))
      .map((word) => word.split('=')),
  );

/** The text, with other choices. @param {Pick<Doc, 'codeOptions'>} doc @param {{ [Key in keyof ReturnType<typeof keptOptions>]?: string | number }} change */
export const withOptions = (doc, change) =>
  Object.entries({ ...keptOptions(doc), ...change })
    .flatMap(([key, value]) => (value === undefined ? [] : [`${key}=${value}`]))
    .join(' ');

/** @param {CodeSource} source */
export const sourceWord = (source) => sourceKey(source).replace(' ', ':');

/** The language that is chosen, or else that of the robot's maker. @param {Doc} doc @param {CodeFormat} usual  of others */
export function formatOf(doc, usual) {
  const { name, info } = doc.robot;
  const maker = `${info.manufacturer ?? ''} ${name}`;
  const ofMaker = /\bkuka\b/i.test(maker) ? 'krl' : /\bfanuc\b/i.test(maker) ? 'pair' : usual;
  return /** @type {CodeFormat} */ (keptOptions(doc).format ?? ofMaker);
}

/** What of the choices counts for a form of code and what it is written of. @param {Doc} doc @param {CodeFormat} format @param {CodeSource} source @returns {CodeOptions} */
export function optionsFor(doc, format, source) {
  const { firstRegister, programName, speed, userFrame, toolNumber, source: of } = keptOptions(doc);
  const isOfThis = of === undefined || of === sourceWord(source);
  const isFrame = doc.frames.some(({ kind, id }) => kind === 'user' && id === userFrame);
  return {
    ...(isOfThis && programName && { programName }),
    ...(isOfThis && speed && { speed: Number(speed) }),
    ...(format === 'pair' && firstRegister && { firstRegister: Number(firstRegister) }),
    ...(isFrame ? { userFrame } : userFrame === WORLD && { userFrame: '' }),
    ...(toolNumber && { numbers: { [frameKey('tool', '')]: Number(toolNumber) } }),
  };
}

/** Among the choices; a frame's id is never so. */
export const WORLD = '0';
