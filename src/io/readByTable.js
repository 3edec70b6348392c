/**
 * An XML tree → a plain record, by the table of the format: the half of reading that a schema can describe. Every fault
 * is reported, with what was found and what was expected; the record is to be used only if there was none.
 *
 * @import { Issue } from '../model/issues.js'
 * @import { AttributeRule, ElementRule } from './robotXmlTable.js'
 * @import { PlainRecord } from './record.js'
 * @import { XmlElement } from './xmlTree.js'
 * @import { FileIssueCode } from './fileIssues.js'
 * @import { Sources } from './sources.js'
 * @import { ValueType } from './valueTypes.js'
 *
 * @typedef {object} Place  in the file and in the record
 * @property {PlainRecord} record
 * @property {string} path    of the record
 * @property {string} [item]  what messages call the item of a list that this belongs to, 'joint "joint_1"'
 * @property {XmlElement} [itemElement]
 *
 * @typedef {object} Reader
 * @property {Issue[]} issues
 * @property {Sources} sources
 * @property {string} namespace
 * @property {(element: XmlElement, reader: Reader) => string | null} foreignText
 */
import { shownText } from '../model/shownText.js';
import { fileIssue, hasErrors } from './fileIssues.js';
import { MAX_ISSUES } from './fileLimits.js';
import { setAt, valueAt } from './record.js';
import { collapse } from './valueTypes.js';
import { SCHEMA_INSTANCE } from './xmlNamespaces.js';

const SCHEMA_HINTS = ['schemaLocation', 'noNamespaceSchemaLocation'];

/**
 * @param {ElementRule} rule
 * @param {XmlElement} element
 * @param {Place} place
 * @param {Reader} reader
 */
export function readElement(rule, element, place, reader) {
  if (rule.olderNameOf) {
    report(
      reader,
      'older-name',
      element,
      place,
      `is an older name; expected <${rule.olderNameOf}>, as which it was read`,
    );
  }
  reader.sources.add(place.record, element);
  readAttributes(rule, element, place, reader);
  if (rule.text) readText(rule.text, element, place, reader);
  else readChildren(rule, element, place, reader);
}

/** @param {ElementRule} rule @param {XmlElement} element @param {Place} place @param {Reader} reader */
function readAttributes({ attributes }, element, place, reader) {
  const isKnown = (/** @type {{ localName: string, namespace: string }} */ { localName, namespace }) =>
    namespace === SCHEMA_INSTANCE
      ? SCHEMA_HINTS.includes(localName)
      : namespace === '' && attributes.some((rule) => rule.name === localName);
  for (const { name } of element.attributes.filter((attribute) => !isKnown(attribute))) {
    const expected = attributes.length > 0 ? `only ${attributes.map((rule) => rule.name).join(', ')}` : 'no attributes';
    const found = `has the attribute "${shownText(name)}"; expected ${expected}`;
    report(reader, 'unknown-attribute', element, place, found, { attribute: name });
  }
  for (const rule of attributes) {
    const attribute = element.attributes.find(
      ({ localName, namespace }) => localName === rule.name && namespace === '',
    );
    if (attribute) {
      readAttribute(rule, attribute.value, element, place, reader);
    } else if (rule.required) {
      const found = `has no ${rule.name}; expected one such as ${rule.name}="${rule.type.example}"`;
      report(reader, 'missing-attribute', element, place, found, { at: rule.at });
    } else if (rule.default !== undefined) {
      setAt(place.record, rule.at, rule.default);
    }
  }
}

/** @param {AttributeRule} rule @param {string} text @param {XmlElement} element @param {Place} place @param {Reader} reader */
function readAttribute({ name, type, at }, text, element, place, reader) {
  const reading = type.read(text);
  if ('value' in reading) {
    setAt(place.record, at, reading.value);
    reader.sources.add(place.record, element, { at, attribute: name });
    return;
  }
  const found = `has ${name}="${shownText(text)}"; expected ${reading.expected}`;
  report(reader, reading.code, element, place, found, { at, attribute: name });
}

/** @param {{ type: ValueType, at: string }} rule @param {XmlElement} element @param {Place} place @param {Reader} reader */
function readText({ type, at }, element, place, reader) {
  let text = '';
  for (const node of element.children) {
    if (node.kind === 'text') text += node.text;
    if (node.kind !== 'element') continue;
    const found = `contains <${shownText(node.name)}>; expected only text`;
    report(reader, 'unknown-element', element, place, found, { line: node.line });
  }
  const reading = type.read(text);
  reader.sources.add(place.record, element, { at });
  if ('value' in reading) setAt(place.record, at, reading.value);
  else
    report(reader, reading.code, element, place, `has the text "${shownText(text)}"; expected ${reading.expected}`, {
      at,
    });
}

