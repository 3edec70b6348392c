/**
 * Steps of a motion program as text, for the clipboard: JSON that says what it is and in which units, and the steps as the document
 * has them. What comes back is looked at step by step when it is put in (motionFaults.js); here, only whether it is that at all.
 *
 * @import { Units } from '../model/document.js'
 * @import { NewStep } from '../model/program/motionCommands.js'
 */
import { MAX_TEXT_LENGTH } from './fileLimits.js';

const VERSION = 1;

/** @param {readonly NewStep[]} steps @param {Units} units */
export function stepsText(steps, { length, angle }) {
  const lines = steps.map((step) => JSON.stringify({ ...step, id: undefined }));
  return `{"denavit":"steps","version":${VERSION},"units":${JSON.stringify({ length, angle })},"steps":[\n${lines.join(',\n')}\n]}\n`;
}

/**
 * @param {string} text
 * @param {Units} units  of the robot that they are for
 * @returns {{ steps: NewStep[] } | { against: 'other' | 'version' | 'units' }}  other: no steps
 */
export function readSteps(text, { length, angle }) {
  const found = parsed(text);
  if (found?.denavit !== 'steps' || !Array.isArray(found.steps) || found.steps.length === 0)
    return { against: 'other' };
  if (found.version !== VERSION) return { against: 'version' };
  const units = Object(found.units);
  return units.length === length && units.angle === angle ? { steps: found.steps } : { against: 'units' };
}

/** @param {string} text @returns {Record<string, unknown> | null} */
function parsed(text) {
  if (text.length > MAX_TEXT_LENGTH || !text.trimStart().startsWith('{')) return null;
  try {
    return JSON.parse(text);
  } catch {
    return null;
  }
}
