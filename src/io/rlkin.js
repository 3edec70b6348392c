/**
 * rlkin, the kinematics format of the Robotics Library, in and out. It has standard Denavit–Hartenberg rows in metres and
 * degrees, so that most of what is read keeps its digits.
 *
 * @import { Doc } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 * @import { ElementRule } from './robotXmlTable.js'
 * @import { RlkinFile } from './rlkin/rlkinTable.js'
 * @import { PlainRecord } from './record.js'
 * @import { Reader } from './readByTable.js'
 * @import { XmlElement } from './xmlTree.js'
 */
import { deepFreeze } from '../model/freeze.js';
import { newDocument } from '../model/newDocument.js';
import { reviewDocument } from '../model/review.js';
import { shownText } from '../model/shownText.js';
import { validateDocument } from '../model/validate.js';
import { atLine, fileIssue, hasErrors } from './fileIssues.js';
import { kinematicIssues } from './kinematicIssues.js';
import { readElement } from './readByTable.js';
import { isJoint, rlkinChain } from './rlkin/rlkinChain.js';
import { rlkinRobot } from './rlkin/rlkinRobot.js';
import { RLKIN_ROOTS } from './rlkin/rlkinTable.js';
import { writeRlkin } from './rlkin/rlkinWriter.js';
import { createSources } from './sources.js';
import { readXmlTree } from './xmlTree.js';

export { writeRlkin };

/** @param {XmlElement} root */
export const isRlkin = ({ name, namespace }) => namespace === '' && RLKIN_ROOTS.has(name);

/**
 * @param {string} text
 * @returns {{ doc: Doc | null, issues: Issue[] }} null when there is an error among the issues
 */
export function readRlkin(text) {
  const { root, issues } = readXmlTree(text);
  return root ? rlkinFrom(root) : { doc: null, issues };
}

/**
 * The same, from the tree of the text.
 * @param {XmlElement} root
 * @returns {ReturnType<typeof readRlkin>}
 */
export function rlkinFrom(root) {
  const rule = isRlkin(root) ? /** @type {ElementRule} */ (RLKIN_ROOTS.get(root.name)) : null;
  if (!rule) {
    const message = `The file begins with <${shownText(root.name)}>; expected <rlkin>.`;
    return { doc: null, issues: [fileIssue('not-a-robot', message, { line: root.line })] };
  }
  const sources = createSources();
  /** @type {Reader} */
  const reader = { issues: [], sources, namespace: '', foreignText: () => null };
  /** @type {PlainRecord} */
  const record = {};
  readElement(rule, root, { record, path: '' }, reader);
  const isEmpty = !Array.isArray(record.frames) || record.frames.length === 0;
  if (!hasErrors(reader.issues) && isEmpty) {
    const message = `<${root.name}> holds no robot; expected <kinematics>, <puma> or <rhino>.`;
    reader.issues.push(fileIssue('missing-element', message, { line: root.line }));
  }
  if (hasErrors(reader.issues)) return { doc: null, issues: reader.issues };
  // what the table reads; it has asked for what must be there
  const file = /** @type {RlkinFile} */ (/** @type {unknown} */ (record));
  const lineOf = (/** @type {object} */ of) => sources.lineOf(of, '');
  const chain = rlkinChain(file, lineOf);
  if (!chain.path) return { doc: null, issues: chain.issues };
  const unread = [...chain.issues, ...unreadIssues(file, lineOf)];
  const { robot, issues } = rlkinRobot(chain.path, file, chain.tip);
  if (!robot) return { doc: null, issues: [...unread, ...issues] };
  const doc = newDocument(robot);
  const faults = validateDocument(doc);
  const found = faults.length > 0 ? faults : [...kinematicIssues(doc), ...reviewDocument(doc)];
  const joints = chain.path.filter(isJoint);
  const placed = found.map((issue) => {
    const [, index] = /^robot\.joints\.(\d)/.exec(issue.path) ?? [];
    return index === undefined ? issue : atLine(issue, lineOf(joints[Number(index)]));
  });
  const all = [...unread, ...placed];
  return hasErrors(all) ? { doc: null, issues: all } : { doc: deepFreeze(doc), issues: all };
}

/**
 * What the schema allows and the Robotics Library takes no notice of, either: poses of what a joint moves.
 * @param {RlkinFile} file
 * @param {(record: object) => number | undefined} lineOf
 * @returns {Issue[]}
 */
function unreadIssues({ frames, joints }, lineOf) {
  const isPlaced = (/** @type {{ rotation?: unknown, translation?: unknown }} */ { rotation, translation }) =>
    [rotation, translation].some((part) => Object.values(part ?? {}).some((value) => value !== 0));
  const unread = [
    ...frames.filter((frame) => frame.kind !== 'world' && isPlaced(frame)),
    ...joints.filter((joint) => isPlaced(joint) || joint.center !== undefined),
  ];
  const turning = joints.filter(({ type, wraparound }) => type === 'prismatic' && wraparound);
  return [
    ...unread.map((of) => {
      const message = `The element "${shownText(of.id)}" has a rotation, a translation or a center of its own, which says nothing of how the arm moves and is not read.`;
      return fileIssue('not-read', message, { line: lineOf(of) });
    }),
    ...turning.map((of) => {
      const message = `The slide "${shownText(of.id)}" has a <wraparound>, which only a turn can have and which is not read.`;
      return fileIssue('not-read', message, { line: lineOf(of) });
    }),
  ];
}
