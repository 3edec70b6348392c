/**
 * What a run of code on the model has shown: in a sentence, along the program, what was found with its lines, and each move.
 *
 * @import { Verified } from './codeVerifier.js'
 * @import { CheckedMove, Verification } from '../../model/controller/verifyCode.js'
 * @import { CodeFinding } from '../../model/controller/runCode.js'
 * @import { RobotDoc } from '../../model/document.js'
 */
import { isSliding } from '../../model/document.js';
import { roundedUp } from '../../model/controller/certificate.js';
import { LANES, moveLevels } from '../../model/controller/moveLevels.js';
import { fromKernel } from '../../model/units.js';
import { h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { VERIFY } from '../words/writeCode.js';
import { iconButton } from './writtenView.js';

/** More than a person reads. */
const MOST_FINDINGS = 200;
const MOST_MOVES = 500;
const PENDANT = /** @type {const} */ ({ length: 'mm', angle: 'deg' });

/**
 * @param {Verified} verified
 * @param {RobotDoc} robot
 * @param {boolean} isWhole  whether each move is shown, too
 * @returns {HTMLElement[]}
 */
export function drawVerification({ verification, files, fate }, robot, isWhole) {
  const { moves, findings } = verification;
  const errors = findings.filter(({ severity }) => severity === 'error').length;
  const assumes =
    robot.joints.some(({ velocity }) => velocity === undefined) && moves.some(({ margins }) => margins.rate);
  return [
    h(
      'div',
      { class: `verify-head ${errors > 0 ? 'is-bad' : 'is-good'}` },
      icon(errors > 0 ? 'octagon' : 'checkCircle'),
      h('p', {}, [fate === 'refused' ? VERIFY.notSaved : '', headline(verification, errors)].filter(Boolean).join(' ')),
      fate === 'refused' &&
        h('button', { type: 'button', class: 'btn btn-small btn-outline', 'data-action': 'force' }, VERIFY.saveAll),
      iconButton('close-found', 'close', VERIFY.close),
    ),
    ...(moves.length > 0 ? [strip(verification)] : []),
    findingsList(findings, files.length > 1),
    ...(moves.length > 0 ? [movesTable(verification, robot, isWhole)] : []),
    h(
      'p',
      { class: 'verify-note' },
      [roundingText(verification), VERIFY.corners, assumes && VERIFY.assumedRates].filter(Boolean).join(' '),
    ),
  ];
}

/** @param {Verification} verification @param {number} errors */
function headline({ moves, deviation: { millimetres, degrees }, isCompared }, errors) {
  if (!isCompared) return errors > 0 ? VERIFY.aloneBad(errors) : moves.length === 0 ? VERIFY.nothing : VERIFY.alone;
  return errors > 0 ? VERIFY.bad(errors) : VERIFY.good(roundedUp(millimetres), roundedUp(degrees));
}

/** @param {Verification} verification */
function roundingText({ moves, isCompared }) {
  if (!isCompared || moves.length === 0) return '';
  const most = (/** @type {'millimetres' | 'degrees'} */ what) =>
    Math.max(...moves.map(({ rounding }) => rounding[what]));
  return VERIFY.rounding(roundedUp(most('millimetres')), roundedUp(most('degrees')));
}

/** A lane for each of what is looked at, a cell for each move; a click goes to its line, as the table's buttons do. @param {Verification} verification */
function strip(verification) {
  const levels = verification.moves.map((move) => moveLevels(verification, move));
  return h(
    'div',
    { class: 'verify-strip', 'aria-hidden': 'true' },
    LANES.flatMap((lane) => [
      h('span', { class: 'verify-lane' }, VERIFY.lanes[lane]),
      h(
        'div',
        { class: 'verify-cells' },
        verification.moves.map((move, i) =>
          h('span', {
            class: `is-${levels[i][lane]}`,
            title: `${VERIFY.toLine(move.file, move.line)}: ${VERIFY.lanes[lane]}, ${VERIFY.levels[levels[i][lane]]}`,
            ...place(move),
          }),
        ),
      ),
    ]),
  );
}

/** @param {{ file: string, line: number }} where */
const place = ({ file, line }) => ({ 'data-at-file': file, 'data-at-line': line });

/** @param {readonly CodeFinding[]} findings @param {boolean} isSeveral  files */
function findingsList(findings, isSeveral) {
  if (findings.length === 0) return h('p', { class: 'verify-note' }, VERIFY.noFindings);
  return h(
    'ul',
    { class: 'verify-list', 'aria-label': VERIFY.findings },
    findings.slice(0, MOST_FINDINGS).map((finding) => {
      const { severity, message, file, line } = finding;
      return h(
        'li',
        { class: severity === 'error' ? 'is-bad' : 'is-warn' },
        icon(severity === 'error' ? 'octagon' : 'exclamation'),
        h(
          'span',
          {},
          line > 0 && lineButton(finding, isSeveral ? VERIFY.toLine(file, line) : VERIFY.line(line)),
          ` ${message}`,
        ),
      );
    }),
    findings.length > MOST_FINDINGS && h('li', {}, VERIFY.more(findings.length - MOST_FINDINGS)),
  );
}

/** @param {{ file: string, line: number }} where @param {string} text */
const lineButton = (where, text) => h('button', { type: 'button', class: 'verify-link', ...place(where) }, text);

/** @param {Verification} verification @param {RobotDoc} robot @param {boolean} isWhole */
function movesTable(verification, robot, isWhole) {
  const { moves } = verification;
  const columns = /** @type {(keyof typeof VERIFY.columns)[]} */ (Object.keys(VERIFY.columns));
  return h(
    'details',
    { class: 'verify-moves', open: isWhole },
    h('summary', {}, VERIFY.moves(moves.length)),
    h(
      'div',
      { class: 'verify-scroll', tabindex: 0, role: 'group', 'aria-label': VERIFY.movesTable },
      h(
        'table',
        {},
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            columns.map((key) => h('th', { scope: 'col' }, VERIFY.columns[key])),
          ),
        ),
        h(
          'tbody',
          {},
          moves.slice(0, MOST_MOVES).map((move) => moveRow(verification, move, robot)),
        ),
      ),
      moves.length > MOST_MOVES && h('p', { class: 'verify-note' }, VERIFY.more(moves.length - MOST_MOVES)),
    ),
  );
}

