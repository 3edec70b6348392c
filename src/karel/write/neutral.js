/**
 * A motion program as controllers want it, in no controller's language: joint values as the pendant counts them, poses in the
 * user frame and with the tool that are chosen, lengths in mm, angles in degrees. Writers make code of it.
 *
 * @typedef {object} NeutralProgram
 * @property {string} name          what a person called it
 * @property {string} robotName
 * @property {string} version       of the software that writes
 * @property {string} generatedAt   ISO 8601, shown as it stands
 * @property {readonly string[]} convention    how pendant values come from the model's
 * @property {readonly boolean[]} slides       for each axis
 * @property {string} [zero]   what FANUC's user frame 0 is, for an arm whose axis 2 has no height
 * @property {readonly NeutralFrame[]} frames  that the moves use; 0, the controller's world and the flange, is not among them
 * @property {readonly NeutralStep[]} steps
 * @property {readonly WriteNote[]} [notes]    what of the program no controller's language holds
 * @property {readonly string[]} [check]       lines for the header, at most 32 characters each: what was checked, and of what
 *
 * @typedef {{ kind: 'user' | 'tool', number: number, name: string, position: readonly number[] }} NeutralFrame  x y z w p r
 *
 * @typedef {object} NeutralTarget
 * @property {readonly number[]} joints
 * @property {readonly number[]} position     x y z w p r
 * @property {string | null} fanuc            the configuration, as 'N U T, 0, 0, 0'
 * @property {{ status: number, turn: number } | null} kuka
 * @property {boolean} isJoint                whether the program has joint values here
 * @property {string} [reason]                why there is no configuration
 *
 * @typedef {{ kind: 'fine' } | { kind: 'percent' | 'distance', value: number }} NeutralEnding  distance: mm
 * @typedef {object} NeutralMove
 * @property {'move'} kind
 * @property {'joint' | 'linear' | 'circular'} motion
 * @property {NeutralTarget} target
 * @property {NeutralTarget} [via]
 * @property {{ value: number, unit: '%' | 'mm/s' | 'deg/s' }} speed
 * @property {number} acceleration   %
 * @property {NeutralEnding} ending
 * @property {number} userFrame
 * @property {number} tool
 * @property {string} [comment]
 * @property {number} step           of the program, from 0; −1: the way to where it begins
 *
 * @typedef {{ kind: 'wait', seconds: number }} NeutralWait
 * @typedef {{ kind: 'output' | 'input', port: number, value: boolean }} NeutralSignal
 * @typedef {{ kind: 'call', program: string }} NeutralCall    of a program that only the controller has
 * @typedef {{ kind: 'comment', text: string }} NeutralComment
 * @typedef {NeutralMove | NeutralWait | NeutralSignal | NeutralCall | NeutralComment} NeutralStep
 *
 * @typedef {object} WriteOptions
 * @property {string} [programName]
 * @property {number} [firstRegister]   of the pair: position registers from this one on; default 1
 *
 * @typedef {{ name: string, language: 'karel' | 'fanuc-tp' | 'krl', text: string }} CodeFile
 * @typedef {{ severity: 'note' | 'warning', code: string, message: string, step?: number }} WriteNote   note: what nobody has verified, or what was rounded
 * @typedef {{ files: CodeFile[], notes: WriteNote[] }} Written
 */

/** @param {NeutralProgram} program @returns {NeutralMove[]} */
export const movesOf = ({ steps }) => steps.flatMap((step) => (step.kind === 'move' ? [step] : []));

/** Decimals of positions and joint values in all of the languages, as pendants show them. */
export const DECIMALS = 3;

/** A pendant's field for a value is 10 characters wide: a sign, 5 digits, the point, 3 decimals. */
export const LARGEST_VALUE = 99999.999;

/** @param {number} value */
export const rounded = (value) => Number(value.toFixed(DECIMALS)) + 0;

/** What rounding a target costs at most: mm in space and degrees, of a position; degrees or mm of a joint value. */
export const ROUNDING = 0.5 * 10 ** -DECIMALS;

/** Whether a target is written as a position, for a language whose configurations are under `code`. @param {NeutralTarget} target @param {'fanuc' | 'kuka'} code */
export const isWrittenAsPosition = (target, code) => !target.isJoint && target[code] !== null;

/**
 * Targets that become joint values though the program has poses there: each reason once.
 * @param {NeutralProgram} program
 * @param {'fanuc' | 'kuka'} code
 * @param {(move: NeutralMove) => boolean} [needs]  whether a move's targets need a configuration
 * @returns {WriteNote[]}
 */
export function missingConfigurations(program, code, needs = () => true) {
  /** @type {Map<string, number[]>} */
  const steps = new Map();
  for (const move of movesOf(program)) {
    if (!needs(move)) continue;
    const without = [move.target, ...(move.via ? [move.via] : [])].find(
      (target) => !target.isJoint && target[code] === null,
    );
    if (!without) continue;
    const reason = without.reason ?? 'its posture has no configuration';
    steps.set(reason, [...(steps.get(reason) ?? []), move.step + 1]);
  }
  return [...steps].map(([reason, numbers]) => ({
    ...{ severity: 'note', code: 'no-configuration', step: numbers[0] - 1 },
    message: `${numbers.length === 1 ? 'Step' : 'Steps'} ${listed(numbers)} ${numbers.length === 1 ? 'goes' : 'go'} to joint values: ${reason}.`,
  }));
}

/** Waits that are written shorter or longer than they are: each once. @param {NeutralProgram} program @param {number} decimals  of seconds @returns {WriteNote[]} */
export function roundedWaits({ steps }, decimals) {
  const changed = steps.flatMap((step) => {
    const written = step.kind === 'wait' ? Number(step.seconds.toFixed(decimals)) : 0;
    return step.kind === 'wait' && written !== step.seconds ? [`${step.seconds} s becomes ${written} s`] : [];
  });
  if (changed.length === 0) return [];
  const each = [...new Set(changed)].slice(0, MOST_NAMED).join(', ');
  return [{ severity: 'note', code: 'wait', message: `Waits have ${decimals} decimals of a second: ${each}.` }];
}

/** @param {readonly number[]} numbers */
const listed = (numbers) => numbers.slice(0, MOST_NAMED).join(', ') + (numbers.length > MOST_NAMED ? ', ...' : '');
const MOST_NAMED = 8;
