/**
 * Forward kinematics of a URDF's text by somebody else: urdf-loader on three. It wants a browser's XML tree, of which this
 * makes as much as it asks for, from a parser that is not ours either.
 */
import { parseXml, XmlElement } from '@rgrove/parse-xml';
import { Matrix4, Vector3 } from 'three';
import URDFLoader from 'urdf-loader';

class Tree {
  /** @param {XmlElement} element */
  constructor(element) {
    this.nodeName = element.name;
    this.attributes = element.attributes;
    /** @type {Tree[]} */
    this.children = element.children.flatMap((child) => (child instanceof XmlElement ? [new Tree(child)] : []));
  }
  /** @param {string} name */
  getAttribute(name) {
    return this.attributes[name] ?? null;
  }
  /** @param {string} selector  child[link="…"], of any depth @returns {Tree | null} */
  querySelector(selector) {
    const [, link] = /^child\[link="(.*)"\]$/.exec(selector) ?? [];
    if (this.nodeName === 'child' && this.getAttribute('link') === link) return this;
    return this.children.map((child) => child.querySelector(selector)).find((found) => found !== null) ?? null;
  }
}

/**
 * @param {string} text
 * @param {string} tip  a link
 * @returns {(values: Record<string, number>) => number[][]} joint values by name → three rows of the tip's pose, metres
 */
export function urdfLoaderPose(text, tip) {
  const { root } = parseXml(text);
  if (!root) throw new RangeError('Expected a URDF.');
  Object.assign(globalThis, { Element: Tree, Document: class {} });
  const loader = new URDFLoader();
  loader.parseVisual = false;
  loader.parseCollision = false;
  const robot = loader.parse(/** @type {Document} */ (/** @type {unknown} */ (new Tree(root))));
  Reflect.deleteProperty(globalThis, 'Element');
  Reflect.deleteProperty(globalThis, 'Document');
  return (values) => {
    for (const [name, value] of Object.entries(values)) {
      robot.joints[name].ignoreLimits = true;
      robot.setJointValue(name, value);
    }
    robot.updateMatrixWorld(true);
    const T = new Matrix4().copy(robot.matrixWorld).invert().multiply(robot.links[tip].matrixWorld);
    const columns = [0, 1, 2].map((k) => new Vector3().setFromMatrixColumn(T, k).toArray());
    const place = new Vector3().setFromMatrixPosition(T).toArray();
    return [0, 1, 2].map((row) => [...columns.map((column) => column[row]), place[row]]);
  };
}
