/**
 * The tree of a URDF file → links and joints as the format means them: SI units, defaults filled in. Only what says how the
 * arm moves is read; looks, masses, transmissions and simulator settings are not. Whatever the file holds, nothing throws.
 *
 * @import { Issue } from '../../model/issues.js'
 * @import { FileIssueCode } from '../fileIssues.js'
 * @import { ValueType } from '../valueTypes.js'
 * @import { XmlElement } from '../xmlTree.js'
 *
 * @typedef {'revolute' | 'continuous' | 'prismatic' | 'fixed' | 'floating' | 'planar'} UrdfJointType
 *
 * @typedef {object} UrdfJoint
 * @property {string} name
 * @property {UrdfJointType} type
 * @property {string} parent   names of links
 * @property {string} child
 * @property {Float64Array} T_parent_joint
 * @property {Float64Array} [T_joint_child]   where the child stands otherwise than at the joint, as in SDFormat
 * @property {readonly number[]} axis   3, of length 1, in the joint's frame; unused by a fixed joint
 * @property {{ lower: number, upper: number, effort?: number, velocity?: number } | null} limit  rad or m, or infinite; null: none given
 * @property {string | null} mimics   the name of the joint that it follows
 * @property {number} line
 *
 * @typedef {object} UrdfRobot
 * @property {string} name
 * @property {ReadonlyMap<string, number>} links   name → line
 * @property {readonly UrdfJoint[]} joints
 */
import { poseFromRollPitchYaw } from '../../kinematics/orientation.js';
import { poseFromQuaternion } from '../../kinematics/orientations/quaternion.js';
import { QUATERNION_TOLERANCE } from '../../model/documentRules.js';
import { shownText } from '../../model/shownText.js';
import { fileIssue } from '../fileIssues.js';
import { collapse, FINITE, QUATERNION, VECTOR_3 } from '../valueTypes.js';

/** @type {readonly string[]} */
const TYPES = ['revolute', 'continuous', 'prismatic', 'fixed', 'floating', 'planar'];
const LIMITED = ['revolute', 'prismatic'];

/** An axis whose length is off by more than what typed digits leave. */
const AXIS_TOLERANCE = 1e-3;

/** What a mesh is called, as any robot's is: a package's file, or a path. Anything else is told. */
const MESH_NAME = /^(package:\/\/|file:\/\/|model:\/\/|https?:\/\/|[^:]*$)/i;

/** @param {XmlElement} element @param {string} name @returns {XmlElement[]} */
const childrenOf = (element, name) =>
  element.children.flatMap((node) =>
    node.kind === 'element' && node.name === name && node.namespace === '' ? [node] : [],
  );

/** @param {XmlElement} element @param {string} name */
const attributeOf = ({ attributes }, name) => attributes.find((attribute) => attribute.name === name)?.value;

/**
 * @param {XmlElement} root  <robot>
 * @returns {{ robot: UrdfRobot, issues: Issue[] }}  of use only if no issue is an error
 */
