/**
 * The same robot in other units: every number of the document converts, none is merely relabelled. Left as they are: what
 * has no unit of the document (quaternions, efforts, couplings), controller programs, and foreign elements.
 *
 * @import { DhField, Doc, FrameDoc, JointDoc, MoveStep, ObstacleDoc, PoseDoc, PoseTarget, TargetDoc, Units } from '../document.js'
 * @import { ObstacleSize } from '../workcell/obstacles.js'
 * @typedef {'length' | 'angle'} Quantity
 * @typedef {(quantity: Quantity, value: number) => number} Convert
 */
import { DH_FIELDS, quantityOf } from '../document.js';
import { LARGEST_NUMBER } from '../documentRules.js';
import { withMoves, withTargets } from '../program/motionProgram.js';
import { OBSTACLE_SIZES } from '../workcell/obstacles.js';
import { commonAngle, convertAngle, convertLength } from '../units.js';

const LIMITS = /** @type {const} */ (['lower', 'upper', 'home']);
const RATES = /** @type {const} */ (['velocity', 'acceleration', 'jerk']);
const SIZES = /** @type {const} */ (['radius', 'width', 'height']);

/**
 * A text that ends in a unit means the same in a document of any units, since a unit belongs to the whole product before it
 * and only like is added to like; unless a sine is in it, whose angle may be in the document's unit.
 */
