/**
 * Arms of factories.
 * @import { RobotDoc } from '../document.js'
 */
import { counted, coupled, robot, turn } from './rows.js';

/**
 * Axis 6 of KUKA arms goes from −350° to 350°. In these tables the flange is turned by half a turn about it against $FLANGE of the
 * controller; counting axis 6 with that has positions and axis values agree, and the joint's limits are half a turn off.
 * @param {number} d @param {number} alpha @param {1 | -1} sign
 */
const kukaFlange = (d, alpha, sign) =>
  counted(sign > 0 ? turn(0, d, 0, alpha, -530, 170, 0) : turn(0, d, 0, alpha, -170, 530, 0), sign, 180);

/** @type {Record<string, RobotDoc>} */
export const INDUSTRIAL = {
  kuka_kr5_arc: robot(
    'KUKA KR 5 arc',
    'ARTE (KUKA KR5 arc), as Robotics Toolbox for Python 1.5.0 with its limits; axes counted as https://github.com/ros-industrial/kuka_experimental @e78bbd1, kr5_arc_macro.xacro; limits put on A3 and A6',
    [
      counted(turn(0, 400, 180, -90, -155, 155, 0), -1),
      turn(0, 0, 600, 0, -180, 65, -95),
      counted(turn(0, 0, 120, 90, -105, 68, 35), 1, 90),
      turn(0, -620, 0, -90, -350, 350, 0),
      turn(0, 0, 0, 90, -130, 130, 60),
      kukaFlange(-115, 180, 1),
    ],
  ),
  kuka_kr6_r900: robot(
    'KUKA KR 6 R900 sixx',
    'Derived from https://github.com/ros-industrial/kuka_experimental @e78bbd1, kr6r900sixx_macro.xacro; axes counted as there, where A1 turns the other way than joint 1; limits of joint 6 put on A6',
    [
      counted(turn(0, 400, 25, -90, -170, 170, 0), -1),
      turn(0, 0, 455, 0, -190, 45, -80),
      turn(-90, 0, 35, 90, -120, 156, 110),
      turn(0, -420, 0, -90, -185, 185, 0),
      turn(0, 0, 0, 90, -120, 120, 60),
      kukaFlange(-80, 180, 1),
    ],
  ),
  kuka_kr210_l150: robot(
    'KUKA KR 210 L150',
    'Lengths rounded to mm, and limits, from https://github.com/ros-industrial/kuka_experimental @e78bbd1, kr210l150_macro.xacro; axes counted as of the KR 6; limits of joint 6 put on A6',
    [
      counted(turn(0, 750, 350, -90, -185, 185, 0), -1),
      counted(turn(-90, 0, 1250, 0, -45, 85, 10), 1, -90),
      counted(turn(0, 0, -55, -90, -210, 65, 20), 1, 90),
      counted(turn(0, 1500, 0, 90, -350, 350, 0), -1),
      turn(0, 0, 0, -90, -125, 125, 60),
      kukaFlange(230, 0, -1),
    ],
  ),
  fanuc_lrmate200id: robot(
    'FANUC LR Mate 200iD',
    'Derived from https://github.com/ros-industrial/fanuc @8fee5e3, lrmate200id_macro.xacro; lengths agree with ARTE. J23_factor 1 as in its launch file',
    [
      turn(0, 330, 50, -90, -170, 170, 0),
      turn(-90, 0, 330, 180, -100, 145, 15),
      coupled(turn(0, 0, 35, -90, -70, 205, -15), 'joint_2', -1),
      turn(0, -335, 0, 90, -190, 190, 0),
      turn(0, 0, 0, -90, -125, 125, -60),
      turn(0, -80, 0, 180, -360, 360, 0),
    ],
  ),
  fanuc_m10ia: robot(
    'FANUC M-10iA',
    'Derived from https://github.com/ros-industrial/fanuc @8fee5e3, m10ia_macro.xacro; lengths agree with ARTE. J23_factor 1 as in its launch file',
    [
      turn(0, 450, 150, -90, -179.9087476710785, 179.9087476710785, 0),
      turn(-90, 0, 600, 180, -89.95437383553924, 159.85522484149968, 10),
      coupled(turn(0, 0, 200, -90, -179.9087476710785, 264.13354355530953, -20), 'joint_2', -1),
      turn(0, -640, 0, 90, -189.64903018830248, 189.64903018830248, 0),
      turn(0, 0, 0, -90, -189.64903018830248, 189.64903018830248, -60),
      turn(0, -100, 0, 180, -359.817495342157, 359.817495342157, 0),
    ],
  ),
  abb_irb120: robot(
    'ABB IRB 120',
    'ARTE @a8df0b1, IRB120; limits from https://github.com/ros-industrial/abb_experimental @20b9cf8, irb120_3_58_macro.xacro',
    [
      turn(0, 290, 0, -90, -164.99981288397933, 164.99981288397933, 0),
      turn(-90, 0, 270, 0, -109.99987525598623, 109.99987525598623, 10),
      turn(0, 0, 70, -90, -109.99987525598623, 69.99997270451806, 20),
      turn(0, 302, 0, 90, -160.0001831636678, 160.0001831636678, 0),
      turn(0, 0, 0, -90, -119.99999413330205, 119.99999413330205, 60),
      turn(180, 72, 0, 0, -400.0001714302719, 400.0001714302719, 0),
    ],
  ),
  abb_irb140: robot('ABB IRB 140', 'ABB data sheet and ARTE, as Robotics Toolbox for Python 1.5.0 with its limits', [
    turn(0, 352, 70, -90, -180, 180, 0),
    turn(0, 0, 360, 0, -100, 100, -80),
    turn(0, 0, 0, -90, -220, 60, 20),
    turn(0, 380, 0, 90, -200, 200, 0),
    turn(0, 0, 0, -90, -120, 120, 60),
    turn(0, 65, 0, 0, -400, 400, 0),
  ]),
  mitsubishi_rv2aj: robot('Mitsubishi RV-2AJ', 'ARTE @a8df0b1, RV-2AJ, limits included', [
    turn(0, 300, 0, 90, -170, 170, 0),
    turn(0, 0, 280, 0, -92, 135, 80),
    turn(0, 0, 100, 0, -107, 166, -70),
    turn(0, 0, 0, -90, -160, 136, -120),
    turn(0, 72, 0, 0, -120, 120, 0),
  ]),
};
