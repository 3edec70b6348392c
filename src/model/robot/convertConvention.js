/**
 * Standard ↔ modified Denavit–Hartenberg, without loss: the same joint axes and the same tool pose in every posture.
 *
 * Both tables are one product of screws about joint axes, Z = Rz(θ) Tz(d), and along links, X = Tx(a) Rx(α) (docs/model.md):
 * B · Z₁X₁ ⋯ ZₙXₙ · E in standard, B · X₀Z₁ ⋯ Xₙ₋₁Zₙ · E in modified order. So the links move by one row, and what falls
 * off the table goes where it stands in the product: Xₙ into the tool in front of what is there, X₀ into the base behind it.
 *
 * A base or a tool that is nothing but such a link is taken into the table, so that there and back gives the same numbers
 * wherever base and tool were not used. Where they were, it gives the same robot.
 *
 * @import { AngleUnit, Convention, Doc, FrameDoc, JointDoc, PoseDoc } from '../document.js'
 * @typedef {{ readonly a: number, readonly alpha: number, readonly text?: JointDoc['text'] }} Link  X, in document units
 */
import { compose, invert } from '../../kinematics/pose.js';
import { rollPitchYawOf } from '../../kinematics/orientation.js';
import { quaternionOf } from '../../kinematics/orientations/quaternion.js';
import { compilePose } from '../compile.js';
import { identityPose } from '../document.js';
import { activeFrame, atPose } from '../frames/frames.js';
import { convertAngle } from '../units.js';

/** Significant digits that a computed length keeps: those of a double, less its noise. */
const DIGITS = 15;
const HALF_TURN = 180; // degrees

/**
 * @param {Doc} doc
 * @param {Convention} convention
 * @returns {Doc} the same object if it has this convention
 */
export const convertConvention = (doc, convention) =>
  doc.robot.convention === convention ? doc : withActiveTool(converted(doc, convention));

/** The active tool is what the robot holds, to the sign of a zero. @param {Doc} doc @returns {Doc} */
function withActiveTool(doc) {
  const inUse = activeFrame(doc, 'tool');
  if (!inUse) return doc;
  return { ...doc, frames: doc.frames.with(doc.frames.indexOf(inUse), atPose(inUse, doc.robot.tool)) };
}

/** @param {Doc} doc @param {Convention} convention @returns {Doc} */
function converted(doc, convention) {
  const { robot } = doc;
  const { base, tool, joints } = robot;
  const { angle } = robot.units;
  if (convention === 'modified') {
    const first = asLink(base);
    const last = linkOf(joints[joints.length - 1]);
    const links = [first ?? NO_LINK, ...joints.slice(0, -1).map(linkOf)];
    return {
      ...doc,
      robot: {
        ...robot,
        convention,
        base: first ? emptied(base) : base,
        tool: before(last, tool, angle),
        joints: joints.map((joint, i) => withLink(joint, links[i])),
      },
      frames: doc.frames.map((frame) => (frame.kind === 'tool' ? before(last, frame, angle) : frame)),
    };
  }
  const first = linkOf(joints[0]);
  const last = asLink(tool);
  const links = [...joints.slice(1).map(linkOf), last ?? NO_LINK];
  return {
    ...doc,
    robot: {
      ...robot,
      convention,
      base: behind(base, first, angle),
      tool: last ? emptied(tool) : tool,
      joints: joints.map((joint, i) => withLink(joint, links[i])),
    },
    // the flange has moved to the end of the last link, and frames on it are seen from there
    frames: doc.frames.map((frame) => (last && frame.kind === 'tool' ? before(last, frame, angle, true) : frame)),
  };
}

/** @type {Link} */
const NO_LINK = { a: 0, alpha: 0 };

/** @param {JointDoc} joint @returns {Link} */
const linkOf = ({ a, alpha, text }) => ({ a, alpha, text });

/** What was typed for a length or an angle goes with it. @param {JointDoc} joint @param {Link} link @returns {JointDoc} */
function withLink({ text: own, ...joint }, { a, alpha, text: brought }) {
  const texts = Object.entries({ theta: own?.theta, d: own?.d, a: brought?.a, alpha: brought?.alpha });
  const text = Object.fromEntries(texts.filter(([, typed]) => typed !== undefined));
  return { ...joint, a, alpha, ...(Object.keys(text).length > 0 && { text }) };
}

const isNone = (/** @type {Link} */ { a, alpha }) => a === 0 && alpha === 0;

/**
 * A pose that is nothing but Tx(a) Rx(α), as its two numbers.
 * @param {PoseDoc} pose
 * @returns {Link | null}
 */
