/**
 * What postureNames.js knows of an arm before it is given a posture: where its shoulder, elbow and wrist are, if it has them.
 *
 * The arm is looked at in its own plane, the one across axis 2 that axis 1 carries round: `forward` and `up` in it, seen from the
 * arm however it stands. Forward is the side of axis 1 that axis 2 is on; if the two meet, the side that the wrist is on while all
 * joint values are zero. That, and the roll of a spherical wrist at joint value zero, is all that a name owes to the table: for
 * the rest, every table of the same arm gives the same names.
 *
 * @import { Line, Vector } from '../lines.js'
 * @import { PlanarArm } from './namePlanar.js'
 * @import { Screws } from '../screws.js'
 *
 * @typedef {'not-six-axes' | 'prismatic' | 'no-spherical-wrist' | 'no-shoulder' | 'no-elbow'} NoCode
 *   why the controllers of six-axis arms would have no code for a posture of this one. no-shoulder: axes 1 and 2 are parallel.
 *   no-elbow: axes 2 and 3 are not, or are one.
 *
 * @typedef {object} Bend   an angle of which the sign of the sine is named
 * @property {number} joint     from 0
 * @property {number} straight  the joint value at which the angle is 0
 * @property {number} sense     1 or −1
 *
 * @typedef {object} Link   what a joint moves in the arm's plane
 * @property {number} joint  from 0
 * @property {number} sense  how it turns the plane: 1, −1, or 0 for a slide
 * @property {readonly [number, number]} slide  the way of a unit of the slide, forward and up
 * @property {readonly [number, number]} reach  to the next joint or to the end, m
 *
 * @typedef {object} Shoulder   how far in front of axis 1 the wrist is
 * @property {number} start     the place of axis 2, m
 * @property {readonly Link[]} links
 * @property {number} border    less than this is neither in front nor behind, m
 *
 * @typedef {object} Names
 * @property {Shoulder | null} shoulder
 * @property {Bend | null} elbow   positive with the elbow above the line from shoulder to wrist while the wrist is in front
 * @property {Bend | null} wrist   positive for no flip
 * @property {PlanarArm | null} planar
 * @property {NoCode | null} noCode
 * @property {number} dof
 */
import { along, cross, dot, footOn, minus, nearestTo, norm, unit } from '../lines.js';
import { planarArm } from './namePlanar.js';

/** Directions that differ by less (radians) are one, and so are points (arm lengths). */
const SAME = 1e-9;

/** Offsets below this part of the arm's length give no direction, nor do products of unit vectors below it. */
const CLEAR = 1e-6;

/** A wrist this near to the plane through axis 1, in arm lengths, is neither in front of it nor behind. */
export const BORDER = 1e-7;

/**
 * @param {Screws} screws
 * @param {ArrayLike<number>} [up]  the direction that is up, as `start` has it: says whether a planar arm lies or stands
 * @returns {Names}
 */
export function prepareNames(screws, up = [0, 0, 1]) {
  const lines = Array.from({ length: screws.dof }, (_, i) => lineOf(screws, i));
  const arm = { lines, length: screws.length, tcp: vectorAt(screws.home, 12) };
  const wrist = sphericalCentre(arm);
  const plane = armPlane(arm, wrist);
  const shoulder = plane && shoulderOf(arm, plane);
  const elbow = plane && elbowOf(arm, plane);
  return {
    shoulder,
    elbow,
    wrist: wrist ? sphericalWrist(arm, wrist, plane) : plane && parallelWrist(arm, plane),
    planar: planarArm(lines, arm.tcp, arm.length, up),
    noCode: noCodeOf(arm, wrist) ?? (elbow ? null : 'no-elbow'),
    dof: screws.dof,
  };
}

/** @param {ArrayLike<number>} values @param {number} at @returns {Vector} */
const vectorAt = (values, at) => [values[at], values[at + 1], values[at + 2]];

/** @param {Screws} screws @param {number} i @returns {Line} */
const lineOf = ({ slides, axes, points }, i) => ({
  slides: slides[i],
  axis: vectorAt(axes, 3 * i),
  point: vectorAt(points, 3 * i),
});

