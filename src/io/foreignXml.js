/**
 * Elements of other namespaces, kept as text that means the same anywhere: what it needs of the namespaces around it is
 * declared in it. Written once more, the same element gives the same text. Comments are left out.
 *
 * @import { XmlElement, XmlNode } from './xmlTree.js'
 */
import { allIn } from './xmlNamespaces.js';
import { escapeLines, escapeWithBlanks } from './xmlText.js';

/**
 * @param {XmlElement} element
 * @returns {string}
 */
export function foreignXml(element) {
  const plain = serialise(element, '');
  const { declared } = element.scope;
  const inherited = [...allIn(element.scope)].filter(([prefix]) => !declared.has(prefix) && prefix !== 'xml');
  // A prefix may also stand in a value (xsi:type="a:b"), so whatever looks like a use of it counts.
  const needed = inherited.filter(([prefix]) => (prefix === '' ? usesDefault(element) : plain.includes(`${prefix}:`)));
  return serialise(element, needed.sort(byPrefix).map(declaration).join(''));
}

/** @param {XmlElement} element @param {string} declarations more of them */
function serialise({ name, scope, attributes, children }, declarations) {
  const own = [...scope.declared].map(declaration).join('');
  const rest = attributes.map((attribute) => ` ${attribute.name}="${escapeWithBlanks(attribute.value)}"`).join('');
  /** @type {string} */
  const content = children.map(nodeText).join('');
  return content === ''
    ? `<${name}${declarations}${own}${rest}/>`
    : `<${name}${declarations}${own}${rest}>${content}</${name}>`;
}

/** @param {XmlNode} node @returns {string} */
function nodeText(node) {
  switch (node.kind) {
    case 'element':
      return serialise(node, '');
    case 'text':
      return escapeLines(node.text);
    case 'instruction':
      return node.content === '' ? `<?${node.name}?>` : `<?${node.name} ${node.content}?>`;
    default: {
      /** @type {never} */ const unknown = node;
      throw new TypeError(`Unknown node: ${JSON.stringify(unknown)}`);
    }
  }
}

/** @param {readonly [string, string]} entry */
const declaration = ([prefix, namespace]) =>
  ` ${prefix === '' ? 'xmlns' : `xmlns:${prefix}`}="${escapeWithBlanks(namespace)}"`;

/** @param {readonly [string, string]} a @param {readonly [string, string]} b */
const byPrefix = ([a], [b]) => (a < b ? -1 : 1);

/** Whether an element without a prefix takes its namespace from outside. @param {XmlElement} element @returns {boolean} */
function usesDefault({ name, scope, children }) {
  if (scope.declared.has('')) return false;
  return !name.includes(':') || children.some((node) => node.kind === 'element' && usesDefault(node));
}
