/**
 * What people and controllers call a posture, from the lines of the arm: pure functions of what `prepareNames` says of the arm and
 * of the joint values. Null stands where a word has no meaning for the arm, or where the posture is on the border of two: with
 * the wrist within 1e-7 arm lengths of axis 1's plane, or an elbow or wrist bent by a sine below 1e-7.
 *
 * - shoulder: whether the wrist is in front of axis 1 or behind it, as the arm sees it, which turns with axis 1;
 * - elbow: whether it is above the line from shoulder to wrist, for an arm that does not lean past axis 1. Its name changes where
 *   the arm is straight or the wrist over axis 1, and nowhere else (Lee and Ziegler 1984 decide alike). An arm in a plane that
 *   lies is righty while its elbow is right of the line from shoulder to hand, seen from above, as a man's right arm is;
 * - wrist: to which side of straight it is bent.
 *
 * @import { Bend, Names, NoCode, Shoulder } from './names/nameLines.js'
 * @import { PlanarArm } from './names/namePlanar.js'
 *
 * @typedef {object} PostureName
 * @property {'front' | 'back' | null} shoulder
 * @property {'up' | 'down' | 'righty' | 'lefty' | null} elbow
 * @property {'no-flip' | 'flip' | null} wrist
 *
 * @typedef {object} CodeOptions
 * @property {ArrayLike<number>} [axisValues]  the joint values as the controller counts them, radians: its signs and zeros,
 *   which no line of the arm tells. If they are not given, the table's values have to do
 *
 * @typedef {object} FanucOptions
 * @property {readonly [number, number, number]} [turnAxes]  the axes, from 1, that the three turn numbers count
 *
 * @typedef {{ text: string, reason: null } | { text: null, reason: NoCode }} FanucConfiguration
 *
 * @typedef {{ status: number, turn: number, reason: null } | { status: null, turn: null, reason: NoCode }} KukaStatusTurn
 */
import { requirePosture } from './checks.js';
import { BORDER } from './names/nameLines.js';

export { prepareNames } from './names/nameLines.js';

const FULL_TURN = 2 * Math.PI;

/** Radians: what rounding makes of zero. */
const ZERO = 1e-12;

/**
 * @param {Names} names
 * @param {ArrayLike<number>} q
 * @returns {PostureName}
 */
export function namePosture(names, q) {
  requirePosture(names.dof, q);
  const { shoulder, elbow, wrist, planar } = names;
  const side = shoulder ? sideOf(shoulder, q) : 0;
  const above = elbow ? side * signOf(sineOf(elbow, q)) : 0;
  const bent = wrist ? signOf(sineOf(wrist, q)) : 0;
  return {
    shoulder: side === 0 ? null : side > 0 ? 'front' : 'back',
    elbow: planar ? planarElbow(planar, q) : above === 0 ? null : above > 0 ? 'up' : 'down',
    wrist: bent === 0 ? null : bent > 0 ? 'no-flip' : 'flip',
  };
}

/** @param {number} value @param {number} [border] @returns {-1 | 0 | 1} 0 on the border */
const signOf = (value, border = BORDER) => (value > border ? 1 : value < -border ? -1 : 0);

/** @param {Bend} bend @param {ArrayLike<number>} q */
const sineOf = ({ joint, straight, sense }, q) => sense * Math.sin(q[joint] - straight);

/** 1 in front, −1 behind. @param {Shoulder} shoulder @param {ArrayLike<number>} q */
function sideOf({ start, links, border }, q) {
  let forward = start;
  let angle = 0;
  for (let i = 0; i < links.length; i++) {
    const { joint, sense, slide, reach } = links[i];
    angle += sense * q[joint];
    const by = sense === 0 ? q[joint] : 0;
    forward += Math.cos(angle) * (reach[0] + by * slide[0]) - Math.sin(angle) * (reach[1] + by * slide[1]);
  }
  return signOf(forward, border);
}

/** @param {PlanarArm} arm @param {ArrayLike<number>} q @returns {PostureName['elbow']} */
function planarElbow({ first, second, sense, aim, bend, upper, fore, isUpright, side }, q) {
  const bent = bend + sense * q[second];
  const right = signOf(Math.sin(bent));
  if (right === 0) return null;
  if (!isUpright) return right * side > 0 ? 'righty' : 'lefty';
  // About the first axis, which points at who looks: right of a line to the left is above it.
  const level = upper * Math.cos(aim + q[first]) + fore * Math.cos(aim + q[first] + bent);
  const above = -right * signOf(level, BORDER * (upper + fore));
  return above === 0 ? null : above > 0 ? 'up' : 'down';
}

