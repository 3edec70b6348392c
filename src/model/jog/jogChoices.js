/**
 * How a person jogs: with what, in which frame, by which step or how fast. Steps and rates are in millimetres and degrees,
 * as on a pendant, whatever the units of the table.
 *
 * @import { JogFrame } from './jog.js'
 *
 * @typedef {object} JogChoices
 * @property {'sliders' | 'dials' | 'joints' | 'tool'} mode  joints: buttons instead of sliders
 * @property {JogFrame} frame     whose axes the tool is moved along
 * @property {boolean} isByStep   a press is one step; else the arm moves for as long as it is held
 * @property {number} step        mm
 * @property {number} turn        degrees
 * @property {number} percent     of the rates below
 */
import { toKernel } from '../units.js';

/** @type {JogChoices} */
export const FIRST_JOG = { mode: 'sliders', frame: 'base', isByStep: true, step: 10, turn: 5, percent: 50 };

export const STEPS = { step: [0.1, 1, 10, 50], turn: [0.1, 1, 5, 15] };

/** What may be typed for a step. */
export const STEP_RANGE = { step: { least: 0.001, most: 1000 }, turn: { least: 0.001, most: 180 } };

/** The tool at 100 %, per second; and what no joint exceeds on the tool's behalf. */
export const RATES = { millimetres: 250, degrees: 45, jointDegrees: 180 };

/** @type {{ length: 'mm', angle: 'deg' }} */
export const PENDANT_UNITS = { length: 'mm', angle: 'deg' };

/** Whether there are buttons to jog by. @param {JogChoices} choices */
export const hasJogButtons = ({ mode }) => mode === 'joints' || mode === 'tool';

/** A step in metres or radians. @param {JogChoices} choices @param {boolean} isTurn */
export const stepOf = ({ step, turn }, isTurn) =>
  isTurn ? toKernel('angle', turn, PENDANT_UNITS) : toKernel('length', step, PENDANT_UNITS);

/** Metres or radians per second. @param {JogChoices} choices @param {boolean} isTurn */
export const rateOf = ({ percent }, isTurn) =>
  (percent / 100) *
  (isTurn ? toKernel('angle', RATES.degrees, PENDANT_UNITS) : toKernel('length', RATES.millimetres, PENDANT_UNITS));

/** How far a joint may turn in so many seconds for the tool's sake, radians. @param {number} seconds */
export const mostTurnIn = (seconds) => seconds * toKernel('angle', RATES.jointDegrees, PENDANT_UNITS);
