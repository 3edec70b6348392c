/**
 * What may stand in <extensions>: elements that other programs put there. They are kept as they are.
 *
 * @import { Reader } from './readByTable.js'
 * @import { XmlElement } from './xmlTree.js'
 */
import { shownText } from '../model/shownText.js';
import { fileIssue } from './fileIssues.js';
import { foreignXml } from './foreignXml.js';
import { ROBOT_MODEL, ROBOT_NAMESPACE } from './robotXmlTable.js';
import { SCHEMA_INSTANCE } from './xmlNamespaces.js';

/**
 * @param {XmlElement} element  a child of <extensions>
 * @param {Reader} reader
 * @returns {string | null} null when it may not be there, which is reported
 */
export function foreignText(element, { issues }) {
  const fault = foreignFault(element, true);
  if (!fault) return foreignXml(element);
  const found = `<extensions> contains ${fault.found}; expected elements of other namespaces`;
  issues.push(fileIssue('unknown-element', `${found}.`, { line: fault.line, path: 'extensions' }));
  return null;
}

/**
 * The schema takes any element of another namespace, but no second robot inside, and no type it does not know.
 * @param {XmlElement} element
 * @param {boolean} isOutermost
 * @returns {{ found: string, line: number } | null}
 */
function foreignFault({ name, localName, namespace, line, attributes, children }, isOutermost) {
  const shown = `<${shownText(name)}>`;
  if (isOutermost && namespace === '') return { found: `${shown}, which is in no namespace`, line };
  if (isOutermost && namespace === ROBOT_NAMESPACE)
    return { found: `${shown}, which is in the robot file's own`, line };
  if (namespace === ROBOT_NAMESPACE && localName === ROBOT_MODEL.name) return { found: `another ${shown}`, line };
  const typed = attributes.find(
    (attribute) => attribute.namespace === SCHEMA_INSTANCE && attribute.localName === 'type',
  );
  if (typed) return { found: `${shown} with the attribute "${shownText(typed.name)}"`, line };
  for (const child of children) {
    const fault = child.kind === 'element' ? foreignFault(child, false) : null;
    if (fault) return fault;
  }
  return null;
}
