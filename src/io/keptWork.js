/**
 * Work as it is kept in the browser for another visit:
 *
 *     denavit-work 1 <fingerprint of all that follows this line>
 *     {"at":"2026-11-22T14:02:00.000Z","look":"tab=code"}
 *     <the robot file>
 *
 * 1 is the version of this form. What is below the second line can be saved as a file whatever becomes of this program. It is
 * written often, so the writer stands in the first load; the reader (readKeptWork.js) does not.
 *
 * @import { Doc } from '../model/document.js'
 */
import { fingerprint } from '../model/fingerprint.js';
import { writeRobotXml } from './robotXmlWriter.js';

/** Of the names under which work is kept. What follows is the visit's own, a point, and a number. */
export const KEPT = 'denavit.work.';

/**
 * @param {object} work
 * @param {Doc} work.doc
 * @param {string} work.at    now, ISO 8601
 * @param {string} work.look  as look.js writes it
 */
export function writeKeptWork({ doc, ...head }) {
  const rest = `${JSON.stringify(head)}\n${writeRobotXml(doc)}`;
  return `denavit-work 1 ${fingerprint(rest)}\n${rest}`;
}
