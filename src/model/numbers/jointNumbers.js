/**
 * The numbers that joints are shown and taken in.
 *
 * @import { AppState } from '../session.js'
 * @import { Command } from '../commands.js'
 * @import { Doc, RobotDoc } from '../document.js'
 *
 * @typedef {object} JointNumbers
 * @property {(doc: Doc) => RobotDoc} robot  whose limits, home and units are in these numbers
 * @property {(doc: Doc) => readonly number[]} values
 * @property {(doc: Doc, joint: number, value: number) => Command} command  one number is another, and the others stay
 * @property {(robot: RobotDoc, keepsLimits: boolean) => { posture: number[], stopped: number[] }} zero
 * @property {(doc: Doc, joint: number) => string} condition  under which the limits are what they are; '' if they always are
 */
import { zeroPosture } from '../jog/jogRange.js';

/** The table's own. @type {JointNumbers} */
export const MODEL_NUMBERS = {
  robot: ({ robot }) => robot,
  values: ({ posture }) => posture,
  command: (_, joint, value) => ({ type: 'set-joint-value', joint, value }),
  zero: zeroPosture,
  condition: () => '',
};

/**
 * What a change of these numbers starts from: in the middle of a drag, where the drag began, so that one that comes back has
 * changed nothing.
 * @param {AppState} state
 * @returns {Doc}
 */
export const groundOf = ({ doc, gesture }) => gesture?.doc ?? doc;
