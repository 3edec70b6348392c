/**
 * What an MJCF file will not hold of a document, and what stands in it that the document does not have.
 *
 * @import { Doc } from '../../model/document.js'
 * @import { Issue } from '../../model/issues.js'
 */
import { characterLosses, lossesIn, massPlaceholder, nameLosses, ofJoints, oneSided, unusedLimits } from '../losses.js';
import { mjcfNames, rangeOf, ROOM } from './mjcfWriter.js';

const FORMAT = 'MJCF';

/**
 * @param {Doc} doc
 * @returns {Issue[]} warnings
 */
export function mjcfLosses(doc) {
  const { robot } = doc;
  const { name, joints, units } = robot;
  return [
    ...lossesIn({ format: FORMAT, table: false, info: [], rates: ['effort'] }, doc),
    ...characterLosses(name, 'robot.name'),
    ...nameLosses(FORMAT, robot, { robot: name, joints: mjcfNames(robot) }),
    ...unusedLimits(FORMAT, joints),
    ...oneSided(FORMAT, joints, (joint) => rangeOf(joint, units) !== null),
    ...ofJoints(
      joints,
      'upper',
      (joint) => rangeOf(joint, units)?.isLocked ?? false,
      (those) => `${FORMAT} wants an upper limit above the lower; ${ROOM} (rad or m) is added for ${those}.`,
      'placeholder',
    ),
    massPlaceholder(FORMAT, joints.length),
  ];
}
