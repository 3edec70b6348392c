/**
 * The programs of a document that a FANUC controller could run, read: by what they are called in their texts.
 *
 * @import { ProgramDoc } from '../document.js'
 * @import { Diagnostic } from '../../karel/parse/cursor.js'
 * @import { TpListing } from '../../karel/tp/tree.js'
 * @import { Fragment, Program } from '../../karel/tree.js'
 *
 * @typedef {{ id: string, name: string, errors: () => readonly Diagnostic[] }} ReadBase  errors: that keep it from running
 * @typedef {ReadBase & { language: 'karel', tree: Program | Fragment, programs: readonly Program[] }} ReadKarel
 * @typedef {ReadBase & { language: 'tp', tree: TpListing }} ReadTp
 */
import { parseInSlices } from '../../karel/parser.js';
import { finished } from '../../karel/slices.js';
import { checkTp } from '../../karel/tp/checker.js';
import { parseTpInSlices } from '../../karel/tp/parser.js';
import { nameOf } from '../../karel/tp/tree.js';

/** @param {readonly ProgramDoc[]} programs @returns {(ReadKarel | ReadTp)[]} */
export const readPrograms = (programs) => finished(readInSlices(programs));

/** The same, some statements at a time. @param {readonly ProgramDoc[]} programs @returns {Generator<null, (ReadKarel | ReadTp)[]>} */
export function* readInSlices(programs) {
  const files = Object.fromEntries(programs.map(({ id, text }) => [id, text]));
  /** @type {(ReadKarel | ReadTp)[]} */
  const read = [];
  for (const { id, language, text } of programs) {
    if (language === 'karel') {
      const { tree, diagnostics, programs: made } = yield* parseInSlices(text, { files });
      const name = tree.kind === 'program' ? tree.name : id;
      const errors = diagnostics.filter(isError);
      read.push({ id, language: 'karel', name, tree, programs: made, errors: () => errors });
    } else if (language === 'fanuc-tp') {
      const { tree, diagnostics } = yield* parseTpInSlices(text);
      /** @type {Diagnostic[] | null} */
      let errors = null;
      const found = () => (errors ??= [...diagnostics, ...checkTp(tree)].filter(isError));
      read.push({ id, language: 'tp', name: nameOf(tree) || id.toUpperCase(), tree, errors: found });
    }
  }
  return read;
}

/** @param {Diagnostic} diagnostic */
const isError = ({ severity }) => severity === 'error';
