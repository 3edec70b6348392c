/**
 * A program as TP alone: its positions stand in the listing.
 *
 * @import { TpPosition } from '../tp/tree.js'
 * @import { NeutralProgram, WriteOptions, Written } from './neutral.js'
 */
import { fanucNames } from '../fanucNames.js';
import { finished } from '../slices.js';
import { printTpInSlices } from '../tp/printer.js';
import { register } from '../tp/tree.js';
import { fanucNotes, headRemarks, linesFor, listingFor, motionFor, positionFor } from './fanucMoves.js';
import { zeroOf } from './header.js';
import { missingConfigurations } from './neutral.js';

/** @param {NeutralProgram} program @param {WriteOptions} [options] @returns {Written} */
export const writeTp = (program, options) => finished(writeTpInSlices(program, options));

/** The same, some moves at a time. @param {NeutralProgram} program @param {WriteOptions} [options] @returns {Generator<null, Written>} */
export function* writeTpInSlices(program, { programName = program.name } = {}) {
  const name = fanucNames(programName).karel.toUpperCase();
  /** @type {TpPosition[]} */
  const positions = [];
  const lines = yield* linesFor(program, (move) => {
    const place = (/** @type {typeof move.target} */ target) => {
      positions.push(positionFor(target, positions.length + 1, move, program));
      return register('P', positions.length);
    };
    const via = move.via && place(move.via);
    return motionFor(move, place(move.target), via);
  });
  const about = [`UFRAME 0 is ${zeroOf(program).replace(' of the controller', '')}. UTOOL 0 is the flange.`];
  const listing = listingFor(name, program, [...headRemarks(program, about), ...lines], positions);
  return {
    files: [{ name: `${name.toLowerCase()}.ls`, language: 'fanuc-tp', text: yield* printTpInSlices(listing) }],
    notes: [...(program.notes ?? []), ...missingConfigurations(program, 'fanuc'), ...fanucNotes(program)],
  };
}
