/**
 * How the links of an arm are joined, decided before anything is drawn. The rules, so that the picture tells the truth
 * about the table:
 *
 * - axial: the link arrives along the joint's axis, or the offset d is long. It is a tube along z; the joint is a drum
 *   round it, at 72 % of a long d, so that what lies before the drum stands still.
 * - fork: the link arrives across the axis. It ends in two cheeks, and the next link turns between them.
 * - side: the same, but d is long enough for the two to lie side by side, a collar and a shaft between them.
 * - A slide is square where a turning joint is round: a ram that slides in a sleeve if the arm goes on along the axis
 *   (lift, if that joint is the first), or else a carriage on a mast.
 *
 * @import { Body } from './bodies.js'
 *
 * @typedef {'axial' | 'fork' | 'side' | 'ram' | 'lift' | 'mast'} Joinery
 * @typedef {readonly [number, number, number]} Vector
 *
 * @typedef {object} JointPlan
 * @property {Joinery} joinery
 * @property {number} radius   of the link that the joint moves
 * @property {1 | -1} sense    the way along z from the joint to the link that it moves
 * @property {Vector} arrival  the direction in which the link before comes, seen from the joint's axis
 * @property {boolean} isStub  whether that link has no length, so that its direction is only for show
 * @property {number} at       where the joint sits on its axis
 * @property {number} half     half the height of its drum
 * @property {number} squeeze  how far parts are flattened where the table leaves little room, 1 being not at all
 */

/** Proportions, as parts of the radius of a link. */
const PLATE = 0.34; // height of the base's plate
const HALF_DRUM = 0.52;
export const TONGUE = 1.3; // thickness of what turns in a fork
export const KNUCKLE = 1.16; // radius of a round end about an axis
export const HALF_KNUCKLE = 0.86;
export const HALF_CORNER = 1.06; // of a knuckle that a round beam leaves
export const FLANGE = 0.42;
export const FORK_CLEAR = 1.22; // from a fork's axis to its root
export const FORK_ROOT = 0.7; // depth of the root
export const SLEEVE = 1.9;
export const CARRIAGE = 1.15; // half its length
const NECK = 1.08;

const LONG = 4;
const SHARE_OF_LONG = 0.72;
const LEAST_SQUEEZE = 0.45;

const sign = (/** @type {number} */ x) => (x < 0 ? -1 : 1);

/** Whether a link is long enough, for its radius, to have a beam. @param {Body} body @param {number} radius */
export const hasBeam = ({ a }, radius) => Math.abs(a) > 1.5 * radius;

/** Whether the axes at its two ends are parallel. @param {Body} body */
export const isFlat = ({ alpha }) => Math.abs(Math.sin(alpha)) < 0.3;

/**
 * Radii fall from the base to the wrist, from 4.7 to 1.8 % of the arm's size.
 * @param {number} size
 * @param {number} count  of joints
 */
export const radiiOf = (size, count) =>
  Array.from({ length: count + 1 }, (_, i) => size * (0.047 - 0.029 * (i / count) ** 0.9));

/**
 * @param {readonly Body[]} bodies
 * @param {readonly number[]} radii
 * @returns {{ joints: JointPlan[], flange: { arrival: Vector, isStub: boolean }, base: { depth: number, plate: number } }}
 */
export function planArm(bodies, radii) {
  /** @type {{ arrival: Vector, isStub: boolean }} */
  let way = { arrival: [0, 0, middle(bodies[1]) < 0 ? -1 : 1], isStub: false };
  const joints = bodies.slice(1).map((body, i) => {
    const plan = { ...join(body, way, radii, i + 1), ...way, radius: radii[i + 1], at: 0, half: 0, squeeze: 1 };
    way = departure(body, plan, bodies[i + 2]);
    return plan;
  });
  joints.forEach((joint, i) => {
    if (joint.joinery === 'fork') joint.at = bodies[i + 1].d;
    if (joint.joinery === 'side') placeCollar(joint, bodies[i], joints[i - 1], radii[i]);
    if (joint.joinery === 'axial') {
      placeDrum(joint, bodies[i + 1], roomAt(i + 1, bodies, joints, radii), radii[i], i === 0);
    }
  });
  return { joints, flange: way, base: planBase(joints[0], bodies[1], roomAt(1, bodies, joints, radii), radii[0]) };
}

const middle = (/** @type {Body} */ { slides, d, low, high }) => (slides ? low + high : d);

/**
 * @param {Body} body  the link that the joint moves
 * @param {{ arrival: Vector, isStub: boolean }} way
 * @param {readonly number[]} radii
 * @param {number} k
 * @returns {{ joinery: Joinery, sense: 1 | -1 }}
 */
function join(body, { arrival, isStub }, radii, k) {
  const { d, slides } = body;
  const radius = radii[k];
  if (slides) {
    const goesOn = isFlat(body) && !hasBeam(body, radius);
    return { joinery: goesOn ? (k === 1 ? 'lift' : 'ram') : 'mast', sense: sign(middle(body)) };
  }
  if (Math.abs(d) > LONG * radius) return { joinery: 'axial', sense: sign(d) };
  if (Math.abs(arrival[2]) >= 0.9) return { joinery: 'axial', sense: isStub ? sign(d) : sign(arrival[2]) };
  const beside = 0.65 * radii[k - 1] + 0.95 * radius;
  return { joinery: Math.abs(d) > Math.max(beside, 1.5 * radius) ? 'side' : 'fork', sense: sign(d) };
}