/**
 * @typedef {object} Arm
 * @property {Line[]} lines
 * @property {number} length
 * @property {Vector} tcp
 *
 * @typedef {object} ArmPlane
 * @property {Vector} forward
 * @property {Vector} up
 * @property {number} start    of axis 2, forward of axis 1
 * @property {Vector} end      the point of the wrist that is in front or behind
 * @property {number} moving   how many joints after the first move it
 * @property {Vector} hand     the end of the forearm; moved by joints 2 and 3
 */

/** @param {Line | undefined} a @param {Line | undefined} b */
const areParallel = (a, b) => a !== undefined && b !== undefined && norm(cross(a.axis, b.axis)) < SAME;

/** @param {Line | undefined} line */
const turns = (line) => line !== undefined && !line.slides;

/** Where two lines that are not parallel meet, or null. @param {Arm} arm @param {Line} a @param {Line} b */
function meeting({ length }, a, b) {
  if (areParallel(a, b)) return null;
  const point = nearestTo(a, b);
  return norm(minus(point, nearestTo(b, a))) < SAME * length ? point : null;
}

/** Where axes 4, 5 and 6 meet. @param {Arm} arm @returns {Vector | null} */
function sphericalCentre(arm) {
  const { lines, length } = arm;
  if (lines.length !== 6 || !lines.slice(3).every(turns) || areParallel(lines[3], lines[4])) return null;
  const centre = meeting(arm, lines[4], lines[5]);
  return centre && norm(minus(centre, footOn(lines[3], centre))) < SAME * length ? centre : null;
}

/** @param {Arm} arm @param {Vector | null} wrist @returns {NoCode | null} */
function noCodeOf({ lines }, wrist) {
  if (lines.length !== 6) return 'not-six-axes';
  if (!lines.every(turns)) return 'prismatic';
  if (!wrist) return 'no-spherical-wrist';
  return areParallel(lines[0], lines[1]) ? 'no-shoulder' : null;
}

/**
 * @param {Arm} arm
 * @param {Vector | null} wrist
 * @returns {ArmPlane | null} null for an arm that has none: axis 2 parallel to axis 1, or joint 3 out of its plane
 */
function armPlane(arm, wrist) {
  const { lines, length } = arm;
  const [first, second, third] = lines;
  if (!turns(first) || !turns(second) || !third || areParallel(first, second)) return null;
  const isInPlane = third.slides ? Math.abs(dot(second.axis, third.axis)) < SAME : areParallel(second, third);
  const ends = isInPlane && endsOf(arm, wrist);
  if (!ends) return null;
  const across = unit(cross(second.axis, first.axis));
  const offset = dot(across, minus(second.point, first.point));
  const reach = dot(across, minus(ends.end, first.point));
  const sign = [offset / length, reach / length, across[0], across[1]].find((value) => Math.abs(value) > CLEAR) ?? 1;
  return {
    forward: along([0, 0, 0], Math.sign(sign), across),
    up: unit(along(first.axis, -dot(first.axis, second.axis), second.axis)),
    start: Math.sign(sign) * offset,
    ...ends,
  };
}

/** @param {Arm} arm @param {Vector | null} wrist @returns {Pick<ArmPlane, 'end' | 'hand' | 'moving'> | null} */
function endsOf(arm, wrist) {
  const { lines, tcp } = arm;
  if (wrist) return { end: wrist, hand: wrist, moving: 2 };
  const fourth = lines[3];
  if (!fourth) return { end: tcp, hand: tcp, moving: 2 };
  if (!turns(lines[2]) || !turns(fourth) || !areParallel(lines[1], fourth)) return null;
  if (lines.length < 6) return { end: fourth.point, hand: fourth.point, moving: 2 };
  const centre = lines.length === 6 && turns(lines[4]) && turns(lines[5]) ? meeting(arm, lines[4], lines[5]) : null;
  return centre && { end: centre, hand: fourth.point, moving: 3 };
}

/** @param {ArmPlane} plane @param {Vector} v @returns {[number, number]} */
const seen = ({ forward, up }, v) => [dot(forward, v), dot(up, v)];

