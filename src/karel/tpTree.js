/**
 * A FANUC teach pendant (TP) program as plain data: what its `.LS` listing says, as far as the page writes it.
 *
 * @typedef {object} TpProgram
 * @property {'tp-program'} kind
 * @property {string} name      as /PROG shows it
 * @property {string} comment   at most 16 characters
 * @property {TpDate} created
 * @property {readonly TpLine[]} lines
 *
 * @typedef {{ year: number, month: number, day: number, hour: number, minute: number, second: number }} TpDate
 *
 * @typedef {{ kind: 'remark', text: string }} TpRemark  1 to 32 characters
 * @typedef {object} TpJointMove   J PR[register] speedPercent% termination
 * @property {'joint-move'} kind
 * @property {number} register     the position register it goes to
 * @property {number} speedPercent 1 to 100, of the axes' own speeds
 * @property {TpTermination} termination
 * @typedef {'FINE' | number} TpTermination  stop at the point, or CNT0 to CNT100: round it off
 * @typedef {{ kind: 'call', program: string }} TpCall
 * @typedef {{ kind: 'user-frame' | 'tool-frame', number: number }} TpFrameChoice  UFRAME_NUM, UTOOL_NUM
 * @typedef {TpRemark | TpJointMove | TpCall | TpFrameChoice} TpLine
 */

/** FANUC HandlingTool operator's manual: remark instruction, program comment. */
export const MAX_REMARK_LENGTH = 32;
export const MAX_COMMENT_LENGTH = 16;
