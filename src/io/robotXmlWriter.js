/**
 * The document → the text of a robot file. It is apart from the reader so that saving needs no parser. Opening what was
 * saved gives the same document, and saving that the same bytes; the one exception is a character that XML cannot hold
 * (xmlText.js).
 *
 * @import { Doc } from '../model/document.js'
 */
import { PRESENT_POSTURE_ID } from '../model/documentRules.js';
import { ROBOT_MODEL, ROBOT_NAMESPACE, ROBOT_VERSION } from './robotXmlTable.js';
import { elementLines } from './writeByTable.js';

/** Who wrote the file, and which version of it. */
export const GENERATOR = 'Denavit 0.1.0';

/**
 * @param {Doc} doc  sound (model/validate.js)
 * @returns {string}
 * @throws {RangeError} for a number that is not finite
 */
export function writeRobotXml({ posture, ...doc }) {
  const file = {
    ...doc,
    version: ROBOT_VERSION,
    generator: GENERATOR,
    postures: [{ id: PRESENT_POSTURE_ID, q: posture }, ...doc.postures],
  };
  const lines = elementLines(ROBOT_MODEL, file, ` xmlns="${ROBOT_NAMESPACE}"`);
  return ['<?xml version="1.0" encoding="UTF-8"?>', ...lines, ''].join('\n');
}
