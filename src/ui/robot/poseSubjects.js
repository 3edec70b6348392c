/**
 * Whose pose a pose editor edits.
 *
 * @import { Change } from '../page.js'
 * @import { Doc, PoseDoc } from '../../model/document.js'
 *
 * @typedef {object} PoseSubject
 * @property {string} id
 * @property {(doc: Doc) => string} name
 * @property {(doc: Doc) => PoseDoc} pose
 * @property {(pose: PoseDoc) => Change} command
 * @property {string} meaning    what it is seen from, in a sentence
 * @property {string} resetDone  what is said when it was made none
 */
import { identityPose } from '../../model/document.js';
import { TEXT } from '../strings.js';
import { DETAILS } from '../words/robotDetails.js';

const COMMAND = /** @type {const} */ ({ base: 'set-base', tool: 'set-tool' });

/** @param {'base' | 'tool'} which @returns {PoseSubject} */
export const robotPose = (which) => ({
  id: which,
  name: () => TEXT.robot[which],
  pose: ({ robot }) => robot[which],
  command: (pose) => ({ type: COMMAND[which], pose }),
  meaning: DETAILS.pose[which],
  resetDone: DETAILS.resetDone[which],
});

const NO_POSE = Object.freeze(identityPose());

/**
 * A user frame or a tool of the list; one that has just gone has no pose any more.
 * @param {'user' | 'tool'} kind
 * @param {number} index
 * @returns {PoseSubject}
 */
export const framePose = (kind, index) => ({
  id: `frame-${index}`,
  name: ({ frames }) => frames[index]?.id ?? '',
  pose: ({ frames }) => frames[index] ?? NO_POSE,
  command: (pose) => ({ type: 'edit-frame', index, pose }),
  meaning: DETAILS.pose[kind === 'user' ? 'user' : 'tool'],
  resetDone: DETAILS.resetDone[kind === 'user' ? 'user' : 'tool'],
});
