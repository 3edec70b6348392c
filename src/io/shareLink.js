/**
 * A document in an address, behind the # that no server is sent:
 *
 *     #model=1.<the robot file, packed>.<its fingerprint>&tab=code&camera=…
 *
 * 1 is the version of this form; the file has its own. The packed file is opened as any file is, by the same reader with the
 * same rules, so what a link holds can be no worse than what a file holds. Whatever the address is, reading does not throw.
 *
 * @import { Doc } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 * @import { Look } from './readLook.js'
 *
 * @typedef {object} LinkAnswer
 * @property {boolean} hasModel      it speaks of a model, be it a broken one
 * @property {Doc | null} doc        null when there is an error among the issues, or no model
 * @property {Issue[]} issues
 * @property {Look} look
 */
import { fileIssue } from './fileIssues.js';
import { fingerprint } from '../model/fingerprint.js';
import { readLook } from './readLook.js';
import { pack, unpack } from './pack.js';
import { readRobotXml } from './robotXml.js';
import { writeRobotXml } from './robotXmlWriter.js';

const VERSION = 1;
/** More letters than any link has that is made here; they are not even looked at. */
const MOST_LETTERS = 1_500_000;
/** What a sentence around a link may leave at its end. */
const STRAY = /[^\w-]+$/;
const MODEL = /^(\d{1,6})\.(.*)$/s;
const VERSION_1 = /^(.*)\.([0-9a-f]{8})$/s;
/** A place on a page, as addresses of other pages have it. */
const PLACE = /^[\w-]{0,64}$/;

/**
 * @param {Doc} doc  sound
 * @returns {string | null} what follows the #; null when the document is too large for a link
 */
export function writeShareLink(doc) {
  const text = writeRobotXml(doc);
  const packed = pack(text);
  return packed && `model=${VERSION}.${packed}.${fingerprint(text)}`;
}

/** @param {string} hash  as in location.hash @returns {LinkAnswer} */
export function readShareLink(hash) {
  if (hash.length > MOST_LETTERS) return refused(TOO_LARGE);
  const fragment = hash.replace(/^#/, '').replace(STRAY, '');
  const model = new URLSearchParams(fragment).get('model');
  if (model === null) {
    const look = readLook(fragment);
    const isLook = look.camera !== null || Object.keys(look.change).length > 0;
    if (isLook) return { hasModel: false, doc: null, issues: lookIssues(look), look };
    return PLACE.test(fragment) ? { hasModel: false, doc: null, issues: [], look } : refused(NO_LINK);
  }
  const opened = openModel(model);
  if (!opened.doc) return refused(...opened.issues);
  const look = readLook(fragment);
  return { hasModel: true, doc: opened.doc, issues: [...opened.issues, ...lookIssues(look)], look };
}

/** @param {string} model @returns {{ doc: Doc | null, issues: Issue[] }} */
function openModel(model) {
  const none = (/** @type {Issue} */ issue) => ({ doc: null, issues: [issue] });
  const [, version, rest] = MODEL.exec(model) ?? [];
  if (version === undefined) return none(/^\d{0,6}$/.test(model) ? CUT : DAMAGED);
  if (Number(version) !== VERSION) return none(Number(version) > VERSION ? newer(Number(version)) : DAMAGED);
  const [, packed, print] = VERSION_1.exec(rest) ?? [];
  if (packed === undefined) return none(/^[\w-]*(\.[0-9a-f]{0,7})?$/.test(rest) ? CUT : DAMAGED);
  const answer = unpack(packed);
  if ('fault' in answer) return none({ cut: CUT, damaged: DAMAGED, 'too-large': TOO_LARGE }[answer.fault]);
  if (fingerprint(answer.text) !== print) return none(DAMAGED);
  const { doc, issues } = readRobotXml(answer.text);
  if (doc) return { doc, issues };
  const { code, message } = issues.find(({ severity }) => severity === 'error') ?? issues[0];
  const reason = message.replace(/^[A-Z](?=[a-z ])/, (letter) => letter.toLowerCase());
  return none({ severity: 'error', code, path: '', message: `The link holds no model that can be opened: ${reason}` });
}

/** @param {Issue[]} issues @returns {LinkAnswer} */
const refused = (...issues) => ({ hasModel: true, doc: null, issues, look: readLook('') });

/** @param {Look} look @returns {Issue[]} */
const lookIssues = ({ refused: names }) => (names.length === 0 ? [] : [fileIssue('link-look', LOOK(names))]);

/** @param {readonly string[]} names */
const LOOK = (names) =>
  `What the link says of how the arm is looked at was not understood (${names.join(', ')}) and is left as it is.`;

const AGAIN = 'Copy it again, all of it, or ask for the model as a file.';
const CUT = fileIssue('link-cut', `The link is cut off: its end is missing, so no model was opened. ${AGAIN}`);
const DAMAGED = fileIssue(
  'link-damaged',
  `The link is damaged: it is not as it was made, so no model was opened. ${AGAIN}`,
);
const TOO_LARGE = fileIssue(
  'link-too-large',
  'The link holds more than the 1 MB that a model may have, so it was not unpacked and no model was opened.',
);
const NO_LINK = fileIssue('link-unknown', `What follows the # in the address is no link to a model. ${AGAIN}`);

/** @param {number} version */
const newer = (version) =>
  fileIssue(
    'link-newer',
    `The link was made by a newer Denavit (its form has the number ${version}, this page knows ${VERSION}), so no model was opened. Load the page anew, or ask for the model as a file.`,
  );
