/**
 * The text of a robot file → the document, or the reasons why not. Whatever the text is, reading does not throw; an
 * answer with a document has warnings at most, and the document is frozen, sound, finite, and can be saved and opened.
 *
 * @import { Doc, PostureDoc } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 * @import { PlainRecord } from './record.js'
 * @import { Reader } from './readByTable.js'
 * @import { XmlElement } from './xmlTree.js'
 */
import { homePosture } from '../model/document.js';
import { PRESENT_POSTURE_ID } from '../model/documentRules.js';
import { deepFreeze } from '../model/freeze.js';
import { documentIssue } from '../model/issues.js';
import { reviewDocument } from '../model/review.js';
import { validateDocument } from '../model/validate.js';
import { atLine, fileIssue, hasErrors } from './fileIssues.js';
import { MAX_TEXT_LENGTH } from './fileLimits.js';
import { foreignText } from './robotXmlExtensions.js';
import { kinematicIssues } from './kinematicIssues.js';
import { roundQuaternions } from './quaternions.js';
import { readElement } from './readByTable.js';
import { ROBOT_MODEL, ROBOT_NAMESPACE } from './robotXmlTable.js';
import { rootIssues } from './robotXmlRoot.js';
import { writeRobotXml } from './robotXmlWriter.js';
import { createSources } from './sources.js';
import { readXmlTree } from './xmlTree.js';

export { writeRobotXml };

/**
 * @param {string} text
 * @returns {{ doc: Doc | null, issues: Issue[] }} null when there is an error among the issues
 */
export function readRobotXml(text) {
  const { root, issues } = readXmlTree(text);
  return root ? robotXmlFrom(root) : { doc: null, issues };
}

/**
 * The same, from the tree of the text.
 * @param {XmlElement} root
 * @returns {{ doc: Doc | null, issues: Issue[] }}
 */
export function robotXmlFrom(root) {
  const opening = rootIssues(root);
  if (hasErrors(opening)) return { doc: null, issues: opening };
  const { doc, issues: found } = readDocument(root);
  const all = [...opening, ...found].sort(byLine);
  return hasErrors(all) ? { doc: null, issues: all } : { doc: deepFreeze(doc), issues: all };
}

/** @param {XmlElement} root @returns {{ doc: Doc, issues: Issue[] }} */
function readDocument(root) {
  const sources = createSources();
  /** @type {Reader} */
  const reader = { issues: [], sources, namespace: ROBOT_NAMESPACE, foreignText };
  /** @type {PlainRecord} */
  const file = { robot: { info: {} } };
  readElement(ROBOT_MODEL, root, { record: file, path: '' }, reader);
  const doc = documentFrom(file);
  if (hasErrors(reader.issues)) return { doc, issues: reader.issues };

  sources.follow(doc, '', file, '');
  const [present, ...more] = /** @type {PostureDoc[]} */ (file.postures).filter(isPresent);
  if (present) sources.follow(doc, 'posture', present, 'q');
  if (more.length > 0) {
    const message = `Two postures have the id "${present.id}"; expected a different id for each.`;
    const issue = documentIssue('id-taken', 'posture', message);
    return { doc, issues: [...reader.issues, atLine(issue, sources.lineOf(more[0], ''))] };
  }
  const rounded = roundQuaternions(doc);
  const faults = validateDocument(doc);
  const checks = faults.length > 0 ? faults : [...kinematicIssues(doc), ...reviewDocument(doc)];
  const placed = [...rounded, ...checks].map((issue) => atLine(issue, sources.lineOf(doc, issue.path)));
  return { doc, issues: [...reader.issues, ...placed, ...(faults.length > 0 ? [] : sizeIssues(doc))] };
}

/** @param {PlainRecord} file  as the table describes it @returns {Doc} */
function documentFrom(file) {
  // What the table reads is a document but for the posture; validateDocument has the last word on it.
  const { robot, postures, activeTool, activeUser, codeOptions, ...lists } = /** @type {Omit<Doc, 'posture'>} */ (
    /** @type {unknown} */ (file)
  );
  const { frames, targets, obstacles, motionPrograms, programs, extensions } = lists;
  const { name, info, units, convention, base, tool, joints } = robot;
  return {
    robot: { name, info, units, convention, base, tool, joints },
    posture: postures.find(isPresent)?.q ?? homePosture(robot),
    postures: postures.filter((posture) => !isPresent(posture)),
    frames,
    ...(activeTool !== undefined && { activeTool }),
    ...(activeUser !== undefined && { activeUser }),
    targets,
    obstacles,
    motionPrograms,
    programs,
    ...(codeOptions && { codeOptions }),
    extensions,
  };
}

/** @param {PostureDoc} posture */
const isPresent = ({ id }) => id === PRESENT_POSTURE_ID;

/** What opens must be possible to save and to open again. @param {Doc} doc @returns {Issue[]} */
function sizeIssues(doc) {
  const { length } = writeRobotXml(doc);
  if (length <= MAX_TEXT_LENGTH) return [];
  const message = `The model would be saved with ${length} characters; expected at most ${MAX_TEXT_LENGTH}.`;
  return [fileIssue('too-large', message)];
}

/** @param {Issue} a @param {Issue} b */
const byLine = ({ line: a = Infinity }, { line: b = Infinity }) => (a === b ? 0 : a - b);
