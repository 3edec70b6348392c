/**
 * Moves as TP instructions, and targets as TP positions.
 *
 * @import { TpInstruction, TpListing, TpMotion, TpOption, TpPart, TpPosition, TpRegister } from '../tp/tree.js'
 * @import { NeutralMove, NeutralProgram, NeutralStep, NeutralTarget, WriteNote } from './neutral.js'
 */
import { plainText, wrapped } from '../plainText.js';
import { inPieces } from '../slices.js';
import { number, register } from '../tp/tree.js';
import { MAX_REMARK_LENGTH, programComment, titleOf } from './header.js';
import { isWrittenAsPosition, movesOf, rounded, roundedWaits } from './neutral.js';

/** Of the seconds of WAIT. */
const WAIT_DECIMALS = 2;

/** What speeds a listing takes (HandlingTool operator's manual, 7.2). */
const SPEEDS = /** @type {const} */ ({
  '%': { unit: '%', least: 1, most: 100 },
  'mm/s': { unit: 'mm/sec', least: 1, most: 2000 },
  'deg/s': { unit: 'deg/sec', least: 1, most: 500 },
});

/** @param {NeutralMove['speed']} speed */
export function speedFor({ value, unit }) {
  const { least, most, unit: written } = SPEEDS[unit];
  return { value: Math.min(most, Math.max(least, Math.round(value))), unit: written };
}

/** @param {Pick<NeutralMove, 'motion' | 'speed' | 'ending' | 'acceleration'>} move @param {TpRegister} target @param {TpRegister} [via] @returns {TpMotion} */
export function motionFor({ motion, speed, ending, acceleration }, target, via) {
  const { value, unit } = speedFor(speed);
  /** @type {TpOption[]} */
  const options = acceleration === 100 ? [] : [{ name: 'ACC', value: number(Math.round(Math.max(1, acceleration))) }];
  return {
    ...{ kind: 'motion', motion: motion === 'joint' ? 'J' : motion === 'linear' ? 'L' : 'C', target },
    ...(via && { via }),
    speed: { value: number(value), unit },
    termination:
      ending.kind === 'fine'
        ? { kind: 'FINE' }
        : { kind: ending.kind === 'percent' ? 'CNT' : 'CR', value: number(Math.round(ending.value)) },
    options,
  };
}

/** @param {NeutralTarget} target @param {number} index @param {NeutralMove} move @param {NeutralProgram} program @returns {TpPosition} */
export function positionFor(target, index, { userFrame, tool }, { slides }) {
  const isPosition = isWrittenAsPosition(target, 'fanuc');
  return {
    ...{ kind: 'position', number: index },
    groups: [
      {
        ...{ group: 1, userFrame, toolFrame: tool },
        ...(isPosition && { configuration: target.fanuc ?? '' }),
        values: isPosition
          ? target.position.map((value, i) => ({
              name: 'XYZWPR'[i],
              value: rounded(value),
              unit: i < 3 ? 'mm' : 'deg',
            }))
          : target.joints.map((value, i) => ({
              name: `J${i + 1}`,
              value: rounded(value),
              unit: slides[i] ? 'mm' : 'deg',
            })),
      },
    ],
  };
}

/**
 * The lines of a program, moves as `write` makes them.
 * @param {NeutralProgram} program
 * @param {(move: NeutralMove) => TpMotion} write
 * @returns {Generator<null, TpInstruction[]>}
 */
export function* linesFor({ steps }, write) {
  /** @type {TpInstruction[]} */
  const lines = [];
  let [userFrame, tool] = [-1, -1];
  yield* inPieces(steps, (piece) => {
    for (const step of piece) {
      if (step.kind !== 'move') {
        lines.push(...lineFor(step));
        continue;
      }
      if (step.comment) lines.push(...remarks(step.comment));
      if (step.userFrame !== userFrame) lines.push(setting('UFRAME_NUM', step.userFrame));
      if (step.tool !== tool) lines.push(setting('UTOOL_NUM', step.tool));
      [userFrame, tool] = [step.userFrame, step.tool];
      lines.push(write(step));
    }
  });
  return lines;
}

/** @param {Exclude<NeutralStep, NeutralMove>} step @returns {TpInstruction[]} */
function lineFor(step) {
  switch (step.kind) {
    case 'wait':
      return [{ kind: 'wait', seconds: number(step.seconds) }];
    case 'output':
      return [{ kind: 'assign', target: register('DO', step.port), value: onOff(step.value) }];
    case 'input': {
      const condition = /** @type {const} */ ({ kind: 'binary', operator: '=', left: register('DI', step.port) });
      return [{ kind: 'wait-for', condition: { ...condition, right: onOff(step.value) } }];
    }
    case 'call':
      return [{ kind: 'call', program: step.program, args: [] }];
    case 'comment':
      return remarks(step.text);
  }
}

