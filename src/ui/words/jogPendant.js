/**
 * The pendant: buttons that move joints and the tool.
 * @import { JogFrame } from '../../model/jog/jog.js'
 */

/** @type {Record<JogFrame, string>} */
const FRAME = { world: 'World', base: 'Base', user: 'User', tool: 'Tool' };

const AXES = ['X', 'Y', 'Z'];

export const PENDANT = {
  frame: 'Frame',
  frameLabel: 'Frame whose axes the tool moves along',
  frameName: FRAME,
  frameNote: {
    world: 'Along and about the axes of the world.',
    base: 'Along and about the axes of the robot’s base.',
    user: 'Along and about the axes of the active user frame.',
    tool: 'Along and about the tool’s own axes.',
  },
  chooseFrame: { tool: 'Which tool is active', user: 'Which user frame is active' },
  noFrame: { tool: 'flange', user: 'world' },
  keeps: {
    flange: 'Another tool keeps the flange: the arm stays.',
    tcp: 'Another tool keeps the TCP: the arm moves.',
  },
  editFrames: 'Add or edit…',
  editFramesDetail: 'user frames and tools, below the table',
  how: 'How the arm moves',
  byStep: 'Step',
  byHolding: 'Hold',
  byStepTitle: 'Each press is one step',
  byHoldingTitle: 'The arm moves for as long as a button is held',
  size: { step: 'Step of the tool’s place, millimetres', turn: 'Step of a turn, degrees' },
  sizes: { step: 'Steps in millimetres', turn: 'Steps in degrees' },
  sizeUnit: { step: 'mm', turn: '°' },
  sizeRange: (/** @type {string} */ least, /** @type {string} */ most) => `A step is between ${least} and ${most}.`,
  speed: 'Speed, percent',
  speedCaption: 'Speed',
  speedText: (/** @type {number} */ percent) => `${percent} %`,
  speedNote: (/** @type {string} */ way, /** @type {string} */ turn, /** @type {boolean} */ hasTool) =>
    hasTool ? `${way} mm/s and ${turn}°/s at the tool.` : `${turn}°/s; where a joint slides, ${way} mm/s.`,
  keys: 'Buttons that move the arm',
  axis: AXES,
  turn: AXES.map((name) => `R${name.toLowerCase()}`),
  /** @param {number} axis @param {1 | -1} sign */
  axisLabel: (axis, sign) =>
    `${axis < 3 ? AXES[axis] : `Turn about ${AXES[axis - 3]}`}, ${sign > 0 ? 'plus' : 'minus'}`,
  /** @param {number} joint @param {1 | -1} sign */
  jointLabel: (joint, sign) => `Joint ${joint}, ${sign > 0 ? 'plus' : 'minus'}`,
  /** @param {number} row @param {1 | -1} sign */
  key: (row, sign) => `Key ${sign > 0 ? '' : 'Shift+'}${row}`,
  keysNote: 'Keys 1 to 6, with Shift backwards. Esc stops.',
  moved: (/** @type {string} */ what, /** @type {string} */ amount) => `${what} ${amount}`,
  stop: {
    reach: 'Stopped: the edge of the tool’s reach.',
    orientation: 'Stopped: the tool could go on only if it turned.',
    singularity:
      'Stopped at a singularity: here the joints have no motion that moves the tool that way. Move a joint to leave it.',
    freedom: 'This arm has no joint that moves the tool that way.',
  },
  atLimit: (/** @type {string} */ joint, /** @type {string} */ limits) =>
    `Stopped: ${joint} is at its limit, ${limits}.`,
  outside: (/** @type {string} */ joint, /** @type {string} */ limits) =>
    `${joint} stands outside its limits, ${limits}. Bring it back first, or let joints go beyond their limits.`,
  slow: 'Slowed down: near a singularity a joint is as fast as it may be.',
  tilting: 'The orientation was not kept: this arm has too few joints for that.',
};