const HAS_OWN_UNIT = /((?<![A-Za-z])(mm|cm|m|in|deg|rad)|[°"])\s*$/;
const HAS_TURN = /sin|cos|tan/i;

/** @param {string} typed */
const hasOwnUnit = (typed) => HAS_OWN_UNIT.test(typed) && !HAS_TURN.test(typed);

/**
 * @param {Doc} doc
 * @param {Units} units
 * @returns {Doc} the same object if it has these units
 */
export function convertUnits(doc, units) {
  const from = doc.robot.units;
  if (from.length === units.length && from.angle === units.angle) return doc;
  return inUnits(doc, units, converter(from, units));
}

/**
 * The first number that no document can hold in these units, as it would be there: too large, or too small to be told
 * from zero.
 * @param {Doc} doc
 * @param {Units} units
 * @returns {{ quantity: Quantity, value: number } | null}
 */
export function firstBeyond(doc, units) {
  /** @type {{ quantity: Quantity, value: number } | null} */
  let found = null;
  const convert = converter(doc.robot.units, units);
  inUnits(doc, units, (quantity, old) => {
    const value = convert(quantity, old);
    if (Math.abs(value) > LARGEST_NUMBER || (value === 0 && old !== 0)) found ??= { quantity, value };
    return value;
  });
  return found;
}

/** @param {Units} from @param {Units} to @returns {Convert} */
const converter = (from, to) => (quantity, value) =>
  quantity === 'length' ? convertLength(value, from.length, to.length) : convertAngle(value, from.angle, to.angle);

/** @param {Doc} doc @param {Units} units @param {Convert} convert @returns {Doc} */
function inUnits(doc, { length, angle }, convert) {
  const { robot } = doc;
  const values = (/** @type {readonly number[]} */ q) =>
    q.map((value, i) => convert(quantityOf(robot.joints[i], 'home'), value));
  const units = { length, angle };
  return {
    ...doc,
    robot: {
      ...robot,
      units,
      base: convertPose(robot.base, convert),
      tool: convertPose(robot.tool, convert),
      joints: robot.joints.map((joint) => withTexts(convertJoint(joint, convert), joint, robot.units, units)),
    },
    posture: values(doc.posture),
    postures: doc.postures.map((posture) => ({ ...posture, q: values(posture.q) })),
    frames: doc.frames.map((frame) => convertPose(frame, convert)),
    targets: doc.targets.map((target) => convertPose(target, convert)),
    obstacles: doc.obstacles.map((obstacle) => convertObstacle(obstacle, convert)),
    motionPrograms: withMoves(doc.motionPrograms, (move) => convertMove(move, convert, values)),
  };
}

/**
 * @template {PoseDoc | FrameDoc | TargetDoc | ObstacleDoc | PoseTarget} Pose
 * @param {Pose} pose
 * @param {Convert} convert
 * @returns {Pose}
 */
function convertPose(pose, convert) {
  const xyz = pose.xyz.map((value) => convert('length', value));
  return { ...pose, xyz, ...(pose.rpy && { rpy: pose.rpy.map((value) => convert('angle', value)) }) };
}

/** @param {ObstacleDoc} obstacle @param {Convert} convert @returns {ObstacleDoc} */
function convertObstacle(obstacle, convert) {
  /** @type {ObstacleDoc & Partial<Record<ObstacleSize, number>>} */
  const there = convertPose(obstacle, convert);
  return converted(there, OBSTACLE_SIZES[obstacle.kind], () => 'length', convert);
}

/**
 * @param {MoveStep} move
 * @param {Convert} convert
 * @param {(q: readonly number[]) => readonly number[]} values  a posture's
 * @returns {MoveStep}
 */
function convertMove(move, convert, values) {
  const { speed, speedUnit, ending } = move;
  const there = withTargets(move, (target) => {
    if (target.kind === 'posture') return { ...target, values: values(target.values) };
    return target.kind === 'pose' ? convertPose(target, convert) : target;
  });
  return {
    ...there,
    speed: speedUnit === '%' ? speed : convert(speedUnit === 'angle/s' ? 'angle' : 'length', speed),
    ending: ending.kind === 'distance' ? { ...ending, value: convert('length', ending.value) } : ending,
  };
}

/** @param {JointDoc} joint @param {Convert} convert @returns {JointDoc} */
function convertJoint(joint, convert) {
  const own = quantityOf(joint, 'home');
  const link = converted(joint.link, SIZES, () => 'length', convert);
  const controller = { ...joint.controller, offset: convert(own, joint.controller.offset) };
  const row = converted(joint, [...DH_FIELDS, ...LIMITS], (field) => quantityOf(joint, field), convert);
  // Numbers that differ in the last digit only may change places by it.
  const upper = row.lower !== undefined && row.upper !== undefined && row.lower > row.upper ? row.lower : row.upper;
  const limits = upper === undefined ? {} : { upper };
  return { ...converted(row, RATES, () => own, convert), ...limits, link, controller };
}

/**
 * @template {string} Field
 * @template {{ readonly [Name in Field]?: number }} Thing
 * @param {Thing} thing
 * @param {readonly Field[]} fields
 * @param {(field: Field) => Quantity} quantity
 * @param {Convert} convert
 * @returns {Thing}
 */
function converted(thing, fields, quantity, convert) {
  const numbers = fields.flatMap((field) => {
    const value = thing[field];
    return value === undefined ? [] : [[field, convert(quantity(field), value)]];
  });
  return { ...thing, ...Object.fromEntries(numbers) };
}

/**
 * What was typed stays where it still means the number: in a column whose unit stays, or with a unit of its own. A common
 * angle that becomes radians is written as a fraction of π.
 * @param {JointDoc} joint  its numbers in the new units
 * @param {JointDoc} old
 * @param {Units} from
 * @param {Units} to
 * @returns {JointDoc}
 */
function withTexts(joint, old, from, to) {
  /** @type {Partial<Record<DhField, string>>} */
  const text = {};
  for (const field of DH_FIELDS) {
    const quantity = quantityOf(old, field);
    const typed = old.text?.[field];
    const stays = from[quantity] === to[quantity] || (typed !== undefined && hasOwnUnit(typed));
    const kept = stays ? typed : quantity === 'angle' && to.angle === 'rad' ? commonAngle(old[field])?.text : undefined;
    if (kept !== undefined) text[field] = kept;
  }
  /** @type {JointDoc} */
  const row = { ...joint, text };
  if (Object.keys(text).length === 0) delete row.text;
  return row;
}