/** @param {Verification} verification @param {CheckedMove} move @param {RobotDoc} robot */
function moveRow(verification, move, robot) {
  const levels = moveLevels(verification, move);
  const { deviation, margins, motion, configuration } = move;
  const { limit, singularity, rate } = margins;
  const number = (/** @type {string} */ text, /** @type {string} */ level) =>
    h('td', { class: `value is-${level}` }, text);
  const far = (/** @type {number | undefined} */ value) =>
    value === undefined || !Number.isFinite(value) ? '–' : fixed(value, 4);
  return h(
    'tr',
    {},
    h('th', { scope: 'row' }, lineButton(move, String(move.line))),
    h('td', {}, [VERIFY.kinds[motion], configuration].filter(Boolean).join(' · ')),
    number(far(deviation?.millimetres), levels.way),
    number(far(deviation?.degrees), levels.way),
    number(limit ? `${VERIFY.joint(limit.joint + 1)} ${roomText(limit, robot)}` : '–', levels.limit),
    number(fixed(singularity, 3), levels.singularity),
    number(rate ? `${VERIFY.joint(rate.joint + 1)} ${fixed(100 * rate.share, 0)}%` : '–', levels.rate),
  );
}

/** @param {{ joint: number, room: number }} limit @param {RobotDoc} robot */
function roomText({ joint, room }, { joints }) {
  const slides = isSliding(joints[joint]);
  const value = fixed(fromKernel(slides ? 'length' : 'angle', room, PENDANT), 1);
  return slides ? `${value} mm` : `${value}°`;
}
