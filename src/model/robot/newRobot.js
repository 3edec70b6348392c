/**
 * Where a robot of one's own begins: a table in which every joint visibly moves something, to be changed row by row.
 * @import { RobotDoc } from '../document.js'
 */
import { MAX_JOINTS, MIN_JOINTS } from '../document.js';
import { robot, turn } from '../library/rows.js';

const WAIST = turn(0, 300, 0, 90, -180, 180, 0);
const SHOULDER = turn(0, 0, 300, 0, -45, 225, 60);
const ELBOW = turn(0, 0, 250, 0, -150, 150, -60);
/** The tool stands off the last axis, so that turning it moves it. */
const HAND = turn(0, 120, 40, 0, -180, 180, 0);
const TIP = turn(0, 0, 150, 0, -120, 120, -60);
const PITCH = turn(90, 0, 0, 90, -120, 120, -60);

/** By number of joints: pan and tilt; an elbow; a wrist that bends; one that turns the tool; a spherical one. */
const TABLES = [
  [WAIST, SHOULDER],
  [WAIST, SHOULDER, ELBOW],
  [WAIST, SHOULDER, ELBOW, TIP],
  [WAIST, SHOULDER, ELBOW, PITCH, HAND],
  [
    WAIST,
    SHOULDER,
    turn(90, 0, 0, 90, -150, 150, -60),
    turn(0, 250, 0, -90, -180, 180, 0),
    turn(0, 0, 0, 90, -120, 120, -60),
    HAND,
  ],
];

/**
 * @param {number} count  of joints, 2 to 6
 * @param {string} name
 * @returns {RobotDoc} away from singularities at home, in millimetres and degrees
 */
export function newRobot(count, name) {
  const table = TABLES[count - MIN_JOINTS];
  if (!table) throw new RangeError(`Expected ${MIN_JOINTS} to ${MAX_JOINTS} joints, got ${count}.`);
  return robot(name, null, table);
}
