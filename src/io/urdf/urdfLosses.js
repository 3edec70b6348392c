/**
 * What a URDF will not hold of a document, and what stands in it that the document does not have.
 *
 * @import { Doc } from '../../model/document.js'
 * @import { Issue } from '../../model/issues.js'
 */
import { limitsOf } from '../../model/document.js';
import { fileIssue } from '../fileIssues.js';
import { lossesIn, ofJoints, renamed } from '../losses.js';
import { FAR, PLACEHOLDERS, urdfNames, urdfTypeOf } from './urdfWriter.js';

const FORMAT = 'URDF';

/**
 * @param {Doc} doc
 * @returns {Issue[]} warnings
 */
export function urdfLosses(doc) {
  const { name, joints } = doc.robot;
  const names = urdfNames(doc.robot);
  const { mass, inertia, effort, velocity } = PLACEHOLDERS;
  const masses = `${FORMAT} asks for masses and inertias; ${mass} kg and ${inertia} kg m² stand for those of ${joints.length + 1} links.`;
  return [
    ...lossesIn({ format: FORMAT, table: false, info: [], rates: ['velocity', 'effort'] }, doc),
    ...renamed(FORMAT, name === '' ? [] : [[name, names.robot]], 'robot.name'),
    ...renamed(
      FORMAT,
      joints.map(({ id }, i) => [id, names.joints[i]]),
      'robot.joints',
    ),
    ...ofJoints(
      joints,
      'type',
      (joint) => joint.type === 'revolute' && urdfTypeOf(joint) === 'continuous',
      (those) => `${FORMAT} calls a turn without limits continuous, so that ${those} will be of that type.`,
    ),
    ...ofJoints(
      joints,
      'lower',
      ({ type, lower, upper }) => type === 'continuous' && (lower !== undefined || upper !== undefined),
      (those) => `${FORMAT} has no place for the unused limits of ${those}.`,
    ),
    ...ofJoints(
      joints,
      'lower',
      (joint) =>
        urdfTypeOf(joint) !== 'continuous' && Object.values(limitsOf(joint)).some((end) => !Number.isFinite(end)),
      (those) => `${FORMAT} asks for both limits; ${FAR} (rad or m) stands for what is missing of ${those}.`,
      'placeholder',
    ),
    fileIssue('placeholder', masses, { path: 'robot.joints' }),
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
