/**
 * A record → XML text, by the table of the format. What has its default value is not written; an element with nothing
 * to say is left out where it may be.
 *
 * @import { ElementRule } from './robotXmlTable.js'
 * @import { PlainRecord } from './record.js'
 */
import { isSameData, valueAt } from './record.js';
import { escapeLines, escapeWithBlanks } from './xmlText.js';

const INDENT = '  ';

/**
 * @param {ElementRule} rule
 * @param {PlainRecord} record
 * @param {string} [declarations]  of namespaces
 * @returns {string[]} lines; a text with line feeds is one of them, so that nothing is put between its lines
 */
export function elementLines(rule, record, declarations = '') {
  const start = `<${rule.name}${declarations}${attributesText(rule, record)}`;
  if (rule.text) return [`${start}>${contentText(rule.text, record)}</${rule.name}>`];
  const content = contentLines(rule, record);
  if (content.length === 0) return [`${start}/>`];
  return [`${start}>`, ...content.map((line) => INDENT + line), `</${rule.name}>`];
}

/** @param {ElementRule} rule @param {PlainRecord} record */
function attributesText({ attributes }, record) {
  let text = '';
  for (const { name, type, at, required, default: usual } of attributes) {
    const value = valueAt(record, at);
    if (required || !isUsual(value, usual)) text += ` ${name}="${escapeWithBlanks(type.write(value))}"`;
  }
  return text;
}

/** @param {NonNullable<ElementRule['text']>} rule @param {PlainRecord} record */
function contentText({ type, at, hasLines }, record) {
  const text = type.write(valueAt(record, at));
  return hasLines ? escapeLines(text) : escapeWithBlanks(text);
}

/** @param {ElementRule} rule @param {PlainRecord} record @returns {string[]} */
function contentLines(rule, record) {
  if (rule.foreign) return /** @type {string[]} */ (valueAt(record, rule.foreign));
  if (rule.order !== 'choice') return rule.children.flatMap((child) => childLines(child, record));
  return itemsAt(record, rule.children[0].list).flatMap((item) => {
    const child = rule.children.find(({ constants = {} }) => isSameData({ ...item, ...constants }, item));
    if (!child) throw new RangeError(`Expected one of ${rule.children.map(({ name }) => name).join(', ')} to write.`);
    return elementLines(child, item);
  });
}

/** @param {ElementRule} rule @param {PlainRecord} record @returns {string[]} */
function childLines(rule, record) {
  if (rule.olderNameOf) return [];
  if (rule.list) return itemsAt(record, rule.list).flatMap((item) => elementLines(rule, item));
  if (rule.text) return isUsual(valueAt(record, rule.text.at), rule.text.default) ? [] : elementLines(rule, record);
  const inner = rule.record ? /** @type {PlainRecord} */ (valueAt(record, rule.record)) : record;
  if (rule.absent) return isSameData(inner, rule.absent()) ? [] : elementLines(rule, inner);
  const isNeeded = rule.min > 0 || attributesText(rule, inner) !== '' || contentLines(rule, inner).length > 0;
  return isNeeded ? elementLines(rule, inner) : [];
}

/** @param {unknown} value @param {unknown} usual */
const isUsual = (value, usual) => value === undefined || (usual !== undefined && isSameData(value, usual));

/** @param {PlainRecord} record @param {string | undefined} path @returns {PlainRecord[]} */
const itemsAt = (record, path) => /** @type {PlainRecord[]} */ (path ? (valueAt(record, path) ?? []) : []);
