/**
 * Which element and attribute of a file each value of a document came from, so that a rule which knows only documents can
 * still be reported with a line. Kept beside the document, by identity, never in it.
 *
 * @import { PlainRecord } from './record.js'
 * @import { XmlElement } from './xmlTree.js'
 */

export function createSources() {
  /** @type {Map<unknown, Map<string, () => number>>} by record, then by path within it; '' is the record itself */
  const places = new Map();

  /**
   * @param {object} record
   * @param {XmlElement} element
   * @param {{ at?: string, attribute?: string }} [value]
   */
  function add(record, element, { at = '', attribute } = {}) {
    const known = places.get(record) ?? new Map();
    places.set(record, known);
    if (!known.has(at)) known.set(at, () => (attribute === undefined ? element.line : element.lineOf(attribute)));
  }

  /**
   * @param {unknown} root  the document
   * @param {string} path   'robot.joints.1.lower'
   * @returns {number | undefined} the line of the value, or else of the closest thing around it
   */
  function lineOf(root, path) {
    const keys = path === '' ? [] : path.split('.');
    /** @type {unknown} */
    let value = root;
    let line = places.get(root)?.get('')?.();
    for (let i = 0; i <= keys.length; i++) {
      const known = places.get(value);
      const rest = keys.slice(i);
      for (let length = rest.length; known && length >= 0; length--) {
        const found = known.get(rest.slice(0, length).join('.'));
        if (!found) continue;
        line = found();
        break;
      }
      if (typeof value !== 'object' || value === null || i === keys.length) break;
      value = /** @type {PlainRecord} */ (value)[keys[i]];
    }
    return line;
  }

  /**
   * Say that a value is, or is kept in, what another was read into.
   * @param {object} record @param {string} at
   * @param {object} original @param {string} originalAt
   */
  function follow(record, at, original, originalAt) {
    const known = places.get(record) ?? new Map();
    places.set(record, known);
    for (const [path, line] of places.get(original) ?? []) {
      if (path === originalAt) known.set(at, line);
      else if (originalAt === '') known.set(path, line);
    }
  }

  return { add, follow, lineOf };
}

/** @typedef {ReturnType<typeof createSources>} Sources */
