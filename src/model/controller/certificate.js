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
 * @typedef {{ millimetres: number, degrees: number, model: string, version: string }} Certificate
 * @typedef {'none' | 'altered' | 'other-files' | 'other-model' | 'valid'} CertificateStatus
 *   other-files: the text is as it was, those that came with it are not
 */
import { fingerprint } from '../fingerprint.js';

const BLANK = '--------';
const DIGITS = 4;
const TEXT = /text (?:[0-9a-f]{8}|-{8}) set (?:[0-9a-f]{8}|-{8})/;
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
  const [millimetres, degrees] = [deviation.millimetres, deviation.degrees].map(roundedUp);
  const lines = [
    `Check ${millimetres}mm ${degrees}deg`,
    `model ${modelPrint(robot)} by ${program.version.replace(/[^0-9A-Za-z.-]/g, '')}`.slice(0, 32),
    `text ${BLANK} set ${BLANK}`,
  ];
  const written = write({ ...program, check: lines }, options);
  const set = setPrint(written.files);
  return {
    ...written,
    files: written.files.map((file) => ({ ...file, text: stamped(file.text, textPrint(file.text), set) })),
  };
}

/** @param {number} value */
const roundedUp = (value) => (Math.ceil(value * 10 ** DIGITS) / 10 ** DIGITS).toFixed(DIGITS);

/** Line ends aside, which travel changes. @param {string} text */
const bare = (text) => text.replace(/\r\n?/g, '\n').replace(TEXT, `text ${BLANK} set ${BLANK}`);

/** @param {string} text */
const textPrint = (text) => fingerprint(bare(text));

/** @param {readonly CodeFile[]} files */
const setPrint = (files) =>
  fingerprint(
    [...files]
      .sort((a, b) => (a.name < b.name ? -1 : 1))
      .map(({ text }) => bare(text))
      .join('\0'),
  );

/** The blanks were printed; only they are filled in. @param {string} text @param {string} own @param {string} set */
const stamped = (text, own, set) => text.replace(TEXT, `text ${own} set ${set}`);

/** @param {string} text @returns {Certificate | null} null where there is none */
export function readCertificate(text) {
  const [checked, model] = [CHECKED.exec(text), MODEL.exec(text)];
  if (!checked || !model || !TEXT.test(text)) return null;
  return { millimetres: Number(checked[1]), degrees: Number(checked[2]), model: model[1], version: model[2] };
}

/**
 * Whether files are what was certified.
 * @param {readonly CodeFile[]} files
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
