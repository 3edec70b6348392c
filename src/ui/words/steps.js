/** What undo and redo call a step: a few words for each kind of change (model/whatChanged.js). */
import { TABLE } from './table.js';

/** @typedef {(joint: number) => string} OfJoint */

export const STEPS = {
  of: {
    undo: (/** @type {string} */ step) => `Undo: ${step}`,
    redo: (/** @type {string} */ step) => `Redo: ${step}`,
  },
  done: {
    undo: (/** @type {string} */ step) => `Undone: ${step}.`,
    redo: (/** @type {string} */ step) => `Done again: ${step}.`,
  },
  field: (/** @type {keyof typeof TABLE.fieldName} */ field, /** @type {number} */ joint) =>
    `${TABLE.fieldName[field]} of joint ${joint}`,
  rate: (/** @type {'velocity' | 'acceleration' | 'jerk' | 'effort'} */ rate, /** @type {number} */ joint) =>
    `${{ velocity: 'rate limit', acceleration: 'acceleration', jerk: 'jerk', effort: 'effort' }[rate]} of joint ${joint}`,
  type: /** @type {OfJoint} */ ((joint) => `type of joint ${joint}`),
  link: /** @type {OfJoint} */ ((joint) => `how link ${joint} is drawn`),
  controller: /** @type {OfJoint} */ ((joint) => `pendant number of joint ${joint}`),
  joint: /** @type {OfJoint} */ ((joint) => `joint ${joint} changed`),
  jointAdded: /** @type {OfJoint} */ ((joint) => `joint ${joint} added`),
  jointRemoved: /** @type {OfJoint} */ ((joint) => `joint ${joint} removed`),
  jointMoved: /** @type {OfJoint} */ ((joint) => `joint ${joint} moved`),
  posture: 'arm moved',
  postures: 'recorded postures',
  order: 'order of the joints',
  table: 'table changed',
  robot: (/** @type {string} */ name) => `${name} opened`,
  name: (/** @type {string} */ name) => `name ${name}`,
  info: 'facts about the robot',
  base: 'base',
  tool: 'tool',
  toolChosen: (/** @type {string | null} */ id) => (id === null ? 'no tool' : `tool ${id} chosen`),
  userChosen: (/** @type {string | null} */ id) => (id === null ? 'no user frame' : `user frame ${id} chosen`),
  units: (/** @type {string} */ length, /** @type {string} */ angle) => `units ${length} and ${angle}`,
  convention: { standard: 'standard DH', modified: 'modified DH' },
  list: {
    postures: 'posture',
    targets: 'target',
    frames: 'frame',
    obstacles: 'obstacle',
    programs: 'code',
    motionPrograms: 'program',
  },
  step: (/** @type {number} */ step, /** @type {string} */ change) => `step ${step} ${change}`,
  inList: (/** @type {string} */ list, /** @type {string} */ id, /** @type {string} */ change) =>
    `${list} ${id} ${change}`,
  change: { added: 'added', removed: 'removed', renamed: 'renamed', moved: 'moved in its list', changed: 'changed' },
  codeOptions: 'how code is written',
  other: 'last change',
};
