/**
 * Light arms, to work beside people or to be carried.
 * @import { RobotDoc } from '../document.js'
 */
import { robot, turn } from './rows.js';

const UNIVERSAL_ROBOTS =
  'Universal Robots, https://www.universal-robots.com/articles/ur/parameters-for-calculations-of-kinematics-and-dynamics; limits from the data sheet, ±360°';
const KINOVA =
  'Kinova, “DH Parameters” 1.0.8 (2013), as Robotics Toolbox for Python 1.5.0, with joint 1 counted the other way; limits from https://github.com/Kinovarobotics/kinova-ros @924781d';

/** @type {Record<string, RobotDoc>} */
export const LIGHT = {
  ur3: robot('UR3', UNIVERSAL_ROBOTS, [
    turn(0, 151.9, 0, 90, -360, 360, 0),
    turn(0, 0, -243.65, 0, -360, 360, -75),
    turn(0, 0, -213.25, 0, -360, 360, 95),
    turn(0, 112.35, 0, 90, -360, 360, -110),
    turn(0, 85.35, 0, -90, -360, 360, -90),
    turn(0, 81.9, 0, 0, -360, 360, 0),
  ]),
  ur5: robot('UR5', UNIVERSAL_ROBOTS, [
    turn(0, 89.459, 0, 90, -360, 360, 0),
    turn(0, 0, -425, 0, -360, 360, -75),
    turn(0, 0, -392.25, 0, -360, 360, 95),
    turn(0, 109.15, 0, 90, -360, 360, -110),
    turn(0, 94.65, 0, -90, -360, 360, -90),
    turn(0, 82.3, 0, 0, -360, 360, 0),
  ]),
  ur10: robot('UR10', UNIVERSAL_ROBOTS, [
    turn(0, 127.3, 0, 90, -360, 360, 0),
    turn(0, 0, -612, 0, -360, 360, -75),
    turn(0, 0, -572.3, 0, -360, 360, 95),
    turn(0, 163.941, 0, 90, -360, 360, -110),
    turn(0, 115.7, 0, -90, -360, 360, -90),
    turn(0, 92.2, 0, 0, -360, 360, 0),
  ]),
  kinova_mico: robot('Kinova Mico', KINOVA, [
    turn(0, 275.5, 0, 90, -360, 360, 0),
    turn(-90, 0, 290, 180, 50, 310, 150),
    turn(90, -7, 0, 90, 35, 325, 275),
    turn(0, -166.08165494695126, 0, 60, -360, 360, 120),
    turn(-180, -85.56330989390253, 0, 60, -360, 360, 60),
    turn(100, -202.78165494695128, 0, 180, -360, 360, 0),
  ]),
  kinova_jaco: robot('Kinova Jaco', KINOVA, [
    turn(0, 275.5, 0, 90, -360, 360, 0),
    turn(-90, 0, 410, 180, 47, 313, 150),
    turn(90, -9.8, 0, 90, 19, 341, 275),
    turn(0, -250.1971250007892, 0, 60, -360, 360, 120),
    turn(-180, -85.79425000157839, 0, 60, -360, 360, 60),
    turn(100, -211.5971250007892, 0, 180, -360, 360, 0),
  ]),
  kuka_youbot: robot('KUKA youBot arm', 'ARTE @a8df0b1, YouBot, limits included', [
    turn(0, 147, 33, 90, -170, 170, 0),
    turn(90, 0, 155, 0, -170, 50, -30),
    turn(0, 0, 135, 0, -110, 155, -60),
    turn(-90, 0, 0, -90, -175, 175, -80),
    turn(0, 217.5, 0, 0, -120, 120, 0),
  ]),
};
