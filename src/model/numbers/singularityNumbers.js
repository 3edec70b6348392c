/**
 * The nearest singular posture that is found, in document units. It takes tens of milliseconds: a worker looks for it.
 *
 * @import { Doc, RobotDoc } from '../document.js'
 * @import { Chain, ChainDescription } from '../../kinematics/chain.js'
 * @import { SingularityDistance } from '../../kinematics/singularity.js'
 * @import { SingularityKind } from '../../kinematics/measures/singularityKinds.js'
 *
 * @typedef {SingularityDistance} FoundSingularity  as the kernel answers
 * @typedef {SingularityKind} NamedSingularity
 * @typedef {{ chain: ChainDescription, q: Float64Array }} SingularityQuestion
 *
 * @typedef {object} NearestSingularity
 * @property {boolean} isFound
 * @property {boolean} isHere
 * @property {number} distance      norm of the joint displacements, in the document's angle; slides over the length scale
 * @property {number} nearness      1 at a singular posture, 0 at a right angle from it or more
 * @property {number} lengthScale   in the document's unit
 * @property {readonly number[] | null} posture
 * @property {number | null} joint  that moves most on the way, from 0
 * @property {number} by            how far it moves, in the document's units
 * @property {readonly SingularityKind[]} kinds
 */
import { compilePosture, postureFromKernel } from '../compile.js';
import { fromKernel } from '../units.js';

/** Radians: farther than a right angle from the nearest is as far as a spherical wrist can be. */
const FAR = Math.PI / 2;

/** Radians: nearer than this it is the same posture. */
const HERE = 1e-9;

/**
 * @param {Doc} doc
 * @param {Chain} chain
 * @returns {SingularityQuestion} plain, for a worker
 */
export const singularityQuestion = ({ robot, posture }, { convention, base, tool, joints }) => ({
  chain: { convention, base, tool, joints: joints.map((joint) => ({ ...joint })) },
  q: compilePosture(robot, posture),
});

/**
 * @param {RobotDoc} robot
 * @param {readonly number[]} from  the posture that was asked about
 * @param {SingularityDistance} found
 * @returns {NearestSingularity}
 */
export function nearestSingularity(robot, from, { isFound, distance, lengthScale, q, joint, kinds }) {
  const posture = q && postureFromKernel(robot, q);
  return {
    isFound,
    isHere: isFound && distance < HERE,
    distance: fromKernel('angle', distance, robot.units),
    nearness: isFound ? Math.max(0, 1 - distance / FAR) : 0,
    lengthScale: fromKernel('length', lengthScale, robot.units),
    posture,
    joint,
    by: joint === null || !posture ? 0 : posture[joint] - from[joint],
    kinds,
  };
}
