/**
 * KRL as far as this page writes it: a module is a `.src` with one program and a `.dat` with its positions.
 *
 * @import { Span } from '../tree.js'
 *
 * @typedef {object} KrlModule
 * @property {'krl'} kind
 * @property {string} name
 * @property {readonly string[]} comments        above the program
 * @property {readonly KrlStatement[]} statements
 * @property {readonly KrlDatum[]} data
 *
 * @typedef {{ span?: Span }} Placed
 * @typedef {object} KrlDatum    DECL POS XP1={X 1.0,…}
 * @property {string} name
 * @property {'POS' | 'AXIS' | 'E6POS' | 'E6AXIS' | 'FRAME'} type
 * @property {Readonly<Record<string, number>>} members   by their names in capitals, in order
 * @property {Span} [span]
 *
 * @typedef {Placed & { kind: 'comment', text: string }} KrlComment   FOLD and ENDFOLD, too
 * @typedef {object} KrlMotionParts
 * @property {'motion'} kind
 * @property {'PTP' | 'LIN' | 'CIRC'} motion
 * @property {string} target        the name of a position, or {0}, {1} of places
 * @property {string} [via]
 * @property {readonly string[]} approximation   C_PTP C_DIS C_VEL C_ORI
 * @property {readonly KrlDatum[]} [places]      those that stand here themselves
 * @typedef {Placed & KrlMotionParts} KrlMotion
 * @typedef {Placed & { kind: 'assign', target: string, value: KrlValue }} KrlAssign   `$VEL.CP=0.25`, `$OUT[1]=TRUE`
 * @typedef {number | boolean} KrlValue
 * @typedef {Placed & { kind: 'bas', what: string, value: number }} KrlBas    BAS(#TOOL,1)
 * @typedef {Placed & { kind: 'wait', seconds: number }} KrlWait
 * @typedef {Placed & { kind: 'wait-for', input: number, value: boolean }} KrlWaitFor
 * @typedef {Placed & { kind: 'call', program: string }} KrlCall
 * @typedef {Placed & { kind: 'interrupt', text: string }} KrlInterrupt   of the INI fold, as it stands
 * @typedef {KrlComment | KrlMotion | KrlAssign | KrlBas | KrlWait | KrlWaitFor | KrlCall | KrlInterrupt} KrlStatement
 */

/** Members of positions, in the order in which they are written. */
export const POSITION_MEMBERS = ['X', 'Y', 'Z', 'A', 'B', 'C', 'S', 'T'];

/** The two lines that KUKA's INI fold has before BAS; they are written, known when read, and do nothing here. */
export const INTERRUPTS = ['GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )', 'INTERRUPT ON 3'];

/** The comments around it fold in KUKA's editor. What a person called FOLD does not: a fold that is never closed hides what follows. */
export const INI_FOLD = ['FOLD INI', 'ENDFOLD (INI)'];

export const MAX_NAME_LENGTH = 24;