/** @param {boolean} value @returns {{ kind: 'word', word: string }} */
const onOff = (value) => ({ kind: 'word', word: value ? 'ON' : 'OFF' });

/** @param {string} word @param {number} value @returns {TpInstruction} */
export const setting = (word, value) => ({ kind: 'assign', target: { kind: 'word', word }, value: number(value) });

/** A remark ends at a semicolon, and holds so many characters. @param {string} text @returns {TpInstruction[]} */
export const remarks = (text) =>
  wrapped(plainText(text).replaceAll(';', ','), MAX_REMARK_LENGTH).map((line) => ({ kind: 'remark', text: line }));

/** What stands at the head of the lines. @param {NeutralProgram} program @param {readonly string[]} about @returns {TpInstruction[]} */
export const headRemarks = (program, about) => [
  ...[titleOf(program), `Written by Denavit ${plainText(program.version)}.`].flatMap(remarks),
  ...remarks('CAUTION: no controller has run this. Check it at low speed first.'),
  ...about.flatMap(remarks),
  ...program.frames.flatMap(({ kind, number: index, position }) =>
    remarks(`${kind === 'user' ? 'UFRAME' : 'UTOOL'} ${index} is ${position.map((value) => rounded(value)).join(' ')}`),
  ),
  ...(program.check ?? []).map((text) => /** @type {const} */ ({ kind: 'remark', text })),
];

/** @param {string} name @param {Pick<NeutralProgram, 'robotName' | 'generatedAt'>} program @param {readonly TpInstruction[]} lines @param {readonly TpPosition[]} positions @returns {TpListing} */
export function listingFor(name, program, lines, positions) {
  const date = dateText(program.generatedAt);
  const attributes = {
    ...{
      OWNER: 'MNEDITOR',
      COMMENT: `"${programComment(program.robotName)}"`,
      PROG_SIZE: '0',
      CREATE: date,
      MODIFIED: date,
    },
    ...{ FILE_NAME: '', VERSION: '0', LINE_COUNT: String(lines.length), MEMORY_SIZE: '0', PROTECT: 'READ_WRITE' },
    ...{
      STACK_SIZE: '0',
      TASK_PRIORITY: '50',
      TIME_SLICE: '0',
      BUSY_LAMP_OFF: '0',
      ABORT_REQUEST: '0',
      PAUSE_REQUEST: '0',
    },
    ...{ DEFAULT_GROUP: '1,*,*,*,*', CONTROL_CODE: '00000000 00000000' },
  };
  /** @type {TpPart[]} */
  const parts = [
    { kind: 'section', name: 'PROG', text: name },
    { kind: 'section', name: 'ATTR', text: '' },
    ...Object.entries(attributes).map(([key, value]) => /** @type {const} */ ({ kind: 'attribute', name: key, value })),
    { kind: 'section', name: 'MN', text: '' },
    ...lines.map((instruction, i) => /** @type {const} */ ({ kind: 'line', number: i + 1, instruction })),
    { kind: 'section', name: 'POS', text: '' },
    ...positions,
    { kind: 'section', name: 'END', text: '' },
  ];
  return { kind: 'tp-listing', parts, lineEnd: '\r\n' };
}

/** @param {string} time  ISO 8601 */
function dateText(time) {
  const match = /^\d\d(\d\d-\d\d-\d\d)T(\d\d:\d\d:\d\d)/.exec(time);
  if (!match) throw new RangeError(`Expected a time such as 2026-07-01T12:00:00Z, got ${JSON.stringify(time)}.`);
  return `DATE ${match[1]}  TIME ${match[2]}`;
}

/** What of moves FANUC takes otherwise than it was asked. @param {NeutralProgram} program @returns {WriteNote[]} */
export function fanucNotes(program) {
  const moves = movesOf(program);
  /** @type {WriteNote[]} */
  const notes = [];
  const note = (/** @type {string} */ code, /** @type {string} */ message) =>
    void notes.push({ severity: 'note', code, message });
  if (moves.some(({ ending }) => ending.kind === 'distance'))
    note(
      'unverified-ending',
      'Corners by distance are written as CR, which not every controller has, and which is not verified.',
    );
  if (moves.some(({ target }) => isWrittenAsPosition(target, 'fanuc')))
    note(
      'unverified-configuration',
      'Of configurations, D and B, and which axes the turn numbers count (here J1, J4, J6), are not verified.',
    );
  for (const { speed, step } of moves) {
    const written = speedFor(speed).value;
    if (written !== speed.value)
      notes.push({
        severity: 'note',
        code: 'speed',
        message: `Step ${step + 1} has a speed of ${written} ${speed.unit}, not ${speed.value}.`,
        step,
      });
  }
  return [...notes, ...roundedWaits(program, WAIT_DECIMALS)];
}
