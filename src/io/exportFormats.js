/**
 * The formats that a document can be written in, ours first. `losses` tells beforehand what of this very document a format will
 * not hold, and what it asks for that the document does not have: one sentence each, nothing if nothing is lost. An error among
 * them (not-writable) means that the document cannot be written so, and `write` throws a RangeError with that sentence.
 *
 * @import { Doc } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 *
 * @typedef {object} ExportFormat
 * @property {'denavit' | 'urdf' | 'sdf' | 'mjcf' | 'rlkin'} id
 * @property {string} extension   without its first dot
 * @property {string} mediaType
 * @property {(doc: Doc) => string} write   of a sound document (model/validate.js)
 * @property {(doc: Doc) => Issue[]} losses
 */
import { deepFreeze } from '../model/freeze.js';
import { mjcfLosses } from './mjcf/mjcfLosses.js';
import { writeMjcf } from './mjcf/mjcfWriter.js';
import { rlkinLosses } from './rlkin/rlkinLosses.js';
import { writeRlkin } from './rlkin/rlkinWriter.js';
import { robotXmlLosses } from './robotXmlLosses.js';
import { writeRobotXml } from './robotXmlWriter.js';
import { sdfLosses } from './sdf/sdfLosses.js';
import { writeSdf } from './sdf/sdfWriter.js';
import { urdfLosses } from './urdf/urdfLosses.js';
import { writeUrdf } from './urdf/urdfWriter.js';

const XML = 'application/xml';

/** @type {readonly ExportFormat[]} */
export const EXPORT_FORMATS = deepFreeze([
  { id: 'denavit', extension: 'xml', mediaType: XML, write: writeRobotXml, losses: robotXmlLosses },
  { id: 'urdf', extension: 'urdf', mediaType: XML, write: writeUrdf, losses: urdfLosses },
  { id: 'sdf', extension: 'sdf', mediaType: XML, write: writeSdf, losses: sdfLosses },
  { id: 'mjcf', extension: 'mjcf.xml', mediaType: XML, write: writeMjcf, losses: mjcfLosses },
  { id: 'rlkin', extension: 'rlkin.xml', mediaType: XML, write: writeRlkin, losses: rlkinLosses },
]);
