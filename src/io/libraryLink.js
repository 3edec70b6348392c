/**
 * The short address of an arm of the library that nobody has changed: its id, its units and where it stands.
 * @import { Doc } from '../model/document.js'
 */
import { homePosture } from '../model/document.js';
import { LIBRARY } from '../model/library.js';
import { startDocument } from '../model/startDocument.js';
import { writeRobotXml } from './robotXmlWriter.js';

/** @param {Doc} doc @returns {string | null} what follows the ?; null when the document is more than an arm of the library */
export function libraryQuery(doc) {
  const file = writeRobotXml(doc);
  const { units, name } = doc.robot;
  for (const [id, robot] of Object.entries(LIBRARY)) {
    if (robot.name !== name) continue;
    const twin = startDocument(robot, { units, q: doc.posture.map((value) => value + 0) });
    if (twin.faults.some(({ code }) => code !== 'outside') || writeRobotXml(twin.doc) !== file) continue;
    const fields = [`robot=${id}`];
    const asked = [
      ...(units.length === robot.units.length ? [] : [units.length]),
      ...(units.angle === robot.units.angle ? [] : [units.angle]),
    ];
    if (asked.length > 0) fields.push(`units=${asked.join(',')}`);
    const home = asked.length > 0 ? null : homePosture(robot);
    if (!home?.every((value, i) => Object.is(value, doc.posture[i]))) fields.push(`q=${doc.posture.join(',')}`);
    return fields.join('&');
  }
  return null;
}
