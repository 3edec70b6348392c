/**
 * What an SDFormat file will not hold of a document, and what stands in it that the document does not have.
 *
 * @import { Doc } from '../../model/document.js'
 * @import { Issue } from '../../model/issues.js'
 */
import { lossesIn, massPlaceholder, nameLosses, unusedLimits } from '../losses.js';
import { sdfNames } from './sdfWriter.js';

const FORMAT = 'SDFormat';

/**
 * @param {Doc} doc
 * @returns {Issue[]} warnings
 */
export function sdfLosses(doc) {
  const { robot } = doc;
  return [
    ...lossesIn({ format: FORMAT, table: false, info: [], rates: ['velocity', 'effort'] }, doc),
    ...nameLosses(FORMAT, robot, sdfNames(robot)),
    ...unusedLimits(FORMAT, robot.joints),
    massPlaceholder(FORMAT, robot.joints.length + 1),
  ];
}
