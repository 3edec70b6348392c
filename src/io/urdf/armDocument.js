/**
 * Links and joints of a file, whatever its format → the document of the arm among them, or the reasons why not.
 *
 * @import { Doc } from '../../model/document.js'
 * @import { Issue } from '../../model/issues.js'
 * @import { TipChoice } from './urdfChain.js'
 * @import { Snap } from './urdfArm.js'
 * @import { UrdfRobot } from './urdfRobot.js'
 *
 * @typedef {object} ChainChoices  what a person may choose otherwise
 * @property {readonly string[]} bases
 * @property {string} base
 * @property {readonly TipChoice[]} tips   of this base
 * @property {string | null} tip
 * @property {boolean} isOpen   whether others are about as likely as the likeliest
 *
 * @typedef {{ doc: Doc | null, issues: Issue[], choices: ChainChoices | null, snaps: readonly Snap[] }} ArmAnswer  doc: null when
 *   there is an error among the issues; choices: null when no chain can be chosen
 * @typedef {{ baseLink?: string, tipLink?: string, snap?: number }} ArmOptions  snap: axes closer to parallel than this, in radians,
 *   are made parallel
 */
import { deepFreeze } from '../../model/freeze.js';
import { newDocument } from '../../model/newDocument.js';
import { reviewDocument } from '../../model/review.js';
import { shownText } from '../../model/shownText.js';
import { validateDocument } from '../../model/validate.js';
import { atLine, fileIssue, hasErrors } from '../fileIssues.js';
import { kinematicIssues } from '../kinematicIssues.js';
import { armFrom } from './urdfArm.js';
import { endBeyond, leavesChoice, likelyTip, moves, pathIssues, pathTo, tipsFrom, urdfTree } from './urdfChain.js';

/** @param {Issue[]} issues @param {ChainChoices | null} [choices] @returns {ArmAnswer} */
export const refused = (issues, choices = null) => ({ doc: null, issues, choices, snaps: [] });

/**
 * @param {UrdfRobot} robot   read without errors
 * @param {Issue[]} read      what was said of it
 * @param {ArmOptions & { format: string }} options
 * @returns {ArmAnswer}
 */
export function armDocument(robot, read, { format, baseLink, tipLink, snap }) {
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

  const source = `${format}, ${shownText(base)} to ${shownText(tip)}`;
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
