/**
 * Postures that have a name: those that follow from the robot itself, and those that a published model of the arm gives.
 * Each says where it is from. Loaded when somebody asks where to go.
 *
 * @import { Doc, JointDoc, RobotDoc } from './document.js'
 *
 * @typedef {object} NamedPosture
 * @property {string} name      'home', 'zero', 'middle', or what the source calls it
 * @property {string | null} source   null: it follows from the robot
 * @property {string} [note]    what it looks like
 * @property {readonly number[]} q    document units
 * @property {readonly number[]} outside  indices of the joints that are past their limits there
 */
import { convertConvention } from './robot/convertConvention.js';
import { convertUnits } from './robot/convertUnits.js';
import { DH_FIELDS, homePosture, isSliding, limitsOf } from './document.js';
import { LIBRARY } from './library.js';
import { PUBLISHED_POSTURES } from './library/postures.js';
import { newDocument } from './newDocument.js';

/**
 * @param {RobotDoc} robot
 * @returns {NamedPosture[]}
 */
export function namedPostures(robot) {
  const { joints } = robot;
  /** @param {string} name @param {readonly number[]} q @param {{ source?: string, note?: string }} [more] @returns {NamedPosture} */
  const posture = (name, q, { source, note } = {}) => ({
    name,
    source: source ?? null,
    ...(note !== undefined && { note }),
    q,
    outside: joints.flatMap((joint, i) => (isInside(joint, q[i]) ? [] : [i])),
  });
  const limits = joints.map(limitsOf);
  const isLimited = limits.every(({ lower, upper }) => Number.isFinite(lower) && Number.isFinite(upper));
  return [
    posture('home', homePosture(robot)),
    posture(
      'zero',
      joints.map(() => 0),
    ),
    ...(isLimited
      ? [
          posture(
            'middle',
            limits.map(({ lower, upper }) => (lower + upper) / 2),
          ),
        ]
      : []),
    ...publishedFor(robot).map(({ name, q, source, note }) => posture(name, q, { source, note })),
  ];
}

/** @param {JointDoc} joint @param {number} value */
function isInside(joint, value) {
  const { lower, upper } = limitsOf(joint);
  return value >= lower && value <= upper;
}

/**
 * What was published holds for the arm with that table, whatever it is called now, in whichever units and convention it is
 * written; as soon as a number of the table is another, it is another arm.
 * @param {RobotDoc} robot
 */
function publishedFor(robot) {
  for (const [id, postures] of Object.entries(PUBLISHED_POSTURES)) {
    const known = LIBRARY[id];
    if (known.joints.length !== robot.joints.length) continue;
    const doc = convertUnits(convertConvention(newDocument(known), robot.convention), robot.units);
    if (!hasSameTable(doc.robot, robot)) continue;
    return postures.map((posture) => {
      const /** @type {Doc} */ there = { ...newDocument(known), posture: posture.q };
      return { ...posture, q: convertUnits(there, robot.units).posture };
    });
  }
  return [];
}

/** @param {RobotDoc} one @param {RobotDoc} other */
const hasSameTable = (one, other) =>
  one.joints.every((joint, i) => {
    const same = other.joints[i];
    return isSliding(joint) === isSliding(same) && DH_FIELDS.every((field) => joint[field] === same[field]);
  });
