/**
 * Forward kinematics of an rlkin text that shares nothing with src: the tree by a parser, matrices by the tests' own oracle, the
 * rule as the Robotics Library has it. It takes what stands in the file for a chain in the order of the file.
 */
import { parseXml, XmlElement } from '@rgrove/parse-xml';
import { rigid, rodrigues, times } from '../kinematics/oracle.js';

/** @param {XmlElement} element @returns {XmlElement[]} */
const within = (element) => element.children.flatMap((child) => (child instanceof XmlElement ? [child] : []));

/** @param {XmlElement} element @param {string} path @returns {XmlElement | undefined} */
const find = (element, path) =>
  path
    .split('/')
    .reduce(
      (/** @type {XmlElement | undefined} */ at, name) => at && within(at).find((child) => child.name === name),
      element,
    );

/** @param {XmlElement} element @param {string} path */
const number = (element, path) => Number(find(element, path)?.text ?? 0);
const radians = (/** @type {number} */ degrees) => (degrees / 180) * Math.PI;
const still = rodrigues([0, 0, 1], 0);

/** @param {XmlElement} element */
function poseOf(element) {
  const [x, y, z] = ['x', 'y', 'z'].map((axis) => radians(number(element, `rotation/${axis}`)));
  const R = times(rodrigues([0, 0, 1], z), times(rodrigues([0, 1, 0], y), rodrigues([1, 0, 0], x)));
  return rigid(
    R,
    ['x', 'y', 'z'].map((axis) => number(element, `translation/${axis}`)),
  );
}

/** @param {XmlElement} joint @param {number} q */
function rowOf(joint, q) {
  const turns = joint.name === 'revolute';
  const value = q + (turns ? radians(number(joint, 'offset')) : number(joint, 'offset'));
  const theta = radians(number(joint, 'dh/theta')) + (turns ? value : 0);
  const d = number(joint, 'dh/d') + (turns ? 0 : value);
  const Z = rigid(rodrigues([0, 0, 1], theta), [0, 0, d]);
  return times(Z, rigid(rodrigues([1, 0, 0], radians(number(joint, 'dh/alpha'))), [number(joint, 'dh/a'), 0, 0]));
}

/**
 * @param {string} text
 * @returns {(q: ArrayLike<number>) => number[][]} rad or m → rows of the last frame's pose
 */
export function rlkinPose(text) {
  const { root } = parseXml(text);
  if (!root) throw new RangeError('Expected an rlkin file.');
  const [robot] = within(root);
  const steps = within(robot).filter(({ name }) => ['world', 'transform', 'revolute', 'prismatic'].includes(name));
  return (q) => {
    let i = 0;
    return steps
      .map((step) => (step.name === 'world' || step.name === 'transform' ? poseOf(step) : rowOf(step, q[i++])))
      .reduce((product, next) => times(product, next), rigid(still, [0, 0, 0]));
  };
}
