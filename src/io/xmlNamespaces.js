/**
 * Namespaces in XML 1.0: from prefixes to namespaces, and what is wrong with them.
 *
 * @typedef {(message: string) => void} Complain
 */
import { shownText } from '../model/shownText.js';

const XML_NAMESPACE = 'http://www.w3.org/XML/1998/namespace';
export const SCHEMA_INSTANCE = 'http://www.w3.org/2001/XMLSchema-instance';
const XMLNS_NAMESPACE = 'http://www.w3.org/2000/xmlns/';

/** Nothing, or a character that may go on a name and may not begin one. */
const NO_START = /^(?:$|[-.\d\u{B7}\u{203F}\u{2040}]|[\u{300}-\u{36F}])/u;

/** What holds before anything is declared. @type {ReadonlyMap<string, string>} */
export const XML_SCOPE = new Map([
  ['', ''],
  ['xml', XML_NAMESPACE],
]);

/**
 * @param {Readonly<Record<string, string>>} attributes
 * @param {Complain} complain
 * @returns {Map<string, string>} namespaces by prefix; '' is the default one
 */
export function declarations(attributes, complain) {
  const declared = new Map();
  for (const [name, namespace] of Object.entries(attributes)) {
    if (name !== 'xmlns' && !name.startsWith('xmlns:')) continue;
    const prefix = name.slice('xmlns:'.length);
    const isReserved =
      prefix === 'xmlns' || namespace === XMLNS_NAMESPACE || (prefix === 'xml') !== (namespace === XML_NAMESPACE);
    if (isReserved || prefix.includes(':') || (name !== 'xmlns' && (prefix === '' || namespace === ''))) {
      complain(
        `The declaration ${shownText(name)}="${shownText(namespace)}" is not allowed; expected xmlns:prefix="namespace".`,
      );
    }
    declared.set(prefix, namespace);
  }
  return declared;
}

/**
 * @param {string} name  with its prefix
 * @param {ReadonlyMap<string, string>} inScope
 * @param {'element' | 'attribute'} what  an attribute without a prefix is in no namespace
 * @param {Complain} complain
 * @returns {{ localName: string, namespace: string }}
 */
export function resolve(name, inScope, what, complain) {
  const [prefix, localName, ...rest] = name.includes(':') ? name.split(':') : ['', name];
  const shown = what === 'element' ? `<${shownText(name)}>` : `the attribute "${shownText(name)}"`;
  if (NO_START.test(localName) || rest.length > 0 || (prefix === '' && name.includes(':'))) {
    complain(`The name of ${shown} has a colon in the wrong place; expected a name, or prefix:name.`);
  } else if (!inScope.has(prefix)) {
    complain(`The prefix of ${shown} is not declared; expected xmlns:${shownText(prefix)}="…" there or further out.`);
  }
  const isBare = prefix === '' && what === 'attribute';
  return { localName, namespace: isBare ? '' : (inScope.get(prefix) ?? '') };
}
