/**
 * XML text → a plain tree with namespaces and lines, or the reason why not. This is the first half of reading any XML
 * file here: size, no document type, well-formed, namespaces, limits. Comments are left out; CDATA becomes text.
 *
 * @import { XmlDocument } from '@rgrove/parse-xml'
 * @import { Issue } from '../model/issues.js'
 * @import { Scope } from './xmlNamespaces.js'
 *
 * @typedef {object} XmlAttribute
 * @property {string} name       with its prefix
 * @property {string} localName
 * @property {string} namespace  '' for none
 * @property {string} value
 *
 * @typedef {object} XmlElement
 * @property {'element'} kind
 * @property {string} name       with its prefix
 * @property {string} localName
 * @property {string} namespace  '' for none
 * @property {readonly XmlAttribute[]} attributes   without namespace declarations
 * @property {Scope} scope
 * @property {readonly XmlNode[]} children
 * @property {number} line
 * @property {(name: string) => number} lineOf      of an attribute
 *
 * @typedef {{ readonly kind: 'text', readonly text: string, readonly isCdata: boolean }} XmlText
 * @typedef {{ readonly kind: 'instruction', readonly name: string, readonly content: string }} XmlInstruction
 * @typedef {XmlElement | XmlText | XmlInstruction} XmlNode
 *
 * @typedef {(offset: number) => number} LineAt
 * @typedef {{ text: string, lineAt: LineAt, faults: Issue[] }} Context
 */
import {
  parseXml,
  XmlCdata as ParsedCdata,
  XmlElement as ParsedElement,
  XmlError,
  XmlProcessingInstruction as Instruction,
  XmlText as ParsedText,
} from '@rgrove/parse-xml';
import { shownText } from '../model/shownText.js';
import { fileIssue } from './fileIssues.js';
import { MAX_ATTRIBUTE_LENGTH, MAX_ATTRIBUTES, MAX_DEPTH, MAX_ELEMENTS, MAX_TEXT_LENGTH } from './fileLimits.js';
import { wellFormednessIssue } from './xmlFaults.js';
import { attributeOffset, createLineIndex } from './xmlLines.js';
import { isDeclaration, OUTERMOST_SCOPE, resolve, scopeWithin } from './xmlNamespaces.js';
import { surveyMarkup } from './xmlSurvey.js';

/**
 * @param {string} text
 * @returns {{ root: XmlElement, issues: [] } | { root: null, issues: Issue[] }}
 */
export function readXmlTree(text) {
  const refused = (/** @type {Issue} */ issue) => ({ root: null, issues: [issue] });
  if (text.length > MAX_TEXT_LENGTH) {
    const message = `The file has ${text.length} characters; expected at most ${MAX_TEXT_LENGTH}.`;
    return refused(fileIssue('too-large', message));
  }
  // As XML 1.0 §2.11 asks; and the parser takes quadratic time for carriage returns.
  const lines = text.replace(/\r\n?/g, '\n').replace(/^\uFEFF/, '');
  const lineAt = createLineIndex(lines);
  const reason = notXml(lines) ?? beyondLimits(lines, lineAt);
  if (reason) return refused(reason);
  const parsed = parse(lines, lineAt);
  if ('severity' in parsed) return refused(parsed);
  const context = { text: lines, lineAt, faults: /** @type {Issue[]} */ ([]) };
  const root = /** @type {ParsedElement} */ (parsed.root); // a document without a root is not well-formed
  const tree = elementFrom(root, OUTERMOST_SCOPE, context);
  return context.faults.length > 0 ? refused(context.faults[0]) : { root: tree, issues: [] };
}

/** Files that are something else altogether deserve to be told so. @param {string} text @returns {Issue | null} */
function notXml(text) {
  const start = text.trimStart();
  if (start === '') return fileIssue('empty', 'The file is empty; expected a robot file.');
  if (/^<(!doctype\s+html|html)[\s>]/i.test(start)) {
    return fileIssue(
      'not-xml',
      'The file is a web page (HTML); expected the robot file itself, not a page that shows it.',
    );
  }
  if (start.startsWith('<')) return null;
  const [beginning] = start.split('\n', 1);
  return fileIssue('not-xml', `The file begins with "${shownText(beginning)}"; expected XML, which begins with "<".`);
}

