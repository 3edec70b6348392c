/**
 * A teach pendant (TP) program as its `.LS` listing has it, part by part in the order of the file. Every part that was read
 * keeps its own text in `raw`, line end included: what was not changed is written as it was read. A part without `raw` is
 * written anew from what it says.
 *
 * @import { Span } from '../tree.js'
 *
 * @typedef {object} TpListing
 * @property {'tp-listing'} kind
 * @property {readonly TpPart[]} parts
 * @property {string} lineEnd   what ends lines that are written anew
 *
 * @typedef {{ raw?: string, span?: Span }} Read  where it was read, and what stood there
 * @typedef {TpSection | TpAttribute | TpLine | TpPosition | TpText} TpPart
 * @typedef {Read & { kind: 'section', name: string, text: string }} TpSection   /PROG, with the program's name as text; /ATTR /APPL /MN /POS /END
 * @typedef {Read & { kind: 'attribute', name: string, value: string }} TpAttribute   `OWNER = MNEDITOR;`
 * @typedef {Read & { kind: 'text', text: string }} TpText   of /APPL, empty lines, and what is not understood outside of /MN
 * @typedef {Read & { kind: 'line', number: number, instruction: TpInstruction }} TpLine
 *
 * @typedef {object} TpPositionPart   P[number:"label"]{ … };
 * @property {'position'} kind
 * @property {number} number
 * @property {string} [label]
 * @property {readonly TpGroup[]} groups
 * @typedef {Read & TpPositionPart} TpPosition
 *
 * @typedef {object} TpGroup           of a motion group
 * @property {number} group
 * @property {number | 'F'} userFrame  F: the one that is chosen when it is used
 * @property {number | 'F'} toolFrame
 * @property {string} [configuration]  of a Cartesian position, as 'N U T, 0, 0, 0'
 * @property {readonly TpValue[]} values
 * @typedef {{ name: string, value: number | null, unit: 'mm' | 'deg' }} TpValue  X Y Z W P R, J1 …, E1 …; null: ********
 *
 * Operands and expressions. Parentheses are nodes, so that an expression is written with those that it had.
 *
 * @typedef {object} TpRegister   R[1:count]  PR[GP1:2,3]  DI[R[5]]  LBL[4]  TIMER[1]  P[2]
 * @property {'register'} kind
 * @property {string} bank
 * @property {TpOperand} index
 * @property {TpOperand} [element]
 * @property {number} [group]
 * @property {string} [comment]
 * @typedef {{ kind: 'number', value: number }} TpNumber
 * @typedef {{ kind: 'string', value: string }} TpString
 * @typedef {{ kind: 'word', word: string }} TpWord   ON OFF LPOS JPOS START STOP RESET, UFRAME_NUM UTOOL_NUM OVERRIDE …
 * @typedef {{ kind: 'pulse', seconds?: TpOperand }} TpPulse
 * @typedef {{ kind: 'system', name: string }} TpSystem   with $, indices and fields, as it stands
 * @typedef {{ kind: 'group', inner: TpOperand }} TpParentheses
 * @typedef {{ kind: 'unary', operator: '-' | '!' | '+', operand: TpOperand }} TpUnary
 * @typedef {{ kind: 'binary', operator: TpOperator, left: TpOperand, right: TpOperand }} TpBinary
 * @typedef {'+' | '-' | '*' | '/' | 'DIV' | 'MOD' | '=' | '<>' | '<' | '<=' | '>' | '>=' | 'AND' | 'OR'} TpOperator
 * @typedef {TpRegister | TpNumber | TpString | TpWord | TpPulse | TpSystem | TpParentheses | TpUnary | TpBinary} TpOperand
 *
 * Instructions.
 *
 * @typedef {'J' | 'L' | 'C' | 'A'} TpMotionType
 * @typedef {'%' | 'sec' | 'msec' | 'mm/sec' | 'cm/min' | 'inch/min' | 'deg/sec'} TpSpeedUnit
 * @typedef {{ value: TpOperand, unit: TpSpeedUnit }} TpSpeed
 * @typedef {{ kind: 'FINE' } | { kind: 'CNT' | 'CR' | 'CD', value: TpOperand }} TpTermination
 * @typedef {object} TpOption   ACC80  Offset,PR[1]  Skip,LBL[2]  INC  Wjnt …; text: an option that is not understood, or more of one
 * @property {string} name
 * @property {TpOperand} [value]
 * @property {string} [text]
 *
 * @typedef {object} TpMotion
 * @property {'motion'} kind
 * @property {TpMotionType} motion
 * @property {TpRegister} target
 * @property {TpRegister} [via]
 * @property {TpSpeed} speed
 * @property {TpTermination} termination
 * @property {readonly TpOption[]} options
 *
 * @typedef {{ kind: 'blank' }} TpBlank
 * @typedef {{ kind: 'remark', text: string, language?: string }} TpRemark   !text, or --eg:text
 * @typedef {{ kind: 'assign', target: TpRegister | TpWord | TpSystem, value: TpOperand }} TpAssign
 * @typedef {{ kind: 'label', label: TpRegister }} TpLabel
 * @typedef {{ kind: 'jump', label: TpRegister }} TpJump
 * @typedef {{ kind: 'call', program: string | TpRegister, args: readonly TpOperand[], parentheses?: true }} TpCall
 * @typedef {{ kind: 'run', program: string | TpRegister, args: readonly TpOperand[], parentheses?: true }} TpRun
 * @typedef {{ kind: 'if', condition: TpOperand, action: TpAction }} TpIf
 * @typedef {{ kind: 'if-then', condition: TpOperand }} TpIfThen
 * @typedef {{ kind: 'else' | 'endif' | 'endfor' | 'end' | 'abort' | 'pause' }} TpBare
 * @typedef {{ kind: 'select', value: TpOperand, choice: TpOperand, action: TpAction }} TpSelect
 * @typedef {{ kind: 'case', choice: TpOperand, action: TpAction }} TpCase    the following lines of a SELECT
 * @typedef {{ kind: 'case-else', action: TpAction }} TpCaseElse
 * @typedef {{ kind: 'for', variable: TpRegister, from: TpOperand, to: TpOperand, down?: true }} TpFor
 * @typedef {{ kind: 'wait', seconds: TpOperand }} TpWait
 * @typedef {{ kind: 'wait-for', condition: TpOperand, timeout?: TpRegister }} TpWaitFor
 * @typedef {{ kind: 'skip-condition', condition: TpOperand }} TpSkipCondition
 * @typedef {{ kind: 'offset-condition', isTool: boolean, register: TpRegister }} TpOffsetCondition
 * @typedef {{ kind: 'alarm', number: TpOperand }} TpAlarm       UALM[1]
 * @typedef {{ kind: 'payload', number: TpOperand }} TpPayload
 * @typedef {{ kind: 'message', text: string }} TpMessage
 * @typedef {{ kind: 'disabled', text: string }} TpDisabled      //…, a line that is taken out
 * @typedef {{ kind: 'unknown', text: string }} TpUnknown
 * @typedef {TpJump | TpCall | TpRun | TpAssign | TpBare} TpAction   what follows a comma
 * @typedef {TpBlank | TpRemark | TpMotion | TpAssign | TpLabel | TpJump | TpCall | TpRun | TpIf | TpIfThen | TpBare | TpSelect | TpCase | TpCaseElse | TpFor
 *   | TpWait | TpWaitFor | TpSkipCondition | TpOffsetCondition | TpAlarm | TpPayload | TpMessage | TpDisabled | TpUnknown} TpInstruction
 */

