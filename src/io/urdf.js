/**
 * URDF, the robot description of ROS, in and out. In: one serial chain of the file becomes a Denavit–Hartenberg table that is
 * the same arm to 1e-8 m. Out: joints whose frames are those of the table.
 *
 * @import { Issue } from '../model/issues.js'
 * @import { ArmAnswer, ArmOptions } from './urdf/armDocument.js'
 * @import { XmlElement } from './xmlTree.js'
 */
import { shownText } from '../model/shownText.js';
import { fileIssue, hasErrors } from './fileIssues.js';
import { armDocument, refused } from './urdf/armDocument.js';
import { urdfRobotFrom } from './urdf/urdfRobot.js';
import { writeUrdf } from './urdf/urdfWriter.js';
import { readXmlTree } from './xmlTree.js';

export { writeUrdf };

/**
 * @param {string} text
 * @param {ArmOptions} [options]
 * @returns {ArmAnswer}
 */
export function readUrdf(text, options = {}) {
  const { root, issues } = readXmlTree(text);
  if (!root) return refused(issues);
  const answer = urdfFrom(root, options);
  return { ...answer, issues: [...styleSheetIssues(text), ...answer.issues] };
}

/** What stands before the root element and is not heeded. @param {string} text @returns {Issue[]} */
export const styleSheetIssues = (text) =>
  /<\?xml-stylesheet\s/.test(text) ? [fileIssue('not-read', 'The file names a style sheet, which is not read.')] : [];

/**
 * @param {XmlElement} root
 * @param {ArmOptions} options
 * @returns {ArmAnswer}
 */
export function urdfFrom(root, options) {
  if (root.name !== 'robot' || root.namespace !== '') {
    const message = `The file begins with <${shownText(root.name)}>; expected <robot>, as a URDF begins.`;
    return refused([fileIssue('not-a-robot', message, { line: root.line })]);
  }
  const { robot, issues } = urdfRobotFrom(root);
  return hasErrors(issues) ? refused(issues) : armDocument(robot, issues, { ...options, format: 'URDF' });
}
