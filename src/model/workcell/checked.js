/**
 * What is known of a motion program's clearances.
 *
 * @import { Doc } from '../document.js'
 * @import { Planned } from '../program/planned.js'
 * @import { Clearance } from './workcell.js'
 *
 * @typedef {Clearance & { readonly step: number, readonly time: number, readonly share: number, readonly posture: Float64Array, readonly isTouch: boolean }} StepTouch
 *   a step of the program that comes too near to something: where it does first. step: its index; time: s, in the program
 *
 * @typedef {object} ProgramCheck
 * @property {Planned} planned
 * @property {Doc['obstacles']} obstacles
 * @property {number | null} margin    as somebody has chosen it
 * @property {number | null} progress  share that is done; null: nothing is under way
 * @property {readonly StepTouch[] | null} touches  null: not known yet, or given up
 */
export {};