/** @param {TpListing} listing @returns {TpLine[]} */
export const linesOf = ({ parts }) => parts.flatMap((part) => (part.kind === 'line' ? [part] : []));

/** @param {TpListing} listing @returns {TpPosition[]} */
export const positionsOf = ({ parts }) => parts.flatMap((part) => (part.kind === 'position' ? [part] : []));

/** The program's name in capitals, as /PROG says it; empty where there is none. @param {TpListing} listing */
export function nameOf({ parts }) {
  const head = parts.find((part) => part.kind === 'section' && part.name === 'PROG');
  return (head?.kind === 'section' ? head.text : '').trim().split(/\s+/)[0].toUpperCase();
}

/** An attribute's value, as it stands. @param {TpListing} listing @param {string} wanted @returns {string | undefined} */
export function attributeOf({ parts }, wanted) {
  const found = parts.find((part) => part.kind === 'attribute' && part.name === wanted);
  return found?.kind === 'attribute' ? found.value : undefined;
}

/** @param {number} value @returns {TpNumber} */
export const number = (value) => ({ kind: 'number', value });

/** @param {string} bank @param {number | TpOperand} index @param {{ element?: TpOperand, comment?: string }} [more] @returns {TpRegister} */
export const register = (bank, index, more = {}) => ({
  ...{ kind: 'register', bank, index: typeof index === 'number' ? number(index) : index },
  ...more,
});

/** The same listing with nothing of where it was read: all of it is written anew. @param {TpListing} listing @returns {TpListing} */
export const withoutSource = (listing) => ({
  ...listing,
  parts: listing.parts.map((part) => {
    const bare = { ...part };
    delete bare.raw;
    delete bare.span;
    return bare;
  }),
});
