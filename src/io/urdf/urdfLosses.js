/**
 * What a URDF will not hold of a document, and what stands in it that the document does not have.
 *
 * @import { Doc } from '../../model/document.js'
 * @import { Issue } from '../../model/issues.js'
 */
import { lossesIn, massPlaceholder, nameLosses, ofJoints, oneSided, unusedLimits } from '../losses.js';
import { PLACEHOLDERS } from '../placeholders.js';
import { urdfNames, urdfTypeOf } from './urdfWriter.js';

const FORMAT = 'URDF';

/**
 * @param {Doc} doc
 * @returns {Issue[]} warnings
 */
export function urdfLosses(doc) {
  const { robot } = doc;
  const { joints } = robot;
  const { effort, velocity } = PLACEHOLDERS;
  return [
    ...lossesIn({ format: FORMAT, table: false, info: [], rates: ['velocity', 'effort'] }, doc),
    ...nameLosses(FORMAT, robot, urdfNames(robot)),
    ...ofJoints(
      joints,
      'type',
      (joint) => joint.type === 'revolute' && urdfTypeOf(joint) === 'continuous',
      (those) => `${FORMAT} calls a turn without limits continuous, so that ${those} will be of that type.`,
    ),
    ...unusedLimits(FORMAT, joints),
    ...oneSided(FORMAT, joints, (joint) => urdfTypeOf(joint) !== 'continuous'),
    massPlaceholder(FORMAT, joints.length + 1),
    ...ofJoints(
      joints,
      'velocity',
      (joint) => joint.velocity === undefined,
      (those) => `${FORMAT} asks for the largest velocity; ${velocity} (rad/s or m/s) stands for that of ${those}.`,
      'placeholder',
    ),
    ...ofJoints(
      joints,
      'effort',
      (joint) => joint.effort === undefined,
      (those) => `${FORMAT} asks for the largest effort; ${effort} (N m or N) stands for that of ${those}.`,
      'placeholder',
    ),
  ];
}
