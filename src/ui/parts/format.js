/**
 * Every number on the screen passes through here: a true minus, tabular figures' fixed decimals, never "-0.00".
 * @import { JointDoc, Units } from '../../model/document.js'
 * @import { IconName } from './icons.js'
 */
import { isSliding } from '../../model/document.js';

/** Decimals that a reader needs, by unit: a hundredth of a millimetre, a hundredth of a degree. */
const POSE_DECIMALS = { mm: 2, cm: 3, m: 5, deg: 2, rad: 4 };
const JOINT_DECIMALS = { mm: 1, cm: 2, m: 4, deg: 1, rad: 3 };
const UNIT_SIGN = { mm: 'mm', cm: 'cm', m: 'm', deg: '°', rad: 'rad' };

/** Digits that a text to edit shows: more than anyone types, fewer than rounding leaves behind. */
const EDIT_DIGITS = 12;

const trueMinus = (/** @type {string} */ text) => text.replace(/-/g, '−');

/** @param {number} value @param {number} decimals */
export function fixed(value, decimals) {
  const text = value.toFixed(decimals);
  return trueMinus(Number(text) === 0 ? text.replace('-', '') : text);
}

/** A document's number as it stands there: 671.83, −90, 0. @param {number} value */
export const plain = (value) => trueMinus(String(Object.is(value, -0) ? 0 : value));

/**
 * A document's number in no more than so many characters, rounded where it must be: 89.9544, −1.571, 1e9.
 * @param {number} value
 * @param {number} characters
 * @returns {{ text: string, isRounded: boolean }}
 */
export function compact(value, characters) {
  if (plain(value).length <= characters) return { text: plain(value), isRounded: false };
  for (let digits = characters; digits > 0; digits--) {
    const rounded = Number(value.toPrecision(digits));
    const texts = [String(rounded), rounded.toExponential().replace('e+', 'e')];
    const text = texts.find(({ length }) => length <= characters);
    if (text !== undefined) return { text: trueMinus(text), isRounded: rounded !== value };
  }
  return { text: trueMinus(value.toExponential(0).replace('e+', 'e')), isRounded: true };
}

/** A number to be edited: all its digits, but not the noise of the last ones. @param {number} value */
export const editable = (value) => plain(Number(value.toPrecision(EDIT_DIGITS)));

/** @param {number} value @param {Units['length'] | Units['angle']} unit */
export const poseNumber = (value, unit) => fixed(value, POSE_DECIMALS[unit]);

/** The number that `poseNumber` shows. @param {number} value @param {Units['length'] | Units['angle']} unit */
export const roundedPose = (value, unit) => Number(value.toFixed(POSE_DECIMALS[unit]));

/** @param {number} value @param {Units['length'] | Units['angle']} unit */
export const jointNumber = (value, unit) => fixed(value, JOINT_DECIMALS[unit]);

/** The unit of a joint's value. @param {JointDoc} joint @param {Units} units */
export const unitOf = (joint, units) => (isSliding(joint) ? units.length : units.angle);

/** How a unit is written after a number. @param {Units['length'] | Units['angle']} unit */
export const unitSign = (unit) => UNIT_SIGN[unit];

/** "12.0°" or "80.0 mm". @param {string} number @param {Units['length'] | Units['angle']} unit */
export const withUnit = (number, unit) => (unit === 'deg' ? `${number}°` : `${number} ${UNIT_SIGN[unit]}`);

/** The least step that a joint's number shows. @param {Units['length'] | Units['angle']} unit */
export const jointStep = (unit) => 10 ** -JOINT_DECIMALS[unit];

/** @param {JointDoc} joint @returns {IconName} */
export const jointIcon = (joint) => (isSliding(joint) ? 'prismatic' : 'revolute');

/** Numbers for other programs: plain minus, all digits but the noise, a blank between them. @param {readonly number[]} values */
export const copyable = (values) => values.map((value) => String(Number(value.toPrecision(EDIT_DIGITS)))).join(' ');
