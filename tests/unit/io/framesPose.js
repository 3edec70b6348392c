/**
 * Forward kinematics of SDFormat and MJCF texts that shares nothing with src: trees by a parser, matrices by the tests' own oracle,
 * the rules as the formats state them. As much of both as a chain of bodies needs.
 */
import { parseXml, XmlElement } from '@rgrove/parse-xml';
import { rigid, rodrigues, times, transpose } from '../kinematics/oracle.js';

/** @import { Matrix } from '../kinematics/oracle.js' */

const NOTHING = rigid(rodrigues([0, 0, 1], 0), [0, 0, 0]);

/** @param {XmlElement} element @returns {XmlElement[]} */
const within = (element) => element.children.flatMap((child) => (child instanceof XmlElement ? [child] : []));
/** @param {XmlElement} element @param {string} name */
const first = (element, name) => within(element).find((child) => child.name === name);
/** @param {string | undefined} text */
const numbers = (text) => (text ?? '').trim().split(/\s+/).map(Number);

/** @param {string} text */
function rootOf(text) {
  const { root } = parseXml(text);
  if (!root) throw new RangeError('Expected a file.');
  return root;
}

/** Inverse of a rigid motion. @param {Matrix} T */
function inverse(T) {
  const R = transpose(T.slice(0, 3).map((row) => row.slice(0, 3)));
  return rigid(
    R,
    R.map((row) => -row.reduce((sum, value, j) => sum + value * T[j][3], 0)),
  );
}

/** What a joint does. @param {number[]} axis @param {boolean} slides @param {number} value @returns {Matrix} */
function motion(axis, slides, value) {
  const length = Math.hypot(...axis);
  if (!slides) return rigid(rodrigues(axis, value), [0, 0, 0]);
  return rigid(
    rodrigues([0, 0, 1], 0),
    axis.map((part) => (part / length) * value),
  );
}

/**
 * SDFormat 1.9: each thing's pose is seen from what `relative_to` names; else a link's from the model, a frame's from what it is
 * attached to, a joint's from its child link. First every rest pose in the model, then the motions along the chain.
 * @param {string} text
 * @param {string} tip  a frame
 * @returns {(values: Record<string, number>) => number[][]} rad or m by joint → rows of the tip's pose in the world
 */
export function sdfPose(text, tip) {
  const model = first(rootOf(text), 'model');
  if (!model) throw new RangeError('Expected a model.');
  const things = new Map(
    within(model)
      .filter(({ name }) => ['link', 'joint', 'frame'].includes(name))
      .map((thing) => [thing.attributes.name, thing]),
  );
  /** @param {string} name @returns {Matrix} at rest, in the model */
  function rest(name) {
    if (name === '__model__') return NOTHING;
    const thing = things.get(name);
    if (!thing) throw new RangeError(`Nothing is called ${name}.`);
    const pose = first(thing, 'pose');
    const [x, y, z, roll, pitch, yaw] = pose ? numbers(pose.text) : [0, 0, 0, 0, 0, 0];
    const R = times(rodrigues([0, 0, 1], yaw), times(rodrigues([0, 1, 0], pitch), rodrigues([1, 0, 0], roll)));
    const usual = { link: undefined, joint: first(thing, 'child')?.text, frame: thing.attributes.attached_to }[
      thing.name
    ];
    const from = pose?.attributes.relative_to ?? usual;
    return times(from === undefined ? NOTHING : rest(from), rigid(R, [x, y, z]));
  }
  const joints = [...things.values()].filter(({ name }) => name === 'joint');
  /** @param {string} link @param {Record<string, number>} values @returns {Matrix} what its joints have done to a link since rest */
  function moved(link, values) {
    const joint = joints.find((each) => first(each, 'child')?.text === link);
    const parent = joint && first(joint, 'parent')?.text;
    if (!joint || parent === undefined) throw new RangeError(`Nothing carries ${link}.`);
    const before = parent === 'world' ? NOTHING : moved(parent, values);
    if (joint.attributes.type === 'fixed') return before;
    const xyz = /** @type {XmlElement} */ (first(/** @type {XmlElement} */ (first(joint, 'axis')), 'xyz'));
    const place = rest(joint.attributes.name);
    const { expressed_in: frame } = xyz.attributes;
    const turn = frame === undefined ? NOTHING : times(inverse(place), rest(frame));
    const axis = turn.slice(0, 3).map((row) => numbers(xyz.text).reduce((sum, part, j) => sum + row[j] * part, 0));
    const step = motion(axis, joint.attributes.type === 'prismatic', values[joint.attributes.name]);
    return times(before, times(place, times(step, inverse(place))));
  }
  /** @param {string} name @returns {string} */
  const linkOf = (name) =>
    things.get(name)?.name === 'link' ? name : linkOf(things.get(name)?.attributes.attached_to ?? '');
  const [place, link] = [rest(tip), linkOf(tip)];
  return (values) => times(moved(link, values), place);
}

/** @param {XmlElement} element @returns {Matrix} */
function bodyPose({ attributes: { pos, quat } }) {
  const [w, x, y, z] = quat === undefined ? [1, 0, 0, 0] : numbers(quat);
  const n = w * w + x * x + y * y + z * z;
  const R = [
    [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
  ].map((row) => row.map((value) => value / n));
  return rigid(R, pos === undefined ? [0, 0, 0] : numbers(pos));
}

/**
 * MJCF: a body's pose in the body around it, then its joints, about axes in its own frame.
 * @param {string} text
 * @param {string} tip  a site
 * @returns {(values: Record<string, number>) => number[][]}
 */
export function mjcfPose(text, tip) {
  const root = rootOf(text);
  const world = first(root, 'worldbody');
  if (!world || first(root, 'compiler')?.attributes.angle !== 'radian') throw new RangeError('Expected radians.');
  /** @param {XmlElement} body @param {Matrix} T @param {Record<string, number>} values @returns {Matrix | null} */
  function find(body, T, values) {
    for (const child of within(body)) {
      if (child.name === 'site' && child.attributes.name === tip) return times(T, bodyPose(child));
      if (child.name !== 'body') continue;
      const moved = within(child)
        .filter(({ name }) => name === 'joint')
        .reduce(
          (pose, { attributes: { name, type, axis } }) =>
            times(pose, motion(numbers(axis), type === 'slide', values[name])),
          times(T, bodyPose(child)),
        );
      const found = find(child, moved, values);
      if (found) return found;
    }
    return null;
  }
  return (values) => {
    const T = find(world, NOTHING, values);
    if (!T) throw new RangeError(`No site ${tip}.`);
    return T;
  };
}
