/**
 * A program as KAREL that moves by itself, for controllers up to R-J3iB. Later ones deprecate MOVE, or have none.
 *
 * @import { Designator, Expression, Statement } from '../tree.js'
 * @import { NeutralMove, NeutralProgram, NeutralStep, NeutralTarget, WriteNote, WriteOptions, Written } from './neutral.js'
 */
import { fanucNames } from '../fanucNames.js';
import { printInSlices } from '../printer.js';
import { finished, inPieces } from '../slices.js';
import { binary, call, integer, name, real } from '../tree.js';
import { headerLines, zeroOf } from './header.js';
import { assign, axisCountNotes, comment, karelProgram, OWN, targetParts } from './karelParts.js';
import { isWrittenAsPosition, missingConfigurations, movesOf, roundedWaits } from './neutral.js';

const MOTION = { joint: 'JOINT', linear: 'LINEAR', circular: 'CIRCULAR' };

/** DELAY counts milliseconds. */
const DELAY_DECIMALS = 3;
/** Of the full rates: tenths of a per cent. */
const SHARE_DECIMALS = 3;

/** What the program calls its own things, besides those of all. */
export const NAMES = { target: 'target_n', via: 'via_n', index: 'prog_idx' };

/** @param {NeutralProgram} program @param {WriteOptions} [options] @returns {Written} */
export const writeKarelMove = (program, options) => finished(writeKarelMoveInSlices(program, options));

/** The same, some moves at a time. @param {NeutralProgram} program @param {WriteOptions} [options] @returns {Generator<null, Written>} */
export function* writeKarelMoveInSlices(program, { programName = program.name } = {}) {
  const moves = movesOf(program);
  const own = fanucNames(programName, [...Object.values(OWN), ...Object.values(NAMES)]).karel;
  /** @type {WriteNote[]} */
  const notes = [
    {
      ...{ severity: 'warning', code: 'deprecated-move' },
      message:
        'KAREL MOVE is for R-J3iB and older controllers. Later ones deprecate it, may move unexpectedly, or refuse it.',
    },
    ...(program.notes ?? []),
    ...missingConfigurations(program, 'fanuc'),
    ...roundedWaits(program, DELAY_DECIMALS),
    {
      ...{ severity: 'note', code: 'unverified-move' },
      message: `How corners are rounded ($DECELTOL)${moves.some(({ ending }) => ending.kind === 'distance') ? '; by a distance they are written as NODECEL, which has none' : ''}, and that joints go at the share $SPEED / $SPEEDLIMJNT of their full rates, is not verified; accelerations are not written.`,
    },
    ...axisCountNotes(program),
  ];
  let [userFrame, tool] = [-1, -1];
  const statementsFor = (/** @type {NeutralStep} */ step) => {
    if (step.kind !== 'move') return otherStep(step);
    const frames = [
      ...(step.userFrame === userFrame ? [] : frameStatements('UFRAME', 'MNUFRAME', step.userFrame)),
      ...(step.tool === tool ? [] : frameStatements('UTOOL', 'MNUTOOL', step.tool)),
    ];
    [userFrame, tool] = [step.userFrame, step.tool];
    return [...(step.comment ? [comment(step.comment)] : []), ...frames, ...moveStatements(step)];
  };
  /** @type {Statement[]} */
  const body = [];
  yield* inPieces(program.steps, (piece) => void body.push(...piece.flatMap(statementsFor)));
  const header = headerLines(program, {
    does: 'For R-J3iB and older: this program moves by itself, with MOVE. It holds motion group 1 while it runs.',
    world: `User frame 0 is ${zeroOf(program)}; tool 0 is the flange.`,
    notes,
  });
  const tree = karelProgram(own, program, header, [], variablesFor(program), [], body);
  return { files: [{ name: `${own}.kl`, language: 'karel', text: yield* printInSlices(tree) }], notes };
}