/** 1 if a positive turn about an axis takes forward to up, −1 if down. @param {ArmPlane} plane @param {Line} line */
const senseOf = ({ forward, up }, { axis, slides }) => (slides ? 0 : Math.sign(dot(cross(forward, up), axis)));

/** @param {Arm} arm @param {ArmPlane} plane @returns {Shoulder} */
function shoulderOf({ lines, length }, plane) {
  const links = Array.from({ length: plane.moving }, (_, k) => {
    const line = lines[k + 1];
    const next = k + 1 < plane.moving ? lines[k + 2].point : plane.end;
    return {
      joint: k + 1,
      sense: senseOf(plane, line),
      slide: seen(plane, line.axis),
      reach: seen(plane, minus(next, line.point)),
    };
  });
  return { start: plane.start, links, border: BORDER * length };
}

/** @param {Arm} arm @param {ArmPlane} plane @returns {Bend | null} */
function elbowOf({ lines, length }, plane) {
  const [, shoulder, elbow] = lines;
  if (elbow.slides) return null;
  const [x, y] = seen(plane, minus(elbow.point, shoulder.point));
  const [u, v] = seen(plane, minus(plane.hand, elbow.point));
  if (Math.hypot(x, y) < CLEAR * length || Math.hypot(u, v) < CLEAR * length) return null;
  // The forearm drops from the line of the upper arm.
  const drop = Math.atan2(y * u - x * v, x * u + y * v);
  const sense = -senseOf(plane, elbow);
  return { joint: 2, straight: -sense * drop, sense };
}

/**
 * The wrist is straight where axes 4 and 6 are in line, both pointing outward. It does not flip while it bends down from there with
 * its roll at zero (about the axis that a turn from up to forward is about).
 * @param {Arm} arm
 * @param {Vector} centre
 * @param {ArmPlane | null} plane
 * @returns {Bend}
 */
function sphericalWrist({ lines, tcp }, centre, plane) {
  const [, second, third, fourth, fifth, sixth] = lines;
  const elbow = third.slides ? second.point : footOn(third, centre);
  const out4 = outward(fourth.axis, [minus(centre, elbow)]);
  const out6 = outward(sixth.axis, [out4, minus(tcp, centre)]);
  const sideways = plane ? cross(plane.up, plane.forward) : fifth.axis;
  return bendOf(fifth.axis, out4, out6, 4, clearSign(dot(fifth.axis, sideways)));
}

/**
 * The wrist of an arm with three parallel axes is straight where axis 6 is parallel to them; it does not flip while the way from axis
 * 4 to the wrist, the axis of the three (about which up turns to forward) and axis 6 make a left-handed frame.
 * @param {Arm} arm
 * @param {ArmPlane} plane
 * @returns {Bend | null}
 */
function parallelWrist({ lines, tcp }, plane) {
  if (lines.length !== 6) return null;
  const [, , , , fifth, sixth] = lines;
  const sideways = cross(plane.up, plane.forward);
  const out6 = outward(sixth.axis, [minus(tcp, plane.end)]);
  const sense = clearSign(dot(fifth.axis, minus(plane.end, plane.hand)));
  return norm(cross(sideways, fifth.axis)) < CLEAR ? null : bendOf(fifth.axis, sideways, out6, 4, -sense);
}

/** An axis the way round that one of some directions has it. @param {Vector} axis @param {Vector[]} ways @returns {Vector} */
function outward(axis, ways) {
  const sign = ways.map((way) => dot(axis, way)).find((value) => Math.abs(value) > CLEAR) ?? 1;
  return along([0, 0, 0], Math.sign(sign), axis);
}

const clearSign = (/** @type {number} */ value) => (value < -CLEAR ? -1 : 1);

/**
 * The bend of a direction that a joint turns, from where it is nearest to another.
 * @param {Vector} axis
 * @param {Vector} from
 * @param {Vector} to  what the joint turns, at joint value 0
 * @param {number} joint
 * @param {number} sense
 * @returns {Bend}
 */
function bendOf(axis, from, to, joint, sense) {
  const now = Math.atan2(dot(axis, cross(from, to)), dot(from, to) - dot(axis, from) * dot(axis, to));
  return { joint, straight: -now, sense };
}
