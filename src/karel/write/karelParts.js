/**
 * Parts of KAREL programs that writers share: positions and joint values as statements, checks of what a built-in answers.
 *
 * @import { Declaration, Expression, Program, Routine, Statement } from '../tree.js'
 * @import { NeutralProgram, NeutralTarget, WriteNote } from './neutral.js'
 */
import { plainText } from '../plainText.js';
import { binary, call, integer, name, real, string, unary } from '../tree.js';
import { programComment } from './header.js';
import { DECIMALS, isWrittenAsPosition, movesOf, rounded } from './neutral.js';

/** What the programs call their own things. */
export const OWN = {
  joints: 'joints',
  at: 'at_joints',
  via: 'via_joints',
  config: 'config_n',
  status: 'status',
  check: 'check_it',
};

/** Axes of the arms whose joint values are known to go through CNV_REL_JPOS. */
const KNOWN_AXES = 6;

/** @param {Pick<NeutralProgram, 'slides'>} program @returns {WriteNote[]} */
export const axisCountNotes = ({ slides: { length } }) =>
  length === KNOWN_AXES
    ? []
    : [
        {
          ...{ severity: 'warning', code: 'axis-count' },
          message: `Joint values are known to arrive by CNV_REL_JPOS for ${KNOWN_AXES} axes only; this arm has ${length}. If the controller refuses, nothing moves.`,
        },
      ];

/** @param {string} text @returns {Statement} */
export const comment = (text) => ({ kind: 'comment', text: plainText(text, 64) });

/** @param {Expression} target @param {Expression} value @returns {Statement} */
export const assign = (target, value) => /** @type {Statement} */ ({ kind: 'assign', target, value });

/** @param {string} array @param {number} index @returns {Expression} */
export const element = (array, index) => ({ kind: 'index', target: name(array), indices: [integer(index)] });

/** Statements that make the target ready, and the expression that it then is. @param {NeutralTarget} target @param {string} [at]  the variable that takes joint values @returns {{ before: Statement[], value: Expression, isJoint: boolean }} */
export function targetParts(target, at = OWN.at) {
  if (!isWrittenAsPosition(target, 'fanuc')) {
    return {
      before: [
        ...target.joints.map((value, i) => assign(element(OWN.joints, i + 1), real(rounded(value), DECIMALS))),
        call('CNV_REL_JPOS', [name(OWN.joints), name(at), name(OWN.status)]),
        call(OWN.check, [string('CNV_REL_JPOS')]),
      ],
      value: name(at),
      isJoint: true,
    };
  }
  const numbers = target.position.map((value) => real(rounded(value), DECIMALS));
  return {
    before: [
      call('CNV_STR_CONF', [string(target.fanuc ?? ''), name(OWN.config), name(OWN.status)]),
      call(OWN.check, [string('CNV_STR_CONF')]),
    ],
    value: call('POS', [...numbers, name(OWN.config)]),
    isJoint: false,
  };
}

/** @param {NeutralProgram} program @returns {NeutralTarget[]} */
const targetsOf = (program) => movesOf(program).flatMap(({ target, via }) => (via ? [via, target] : [target]));

/** @param {string} text @returns {{ kind: 'type', name: string }} */
const type = (text) => ({ kind: 'type', name: text });

/**
 * @param {string} programName
 * @param {NeutralProgram} program
 * @param {readonly string[]} header
 * @param {readonly Declaration[]} directives
 * @param {readonly { names: string[], type: string }[]} variables
 * @param {readonly Declaration[]} routines
 * @param {readonly Statement[]} body
 * @returns {Program}
 */
export function karelProgram(programName, program, header, directives, variables, routines, body) {
  const all = targetsOf(program);
  const isPosition = (/** @type {NeutralTarget} */ target) => isWrittenAsPosition(target, 'fanuc');
  return {
    kind: 'program',
    comments: header.map((text) => ({ kind: 'comment', text })),
    name: programName,
    declarations: [
      { kind: 'directive', name: 'COMMENT', value: string(programComment(program.robotName)) },
      ...directives,
      {
        kind: 'variables',
        entries: [
          ...(all.every(isPosition)
            ? []
            : [
                {
                  names: [OWN.joints],
                  type: { kind: /** @type {const} */ ('array-type'), sizes: [program.slides.length], of: type('REAL') },
                },
                { names: [OWN.at], type: type('JOINTPOS') },
              ]),
          ...(all.some(isPosition) ? [{ names: [OWN.config], type: type('CONFIG') }] : []),
          { names: [OWN.status], type: type('INTEGER') },
          ...variables.map(({ names, type: of }) => ({ names, type: type(of) })),
        ],
      },
      ...routines,
      checkRoutine(OWN.status, OWN.check),
    ],
    body: [...body],
  };
}

/** Stops before anything moves where a built-in refused. @param {string} status @param {string} check  what the two are called @returns {Routine} */
export function checkRoutine(status, check) {
  return {
    kind: 'routine',
    name: check,
    parameters: [{ names: ['what'], type: { kind: 'string-type' } }],
    body: [stopIf(binary(name(status), '<>', integer(0)), [name('what'), string(' gave status '), name(status)])],
  };
}

/** Joint values outside of the arm's limits stop the program, too. @returns {Statement} */
export const stopPastLimits = () =>
  stopIf(unary('NOT', call('J_IN_RANGE', [name(OWN.at)])), [string('Joint values are outside of the limits')]);

/** @param {Expression} condition @param {Expression[]} items @returns {Statement} */
const stopIf = (condition, items) => ({
  kind: 'if',
  condition,
  then: [{ kind: 'write', items: [...items, { kind: 'new-line' }] }, { kind: 'abort' }],
});