/** @param {NeutralMove} move @returns {Statement[]} */
function moveStatements({ motion, target, via, speed, ending }) {
  const to = placed(target, NAMES.target);
  const past = via && placed(via, NAMES.via, OWN.via);
  /** @type {[string, Expression][]} */
  const settings = [
    ['MOTYPE', name(MOTION[motion])],
    ['TERMTYPE', name(ending.kind === 'fine' ? 'FINE' : ending.kind === 'percent' ? 'VARDECEL' : 'NODECEL')],
    ...(ending.kind === 'percent'
      ? [/** @type {[string, Expression]} */ (['DECELTOL', integer(Math.round(ending.value))])]
      : []),
    speed.unit === '%'
      ? ['SPEED', binary(jointSpeedLimit(), '*', real(speed.value / 100, SHARE_DECIMALS))]
      : [speed.unit === 'deg/s' ? 'ROTSPEED' : 'SPEED', real(speed.value, 1)],
  ];
  return [
    ...(past?.before ?? []),
    ...to.before,
    {
      kind: 'move',
      settings: settings.map(([variable, value]) => ({ variable: { kind: 'system', name: variable }, value })),
      target: { to: 'TO', position: to.value, ...(past && { via: past.value }) },
    },
  ];
}

/** @param {NeutralTarget} target @param {string} variable  of a position @param {string} [joints]  likewise */
function placed(target, variable, joints) {
  const { before, value, isJoint } = targetParts(target, joints);
  if (isJoint) return { before, value };
  return { before: [...before, assign(name(variable), value)], value: name(variable) };
}

/** Only those that are used. @param {NeutralProgram} program */
function variablesFor(program) {
  const moves = movesOf(program);
  const vias = moves.flatMap(({ via }) => (via ? [via] : []));
  const isPosition = (/** @type {NeutralTarget} */ target) => isWrittenAsPosition(target, 'fanuc');
  /** @type {[boolean, string, string][]} */
  const all = [
    [moves.some(({ target }) => isPosition(target)), NAMES.target, 'XYZWPR'],
    [vias.some(isPosition), NAMES.via, 'XYZWPR'],
    [!vias.every(isPosition), OWN.via, 'JOINTPOS'],
    [program.steps.some(({ kind }) => kind === 'call'), NAMES.index, 'INTEGER'],
  ];
  return all.flatMap(([isUsed, one, type]) => (isUsed ? [{ names: [one], type }] : []));
}

/** The chosen frame, by its number and its place. @param {string} own @param {string} table @param {number} index @returns {Statement[]} */
const frameStatements = (own, table, index) => [
  assign(system(`${table}NUM`, 1), integer(index)),
  assign(
    systemField(system('GROUP', 1), own),
    index === 0 ? systemField(system('MOR_GRP', 1), 'NILPOS') : system(table, 1, index),
  ),
];

/** The $SPEED of joints at their full rates, mm/s. */
const jointSpeedLimit = () => systemField(system('PARAM_GROUP', 1), 'SPEEDLIMJNT');

/** @param {string} variable @param {number[]} indices @returns {Designator} */
const system = (variable, ...indices) => ({
  kind: 'index',
  target: { kind: 'system', name: variable },
  indices: indices.map(integer),
});

/** @param {Designator} target @param {string} field @returns {Designator} */
const systemField = (target, field) => ({ kind: 'field', target, name: field, system: true });

/** @param {Exclude<NeutralStep, NeutralMove>} step @returns {Statement[]} */
function otherStep(step) {
  switch (step.kind) {
    case 'wait':
      return [{ kind: 'delay', milliseconds: integer(Math.round(step.seconds * 10 ** 3)) }];
    case 'output':
      return [assign(port('DOUT', step.port), name(step.value ? 'ON' : 'OFF'))];
    case 'input':
      return [
        { kind: 'wait', conditions: { terms: [binary(port('DIN', step.port), '=', name(step.value ? 'ON' : 'OFF'))] } },
      ];
    case 'call':
      return [call('CALL_PROG', [{ kind: 'string', value: step.program }, name(NAMES.index)])];
    case 'comment':
      return [comment(step.text)];
  }
}

/** @param {string} bank @param {number} index @returns {Expression} */
const port = (bank, index) => ({ kind: 'index', target: name(bank), indices: [integer(index)] });
