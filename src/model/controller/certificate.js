/**
 * What a file says of itself in its header: how far it is from the program, by a run of the code on the model of the arm; of
 * which model; and a fingerprint of its text, so that a text that was altered can be told. It keeps no secret: it is against
 * mistakes, not against people.
 *
 * @import { RobotDoc } from '../document.js'
 * @import { Deviation } from './moveMargins.js'
 * @import { CodeFile, NeutralProgram, WriteOptions, Written } from '../../karel/write/neutral.js'
 *
 * @typedef {(program: NeutralProgram, options?: WriteOptions) => Written} Writer
 * @typedef {(program: NeutralProgram, options?: WriteOptions) => Generator<null, Written>} SlicedWriter
 * @typedef {{ millimetres: number, degrees: number, model: string, version: string }} Certificate
 * @typedef {'none' | 'altered' | 'other-files' | 'other-model' | 'valid'} CertificateStatus
 *   other-files: the text is as it was, those that came with it are not
 */
import { fingerprint } from '../fingerprint.js';

const BLANK = '--------';
const BLANKS = `text ${BLANK} set ${BLANK}`;
/** Of a remark of TP. */
const LONGEST_LINE = 32;
const DIGITS = 4;
const TEXT = /text (?:[0-9a-f]{8}|-{8}) set (?:[0-9a-f]{8}|-{8})/;
const CHECK_LINE = /Check (?:none: not verified yet|[\d.]+mm [\d.]+deg)/;
const CHECKED = /Check ([\d.]+)mm ([\d.]+)deg/;
const MODEL = /model ([0-9a-f]{8}) by ([0-9A-Za-z.-]+)/;

/** Of everything about a robot that moves its tool or its numbers on the pendant. @param {RobotDoc} robot */
export const modelPrint = ({ convention, base, tool, joints, units }) =>
  fingerprint(
    JSON.stringify([
      ...[convention, units, base, tool],
      joints.map(({ type, theta, d, a, alpha, lower, upper, controller }) => [
        type,
        theta,
        d,
        a,
        alpha,
        lower,
        upper,
        controller,
      ]),
    ]),
  );

/** What stands in the header instead until the code has been run: as many lines. @param {RobotDoc} robot @param {string} version */
export const uncheckedLines = (robot, version) => ['Check none: not verified yet', modelLine(robot, version), BLANKS];

/** @param {RobotDoc} robot @param {string} version */
const modelLine = (robot, version) =>
  `model ${modelPrint(robot)} by ${version.replace(/[^0-9A-Za-z.-]/g, '')}`.slice(0, LONGEST_LINE);

/**
 * The files with their certificate, written anew.
 * @param {NeutralProgram} program
 * @param {Writer} write
 * @param {WriteOptions} options
 * @param {RobotDoc} robot
 * @param {Deviation} deviation
 * @returns {Written}
 */
export function withCertificate(program, write, options, robot, deviation) {
  const written = write(checkedProgram(program, robot, deviation), options);
  return { ...written, files: stamped(written.files) };
}

/**
 * The same, in slices.
 * @param {NeutralProgram} program
 * @param {SlicedWriter} write
 * @param {WriteOptions} options
 * @param {RobotDoc} robot
 * @param {Deviation} deviation
 * @returns {Generator<null, Written>}
 */
export function* certifiedInSlices(program, write, options, robot, deviation) {
  const written = yield* write(checkedProgram(program, robot, deviation), options);
  yield null;
  return { ...written, files: stamped(written.files) };
}

/** @param {NeutralProgram} program @param {RobotDoc} robot @param {Deviation} deviation @returns {NeutralProgram} */
const checkedProgram = (program, robot, deviation) => ({
  ...program,
  check: [checkLine(deviation), modelLine(robot, program.version), BLANKS],
});

/**
 * Files that have the lines of a certificate, with another one in them.
 * @param {readonly CodeFile[]} files
 * @param {RobotDoc} robot
 * @param {string} version
 * @param {Deviation} deviation
 * @returns {CodeFile[] | null} null where one of them has none
 */
export function recertified(files, robot, version, deviation) {
  if (!files.every(({ text }) => [CHECK_LINE, MODEL, TEXT].every((line) => line.test(text)))) return null;
  return stamped(
    files.map((file) => ({
      ...file,
      text: file.text
        .replace(TEXT, BLANKS)
        .replace(CHECK_LINE, checkLine(deviation))
        .replace(MODEL, modelLine(robot, version)),
    })),
  );
}

/** @param {Deviation} deviation */
const checkLine = ({ millimetres, degrees }) => `Check ${roundedUp(millimetres)}mm ${roundedUp(degrees)}deg`;

/** As "at most" is said: never less than it is. @param {number} value */
export const roundedUp = (value) => (Math.ceil(value * 10 ** DIGITS) / 10 ** DIGITS).toFixed(DIGITS);

/** Line ends aside, which travel changes. @param {string} text */
const bare = (text) => text.replace(/\r\n?/g, '\n').replace(TEXT, BLANKS);

/** @param {string} text */
const textPrint = (text) => fingerprint(bare(text));

/** Whatever the files are called by now. @param {readonly { text: string }[]} files */
const setPrint = (files) =>
  fingerprint(
    files
      .map(({ text }) => bare(text))
      .sort()
      .join('\0'),
  );

/** The blanks were printed; only they are filled in. @param {readonly CodeFile[]} files */
function stamped(files) {
  const set = setPrint(files);
  return files.map((file) => ({ ...file, text: file.text.replace(TEXT, `text ${textPrint(file.text)} set ${set}`) }));
}

/** @param {string} text @returns {Certificate | null} null where there is none */
export function readCertificate(text) {
  const [checked, model] = [CHECKED.exec(text), MODEL.exec(text)];
  if (!checked || !model || !TEXT.test(text)) return null;
  return { millimetres: Number(checked[1]), degrees: Number(checked[2]), model: model[1], version: model[2] };
}

/** By which the files of a set know each other; null where there is none. @param {string} text */
export const setOf = (text) => / set ([0-9a-f]{8})/.exec(TEXT.exec(text)?.[0] ?? '')?.[1] ?? null;

/**
 * Whether files are what was certified.
 * @param {readonly { text: string }[]} files
 * @param {RobotDoc} robot
 * @returns {CertificateStatus[]} of each file
 */
export function certificateStatus(files, robot) {
  const set = setPrint(files);
  return files.map(({ text }) => {
    const certificate = readCertificate(text);
    const found = TEXT.exec(text)?.[0] ?? '';
    if (!certificate) return 'none';
    if (!found.startsWith(`text ${textPrint(text)} `)) return 'altered';
    if (!found.endsWith(` set ${set}`)) return 'other-files';
    return certificate.model === modelPrint(robot) ? 'valid' : 'other-model';
  });
}