/** @param {string} text @param {LineAt} lineAt @returns {Issue | null} */
function beyondLimits(text, lineAt) {
  const { doctypeAt, elements, depth, deepestAt, attributes, attributesAt } = surveyMarkup(text);
  if (doctypeAt !== -1) {
    const [declaration] = text.slice(doctypeAt).match(/^<!\w+/) ?? [''];
    const message = `The file has a document type declaration, ${declaration}; expected none, because a robot file needs none and it can do harm.`;
    return fileIssue('doctype', message, { line: lineAt(doctypeAt) });
  }
  if (elements > MAX_ELEMENTS) {
    return fileIssue('too-many-elements', `The file has ${elements} elements; expected at most ${MAX_ELEMENTS}.`);
  }
  if (depth > MAX_DEPTH) {
    const message = `Elements are nested ${depth} deep; expected at most ${MAX_DEPTH}.`;
    return fileIssue('too-deep', message, { line: lineAt(deepestAt) });
  }
  if (attributes > MAX_ATTRIBUTES) {
    const message = `An element has ${attributes} attributes; expected at most ${MAX_ATTRIBUTES}.`;
    return fileIssue('too-many-attributes', message, { line: lineAt(attributesAt) });
  }
  return null;
}

/** @param {string} text @param {LineAt} lineAt @returns {XmlDocument | Issue} */
function parse(text, lineAt) {
  try {
    return parseXml(text, { includeOffsets: true, preserveCdata: true });
  } catch (error) {
    if (error instanceof XmlError) return wellFormednessIssue(error, text, lineAt);
    throw error;
  }
}

/**
 * @param {ParsedElement} parsed
 * @param {Scope} outer
 * @param {Context} context
 * @returns {XmlElement}
 */
function elementFrom(parsed, outer, context) {
  const { text, lineAt, faults } = context;
  const line = lineAt(parsed.start);
  const complain = (/** @type {string} */ message) => void faults.push(fileIssue('namespace', message, { line }));
  const scope = scopeWithin(parsed.attributes, outer, complain);
  const attributes = Object.entries(parsed.attributes).flatMap(([name, value]) => {
    if (Array.from(value).length > MAX_ATTRIBUTE_LENGTH) {
      const message = `The attribute "${shownText(name)}" of <${shownText(parsed.name)}> has ${value.length} characters; expected at most ${MAX_ATTRIBUTE_LENGTH}.`;
      faults.push(fileIssue('attribute-length', message, { line }));
    }
    if (isDeclaration(name)) return [];
    return [{ name, ...resolve(name, scope, 'attribute', complain), value }];
  });
  const names = new Set(attributes.map(({ localName, namespace }) => `${namespace} ${localName}`));
  if (names.size < attributes.length)
    complain(`<${shownText(parsed.name)}> has one attribute under two prefixes; expected it once.`);
  return {
    kind: 'element',
    name: parsed.name,
    ...resolve(parsed.name, scope, 'element', complain),
    attributes,
    scope,
    children: childrenFrom(parsed, scope, context),
    line,
    lineOf: (name) => lineAt(attributeOffset(text, parsed.start, name)),
  };
}

/**
 * @param {ParsedElement} parsed
 * @param {Scope} scope
 * @param {Context} context
 * @returns {XmlNode[]}
 */
function childrenFrom(parsed, scope, context) {
  /** @type {XmlNode[]} */
  const nodes = [];
  for (const child of parsed.children) {
    if (child instanceof ParsedElement) nodes.push(elementFrom(child, scope, context));
    else if (child instanceof ParsedText)
      nodes.push({ kind: 'text', text: child.text, isCdata: child instanceof ParsedCdata });
    else if (child instanceof Instruction)
      nodes.push({ kind: 'instruction', name: child.name, content: child.content });
  }
  return nodes;
}
