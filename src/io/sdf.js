/**
 * SDFormat, the format of Gazebo, in and out. In, as a URDF: one serial chain of the model becomes a table that is the same arm to
 * 1e-8 m. Out: joints whose frames are those of the table.
 *
 * @import { ArmAnswer, ArmOptions } from './urdf/armDocument.js'
 * @import { XmlElement } from './xmlTree.js'
 */
import { shownText } from '../model/shownText.js';
import { fileIssue } from './fileIssues.js';
import { sdfRobotFrom } from './sdf/sdfRobot.js';
import { writeSdf } from './sdf/sdfWriter.js';
import { armDocument, refused } from './urdf/armDocument.js';
import { readXmlTree } from './xmlTree.js';

export { writeSdf };

/** @param {XmlElement} root */
export const isSdf = ({ name, namespace }) => name === 'sdf' && namespace === '';

/**
 * @param {string} text
 * @param {ArmOptions} [options]
 * @returns {ArmAnswer}
 */
export function readSdf(text, options = {}) {
  const { root, issues } = readXmlTree(text);
  return root ? sdfFrom(root, options) : refused(issues);
}

/**
 * @param {XmlElement} root
 * @param {ArmOptions} options
 * @returns {ArmAnswer}
 */
export function sdfFrom(root, options) {
  if (!isSdf(root)) {
    const message = `The file begins with <${shownText(root.name)}>; expected <sdf>.`;
    return refused([fileIssue('not-a-robot', message, { line: root.line })]);
  }
  const { robot, issues } = sdfRobotFrom(root);
  return robot ? armDocument(robot, issues, { ...options, format: 'SDFormat' }) : refused(issues);
}
