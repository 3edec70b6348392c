/**
 * The arms that come with the page, in millimetres and degrees, each with the source of its numbers. Base and tool are
 * the identity. `home` is a posture to begin with: away from singularities, tool in view; it is our choice.
 *
 * @import { JointDoc, JointType, RobotDoc, Doc } from './document.js'
 */
import { homePosture, identityPose } from './document.js';
import { deepFreeze } from './freeze.js';

/**
 * @param {JointType} type
 * @param {number[]} row  theta d a alpha lower upper home
 * @returns {(index: number) => JointDoc}
 */
const joint =
  (type, [theta, d, a, alpha, lower, upper, home]) =>
  (index) => ({
    id: `joint_${index + 1}`,
    type,
    ...{ theta, d, a, alpha, lower, upper, home },
    link: { kind: 'auto' },
    controller: { sign: 1, offset: 0, coupling: 0 },
  });
const turn = (/** @type {number[]} */ ...row) => joint('revolute', row);
const slide = (/** @type {number[]} */ ...row) => joint('prismatic', row);

/**
 * @param {string} name
 * @param {string} source
 * @param {((index: number) => JointDoc)[]} joints
 * @returns {RobotDoc}
 */
const robot = (name, source, joints) => ({
  name,
  info: { source },
  units: { length: 'mm', angle: 'deg' },
  convention: 'standard',
  base: identityPose(),
  tool: identityPose(),
  joints: joints.map((make, index) => make(index)),
});

/** @type {Readonly<Record<string, RobotDoc>>} keys are the ids that scripts and links use */
export const LIBRARY = deepFreeze({
  puma560: robot(
    'Puma 560',
    'Corke and Armstrong-Hélouvry, ICRA 1994, pp. 1608–1613; limits as Robotics Toolbox for Python 1.5.0',
    [
      turn(0, 671.83, 0, 90, -160, 160, 0),
      turn(0, 0, 431.8, 0, -45, 225, 45),
      turn(0, 150.05, 20.3, -90, -225, 45, -180),
      turn(0, 431.8, 0, 90, -110, 170, 0),
      turn(0, 0, 0, -90, -100, 100, 45),
      turn(0, 0, 0, 0, -266, 266, 0),
    ],
  ),
  ur5: robot(
    'UR5',
    'Universal Robots, "Parameters for calculations of kinematics and dynamics"; limits from the data sheet, ±360°',
    [
      turn(0, 89.459, 0, 90, -360, 360, 0),
      turn(0, 0, -425, 0, -360, 360, -75),
      turn(0, 0, -392.25, 0, -360, 360, 95),
      turn(0, 109.15, 0, 90, -360, 360, -110),
      turn(0, 94.65, 0, -90, -360, 360, -90),
      turn(0, 82.3, 0, 0, -360, 360, 0),
    ],
  ),
  scara_cobra600: robot(
    'Cobra 600',
    'Adept Cobra 600, as in Robotics Toolbox for Python 1.5.0; limits of joint 4 chosen here, ±180°',
    [
      turn(0, 387, 325, 0, -50, 50, -20),
      turn(0, 0, 275, 180, -88, 88, 60),
      slide(0, 0, 0, 0, 0, 210, 80),
      turn(0, 0, 0, 0, -180, 180, 0),
    ],
  ),
  planar2r: robot(
    'Planar 2R',
    'Two links of one metre, as in Robotics Toolbox for Python 1.5.0 (Planar2); limits chosen here, ±180°',
    [turn(0, 0, 1000, 0, -180, 180, 30), turn(0, 0, 1000, 0, -180, 180, 60)],
  ),
});

export const FIRST_ROBOT = 'puma560';

/**
 * A new document around a robot: at home, nothing recorded.
 * @param {RobotDoc} robotDoc
 * @returns {Doc}
 */
export const newDocument = (robotDoc) => ({
  robot: robotDoc,
  posture: homePosture(robotDoc),
  postures: [],
  frames: [],
  programs: [],
  extensions: [],
});
