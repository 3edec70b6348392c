/**
 * What an rlkin file will not hold of a document.
 *
 * @import { Doc } from '../../model/document.js'
 * @import { Issue } from '../../model/issues.js'
 */
import { characterLosses, lossesIn, renamed } from '../losses.js';
import { rlkinNames } from './rlkinWriter.js';

const FORMAT = 'rlkin';

/**
 * @param {Doc} doc
 * @returns {Issue[]} warnings
 */
export function rlkinLosses(doc) {
  const { name, info, joints } = doc.robot;
  const names = rlkinNames(doc.robot);
  return [
    ...lossesIn({ format: FORMAT, table: true, info: ['manufacturer'], rates: ['velocity'] }, doc),
    ...renamed(
      FORMAT,
      joints.map(({ id }, i) => [id, names[i]]),
      'robot.joints',
    ),
    ...characterLosses(name, 'robot.name'),
    ...characterLosses(info.manufacturer ?? '', 'robot.info.manufacturer'),
  ];
}
