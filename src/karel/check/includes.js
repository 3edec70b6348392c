/**
 * %INCLUDE is text inclusion: the tree with what the files hold in place of the directives. Files that are not at hand are
 * warned of and leave a gap, which makes names that nobody declares less of a fault.
 *
 * @import { Declaration, Directive, Fragment, Program, Routine, Statement, TypeDefinition } from '../tree.js'
 * @import { Diagnostic } from '../parse/cursor.js'
 * @import { Files } from '../parser.js'
 *
 * @typedef {'constants' | 'types' | 'variables' | 'fields' | 'declarations' | 'statements'} Place
 * @typedef {{ files: Files, diagnostics: Diagnostic[], gaps: number, depth: number, count: number }} Inclusion
 * @typedef {object} Part
 */
import { parseIncluded } from '../parser.js';
import { fileNamed } from '../preprocess/files.js';

const MAX_DEPTH = 16;
const MAX_FILES = 500;
const NOWHERE = { start: 0, end: 0, line: 1, column: 1 };

/** @param {Program | Fragment} tree @param {Files} files */
export function includeFiles(tree, files) {
  /** @type {Inclusion} */
  const inclusion = { files, diagnostics: [], gaps: 0, depth: 0, count: 0 };
  const whole =
    tree.kind === 'fragment'
      ? { ...tree, parts: parts(tree.parts, 'declarations', inclusion) }
      : {
          ...tree,
          declarations: parts(tree.declarations, 'declarations', inclusion),
          body: parts(tree.body, 'statements', inclusion),
          ...(tree.after && { after: parts(tree.after, 'declarations', inclusion) }),
        };
  return { tree: /** @type {Program | Fragment} */ (whole), diagnostics: inclusion.diagnostics, gaps: inclusion.gaps };
}

/** @template {Part} T @param {readonly T[]} list @param {Place} place @param {Inclusion} inclusion @returns {T[]} */
function parts(list, place, inclusion) {
  return list.flatMap((part) => {
    if ('kind' in part && part.kind === 'directive') {
      const directive = /** @type {Directive} */ (/** @type {unknown} */ (part));
      return directive.name === 'INCLUDE' ? /** @type {T[]} */ (included(directive, place, inclusion)) : [part];
    }
    return [/** @type {T} */ (inside(part, inclusion))];
  });
}

/** @param {Directive} directive @param {Place} place @param {Inclusion} inclusion @returns {Part[]} */
function included({ path, span = NOWHERE }, place, inclusion) {
  if (path === undefined) return [];
  const text = fileNamed(inclusion.files, path);
  const warn = (/** @type {string} */ message) => {
    inclusion.gaps++;
    inclusion.diagnostics.push({ severity: 'warning', code: 'include', message, span });
    return [];
  };
  if (text === undefined)
    return warn(`Expected the file "${path}" to include, but it is not at hand; names that it declares are not known.`);
  if (inclusion.count > MAX_FILES) return [];
  if (++inclusion.count > MAX_FILES)
    return warn(`Expected at most ${MAX_FILES} files; "${path}" and all further ones are left out.`);
  if (inclusion.depth >= MAX_DEPTH)
    return warn(`Expected at most ${MAX_DEPTH} files inside each other; "${path}" is left out.`);
  const { tree, diagnostics } = parseIncluded(text, place, { files: inclusion.files, name: path });
  inclusion.diagnostics.push(...diagnostics);
  inclusion.depth++;
  const list = parts(tree.parts, place, inclusion);
  inclusion.depth--;
  if (place === 'declarations' || place === 'statements') return list;
  // Entries of the section that it stands in; whole declarations there would end the section and are kept apart by nobody.
  return list.flatMap((part) => ('bare' in part && 'entries' in part ? [...part.entries] : []));
}

/** @param {Part} part @param {Inclusion} inclusion @returns {Part} */
function inside(part, inclusion) {
  const node = /** @type {Declaration | Statement} */ (part);
  switch (node.kind) {
    case 'constants':
      return { ...node, entries: parts(node.entries, 'constants', inclusion) };
    case 'variables':
      return { ...node, entries: parts(node.entries, 'variables', inclusion) };
    case 'types':
      return {
        ...node,
        entries: parts(node.entries, 'types', inclusion).map((entry) =>
          'definition' in entry ? withFields(entry, inclusion) : entry,
        ),
      };
    case 'routine':
      return /** @type {Routine} */ ({
        ...node,
        ...(node.declarations && { declarations: parts(node.declarations, 'declarations', inclusion) }),
        ...(node.body && { body: parts(node.body, 'statements', inclusion) }),
      });
    case 'if':
      return {
        ...node,
        then: parts(node.then, 'statements', inclusion),
        ...(node.else && { else: parts(node.else, 'statements', inclusion) }),
      };
    case 'for':
    case 'while':
    case 'repeat':
    case 'using':
      return { ...node, body: parts(node.body, 'statements', inclusion) };
    case 'select':
      return {
        ...node,
        cases: node.cases.map((one) => ({ ...one, body: parts(one.body, 'statements', inclusion) })),
        ...(node.else && { else: parts(node.else, 'statements', inclusion) }),
      };
    default:
      return part;
  }
}

/** @param {TypeDefinition} entry @param {Inclusion} inclusion @returns {TypeDefinition} */
function withFields(entry, inclusion) {
  if (entry.definition.kind !== 'structure') return entry;
  return { ...entry, definition: { ...entry.definition, fields: parts(entry.definition.fields, 'fields', inclusion) } };
}