/** @param {ElementRule} rule @param {XmlElement} element @param {Place} place @param {Reader} reader */
function readChildren(rule, element, place, reader) {
  const counts = new Map(rule.children.map(({ name }) => [name, 0]));
  for (const list of [rule.foreign, ...rule.children.map((child) => child.list)]) startList(place.record, list);
  checkText(rule, element, place, reader);
  for (const child of element.children.filter((node) => node.kind === 'element')) {
    if (rule.foreign) {
      const text = reader.foreignText(child, reader);
      if (text !== null) /** @type {string[]} */ (valueAt(place.record, rule.foreign)).push(text);
      continue;
    }
    const known = rule.children.find(({ name }) => name === child.localName && child.namespace === reader.namespace);
    if (!known) {
      const expected = rule.children.map(({ name }) => `<${name}>`).join(', ') || 'nothing';
      const found = `contains <${shownText(child.name)}>; expected only ${expected}`;
      report(reader, 'unknown-element', element, place, found, { line: child.line });
      continue;
    }
    const count = (counts.get(known.name) ?? 0) + 1;
    counts.set(known.name, count);
    if (count > known.max && known.max === 1) {
      report(reader, 'too-many-of-element', element, place, `has a second <${known.name}>; expected one`, {
        line: child.line,
      });
    }
    readElement(known, child, placeOf(known, child, place), reader);
  }
  checkCounts(rule, counts, element, place, reader);
}

/** @param {ElementRule} rule @param {XmlElement} element @param {Place} place @param {Reader} reader */
function checkText(rule, element, place, reader) {
  const isEmpty = rule.children.length === 0 && !rule.foreign;
  for (const node of element.children) {
    if (node.kind !== 'text' || (!isEmpty && !node.isCdata && collapse(node.text) === '')) continue;
    const text = collapse(node.text) === '' ? 'blanks' : `the text "${shownText(collapse(node.text))}"`;
    const expected = isEmpty ? 'nothing in it' : 'only elements';
    report(reader, 'unexpected-text', element, place, `contains ${text}; expected ${expected}`);
  }
}

/** @param {ElementRule} rule @param {Map<string, number>} counts @param {XmlElement} element @param {Place} place @param {Reader} reader */
function checkCounts(rule, counts, element, place, reader) {
  for (const child of rule.children) {
    const count = counts.get(child.name) ?? 0;
    if (count < child.min && child.max === 1) {
      report(reader, 'missing-element', element, place, `has no <${child.name}>; expected one`);
    } else if (count < child.min || (count > child.max && child.max > 1 && !rule.maxChildren)) {
      const code = count < child.min ? 'missing-element' : 'too-many-of-element';
      const expected = child.min > 0 ? `${child.min} to ${child.max}` : `at most ${child.max}`;
      report(reader, code, element, place, `has ${count} <${child.name}>; expected ${expected}`);
    }
    if (count === 0) fillIn(child, place.record);
  }
  const total = [...counts.values()].reduce((sum, count) => sum + count, 0);
  if (rule.maxChildren && total > rule.maxChildren) {
    const found = `has ${total} elements; expected at most ${rule.maxChildren}`;
    report(reader, 'too-many-of-element', element, place, found);
  }
}

/** What holds when an element is missing. @param {ElementRule} rule @param {PlainRecord} record */
function fillIn(rule, record) {
  startList(record, rule.foreign);
  startList(record, rule.list);
  if (rule.list) return;
  if (rule.text && rule.text.default !== undefined) setAt(record, rule.text.at, rule.text.default);
  if (rule.absent && rule.record) {
    setAt(record, rule.record, rule.absent());
    return;
  }
  const inner = rule.record ? {} : record;
  if (rule.record) setAt(record, rule.record, inner);
  for (const { at, default: value } of rule.attributes) if (value !== undefined) setAt(inner, at, value);
  for (const child of rule.children) fillIn(child, inner);
}

/** @param {PlainRecord} record @param {string | undefined} path */
function startList(record, path) {
  if (path && !valueAt(record, path)) setAt(record, path, []);
}

/** Where the values of a child element go. @param {ElementRule} rule @param {XmlElement} element @param {Place} place @returns {Place} */
function placeOf(rule, element, place) {
  /** @type {PlainRecord} */
  const record = { ...rule.constants };
  if (rule.record) {
    setAt(place.record, rule.record, record);
    return { ...place, record, path: join(place.path, rule.record) };
  }
  if (!rule.list) return place;
  const items = /** @type {PlainRecord[]} */ (valueAt(place.record, rule.list));
  items.push(record);
  const id = element.attributes.find(({ name }) => name === 'id')?.value;
  const item = id === undefined ? `${rule.noun} ${items.length}` : `${rule.noun} "${shownText(id)}"`;
  return { record, path: join(place.path, `${rule.list}.${items.length - 1}`), item, itemElement: element };
}

/** @param {string} path @param {string} more */
const join = (path, more) => (path ? `${path}.${more}` : more);

/**
 * @param {Reader} reader
 * @param {FileIssueCode} code
 * @param {XmlElement} element
 * @param {Place} place
 * @param {string} found  and expected; the sentence without its subject and full stop
 * @param {{ at?: string, line?: number, attribute?: string }} [where]
 */
function report({ issues }, code, element, { path, item, itemElement }, found, { at, line, attribute } = {}) {
  if (issues.length >= MAX_ISSUES && hasErrors(issues)) return;
  const tag = `<${element.localName}>`;
  const inItem = item && element !== itemElement ? `${tag} of ${item}` : item;
  const place = {
    line: line ?? (attribute ? element.lineOf(attribute) : element.line),
    path: at ? join(path, at) : path,
  };
  issues.push(fileIssue(code, `${inItem ?? tag} ${found}.`, place));
}
