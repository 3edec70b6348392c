/**
 * The KAREL half of a FANUC pair: it writes each point into its position register, checks every answer of the controller,
 * and only then calls the TP program that moves.
 *
 * `CNV_REL_JPOS` is handed an array with exactly as many elements as the arm has axes. FANUC's own example does so for six
 * axes; longer arrays are seen to work too (fanucpy: 9, the rest unset; ROS-Industrial: 10, the rest zero), but padding
 * with zeros would send the other axes of a larger arm to zero. For fewer axes there is no evidence. Where the array does
 * not fit, the status is relied on to stop the program before anything moves.
 *
 * `%ENVIRONMENT REGOPE` makes the built-ins for registers known to the translator; the others always are.
 *
 * @import { Expression, Program, Routine, Statement } from './tree.js'
 * @import { PairPlan } from './fanucPlan.js'
 */
import { headerLines, programComment } from './fanucHeader.js';
import { DECIMALS, FILLER_NAMES } from './fanucPlan.js';
import { plainText } from './plainText.js';
import { binary, call, integer, name, real, string, unary } from './tree.js';

const { joints: JOINTS, target: TARGET, status: STATUS, register: REGISTER, fill: FILL } = FILLER_NAMES;

const LONGEST_POINT_NAME = 64;

/** @param {PairPlan} plan @returns {Program} */
export function fillerProgram(plan) {
  const { names, slides, moves } = plan;
  const mover = names.tp.toLowerCase();
  return {
    kind: 'program',
    comments: headerLines(plan).map((text) => ({ kind: 'comment', text })),
    name: names.karel,
    declarations: [
      { kind: 'directive', name: 'COMMENT', value: string(programComment(plan.robotName)) },
      { kind: 'directive', name: 'ENVIRONMENT', word: 'REGOPE' },
      { kind: 'directive', name: 'NOLOCKGROUP' },
      { kind: 'directive', name: 'NOPAUSE', value: { kind: 'words', words: ['ERROR', 'COMMAND', 'TPENABLE'] } },
      {
        kind: 'variables',
        entries: [
          { names: [JOINTS], type: { kind: 'array-type', sizes: [slides.length], of: { kind: 'type', name: 'REAL' } } },
          { names: [TARGET], type: { kind: 'type', name: 'JOINTPOS' } },
          { names: [STATUS], type: { kind: 'type', name: 'INTEGER' } },
        ],
      },
      { kind: 'comment', text: 'The TP program that moves. It must be on the controller before this one runs.' },
      { kind: 'routine', name: mover, parameters: [], from: mover },
      { kind: 'comment', text: 'Puts the joint values into a position register, or stops before anything moves.' },
      fillRoutine(),
    ],
    body: [
      ...moves.flatMap(({ name: point, register, jointValues }) => [
        comment(`PR[${register}]: '${plainText(point, LONGEST_POINT_NAME)}'`),
        ...jointValues.map((value, i) => assignJoint(i + 1, value)),
        call(FILL, [integer(register)]),
      ]),
      comment('All registers are filled: move.'),
      call(mover),
    ],
  };
}

/** @param {string} text @returns {Statement} */
const comment = (text) => ({ kind: 'comment', text });

/** @param {number} axis @param {number} value @returns {Statement} */
const assignJoint = (axis, value) => ({
  kind: 'assign',
  target: { kind: 'index', target: name(JOINTS), indices: [integer(axis)] },
  value: real(value, DECIMALS),
});

/** @returns {Routine} */
function fillRoutine() {
  const failed = binary(name(STATUS), '<>', integer(0));
  return {
    kind: 'routine',
    name: FILL,
    parameters: [{ names: [REGISTER], type: { kind: 'type', name: 'INTEGER' } }],
    body: [
      call('CNV_REL_JPOS', [name(JOINTS), name(TARGET), name(STATUS)]),
      stopIf(failed, ['CNV_REL_JPOS refused the joint values of PR[', name(REGISTER), '], status ', name(STATUS)]),
      stopIf(unary('NOT', call('J_IN_RANGE', [name(TARGET)])), [
        'The joint values of PR[',
        name(REGISTER),
        '] are outside the limits of the arm',
      ]),
      call('SET_JPOS_REG', [name(REGISTER), name(TARGET), name(STATUS)]),
      stopIf(failed, ['SET_JPOS_REG could not write PR[', name(REGISTER), '], status ', name(STATUS)]),
    ],
  };
}

/** @param {Expression} condition @param {(string | Expression)[]} message @returns {Statement} */
const stopIf = (condition, message) => ({
  kind: 'if',
  condition,
  then: [
    {
      kind: 'write',
      items: [...message.map((item) => (typeof item === 'string' ? string(item) : item)), { kind: 'new-line' }],
    },
    { kind: 'abort' },
  ],
});
