/**
 * Is this a robot file, and of a version that can be read? Files of other formats are called by their name.
 *
 * @import { Issue } from '../model/issues.js'
 * @import { XmlElement } from './xmlTree.js'
 */
import { shownText } from '../model/shownText.js';
import { fileIssue } from './fileIssues.js';
import { ROBOT_MODEL, ROBOT_NAMESPACE, ROBOT_VERSION } from './robotXmlTable.js';
import { collapse } from './valueTypes.js';

/** By root element. @type {ReadonlyMap<string, string>} */
const OTHER_FORMATS = new Map([
  ['robot', 'URDF'],
  ['sdf', 'SDFormat'],
  ['mujoco', 'MJCF'],
  ['rlkin', 'rlkin'],
  ['rlmdl', 'rlmdl'],
  ['COLLADA', 'COLLADA'],
]);

/**
 * @param {XmlElement} root
 * @returns {Issue[]}
 */
export function rootIssues(root) {
  const { line, localName, name, namespace } = root;
  const start = `<${ROBOT_MODEL.name} xmlns="${ROBOT_NAMESPACE}">`;
  if (localName !== ROBOT_MODEL.name) {
    const format = OTHER_FORMATS.get(localName);
    const beginning = `begins with <${shownText(name)}>`;
    const found = format ? `is in the format ${format} (it ${beginning})` : beginning;
    return [fileIssue('not-a-robot', `The file ${found}; expected ${start}.`, { line })];
  }
  if (namespace !== ROBOT_NAMESPACE) {
    const found = namespace === '' ? 'no namespace' : `the namespace "${shownText(namespace)}"`;
    return [fileIssue('not-a-robot', `<${shownText(name)}> has ${found}; expected ${start}.`, { line })];
  }
  return versionIssues(root);
}

/** @param {XmlElement} root @returns {Issue[]} */
function versionIssues({ attributes, lineOf }) {
  const attribute = attributes.find(({ name }) => name === 'version');
  const [, major, minor] = /^(\d+)\.(\d{1,3})$/.exec(collapse(attribute?.value ?? '')) ?? [];
  if (!attribute || major === undefined) return []; // missing or misspelt, which the table sees
  const where = { line: lineOf('version'), path: 'version' };
  const found = `The file has version="${shownText(attribute.value)}"`;
  if (major !== '1') return [fileIssue('version', `${found}; expected version 1.x, such as ${ROBOT_VERSION}.`, where)];
  if (Number(minor) === 0) return [];
  return [
    fileIssue('newer-version', `${found}, newer than ${ROBOT_VERSION}; what is new in it is not known here.`, where),
  ];
}
