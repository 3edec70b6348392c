/**
 * The text of a robot file of any format that is read here → the document, or the reasons why not. The root element tells
 * which format it is.
 *
 * @import { Doc } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 * @import { UrdfChoices } from './urdf/armDocument.js'
 * @import { Snap } from './urdf/urdfArm.js'
 */
import { shownText } from '../model/shownText.js';
import { fileIssue } from './fileIssues.js';
import { isRlkin, rlkinFrom } from './rlkin.js';
import { robotXmlFrom } from './robotXml.js';
import { isSdf, sdfFrom } from './sdf.js';
import { styleSheetIssues, urdfFrom } from './urdf.js';
import { readXmlTree } from './xmlTree.js';

/**
 * @param {string} text
 * @returns {{ doc: Doc | null, issues: Issue[], chain?: { choices: UrdfChoices | null, snaps: readonly Snap[] } }} doc: null
 *   when there is an error among the issues; chain: what of a URDF a person may choose otherwise, with `readUrdf`
 */
export function readRobotFile(text) {
  const { root, issues } = readXmlTree(text);
  if (!root) return { doc: null, issues };
  if (isRlkin(root)) return rlkinFrom(root);
  const isUrdf = root.name === 'robot' && root.namespace === '';
  if (!isUrdf && !isSdf(root)) return robotXmlFrom(root);
  const { doc, issues: found, choices, snaps } = isUrdf ? urdfFrom(root, {}) : sdfFrom(root, {});
  const told = [...(isUrdf ? styleSheetIssues(text) : []), ...found, ...(doc ? snaps.map(nearlyParallel) : [])];
  if (isUrdf) return { doc, issues: told, chain: { choices, snaps } };
  return { doc, issues: doc && choices?.isOpen ? [...told, otherChains(choices)] : told };
}

/** @param {UrdfChoices} choices */
function otherChains({ base, tip }) {
  const taken = `from "${shownText(base)}" to "${shownText(tip ?? '')}"`;
  return fileIssue('not-read', `The file has several chains that may be the arm; the one ${taken} was read.`);
}

/** @param {Snap} snap */
function nearlyParallel({ after, angle, moves }) {
  const [degrees, metres] = [angle, moves].map((value) => Number(value.toPrecision(2)));
  const message = `The axes of joints ${after} and ${after + 1} are ${degrees}° from parallel, so that the exact table has long links; parallel axes would move the tool by ${metres} m at most.`;
  return fileIssue('nearly-parallel', message);
}
