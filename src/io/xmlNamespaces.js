/**
 * Namespaces in XML 1.0: from prefixes to namespaces, and what is wrong with them.
 *
 * @typedef {object} Scope  the namespaces in force at an element
 * @property {ReadonlyMap<string, string>} declared  by itself, by prefix; '' is the default namespace
 * @property {Scope | null} outer
 *
 * @typedef {(message: string) => void} Complain
 */
import { shownText } from '../model/shownText.js';

const XML_NAMESPACE = 'http://www.w3.org/XML/1998/namespace';
export const SCHEMA_INSTANCE = 'http://www.w3.org/2001/XMLSchema-instance';
const XMLNS_NAMESPACE = 'http://www.w3.org/2000/xmlns/';

/** Nothing, or a character that may go on a name and may not begin one. */
const NO_START = /^(?:$|[-.\d\u{B7}\u{203F}\u{2040}]|[\u{300}-\u{36F}])/u;

/** The characters of a URI (RFC 3986); a namespace is one. */
const URI = /^[\w!#$%&'()*+,./:;=?@[\]~-]*$/;

/** What holds before anything is declared. @type {Scope} */
export const OUTERMOST_SCOPE = {
  declared: new Map([
    ['', ''],
    ['xml', XML_NAMESPACE],
  ]),
  outer: null,
};

/**
 * @param {Scope | null} scope
 * @param {string} prefix
 * @returns {string | undefined} undefined when it is not declared
 */
function namespaceIn(scope, prefix) {
  for (let at = scope; at; at = at.outer) {
    const namespace = at.declared.get(prefix);
    if (namespace !== undefined) return namespace;
  }
  return undefined;
}

/** All that holds in a scope, by prefix. @param {Scope} scope @returns {Map<string, string>} */
export const allIn = ({ declared, outer }) => new Map([...(outer ? allIn(outer) : []), ...declared]);

/** Whether a name of an attribute declares a namespace. @param {string} name */
export const isDeclaration = (name) => name === 'xmlns' || name.startsWith('xmlns:');

/**
 * @param {Readonly<Record<string, string>>} attributes
 * @param {Scope} outer
 * @param {Complain} complain
 * @returns {Scope}
 */
export function scopeWithin(attributes, outer, complain) {
  const declared = new Map();
  for (const [name, namespace] of Object.entries(attributes)) {
    if (!isDeclaration(name)) continue;
    const prefix = name.slice('xmlns:'.length);
    const isReserved =
      prefix === 'xmlns' || namespace === XMLNS_NAMESPACE || (prefix === 'xml') !== (namespace === XML_NAMESPACE);
    if (
      isReserved ||
      !URI.test(namespace) ||
      prefix.includes(':') ||
      (name !== 'xmlns' && (prefix === '' || namespace === ''))
    ) {
      const found = `${shownText(name)}="${shownText(namespace)}"`;
      complain(`The declaration ${found} is not allowed; expected xmlns:prefix="namespace".`);
    }
    declared.set(prefix, namespace);
  }
  return { declared, outer };
}

/**
 * @param {string} name  with its prefix
 * @param {Scope} scope
 * @param {'element' | 'attribute'} what  an attribute without a prefix is in no namespace
 * @param {Complain} complain
 * @returns {{ localName: string, namespace: string }}
 */
export function resolve(name, scope, what, complain) {
  const [prefix, localName, ...rest] = name.includes(':') ? name.split(':') : ['', name];
  const shown = what === 'element' ? `<${shownText(name)}>` : `the attribute "${shownText(name)}"`;
  const namespace = namespaceIn(scope, prefix);
  if (NO_START.test(localName) || rest.length > 0 || (prefix === '' && name.includes(':'))) {
    complain(`The name of ${shown} has a colon in the wrong place; expected a name, or prefix:name.`);
  } else if (namespace === undefined) {
    complain(`The prefix of ${shown} is not declared; expected xmlns:${shownText(prefix)}="…" there or further out.`);
  }
  const isBare = prefix === '' && what === 'attribute';
  return { localName, namespace: isBare ? '' : (namespace ?? '') };
}
