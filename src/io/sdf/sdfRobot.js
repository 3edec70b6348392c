/**
 * The tree of an SDFormat file → links and joints as a URDF has them. A thing's pose is seen from what `relative_to` names, or else a
 * link's from the model, a joint's from its child, a frame's from what it is attached to. Only what says how the arm moves is read.
 * Versions before 1.5 mean their axes otherwise, and are refused; so are models in pieces (<include>, nested models).
 *
 * @import { Pose } from '../../kinematics/pose.js'
 * @import { Issue } from '../../model/issues.js'
 * @import { UrdfJoint, UrdfJointType, UrdfRobot } from '../urdf/urdfRobot.js'
 * @import { FileIssueCode } from '../fileIssues.js'
 * @import { XmlElement } from '../xmlTree.js'
 */
import { poseFromRollPitchYaw } from '../../kinematics/orientation.js';
import { poseFromQuaternion } from '../../kinematics/orientations/quaternion.js';
import { compose, identity, invert } from '../../kinematics/pose.js';
import { LARGEST_NUMBER, QUATERNION_TOLERANCE } from '../../model/documentRules.js';
import { shownText } from '../../model/shownText.js';
import { toRadians } from '../../model/units.js';
import { fileIssue } from '../fileIssues.js';
import { collapse, numberList, VECTOR_3 } from '../valueTypes.js';

const OLDEST = 5;
const MODEL = '__model__';
const TYPES = ['revolute', 'prismatic', 'continuous', 'fixed'];
const [SIX, SEVEN] = [numberList(6, 6), numberList(7, 7)];
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;

/** @param {XmlElement} element @returns {XmlElement[]} */
const elementsOf = ({ children }) => children.flatMap((node) => (node.kind === 'element' ? [node] : []));
/** @param {XmlElement | undefined} element @param {string} name */
const childOf = (element, name) => (element ? elementsOf(element).find((child) => child.name === name) : undefined);
/** @param {XmlElement} element @param {string} name */
const attributeOf = ({ attributes }, name) => attributes.find((attribute) => attribute.name === name)?.value;
/** @param {XmlElement | undefined} element */
const textOf = (element) =>
  collapse((element?.children ?? []).map((node) => (node.kind === 'text' ? node.text : '')).join(''));

/** What cannot be read at all. Reading stops there. */
class Refusal extends Error {
  /** @param {FileIssueCode} code @param {string} message @param {XmlElement} where */
  constructor(code, message, { line }) {
    super(message);
    this.issue = fileIssue(code, message, { line });
  }
}

/**
 * @param {XmlElement} root  <sdf>
 * @returns {{ robot: UrdfRobot, issues: [] } | { robot: null, issues: Issue[] }}
 */
export function sdfRobotFrom(root) {
  try {
    return { robot: robotFrom(modelOf(root)), issues: [] };
  } catch (error) {
    if (error instanceof Refusal) return { robot: null, issues: [error.issue] };
    throw error;
  }
}

/** @param {XmlElement} root */
function modelOf(root) {
  const version = attributeOf(root, 'version') ?? '';
  const [, minor] = /^1\.(\d{1,2})$/.exec(collapse(version)) ?? [];
  if (minor === undefined || Number(minor) < OLDEST) {
    const found = `The file is SDFormat "${shownText(version)}"`;
    throw new Refusal('version', `${found}; expected version 1.${OLDEST} or later, such as 1.9.`, root);
  }
  const places = [root, ...elementsOf(root).filter(({ name }) => name === 'world')];
  const inside = places.flatMap(elementsOf);
  const models = inside.filter(({ name }) => name === 'model');
  const [model] = models;
  for (const part of [...inside, ...(model ? elementsOf(model) : [])]) {
    if (part.name !== 'include' && !(part.name === 'model' && part !== model)) continue;
    const message = `A model is put together of others (<${part.name}>); expected one model with all its links.`;
    throw new Refusal('unknown-element', message, part);
  }
  if (!model) throw new Refusal('missing-element', 'The file has no <model>; expected one.', root);
  if (attributeOf(model, 'placement_frame') !== undefined)
    throw new Refusal(
      'unknown-attribute',
      'The model has a placement_frame; expected a model that stands by itself.',
      model,
    );
  return model;
}