/**
 * How a link comes to its far end, seen from there.
 * @param {Body} body
 * @param {{ joinery: Joinery, sense: 1 | -1, radius: number }} joint
 * @param {Body | undefined} next
 * @returns {{ arrival: Vector, isStub: boolean }}
 */
function departure(body, { joinery, sense, radius }, next) {
  if (hasBeam(body, radius)) return { arrival: [sign(body.a), 0, 0], isStub: false };
  if (joinery === 'fork' || joinery === 'mast') return { arrival: [0, 0, next ? sign(middle(next)) : 1], isStub: true };
  return { arrival: [0, sense * Math.sin(body.alpha), sense * Math.cos(body.alpha)], isStub: false };
}

/**
 * How much room along the axis is taken, before the far end of d, by what sits there: `core` of it cannot be flattened.
 * @param {number} k  the joint, from 1
 * @param {readonly Body[]} bodies
 * @param {readonly JointPlan[]} joints
 * @param {readonly number[]} radii
 * @returns {{ core: number, spare: number }}
 */
function roomAt(k, bodies, joints, radii) {
  const next = joints[k];
  const radius = radii[k];
  if (hasBeam(bodies[k], radius))
    return { core: (isFlat(bodies[k]) ? TONGUE / 2 : HALF_CORNER) * radius, spare: 0.05 * radius };
  if (!next) return { core: 0.1 * radius, spare: FLANGE * radius };
  if (next.joinery === 'fork') return { core: FORK_CLEAR * next.radius, spare: FORK_ROOT * next.radius };
  if (next.joinery === 'ram') return { core: SLEEVE * next.radius, spare: 0.2 * next.radius };
  if (next.joinery === 'axial' && Math.abs(next.arrival[2]) >= 0.9) return { core: 0, spare: 0.3 * radius };
  return { core: KNUCKLE * next.radius, spare: 0.2 * radius };
}

/**
 * @param {JointPlan} joint
 * @param {Body} body
 * @param {{ core: number, spare: number }} room
 * @param {number} before  the radius of the link before
 * @param {boolean} isFirst
 */
function placeDrum(joint, { d }, { core, spare }, before, isFirst) {
  const { radius, sense, isStub, arrival } = joint;
  const reach = sense * d;
  if (isFirst) {
    const soft = spare + 2 * HALF_DRUM * radius + PLATE * before;
    joint.squeeze = Math.max(LEAST_SQUEEZE, Math.min(1, (reach - core) / soft));
  }
  joint.half = HALF_DRUM * radius * joint.squeeze;
  const highest = reach - core - spare * joint.squeeze - joint.half;
  const isLong = Math.abs(d) > LONG * radius;
  let at = isLong ? Math.min(SHARE_OF_LONG * reach, highest) : highest;
  if (isLong && Math.abs(arrival[2]) < 0.9) at = Math.max(at, 1.25 * radius + joint.half); // clear of the elbow before it
  if (isStub) at = Math.max(at, NECK * before + joint.half); // clear of the fork that the stub turns in
  joint.at = sense * at;
}

/**
 * Half the length of a knuckle about the next axis, wide enough that no tube pokes out of it.
 * @param {number} nextRadius
 * @param {number} radius
 */
export const halfEye = (nextRadius, radius) => Math.max(HALF_KNUCKLE * nextRadius, 0.95 * radius);

/**
 * A collar on whatever the link before has about this axis.
 * @param {JointPlan} joint
 * @param {Body} before
 * @param {JointPlan | undefined} beforeJoint
 * @param {number} beforeRadius
 */
function placeCollar(joint, before, beforeJoint, beforeRadius) {
  const isPlate = hasBeam(before, beforeRadius) && isFlat(before);
  const isKnuckle = beforeJoint?.joinery === 'side' && !hasBeam(before, beforeRadius);
  const eye = halfEye(joint.radius, beforeRadius);
  const face = isPlate ? (TONGUE / 2) * beforeRadius : isKnuckle ? KNUCKLE * beforeRadius : eye;
  joint.half = 0.15 * joint.radius;
  joint.at = joint.sense * (face + joint.half);
}

/**
 * How far the base goes behind frame 0 to have room, and how high its plate is.
 * @param {JointPlan} joint
 * @param {Body} body
 * @param {{ core: number, spare: number }} room
 * @param {number} baseRadius
 */
function planBase({ joinery, sense, radius, squeeze, at, half }, { low, high }, { core }, baseRadius) {
  const plate = PLATE * baseRadius * squeeze;
  const nearest = sense > 0 ? low : -high;
  if (joinery === 'axial') return { plate, depth: Math.max(0, plate + half - sense * at) };
  if (joinery === 'lift') return { plate, depth: Math.max(0, plate + radius + core - nearest) };
  return { plate, depth: Math.max(0, plate + (CARRIAGE + 0.1) * radius - nearest) };
}
