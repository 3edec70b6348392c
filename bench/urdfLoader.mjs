/**
 * Forward kinematics by urdf-loader 0.13.1 on three, as pages do it that show a robot: set the joints, update the matrices, read
 * the last one. The arm is built of its classes, as its parser would build it from a file.
 *
 * @import { Arm } from './arms.mjs'
 */
import { Vector3 } from 'three';
import { URDFJoint, URDFLink, URDFRobot } from 'urdf-loader/src/URDFClasses.js';
import { linkMatrix } from './closedChain.mjs';

/** @param {Arm} arm @returns {(q: ArrayLike<number>) => ArrayLike<number>} T_base_tcp, good until the next call */
export function createUrdfArm({ joints }) {
  const robot = new URDFRobot();
  let tip = new URDFLink();
  robot.add(tip);
  const movers = joints.map((row, i) => {
    const joint = new URDFJoint();
    joint.jointType = row.type;
    joint.axis = new Vector3(0, 0, 1);
    joint.limit = { lower: row.lower, upper: row.upper, effort: 0, velocity: 0 };
    if (i > 0) linkMatrix(joints[i - 1]).decompose(joint.position, joint.quaternion, joint.scale);
    tip.add(joint);
    tip = new URDFLink();
    joint.add(tip);
    return joint;
  });
  const flange = new URDFJoint(); // fixed
  linkMatrix(joints[joints.length - 1]).decompose(flange.position, flange.quaternion, flange.scale);
  tip.add(flange);
  return function pose(q) {
    for (let i = 0; i < movers.length; i++) movers[i].setJointValue(q[i]);
    robot.updateMatrixWorld();
    return flange.matrixWorld.elements;
  };
}