/** @param {XmlElement} model @returns {UrdfRobot} */
function robotFrom(model) {
  const things = new Map();
  for (const element of elementsOf(model).filter(({ name }) => ['link', 'joint', 'frame'].includes(name))) {
    const name = attributeOf(element, 'name');
    if (name === undefined) {
      throw new Refusal(
        'missing-attribute',
        `A ${element.name} has no name; expected <${element.name} name="…">.`,
        element,
      );
    }
    if (things.has(name) || name === MODEL || name === 'world') {
      const message = `Two things are called "${shownText(name)}"; expected a name of its own for each.`;
      throw new Refusal('id-taken', message, element);
    }
    things.set(name, element);
  }
  const rest = restPoses(model, things);
  /** @param {string} name of a link or frame @param {XmlElement} by @param {number} [depth] @returns {string} the link */
  const linkOf = (name, by, depth = 0) => {
    const thing = things.get(name);
    if (thing?.name === 'link' || name === 'world') return name;
    const next = thing?.name === 'frame' ? attributeOf(thing, 'attached_to') : undefined;
    if (next !== undefined && depth <= things.size) return linkOf(next, by, depth + 1);
    const message = `The ${by.name} "${shownText(attributeOf(by, 'name') ?? '')}" refers to "${shownText(name)}", which is on no link of this file.`;
    throw new Refusal('unknown-link', message, by);
  };
  /** @type {Map<string, number>} */
  const links = new Map();
  /** @type {UrdfJoint[]} */
  const joints = [];
  for (const [name, element] of things) {
    if (element.name === 'link') links.set(name, element.line);
    if (element.name === 'joint') {
      const joint = jointFrom(name, element, rest, linkOf);
      if (joint.parent === 'world') links.set('world', model.line);
      joints.push(joint);
    }
    const on = attributeOf(element, 'attached_to');
    if (element.name !== 'frame' || on === undefined || on === MODEL) continue;
    links.set(name, element.line);
    const parent = linkOf(on, element);
    const T = compose(invert(rest(parent, element)), rest(name, element));
    const still = { type: /** @type {const} */ ('fixed'), axis: [0, 0, 1], limit: null, mimics: null };
    joints.push({ ...still, name, parent, child: name, T_parent_joint: T, line: element.line });
  }
  return { name: attributeOf(model, 'name') ?? '', links, joints };
}

/**
 * @param {XmlElement} model
 * @param {ReadonlyMap<string, XmlElement>} things
 * @returns {(name: string, by: XmlElement, depth?: number) => Pose} at rest, seen from the model
 */
function restPoses(model, things) {
  /** @type {Map<string, Pose>} */
  const known = new Map();
  return function rest(name, by, depth = 0) {
    const before = known.get(name);
    if (before) return before;
    if (name === MODEL) return identity();
    if (name === 'world') return invert(ownPose(model));
    const thing = things.get(name);
    if (!thing || depth > things.size) {
      const found = thing ? 'goes round in a circle' : 'is nothing in this file';
      const message = `The ${by.name} "${shownText(attributeOf(by, 'name') ?? '')}" is placed by "${shownText(name)}", which ${found}.`;
      throw new Refusal('unknown-link', message, by);
    }
    const usual = { joint: textOf(childOf(thing, 'child')), frame: attributeOf(thing, 'attached_to') }[thing.name];
    const pose = childOf(thing, 'pose');
    const from = (pose && attributeOf(pose, 'relative_to')) || usual || MODEL;
    const T = compose(rest(from, thing, depth + 1), ownPose(thing));
    known.set(name, T);
    return T;
  };
}

/** @param {XmlElement} thing @returns {Pose} */
function ownPose(thing) {
  const pose = childOf(thing, 'pose');
  const text = textOf(pose);
  if (!pose || text === '') return identity();
  const isQuaternion = attributeOf(pose, 'rotation_format') === 'quat_xyzw';
  const reading = (isQuaternion ? SEVEN : SIX).read(text);
  if (!('value' in reading)) {
    throw new Refusal(reading.code, `The <pose> is "${shownText(text)}"; expected ${reading.expected}.`, pose);
  }
  const values = /** @type {number[]} */ (reading.value); // a list of numbers
  const [place, turn] = [values.slice(0, 3), values.slice(3)];
  if (!isQuaternion) {
    const isDegrees = /^(true|1)$/.test(collapse(attributeOf(pose, 'degrees') ?? ''));
    return poseFromRollPitchYaw(place, isDegrees ? turn.map(toRadians) : turn);
  }
  const length = Math.hypot(...turn);
  if (Math.abs(length - 1) > QUATERNION_TOLERANCE) {
    throw new Refusal('number', `The quaternion has the length ${Number(length.toPrecision(6))}; expected 1.`, pose);
  }
  return poseFromQuaternion(
    place,
    turn.map((value) => value / length),
  );
}

