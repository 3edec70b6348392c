/**
 * What can be wrong with a document, wherever it came from. Nothing here throws: a fault in data is data. An error means
 * that a document may not enter the store; a warning, that it may and a person should know.
 *
 * @typedef {object} Issue
 * @property {'error' | 'warning'} severity
 * @property {string} code     stable, for tests and translations
 * @property {string} path     where, as 'robot.joints.1.a'
 * @property {number} [line]   in the file, where it came from one
 * @property {string} message  one sentence for a person: what was expected and what came
 *
 * @typedef {keyof typeof DOCUMENT_ISSUES} DocumentIssueCode
 */

/** The codes of validate.js (errors) and review.js (warnings). */
export const DOCUMENT_ISSUES = Object.freeze({
  number: 'error', // not finite, beyond ±10⁹, or not above zero where it must be
  choice: 'error', // not one of the words allowed
  colour: 'error',
  id: 'error', // not [A-Za-z_][A-Za-z0-9_]{0,63}
  'id-taken': 'error',
  'id-reserved': 'error', // a recorded posture called "current"
  'text-length': 'error',
  'vector-length': 'error',
  'joint-count': 'error',
  'posture-length': 'error', // not one value for each joint
  'frame-unknown': 'error', // the active one, or that of a target, is not in the list
  'tool-differs': 'error', // the active tool and the tool of the robot are different poses
  'too-many-postures': 'error',
  'too-many-frames': 'error',
  'too-many-targets': 'error',
  'too-many-obstacles': 'error',
  'too-many-programs': 'error',
  'limits-crossed': 'error',
  'orientation-twice': 'error', // rpy and quaternion
  'quaternion-length': 'error',
  'coupling-unknown': 'error', // to a joint that does not exist
  'coupling-circle': 'error', // to itself, or round through others
  'coupling-without-joint': 'error',

  'posture-outside-limits': 'warning',
  'home-outside-limits': 'warning',
  'coupling-kinds': 'warning', // between a joint that turns and one that slides
  'joint-locked': 'warning', // lower = upper
  'limits-unused': 'warning', // a continuous joint with limits
  'no-extent': 'warning', // all lengths zero
  'very-small': 'warning',
  'very-large': 'warning',
});

/**
 * @param {DocumentIssueCode} code
 * @param {string} path
 * @param {string} message
 * @returns {Issue}
 */
export const documentIssue = (code, path, message) => ({
  severity: /** @type {Issue['severity']} */ (DOCUMENT_ISSUES[code]), // Object.freeze keeps the words' types too wide
  code,
  path,
  message,
});
