import { expect, test } from 'vitest';
import { decodeText } from '../../../src/io/decodeText.js';
import { hasErrors } from '../../../src/io/fileIssues.js';
import { readRobotXml } from '../../../src/io/robotXml.js';
import { validateDocument } from '../../../src/model/validate.js';
import { BAD_FILES } from './files.js';

/** @import { Issue } from '../../../src/model/issues.js' */

/** @param {Uint8Array} bytes @returns {ReturnType<typeof readRobotXml>} */
function open(bytes) {
  const { text, issues } = decodeText(bytes);
  if (text === null) return { doc: null, issues };
  const read = readRobotXml(text);
  return { doc: read.doc, issues: [...issues, ...read.issues] };
}

/** @param {ReturnType<typeof readRobotXml>} answer */
const outcome = ({ doc, issues }) => (doc ? (issues.length > 0 ? 'accept_warn' : 'accept') : 'reject');

test('every bad or odd file of the collection has the outcome that its manifest states', () => {
  const stated = BAD_FILES.filter(({ expect: outcome }) => outcome !== 'any');
  const outcomes = stated.map(({ file, bytes }) => [file, outcome(open(bytes))]);
  expect(outcomes).toEqual(stated.map((entry) => [entry.file, entry.expect]));
});

test('a document comes with warnings at most, a refusal with an error', () => {
  for (const { file, bytes } of BAD_FILES) {
    const { doc, issues } = open(bytes);
    expect({ file, hasErrors: hasErrors(issues) }).toEqual({ file, hasErrors: doc === null });
    if (doc) expect(validateDocument(doc)).toEqual([]);
  }
});

test('every message is one short sentence, with its line where there is one', () => {
  for (const { file, bytes } of BAD_FILES) {
    for (const { message, line } of open(bytes).issues) {
      expect({ file, message }).toEqual({
        file,
        message: expect.stringMatching(/^[^\p{Cc}\p{Cf}\u2028\u2029]{20,400}\.$/u),
      });
      expect(message.startsWith(`Line ${line}: `)).toBe(line !== undefined);
    }
  }
});

/** @param {string} name @returns {Issue[]} */
const issuesOf = (name) => open(BAD_FILES.filter(({ file }) => file.includes(name))[0].bytes).issues;

test.for([
  ['empty_model', 'The file is empty; expected a robot file.'],
  ['json-instead', 'The file begins with "{"robot":1}"; expected XML, which begins with "<".'],
  ['html-instead', 'The file is a web page (HTML); expected the robot file itself, not a page that shows it.'],
  ['png-bytes', 'The file is not text; expected a robot file.'],
  ['truncated-25', 'Line 3: the element <source> is not closed: expected </source>, found the end of the file.'],
  ['two-roots', 'Line 31: there is more after the end of the root element; expected the end of the file.'],
  ['dup-attribute', 'Line 5: the attribute "id" is there twice in one element; expected it once.'],
  ['nul-byte', 'Line 3: the character U+0000 stands here, which XML forbids; expected it to be taken out.'],
  ['latin1-bytes', 'Line 1: the file has bytes here that are not UTF-8; expected it to be saved as UTF-8.'],
  [
    'billion-laughs',
    'Line 2: the file has a document type declaration, <!DOCTYPE; expected none, because a robot file needs none and it can do harm.',
  ],
  ['number_dh-d-12abc', 'Line 6: <dh> of joint "joint_1" has d="12abc"; expected a number such as 12.5.'],
  ['1-joint', 'Line 4: <chain> has 1 <joint>; expected 2 to 6.'],
  [
    'velocity-0',
    'Line 7: <limits> of joint "joint_1" has velocity="0"; expected a number above 0 and up to 1000000000.',
  ],
  ['missing-dh', 'Line 5: joint "joint_1" has no <dh>; expected one.'],
  ['version-2-0', 'Line 2: the file has version="2.0"; expected version 1.x, such as 1.0.'],
  ['convention-craig', 'Line 2: <robotModel> has convention="craig"; expected standard or modified.'],
  [
    'wrong-namespace',
    'Line 2: <robotModel> has the namespace "urn:example:another-model:1"; expected <robotModel xmlns="urn:denavit:robot-model:1">.',
  ],
  ['rpy-and-quat', 'Line 4: the base has both rpy and a quaternion; expected one of them.'],
  ['coupling-cycle', 'Line 8: the controller of joint "joint_1" is coupled to itself; expected another joint.'],
  [
    'joint-id-evil',
    'Line 5: joint "\\u{202E}evil" has id="\\u{202E}evil"; expected a letter or _, then letters, digits or _, at most 64 characters.',
  ],
])('%s is refused in plain words', ([name, message]) => {
  expect(issuesOf(name).filter(({ severity }) => severity === 'error')[0].message).toBe(message);
});

test.for([
  ['utf16-le-bom', 'The file is encoded as UTF-16; saving it will make it UTF-8.'],
  ['declared-shift-jis', 'Line 1: the file says encoding="Shift_JIS" but is UTF-8, as which it was read.'],
  ['version-1-7', 'Line 2: the file has version="1.7", newer than 1.0; what is new in it is not known here.'],
  ['all-zero', 'Line 2: all link lengths and offsets of the robot are 0, so all its joints are in one place.'],
  ['unit-mm', 'Line 2: all links of the robot together are 0.00116 m long, so its length unit "mm" may be wrong.'],
  ['quat-not-unit', 'Line 4: the base has a quaternion of length 1.001; it was brought to length 1.'],
])('%s is opened with a warning in plain words', ([name, message]) => {
  expect(issuesOf(name).map((issue) => issue.message)).toEqual([message]);
});

test('a posture outside the limits is opened with a warning, under the older name of postures too', () => {
  expect(issuesOf('q-outside-limits').map(({ message }) => message)).toEqual([
    'Line 30: <configurations> is an older name; expected <postures>, as which it was read.',
    'Line 30: posture "home" has 999 for joint "joint_1", outside its limits, -170 to 170.',
  ]);
});
