/**
 * URDF, the robot description of ROS, in and out. In: one serial chain of the file becomes a Denavit–Hartenberg table that is
 * the same arm to 1e-8 m. Out: joints whose frames are those of the table.
 *
 * @import { Doc } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 * @import { TipChoice } from './urdf/urdfChain.js'
 * @import { Snap } from './urdf/urdfArm.js'
 * @import { XmlElement } from './xmlTree.js'
 *
 * @typedef {object} UrdfChoices  what a person may choose otherwise
 * @property {readonly string[]} bases
 * @property {string} base
 * @property {readonly TipChoice[]} tips   of this base
 * @property {string | null} tip
 * @property {boolean} isOpen   whether others are about as likely as the likeliest
 */
import { deepFreeze } from '../model/freeze.js';
import { newDocument } from '../model/newDocument.js';
import { reviewDocument } from '../model/review.js';
import { shownText } from '../model/shownText.js';
import { validateDocument } from '../model/validate.js';
import { atLine, fileIssue, hasErrors } from './fileIssues.js';
import { kinematicIssues } from './kinematicIssues.js';
import { armFrom } from './urdf/urdfArm.js';
import { endBeyond, leavesChoice, likelyTip, moves, pathIssues, pathTo, tipsFrom, urdfTree } from './urdf/urdfChain.js';
import { urdfRobotFrom } from './urdf/urdfRobot.js';
import { writeUrdf } from './urdf/urdfWriter.js';
import { readXmlTree } from './xmlTree.js';

export { writeUrdf };

/**
 * @param {string} text
 * @param {{ baseLink?: string, tipLink?: string, snap?: number }} [options]  snap: axes closer to parallel than this, in
 *   radians, are made parallel
 * @returns {{ doc: Doc | null, issues: Issue[], choices: UrdfChoices | null, snaps: readonly Snap[] }} doc: null when there is
 *   an error among the issues; choices: null when no chain can be chosen
 */
export function readUrdf(text, options = {}) {
  const { root, issues } = readXmlTree(text);
  if (!root) return { doc: null, issues, choices: null, snaps: [] };
  const answer = urdfFrom(root, options);
  const styled = /<\?xml-stylesheet\s/.test(text)
    ? [fileIssue('not-read', 'The file names a style sheet, which is not read.')]
    : [];
  return { ...answer, issues: [...styled, ...answer.issues] };
}

/**
 * @param {XmlElement} root
 * @param {{ baseLink?: string, tipLink?: string, snap?: number }} options
 * @returns {ReturnType<typeof readUrdf>}
 */
export function urdfFrom(root, { baseLink, tipLink, snap }) {
  /** @param {Issue[]} issues @param {UrdfChoices | null} [choices] @returns {ReturnType<typeof readUrdf>} */
  const refused = (issues, choices = null) => ({ doc: null, issues, choices, snaps: [] });
  if (root.name !== 'robot' || root.namespace !== '') {
    const message = `The file begins with <${shownText(root.name)}>; expected <robot>, as a URDF begins.`;
    return refused([fileIssue('not-a-robot', message, { line: root.line })]);
  }
  const { robot, issues: read } = urdfRobotFrom(root);
  if (hasErrors(read)) return refused(read);
  const { tree, issues: shape } = urdfTree(robot);
  if (!tree) return refused([...read, ...shape]);

  const base = baseLink ?? tree.root;
  const unknown = [base, tipLink].find((link) => link !== undefined && !robot.links.has(link));
  if (unknown !== undefined)
    return refused([...read, fileIssue('unknown-link', `There is no link "${shownText(unknown)}" in this file.`)]);
  const tips = tipsFrom(tree, robot, base);
  const tip = tipLink ?? likelyTip(tree, robot, base);
  const bases = [...robot.links.keys()].filter((link) => tipsFrom(tree, robot, link).length > 0);
  const isOpen = leavesChoice(tree, robot, base);
  const choices = bases.length > 0 ? { bases, base, tips, tip, isOpen } : null;
  if (tip === null) {
    const moving = robot.joints.filter(moves).length;
    const message = `No chain from "${shownText(base)}" has 2 to 6 joints that move (the file has ${moving}); expected an arm.`;
    return refused([...read, fileIssue('joint-count', message)], choices);
  }
  const end = tipLink === undefined ? endBeyond(tree, robot, base, tip) : null;
  if (end) {
    const message = `From "${shownText(base)}" to "${shownText(end.link)}" ${end.moving} joints move; expected 2 to 6, or a tip to be named that comes before.`;
    return refused([...read, fileIssue('joint-count', message)], choices);
  }
  const path = pathTo(tree, base, tip);
  if (!path) {
    const message = `The link "${shownText(base)}" does not carry "${shownText(tip)}"; expected a tip beyond the base.`;
    return refused([...read, fileIssue('unknown-link', message)], choices);
  }
  const wrong = pathIssues(path);
  if (hasErrors(wrong)) return refused([...read, ...wrong], choices);

  const source = `URDF, ${shownText(base)} to ${shownText(tip)}`;
  const arm = armFrom(path, { name: robot.name, source, snap });
  if (!arm.robot) return { ...refused([...read, ...arm.issues], choices), snaps: arm.snaps };
  const doc = newDocument(arm.robot);
  const faults = validateDocument(doc);
  const found = faults.length > 0 ? faults : [...kinematicIssues(doc), ...reviewDocument(doc)];
  const lines = path.filter(moves).map(({ line }) => line);
  const all = [
    ...read,
    ...found.map((issue) => atLine(issue, lines[Number(/^robot\.joints\.(\d)/.exec(issue.path)?.[1])])),
  ];
  return hasErrors(all) ? refused(all, choices) : { doc: deepFreeze(doc), issues: all, choices, snaps: arm.snaps };
}