/**
 * FANUC's arm configuration, as in a position's `CONFIG : 'N U T, 0, 0, 0'`, for arms of six turning axes with a spherical wrist.
 *
 * T: the wrist centre is in front of axis 1 (B: behind). U: the elbow is on the outer side of the straight arm, where it is with
 * the upper arm upright and the forearm level (D: on the other). N: the wrist is bent as it is by a negative J5 (F: by a
 * positive one). A turn number is 0 from −179° to 179°, 1 from 180° to 539°, −1 from −539° to −180°, and so on.
 *
 * N and F are checked against postures published with both (ONE Robotics 2013, "The perils of six-axis robots"). Not checked
 * against a controller: D, B, and what is said on a border, which here is N, U and T. Which axes the turn numbers count is a
 * setting of the controller ($SCR_GRP.$TURN_AXIS); programs in use agree with J1, J4 and J6.
 * @param {Names} names
 * @param {ArrayLike<number>} q
 * @param {CodeOptions & FanucOptions} [options]
 * @returns {FanucConfiguration}
 */
export function fanucConfiguration(names, q, { axisValues = q, turnAxes = [1, 4, 6] } = {}) {
  requirePosture(names.dof, q);
  requirePosture(names.dof, axisValues);
  const { shoulder, elbow, wrist, noCode } = names;
  if (!shoulder || !elbow || !wrist || noCode) return { text: null, reason: noCode ?? 'no-elbow' };
  const bent = signOf(sineOf(wrist, q)) < 0 ? 'F' : 'N';
  const outer = signOf(sineOf(elbow, q)) < 0 ? 'D' : 'U';
  const letters = `${bent} ${outer} ${sideOf(shoulder, q) < 0 ? 'B' : 'T'}`;
  const [first, second, third] = turnAxes;
  return {
    text: `${letters}, ${turnNumber(axisValues[first - 1])}, ${turnNumber(axisValues[second - 1])}, ${turnNumber(axisValues[third - 1])}`,
    reason: null,
  };
}

/** A half turn itself counts as begun, either way. @param {number} value */
function turnNumber(value) {
  const turns = Math.floor(Math.abs(value) / FULL_TURN + 0.5);
  return value < 0 && turns > 0 ? -turns : turns;
}

/**
 * KUKA's Status and Turn, the S and T of a POS, for arms of six turning axes with a spherical wrist.
 *
 * Status bit 0: the wrist centre is behind axis 1 ("overhead area"). Bit 1: A3 is at or past the angle at which the arm is straight,
 * which is 0 unless axis 4 passes axis 3 at a distance; here by the lines, so that an arm folded past straight the other way
 * (A3 more than 180° below that angle, where few arms get) counts as past it. Bit 2: A5 is negative, full turns aside, or, if no
 * axis values are given, the wrist is bent as by a negative A5. Turn bit i: axis i + 1 is negative.
 *
 * Sources: the SINUMERIK ONE and Beckhoff TF5200 manuals of the same codes; KUKA's expert programming manual on bit 0, as
 * quoted on robot-forum.com (7173). KUKA's manuals contradict each other on bit 2; a test on a KR 60-3 found the sign of A5
 * (robot-forum.com 45777). Not checked against a controller here. Bit 4 of Status (taught on an absolutely accurate robot) is never set.
 * @param {Names} names
 * @param {ArrayLike<number>} q
 * @param {CodeOptions} [options]
 * @returns {KukaStatusTurn}
 */
export function kukaStatusTurn(names, q, { axisValues } = {}) {
  requirePosture(names.dof, q);
  if (axisValues) requirePosture(names.dof, axisValues);
  const { shoulder, elbow, wrist, noCode } = names;
  if (!shoulder || !elbow || !wrist || noCode) return { status: null, turn: null, reason: noCode ?? 'no-elbow' };
  const bent = axisValues ? Math.sin(axisValues[4]) : sineOf(wrist, q);
  const status =
    (sideOf(shoulder, q) < 0 ? 1 : 0) + (signOf(sineOf(elbow, q)) < 0 ? 0 : 2) + (signOf(bent) < 0 ? 4 : 0);
  const values = axisValues ?? q;
  let turn = 0;
  for (let i = 0; i < 6; i++) if (values[i] < -ZERO) turn += 1 << i;
  return { status, turn, reason: null };
}
