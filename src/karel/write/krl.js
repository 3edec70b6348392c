/**
 * A program as KRL for KUKA controllers: a `.src` with the moves and a `.dat` with the positions.
 *
 * @import { KrlDatum, KrlModule, KrlStatement } from '../krl/tree.js'
 * @import { NeutralMove, NeutralProgram, NeutralStep, NeutralTarget, WriteNote, WriteOptions, Written } from './neutral.js'
 */
import { plainText } from '../plainText.js';
import { INI_FOLD, INTERRUPTS, MAX_NAME_LENGTH } from '../krl/tree.js';
import { printKrl } from '../krl/printer.js';
import { finished, PIECE } from '../slices.js';
import { headerLines } from './header.js';
import { isWrittenAsPosition, missingConfigurations, movesOf, rounded } from './neutral.js';

const MOTION = /** @type {const} */ ({ joint: 'PTP', linear: 'LIN', circular: 'CIRC' });

/** Names of the language that a program cannot have. */
const TAKEN = new Set(
  (
    'AND ANIN ANOUT AXIS B_AND B_EXOR B_NOT B_OR BAS BOOL BRAKE CASE CCLOSE CHANNEL CHAR CIRC CIRC_REL CONFIRM CONST CONTINUE COPEN CREAD CWRITE ' +
    'DECL DEF DEFAULT DEFDAT DEFFCT DELAY DIGIN DISTANCE DO E6AXIS E6POS ELSE ELSEIF END ENDDAT ENDFCT ENDFOR ENDIF ENDLOOP ENDSPLINE ENDSWITCH ' +
    'ENDWHILE ENUM EXIT EXOR EXT EXTFCT FALSE FOR FRAME GLOBAL GOTO HALT IF IMPORT INTERRUPT IS INT LIN LIN_REL LOOP MAXIMUM MINIMUM NOT ON OFF OR ' +
    'PATH POS PRIO PTP PTP_REL PUBLIC PULSE REAL REPEAT RESUME RETURN SCIRC SEC SIGNAL SLIN SPL SPLINE SPTP SREAD STEP STRUC SWITCH SWRITE SYNC ' +
    'THEN TO TRIGGER TRUE UNTIL WAIT WHEN WHILE WITH'
  ).split(' '),
);

/** @param {string} wanted @returns {string} a name that KUKA takes */
export function krlName(wanted) {
  if (krlNameFault(wanted) === null) return wanted;
  const word = plainText(wanted)
    .replace(/[^A-Za-z0-9]+/g, '_')
    .replace(/^_+|_+$/g, '');
  const name = (/^[A-Za-z]/.test(word) ? word : `P_${word}`).slice(0, MAX_NAME_LENGTH).replace(/_+$/, '');
  return TAKEN.has(name.toUpperCase()) ? `${name}_1` : name;
}

/** What is against a name that somebody has typed; null: nothing. @param {string} name @returns {string | null} */
export function krlNameFault(name) {
  if (!/^[A-Za-z_][A-Za-z0-9_]*$/.test(name) || name.length > MAX_NAME_LENGTH)
    return `Expected a name of at most ${MAX_NAME_LENGTH} letters, digits and _, no digit first. Got "${name}".`;
  return TAKEN.has(name.toUpperCase()) ? `"${name}" is a word of KRL, and no name for a program.` : null;
}

/** @param {NeutralProgram} program @param {WriteOptions} [options] @returns {Written} */
export const writeKrl = (program, options) => finished(writeKrlInSlices(program, options));

/** The same, some moves at a time. @param {NeutralProgram} program @param {WriteOptions} [options] @returns {Generator<null, Written>} */
export function* writeKrlInSlices(program, { programName = program.name } = {}) {
  const name = krlName(programName);
  /** @type {KrlDatum[]} */
  const data = [];
  /** @type {KrlStatement[]} */
  const statements = [...iniFold()];
  /** @type {Record<string, number>} */
  const set = {};
  const change = (/** @type {string} */ key, /** @type {number} */ value, /** @type {KrlStatement} */ statement) => {
    if (set[key] !== value) statements.push(statement);
    set[key] = value;
  };
  const bas = (/** @type {string} */ what, /** @type {number} */ value) =>
    change(what, value, { kind: 'bas', what, value });
  const variable = (/** @type {string} */ target, /** @type {number} */ value) =>
    change(target, value, { kind: 'assign', target, value });
  const place = (/** @type {NeutralTarget} */ target, /** @type {boolean} */ needsPosition) => {
    const point = `XP${data.length + 1}`;
    data.push(datumFor(point, target, needsPosition));
    return point;
  };
  for (const [i, step] of program.steps.entries()) {
    if (i % PIECE === PIECE - 1) yield null;
    if (step.kind !== 'move') {
      statements.push(otherStep(step));
      continue;
    }
    if (step.comment) statements.push({ kind: 'comment', text: plainText(step.comment) });
    bas('TOOL', step.tool);
    bas('BASE', step.userFrame);
    setSpeed(step, bas, variable);
    const via = step.via && place(step.via, true);
    const target = place(step.target, step.motion !== 'joint');
    statements.push({
      kind: 'motion',
      motion: MOTION[step.motion],
      target,
      ...(via && { via }),
      approximation: setEnding(step, variable),
    });
  }
  const notes = notesFor(program);
  const header = headerLines(program, {
    does: `${name}.src moves through the positions of ${name}.dat; both belong in the same folder.`,
    world:
      'A B C of a position turn about z, y, x: the last of the three turns first. Base 0 is the world of the model; tool 0 is the flange.',
    notes,
    axis: 'A',
  });
  /** @type {KrlModule} */
  const module = { kind: 'krl', name, comments: header, statements, data };
  const { src, dat } = printKrl(module);
  return {
    files: [
      { name: `${name}.src`, language: 'krl', text: src },
      { name: `${name}.dat`, language: 'krl', text: dat },
    ],
    notes,
  };
}

