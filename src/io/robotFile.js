/**
 * The text of a robot file of any format that is read here → the document, or the reasons why not. The root element tells
 * which format it is.
 *
 * @import { Doc } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 * @import { Snap } from './urdf/urdfArm.js'
 */
import { fileIssue } from './fileIssues.js';
import { isRlkin, rlkinFrom } from './rlkin.js';
import { robotXmlFrom } from './robotXml.js';
import { urdfFrom } from './urdf.js';
import { readXmlTree } from './xmlTree.js';

/**
 * @param {string} text
 * @returns {{ doc: Doc | null, issues: Issue[] }} null when there is an error among the issues
 */
export function readRobotFile(text) {
  const { root, issues } = readXmlTree(text);
  if (!root) return { doc: null, issues };
  if (isRlkin(root)) return rlkinFrom(root);
  if (root.name !== 'robot' || root.namespace !== '') return robotXmlFrom(root);
  const urdf = urdfFrom(root, {});
  return { doc: urdf.doc, issues: [...urdf.issues, ...(urdf.doc ? urdf.snaps.map(nearlyParallel) : [])] };
}

/** @param {Snap} snap */
function nearlyParallel({ after, angle, moves }) {
  const [degrees, metres] = [angle, moves].map((value) => Number(value.toPrecision(2)));
  const message = `The axes of joints ${after} and ${after + 1} are ${degrees}° from parallel, so that the exact table has long links; parallel axes would move the tool by ${metres} m at most.`;
  return fileIssue('nearly-parallel', message);
}
