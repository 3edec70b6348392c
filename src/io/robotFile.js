/**
 * The text of a robot file of any format that is read here → the document, or the reasons why not. The root element tells
 * which format it is.
 *
 * @import { Doc } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 * @import { ArmAnswer, ArmOptions, ChainChoices } from './urdf/armDocument.js'
 * @import { Snap } from './urdf/urdfArm.js'
 *
 * @typedef {object} FileChain  what of a file of links and joints a person may choose otherwise
 * @property {ChainChoices | null} choices
 * @property {readonly Snap[]} snaps
 * @property {(options: ArmOptions) => ArmAnswer} read  the same file once more, as it was chosen
 */
import { fileIssue } from './fileIssues.js';
import { isRlkin, rlkinFrom } from './rlkin.js';
import { robotXmlFrom } from './robotXml.js';
import { isSdf, sdfFrom } from './sdf.js';
import { styleSheetIssues, urdfFrom } from './urdf.js';
import { readXmlTree } from './xmlTree.js';

/**
 * @param {string} text
 * @returns {{ doc: Doc | null, issues: Issue[], chain?: FileChain }} doc: null when there is an error among the issues
 */
export function readRobotFile(text) {
  const { root, issues } = readXmlTree(text);
  if (!root) return { doc: null, issues };
  if (isRlkin(root)) return rlkinFrom(root);
  const isUrdf = root.name === 'robot' && root.namespace === '';
  if (!isUrdf && !isSdf(root)) return robotXmlFrom(root);
  const read = (/** @type {ArmOptions} */ options) => {
    if (!isUrdf) return sdfFrom(root, options);
    const answer = urdfFrom(root, options);
    return { ...answer, issues: [...styleSheetIssues(text), ...answer.issues] };
  };
  const { doc, issues: found, choices, snaps } = read({});
  return { doc, issues: doc ? [...found, ...snaps.map(nearlyParallel)] : found, chain: { choices, snaps, read } };
}

/** @param {Snap} snap */
function nearlyParallel({ after, angle, moves }) {
  const [degrees, metres] = [angle, moves].map((value) => Number(value.toPrecision(2)));
  const message = `The axes of joints ${after} and ${after + 1} are ${degrees}° from parallel, so that the exact table has long links; parallel axes would move the tool by ${metres} m at most.`;
  return fileIssue('nearly-parallel', message);
}
