/**
 * The document that an address asks for: a robot, in other units if so wished, at a posture. What cannot be had is left
 * out and reported; undo begins after it.
 *
 * @import { Doc, RobotDoc, Units } from './document.js'
 *
 * @typedef {{ code: 'units', reason: string }
 *   | { code: 'count', given: number, joints: number }
 *   | { code: 'other-robot' }
 *   | { code: 'outside', joints: readonly number[] }} StartFault
 *   `reason` is a sentence; `joints` of 'outside' are indices
 */
import { applyCommand } from './commands.js';
import { limitsOf } from './document.js';
import { newDocument } from './newDocument.js';
import { refusal } from './refusals.js';

/**
 * @param {RobotDoc} robot
 * @param {object} [wishes]
 * @param {Partial<Units> | null} [wishes.units]
 * @param {readonly number[] | null} [wishes.q]  in the units of the document that comes of it
 * @param {boolean} [wishes.isOther]  the robot is not the one that q was meant for
 * @returns {{ doc: Doc, faults: StartFault[] }}
 */
export function startDocument(robot, { units = null, q = null, isOther = false } = {}) {
  /** @type {StartFault[]} */
  const faults = [];
  let doc = newDocument(robot);
  if (units) {
    const command = /** @type {const} */ ({ type: 'convert-units', units: { ...robot.units, ...units } });
    const reason = refusal(doc, command);
    if (reason) faults.push({ code: 'units', reason: reason.message });
    else doc = applyCommand(doc, command);
  }
  if (!q) return { doc, faults };
  if (isOther) return { doc, faults: [...faults, { code: 'other-robot' }] };
  const { joints } = doc.robot;
  if (q.length !== joints.length) {
    return { doc, faults: [...faults, { code: 'count', given: q.length, joints: joints.length }] };
  }
  const outside = joints.flatMap((joint, i) => {
    const { lower, upper } = limitsOf(joint);
    return q[i] < lower || q[i] > upper ? [i] : [];
  });
  if (outside.length > 0) faults.push({ code: 'outside', joints: outside });
  return { doc: applyCommand(doc, { type: 'set-posture', posture: [...q] }), faults };
}
