/**
 * What "Record here" makes of the posture in which the arm stands; it goes with the session.
 *
 * @import { MoveStep, PoseTarget } from '../document.js'
 *
 * @typedef {{ readonly kind: MoveStep['kind'], readonly via: PoseTarget | null }} Recording  via: taken already, of an arc that is half recorded
 */

/** @type {Recording} */
export const FIRST_RECORDING = { kind: 'joint', via: null };
