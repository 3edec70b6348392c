/**
 * What is against a KAREL program beyond its syntax: names that are not declared, types that do not agree, arguments of
 * routines and built-ins, directives, files that are not at hand (a warning), variables that are never used or never set
 * (warnings), names that are too long for some controllers (a warning).
 *
 * @import { Fragment, Program } from './tree.js'
 * @import { Diagnostic } from './parse/cursor.js'
 * @import { Files } from './parser.js'
 */
import { analyseInSlices } from './check/analysis.js';
import { finished } from './slices.js';

/**
 * @param {Program | Fragment} tree
 * @param {{ files?: Files, hasGaps?: boolean }} [options]  what %INCLUDE finds, by name; whether parts of the text are missing,
 *   as macros that nobody knows, so that unknown names are no fault
 * @returns {Diagnostic[]} in the order of the text
 */
export const checkKarel = (tree, options) => finished(checkInSlices(tree, options));

/**
 * The same, some statements at a time.
 * @param {Program | Fragment} tree
 * @param {{ files?: Files, hasGaps?: boolean }} [options]
 * @returns {Generator<null, Diagnostic[]>}
 */
export function* checkInSlices(tree, { files = {}, hasGaps = false } = {}) {
  const { diagnostics } = yield* analyseInSlices(tree, files, hasGaps);
  return diagnostics.sort((a, b) => a.span.start - b.span.start);
}