export function urdfRobotFrom(root) {
  /** @type {Issue[]} */
  const issues = [];
  /** @param {FileIssueCode} code @param {string} message @param {number} line */
  const complain = (code, message, line) => void issues.push(fileIssue(code, message, { line }));

  const macro = findMacro(root);
  if (macro) complain('xacro', XACRO, macro.line);

  /** @param {XmlElement} element @param {string} name @param {string} what @returns {string} '' and an issue if there is none */
  function requireAttribute(element, name, what) {
    const value = attributeOf(element, name);
    if (value === undefined)
      complain('missing-attribute', `${what} has no "${name}"; expected <${element.name} ${name}="…">.`, element.line);
    return value ?? '';
  }

  /**
   * @template T
   * @param {XmlElement | undefined} element
   * @param {string} name
   * @param {ValueType} type
   * @param {T} missing  what stands there if nothing does
   * @returns {T}
   */
  function valueOf(element, name, type, missing) {
    const text = element && attributeOf(element, name);
    if (!element || text === undefined) return missing;
    const reading = type.read(text);
    if ('value' in reading) return /** @type {T} */ (reading.value); // each type reads what its caller asks for
    const line = element.lineOf(name);
    if (text.includes('${') || text.includes('$(')) complain('xacro', XACRO, line);
    else {
      const found = `${name} of <${element.name}> is "${shownText(text)}"`;
      complain(reading.code, `The ${found}; expected ${reading.expected}.`, line);
    }
    return missing;
  }

  /** @param {XmlElement | undefined} origin */
  function poseOf(origin) {
    const xyz = valueOf(origin, 'xyz', VECTOR_3, [0, 0, 0]);
    const turned = origin && attributeOf(origin, 'rpy') === undefined && attributeOf(origin, 'quat_xyzw') !== undefined;
    if (!turned) return poseFromRollPitchYaw(xyz, valueOf(origin, 'rpy', VECTOR_3, [0, 0, 0]));
    const quaternion = valueOf(origin, 'quat_xyzw', QUATERNION, [0, 0, 0, 1]);
    const length = Math.hypot(...quaternion);
    if (Math.abs(length - 1) > QUATERNION_TOLERANCE) {
      const message = `The quaternion has the length ${Number(length.toPrecision(6))}; expected 1.`;
      complain('number', message, origin.lineOf('quat_xyzw'));
      return poseFromRollPitchYaw(xyz, [0, 0, 0]);
    }
    return poseFromQuaternion(
      xyz,
      quaternion.map((value) => value / length),
    );
  }

  /** @param {XmlElement} element @param {string} name */
  function axisOf(element, name) {
    const [axis] = childrenOf(element, 'axis');
    const xyz = valueOf(axis, 'xyz', VECTOR_3, [1, 0, 0]);
    const length = Math.hypot(...xyz);
    if (length === 0) {
      complain('number', `${name} has the axis 0 0 0; expected a direction such as 0 0 1.`, axis?.line ?? element.line);
      return [0, 0, 1];
    }
    if (Math.abs(length - 1) > AXIS_TOLERANCE) {
      const message = `${name} has an axis of the length ${Number(length.toPrecision(6))}; only its direction is taken.`;
      complain('axis-length', message, axis?.line ?? element.line);
    }
    return xyz.map((value) => value / length);
  }

  /** @param {XmlElement} element @param {UrdfJointType} type @param {string} name @returns {UrdfJoint['limit']} */
  function limitOf(element, type, name) {
    if (!LIMITED.includes(type) && type !== 'continuous') return null;
    const [limit] = childrenOf(element, 'limit');
    if (!limit) {
      if (type !== 'continuous')
        complain('limit-missing', `${name} has no <limit>; it is taken to be without limits.`, element.line);
      return null;
    }
    const number = (/** @type {string} */ attribute) =>
      valueOf(limit, attribute, FINITE, /** @type {number | undefined} */ (undefined));
    const [effort, velocity] = [number('effort'), number('velocity')];
    return {
      lower: number('lower') ?? 0, // as the format has it
      upper: number('upper') ?? 0,
      ...(effort !== undefined && effort > 0 && { effort }),
      ...(velocity !== undefined && velocity > 0 && { velocity }),
    };
  }

  /** @param {XmlElement} element @returns {UrdfJoint} */
  function jointFrom(element) {
    const name = requireAttribute(element, 'name', 'A joint');
    const what = `The joint "${shownText(name)}"`;
    const typed = collapse(requireAttribute(element, 'type', what));
    if (typed !== '' && !TYPES.includes(typed)) {
      const message = `${what} is of the type "${shownText(typed)}"; expected ${TYPES.slice(0, -1).join(', ')} or ${TYPES.at(-1)}.`;
      complain('choice', message, element.line);
    }
    const type = /** @type {UrdfJointType} */ (TYPES.includes(typed) ? typed : 'fixed');
    const [parent, child] = ['parent', 'child'].map((end) => {
      const [found] = childrenOf(element, end);
      if (!found) complain('missing-element', `${what} has no <${end}>; expected <${end} link="…">.`, element.line);
      return found ? requireAttribute(found, 'link', `The ${end} of ${what.toLowerCase().slice(4)}`) : '';
    });
    const [origin] = childrenOf(element, 'origin');
    const [mimic] = childrenOf(element, 'mimic');
    return {
      name,
      type,
      parent,
      child,
      T_parent_joint: poseOf(origin),
      axis: type === 'fixed' ? [0, 0, 1] : axisOf(element, what),
      limit: limitOf(element, type, what),
      mimics: mimic ? requireAttribute(mimic, 'joint', 'A <mimic>') : null,
      line: element.line,
    };
  }

  /**
   * Looks and masses are not read, but what is wrong in them is wrong in the file: numbers that are none, and names of meshes,
   * which are never fetched, that are none of a file.
   * @param {XmlElement} element
   */
  function lookOver(element) {
    for (const child of element.children) {
      if (child.kind !== 'element') continue;
      if (child.name === 'origin') poseOf(child);
      const file = child.name === 'mesh' ? attributeOf(child, 'filename') : undefined;
      if (file !== undefined && !MESH_NAME.test(file)) {
        const message = `A mesh is called "${shownText(file)}", which names no file; meshes are not read.`;
        complain('mesh-name', message, child.line);
      }
      lookOver(child);
    }
  }

  for (const child of root.children) {
    if (child.kind === 'element' && child.namespace !== '' && child !== macro)
      complain('not-read', `The element <${shownText(child.name)}> is of another format and is not read.`, child.line);
  }
  /** @type {Map<string, number>} */
  const links = new Map();
  for (const element of childrenOf(root, 'link')) {
    const name = requireAttribute(element, 'name', 'A link');
    if (links.has(name))
      complain('id-taken', `Two links are called "${shownText(name)}"; expected another name.`, element.line);
    links.set(name, element.line);
    lookOver(element);
  }
  const joints = childrenOf(root, 'joint').map(jointFrom);
  const names = new Set();
  for (const { name, line, mimics, parent, child } of joints) {
    const what = `the joint "${shownText(name)}"`;
    if (names.has(name))
      complain('id-taken', `Two joints are called "${shownText(name)}"; expected another name.`, line);
    names.add(name);
    for (const [end, link] of [
      ['parent', parent],
      ['child', child],
    ]) {
      if (link !== '' && !links.has(link))
        complain('unknown-link', `The ${end} of ${what} is "${shownText(link)}", which is no link of this file.`, line);
    }
    if (mimics !== null && !joints.some((other) => other.name === mimics))
      complain('unknown-link', `The joint that ${what} follows, "${shownText(mimics)}", is not in this file.`, line);
  }
  return { robot: { name: attributeOf(root, 'name') ?? '', links, joints }, issues };
}

const XACRO =
  'The file has xacro macros, from which a URDF is yet to be made; expected the URDF itself, as "xacro robot.urdf.xacro > robot.urdf" makes it.';

/** Names alone may be declared in a finished URDF; an element that uses them is a recipe. @param {XmlElement} element @returns {XmlElement | null} */
function findMacro(element) {
  if (/xacro/i.test(element.namespace) || element.name.startsWith('xacro:')) return element;
  for (const child of element.children) {
    const found = child.kind === 'element' ? findMacro(child) : null;
    if (found) return found;
  }
  return null;
}
