/**
 * The arm as running code knows it: where it is, and its kinematics, in the controller's numbers.
 *
 * @import { SystemValues } from './codeFrames.js'
 * @import { Doc, RobotDoc } from '../document.js'
 * @import { Kinematics } from '../../karel/run/machine.js'
 *
 * @typedef {object} CodeArm    as a pendant counts, degrees and millimetres
 * @property {() => readonly number[]} joints
 * @property {(system: SystemValues, isTp: boolean) => readonly number[]} position
 * @property {Kinematics} [kinematics]
 * @property {(joints: readonly number[]) => boolean} [isInRange]
 */
import { compilePosture, postureFromKernel } from '../compile.js';
import { pendantValues } from '../controller/controllerValues.js';
import { limitsOf } from '../document.js';
import { postureFromPendant } from '../controller/pendantNumbers.js';
import { OWN_FRAME, positionForCode, positionOfJoints } from './codeFrames.js';
import { movesOf } from './codeMoves.js';

const ANY_MOVE = {
  ...{ kind: 'move', motion: 'J', isJoint: false, userFrame: OWN_FRAME, toolFrame: OWN_FRAME },
  ...{ speed: { value: 100, unit: '%' }, termination: { kind: 'FINE' } },
};

/** What single precision, which a REAL has, makes of a limit: a share of it, and a little where the pendant counts from elsewhere. */
const ROUNDING = 2 ** -23;
const LITTLE = 1e-5;

/** @param {RobotDoc} robot @param {readonly number[]} pendant */
const isWithinLimits = (robot, pendant) =>
  postureFromPendant(robot, pendant.slice(0, robot.joints.length)).every((value, i) => {
    const { lower, upper } = limitsOf(robot.joints[i]);
    const slack = LITTLE + ROUNDING * Math.abs(value);
    return value >= lower - slack && value <= upper + slack;
  });

/** @param {() => Doc} docNow @returns {CodeArm} */
export const codeArm = (docNow) => ({
  joints: () => pendantValues(docNow().robot, docNow().posture),
  position: (system, isTp) => positionForCode(docNow(), system, isTp),
  kinematics: {
    toPosition: (joints, system) => positionOfJoints(docNow(), system, joints),
    /** Where a joint move there would end. */
    toJoints(position, system, near) {
      const doc = docNow();
      const { robot } = doc;
      const seed = near ? postureFromPendant(robot, near.slice(0, robot.joints.length)) : doc.posture;
      const found = movesOf(doc, compilePosture(robot, seed), { ...ANY_MOVE, position }, system);
      return 'message' in found
        ? null
        : pendantValues(robot, postureFromKernel(robot, found.moves[0].move.followed.end));
    },
  },
  isInRange: (joints) => isWithinLimits(docNow().robot, joints),
});