/** As KUKA's own programs begin. @returns {KrlStatement[]} */
const iniFold = () => [
  { kind: 'comment', text: INI_FOLD[0] },
  ...INTERRUPTS.map((text) => /** @type {const} */ ({ kind: 'interrupt', text })),
  { kind: 'bas', what: 'INITMOV', value: 0 },
  { kind: 'comment', text: INI_FOLD[1] },
];

/**
 * @param {NeutralMove} move
 * @param {(what: string, value: number) => void} bas
 * @param {(target: string, value: number) => void} variable
 */
function setSpeed({ motion, speed, acceleration }, bas, variable) {
  if (motion === 'joint') {
    bas('VEL_PTP', Math.max(1, Math.round(speed.value)));
    bas('ACC_PTP', Math.max(1, Math.round(acceleration)));
    return;
  }
  if (speed.unit === 'mm/s') return variable('$VEL.CP', speed.value / 10 ** 3);
  variable('$VEL.ORI1', speed.value);
  variable('$VEL.ORI2', speed.value);
}

/** How a move ends. @param {NeutralMove} move @param {(target: string, value: number) => void} variable @returns {string[]} */
function setEnding({ motion, ending }, variable) {
  if (ending.kind === 'fine') return [];
  if (ending.kind === 'distance') {
    variable('$APO.CDIS', rounded(ending.value));
    return motion === 'joint' ? ['C_PTP', 'C_DIS'] : ['C_DIS'];
  }
  variable(motion === 'joint' ? '$APO.CPTP' : '$APO.CVEL', Math.round(ending.value));
  return [motion === 'joint' ? 'C_PTP' : 'C_VEL'];
}

/** @param {string} name @param {NeutralTarget} target @param {boolean} needsPosition @returns {KrlDatum} */
function datumFor(name, target, needsPosition) {
  if (!needsPosition && !isWrittenAsPosition(target, 'kuka')) {
    const members = Object.fromEntries(target.joints.map((value, i) => [`A${i + 1}`, rounded(value)]));
    return { name, type: 'AXIS', members };
  }
  const [x, y, z, w, p, r] = target.position.map(rounded);
  const status = target.kuka && { S: target.kuka.status, T: target.kuka.turn };
  return { name, type: status ? 'POS' : 'FRAME', members: { X: x, Y: y, Z: z, A: r, B: p, C: w, ...status } };
}

/** @param {Exclude<NeutralStep, NeutralMove>} step @returns {KrlStatement} */
function otherStep(step) {
  switch (step.kind) {
    case 'wait':
      return { kind: 'wait', seconds: step.seconds };
    case 'output':
      return { kind: 'assign', target: `$OUT[${step.port}]`, value: step.value };
    case 'input':
      return { kind: 'wait-for', input: step.port, value: step.value };
    case 'call':
      return { kind: 'call', program: krlName(step.program) };
    case 'comment':
      return { kind: 'comment', text: plainText(step.text) };
  }
}

/** @param {NeutralProgram} program @returns {WriteNote[]} */
function notesFor(program) {
  const moves = movesOf(program);
  /** @type {WriteNote[]} */
  const notes = [
    ...(program.notes ?? []),
    ...missingConfigurations(program, 'kuka', ({ motion }) => motion === 'joint'),
  ];
  const note = (/** @type {string} */ code, /** @type {string} */ message) =>
    void notes.push({ severity: 'note', code, message });
  if (moves.some(({ target }) => isWrittenAsPosition(target, 'kuka')))
    note(
      'unverified-status',
      'S and T are by published definitions, of which no controller has judged this use; bit 2 of S is the sign of A5.',
    );
  if (moves.some(({ motion, ending }) => motion !== 'joint' && ending.kind === 'percent'))
    note(
      'unverified-ending',
      'Corners of LIN and CIRC by a share are written as C_VEL with $APO.CVEL, which is not verified to be the same share.',
    );
  if (moves.some(({ motion, ending }) => motion === 'joint' && ending.kind === 'distance'))
    note(
      'unverified-ending',
      'Corners of PTP by a distance are written as C_PTP C_DIS with $APO.CDIS: between two PTP moves $APO.CPTP, which is a share, counts on some controllers.',
    );
  if (moves.some(({ motion, acceleration }) => motion !== 'joint' && acceleration !== 100))
    note(
      'acceleration',
      'Accelerations of LIN and CIRC are not written: $ACC.CP needs m/s2, and the program has a share.',
    );
  if (moves.some(({ speed }) => speed.unit === 'deg/s'))
    note(
      'turn-speed',
      'A speed in deg/s is written as $VEL.ORI1 and $VEL.ORI2; $VEL.CP still bounds the way of the tool.',
    );
  return notes;
}
