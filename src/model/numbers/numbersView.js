/**
 * How the numbers are shown and copied, and whether joints are kept within their limits. It is the person's choice, not the
 * robot's, so it stays when another one is opened.
 *
 * @import { RobotDoc } from '../document.js'
 * @import { CopyFormat } from './copyText.js'
 * @import { FrameId } from './frameNumbers.js'
 *
 * @typedef {'pose' | 'matrix' | 'links'} NumbersTab
 *
 * @typedef {object} NumbersView
 * @property {FrameId} frame       whose pose is shown
 * @property {FrameId} from        and what it is seen from
 * @property {string} form         the id of one of ORIENTATION_FORMS
 * @property {NumbersTab} tab
 * @property {CopyFormat} format   that was copied last
 * @property {boolean} isKernelUnits  copied in metres and radians instead of the document's units
 * @property {boolean} keepsLimits    jogging stops at the limits
 * @property {boolean} isPendant      joints are shown and taken as the controller's pendant has them
 */

/** @type {Readonly<NumbersView>} */
export const FIRST_NUMBERS = {
  frame: 'tool',
  from: 'world',
  form: 'wpr',
  tab: 'pose',
  format: 'text',
  isKernelUnits: false,
  keepsLimits: true,
  isPendant: false,
};

/**
 * The same choices for another robot; a frame that it does not have is exchanged for the one at its end.
 * @param {NumbersView} numbers
 * @param {RobotDoc} robot
 * @returns {NumbersView} the same object if it fits
 */
export function fitNumbers(numbers, { joints: { length } }) {
  const isBeyond = [numbers.frame, numbers.from].map((frame) => typeof frame === 'number' && frame > length);
  if (!isBeyond.includes(true)) return numbers;
  return {
    ...numbers,
    frame: isBeyond[0] ? 'flange' : numbers.frame,
    from: isBeyond[1] ? 'flange' : numbers.from,
  };
}
