/**
 * What can be wrong with a document, wherever it came from. Nothing here throws: a fault in data is data.
 *
 * @import { Doc, JointDoc, PoseDoc } from './document.js'
 *
 * @typedef {object} Issue
 * @property {'error' | 'warning'} severity
 * @property {string} code     stable, for tests and translations
 * @property {string} path     where, as 'robot.joints.1.a'
 * @property {number} [line]   in the file, where it came from one
 * @property {string} message  one sentence for a person: what was expected and what came
 */
