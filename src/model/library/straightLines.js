/**
 * SCARA, cylinder and gantry: arms whose tool keeps its tilt.
 * @import { RobotDoc } from '../document.js'
 */
import { robot, slide, turn } from './rows.js';

/** @type {Record<string, RobotDoc>} */
export const STRAIGHT_LINES = {
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
  cyl_rpp: robot(
    'Cylindrical arm RPP',
    'Spong, Hutchinson and Vidyasagar, Robot Modeling and Control (2006), ch. 3; lengths and limits chosen here',
    [turn(0, 500, 0, 0, -170, 170, 0), slide(0, 0, 0, -90, 0, 800, 350), slide(0, 0, 0, 0, 300, 1100, 700)],
  ),
  cart_ppp: robot(
    'Gantry PPP',
    'Three slides at right angles, twists as the base of P8 in Robotics Toolbox for Python 1.5.0; lengths and limits chosen here',
    [slide(0, 0, 0, -90, 0, 1000, 400), slide(-90, 0, 0, -90, -600, 600, 200), slide(0, 0, 0, 0, 100, 900, 500)],
  ),
};
