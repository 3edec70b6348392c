/**
 * A move's poses, seen from another user frame: the numbers are others, the places are the same.
 *
 * @import { Doc, MoveStep, PoseTarget, StepTarget } from '../document.js'
 */
import { compose } from '../../kinematics/pose.js';
import { compilePose } from '../compile.js';
import { framePose, seenFromUser } from '../frames/frames.js';
import { poseInUnits } from '../numbers/poseNumbers.js';

/**
 * @param {Doc} doc
 * @param {MoveStep} step
 * @param {string | undefined} id  of a user frame of the document; undefined: the world
 * @returns {Pick<MoveStep, 'frame' | 'target'> & Partial<Pick<MoveStep, 'via'>>}
 */
export function inFrame(doc, step, id) {
  const { units } = doc.robot;
  const frame = doc.frames.find((one) => one.kind === 'user' && one.id === step.frame) ?? null;
  /** @param {StepTarget} target @returns {StepTarget} */
  const seen = (target) => {
    if (target.kind !== 'pose') return target;
    const T = compose(framePose(frame, units), compilePose(target, units));
    return { ...withoutPose(target), ...poseInUnits(id === undefined ? T : seenFromUser(doc, id, T), units) };
  };
  return { frame: id, target: seen(step.target), ...(step.via && { via: seen(step.via) }) };
}

/**
 * A pose's numbers as they are typed: X Y Z W P R.
 * @param {Doc} doc
 * @param {PoseTarget} target
 * @returns {readonly number[]}
 */
export function poseNumbers({ robot: { units } }, target) {
  const { xyz, rpy } = target;
  const turned = rpy ?? poseInUnits(compilePose(target, units), units).rpy ?? [0, 0, 0];
  return [...xyz, ...turned];
}

/** @param {PoseTarget} target @param {readonly number[]} numbers  X Y Z W P R @returns {PoseTarget} */
export const atNumbers = (target, numbers) => ({
  ...withoutPose(target),
  ...{ xyz: numbers.slice(0, 3), rpy: numbers.slice(3) },
});

/** @param {PoseTarget} target */
const withoutPose = ({ kind, configuration }) => ({ kind, ...(configuration !== undefined && { configuration }) });