/**
 * @param {string} name
 * @param {XmlElement} element
 * @param {ReturnType<typeof restPoses>} rest
 * @param {(name: string, by: XmlElement) => string} linkOf
 * @returns {UrdfJoint}
 */
function jointFrom(name, element, rest, linkOf) {
  const what = `The joint "${shownText(name)}"`;
  const typed = collapse(attributeOf(element, 'type') ?? '');
  if (!TYPES.includes(typed)) {
    const message = `${what} is of the type "${shownText(typed)}"; expected ${TYPES.slice(0, -1).join(', ')} or ${TYPES.at(-1)}.`;
    throw new Refusal('joint-type', message, element);
  }
  const type = /** @type {UrdfJointType} */ (typed);
  const [parent, child] = ['parent', 'child'].map((end) => {
    const text = textOf(childOf(element, end));
    if (text === '')
      throw new Refusal('missing-element', `${what} has no <${end}>; expected a link's name in one.`, element);
    return linkOf(text, element);
  });
  const T_model_joint = rest(name, element);
  const T_joint_model = invert(T_model_joint);
  const axis = childOf(element, 'axis');
  const mimic = childOf(axis, 'mimic');
  return {
    name,
    type,
    parent,
    child,
    T_parent_joint: compose(invert(rest(parent, element)), T_model_joint),
    T_joint_child: compose(T_joint_model, rest(child, element)),
    axis:
      type === 'fixed'
        ? [0, 0, 1]
        : axisOf(axis ?? element, what, (frame) => compose(T_joint_model, rest(frame, element))),
    limit: limitOf(childOf(axis, 'limit')),
    mimics: mimic ? (attributeOf(mimic, 'joint') ?? '') : null,
    line: element.line,
  };
}

/**
 * @param {XmlElement} axis
 * @param {string} what
 * @param {(frame: string) => Pose} seenFromJoint
 * @returns {number[]} of length 1, in the joint's frame
 */
function axisOf(axis, what, seenFromJoint) {
  const element = childOf(axis, 'xyz');
  const text = textOf(element);
  const reading = VECTOR_3.read(element ? text : '0 0 1');
  if (!('value' in reading)) {
    throw new Refusal(
      reading.code,
      `The axis of ${what.slice(4)} is "${shownText(text)}"; expected ${reading.expected}.`,
      axis,
    );
  }
  const [x, y, z] = /** @type {number[]} */ (reading.value); // three numbers
  const length = Math.hypot(x, y, z);
  if (length === 0)
    throw new Refusal('number', `${what} has the axis 0 0 0; expected a direction such as 0 0 1.`, axis);
  const inModel = /^(true|1)$/.test(textOf(childOf(axis, 'use_parent_model_frame')));
  const frame = (element && attributeOf(element, 'expressed_in')) || (inModel ? MODEL : null);
  const T = frame === null ? identity() : seenFromJoint(frame);
  return [0, 1, 2].map((k) => (T[k] * x + T[4 + k] * y + T[8 + k] * z) / length);
}

/** @param {XmlElement | undefined} limit @returns {UrdfJoint['limit']} */
function limitOf(limit) {
  const [lower, upper, effort, velocity] = ['lower', 'upper', 'effort', 'velocity'].map((name) => {
    const element = childOf(limit, name);
    const text = textOf(element);
    if (!element || text === '') return undefined;
    if (/^[+-]?inf(inity)?$/i.test(text)) return text.startsWith('-') ? -Infinity : Infinity;
    if (!NUMBER.test(text)) {
      throw new Refusal('number', `<${name}> is "${shownText(text)}"; expected a number such as 12.5.`, element);
    }
    const value = Number(text);
    return Math.abs(value) > LARGEST_NUMBER ? Math.sign(value) * Infinity : value; // 1e16 is how older versions say it
  });
  return {
    lower: lower ?? -Infinity,
    upper: upper ?? Infinity,
    ...(effort !== undefined && effort > 0 && effort < Infinity && { effort }),
    ...(velocity !== undefined && velocity > 0 && velocity < Infinity && { velocity }),
  };
}