function asLink({ xyz: [a, y, z], rpy: [alpha, pitch, yaw] = [0, 0, 0], quaternion }) {
  if (quaternion || y !== 0 || z !== 0 || pitch !== 0 || yaw !== 0) return null;
  return { a, alpha };
}

/** What is left of a pose whose link was taken into the table. @param {PoseDoc} pose */
const emptied = (pose) => (isNone(asLink(pose) ?? NO_LINK) ? pose : identityPose());

/**
 * X · pose, or X⁻¹ · pose.
 * @template {PoseDoc | FrameDoc} Pose
 * @param {Link} link
 * @param {Pose} pose
 * @param {AngleUnit} angle
 * @param {boolean} [isInverse]
 * @returns {Pose}
 */
function before(link, pose, angle, isInverse = false) {
  if (isNone(link)) return pose;
  const own = asLink(pose);
  const sign = isInverse ? -1 : 1;
  // two links on one line: their numbers add up
  if (own) return { ...pose, ...joined(own, { a: sign * link.a, alpha: sign * link.alpha }, angle) };
  const X = inDocumentLengths(linkPose(link.a, link.alpha), angle);
  return written(compose(isInverse ? invert(X) : X, inDocumentLengths(pose, angle)), pose, link, angle);
}

/** pose · X. @param {PoseDoc} pose @param {Link} link @param {AngleUnit} angle @returns {PoseDoc} */
function behind(pose, link, angle) {
  if (isNone(link)) return pose;
  const own = asLink(pose);
  if (own) return joined(own, link, angle);
  const X = inDocumentLengths(linkPose(link.a, link.alpha), angle);
  const product = written(compose(inDocumentLengths(pose, angle), X), pose, link, angle);
  if (!pose.rpy) return product;
  const [roll, pitch, yaw] = pose.rpy;
  return { ...product, rpy: [sumOfAngles(roll, link.alpha, angle), pitch, yaw] }; // Rx(roll) · Rx(α), read from no matrix
}

/** @param {number} a @param {number} alpha @returns {PoseDoc} */
const linkPose = (a, alpha) => ({ xyz: [a, 0, 0], rpy: [alpha, 0, 0] });

/** @param {Link} one @param {Link} other  on the same line @param {AngleUnit} angle */
const joined = (one, other, angle) => linkPose(sum(one.a, other.a), sumOfAngles(one.alpha, other.alpha, angle));

/** A pose matrix whose lengths stay in the document's unit. @param {PoseDoc} pose @param {AngleUnit} angle */
const inDocumentLengths = (pose, angle) => compilePose(pose, { length: 'm', angle });

/**
 * A matrix → the numbers of a pose, turned as the old one was written.
 * @template {PoseDoc | FrameDoc} Pose
 * @param {Float64Array} T  lengths in the document's unit
 * @param {Pose} old
 * @param {Link} link  what was multiplied
 * @param {AngleUnit} angle
 * @returns {Pose}
 */
function written(T, old, { a }, angle) {
  const scale = Math.hypot(a, ...old.xyz);
  const xyz = [T[12], T[13], T[14]].map((value) => tidy(value, scale));
  if (old.quaternion) return { ...old, xyz, quaternion: [...quaternionOf(T)] };
  return { ...old, xyz, rpy: rollPitchYawOf(T).map((value) => readAngle(value, angle)) };
}

/** @param {number} a @param {number} b */
function sum(a, b) {
  if (a === 0 || b === 0) return a === 0 ? b : a;
  return tidy(a + b, Math.max(Math.abs(a), Math.abs(b)));
}

/** Radians are not decimals: rounding would make π of no two halves. @param {number} a @param {number} b @param {AngleUnit} angle */
const sumOfAngles = (a, b, angle) => (angle === 'deg' ? sum(a, b) : a + b);

/** An angle of the kernel in the document's unit, without noise: by way of degrees, where a right angle is a round number. @param {number} radians @param {AngleUnit} angle */
export const readAngle = (radians, angle) =>
  convertAngle(tidy(convertAngle(radians, 'rad', 'deg'), HALF_TURN), 'deg', angle);

/** Without the noise that lies below the last digits of what a number was computed from. @param {number} value @param {number} scale */
function tidy(value, scale) {
  if (value === 0 || scale === 0) return value;
  const decimals = DIGITS - 1 - Math.floor(Math.log10(scale));
  if (decimals < 0 || decimals > 100) return value;
  const rounded = Number(value.toFixed(decimals));
  return rounded === 0 ? 0 : rounded;
}
