/**
 * The arms of first courses.
 * @import { RobotDoc } from '../document.js'
 */
import { robot, slide, turn } from './rows.js';

/** @type {Record<string, RobotDoc>} */
export const TEXTBOOK = {
  planar2r: robot(
    'Planar 2R',
    'Two links of one metre, as in Robotics Toolbox for Python 1.5.0 (Planar2); limits chosen here, ±180°',
    [turn(0, 0, 1000, 0, -180, 180, 30), turn(0, 0, 1000, 0, -180, 180, 60)],
  ),
  planar3r: robot(
    'Planar 3R',
    'Three links of one metre, as in Robotics Toolbox for Python 1.5.0 (Planar3); limits chosen here, ±180°',
    [turn(0, 0, 1000, 0, -180, 180, 20), turn(0, 0, 1000, 0, -180, 180, 40), turn(0, 0, 1000, 0, -180, 180, 40)],
  ),
  planar_rp: robot(
    'Planar RP',
    'The RP manipulator of Craig, Introduction to Robotics (3rd ed., 2005); lengths and limits chosen here',
    [turn(90, 0, 0, 90, -180, 180, 30), slide(0, 0, 0, 0, 200, 1000, 700)],
  ),
  planar_pr: robot('PR arm', 'The PR arm of first courses; table, lengths and limits chosen here', [
    slide(0, 0, 0, 90, 200, 1000, 500),
    turn(0, 0, 500, 0, -180, 180, 30),
  ]),
  anthropomorphic_3r: robot(
    'Anthropomorphic arm 3R',
    'Siciliano et al., Robotics: Modelling, Planning and Control (2009), ch. 2; lengths, the column of 400 mm and limits chosen here',
    [turn(0, 400, 0, 90, -170, 170, 0), turn(0, 0, 400, 0, -30, 210, 70), turn(0, 0, 400, 0, -150, 150, -80)],
  ),
  spherical_wrist: robot(
    'Spherical wrist',
    'Siciliano et al., Robotics: Modelling, Planning and Control (2009), ch. 2; d of the last joint and limits chosen here',
    [turn(0, 0, 0, -90, -180, 180, 0), turn(0, 0, 0, 90, -120, 120, 45), turn(0, 200, 0, 0, -180, 180, 0)],
  ),
  polar_rrp: robot(
    'Spherical arm RRP',
    'Spong, Hutchinson and Vidyasagar, Robot Modeling and Control (2006), ch. 3 (first three joints of the Stanford arm); lengths and limits chosen here',
    [turn(0, 600, 0, -90, -170, 170, 0), turn(0, 120, 0, 90, -120, 120, 60), slide(0, 0, 0, 0, 300, 1200, 800)],
  ),
  stanford: robot(
    'Stanford arm',
    'Paul, Robot Manipulators (1981), and Stanford AIM-177, fig. 2.3, as Robotics Toolbox for Python 1.5.0 with its limits',
    [
      turn(0, 412, 0, -90, -170, 170, 0),
      turn(0, 154, 0, 90, -170, 170, 60),
      slide(-90, 0, 20.3, 0, 304.8, 1270, 600),
      turn(0, 0, 0, -90, -170, 170, 0),
      turn(0, 0, 0, 90, -90, 90, 45),
      turn(0, 0, 0, 0, -170, 170, 0),
    ],
  ),
};
