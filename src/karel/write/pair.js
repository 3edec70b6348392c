/**
 * A program as FANUC controllers since R-30iA want it: KAREL puts every target into a position register and calls a TP program,
 * which moves. KAREL itself must not move the arm there.
 *
 * @import { Statement } from '../tree.js'
 * @import { NeutralProgram, NeutralTarget, WriteNote, WriteOptions, Written } from './neutral.js'
 */
import { fanucNames } from '../fanucNames.js';
import { printInSlices } from '../printer.js';
import { finished } from '../slices.js';
import { call, integer, name } from '../tree.js';
import { printTpInSlices } from '../tp/printer.js';
import { register } from '../tp/tree.js';
import { fanucNotes, headRemarks, linesFor, listingFor, motionFor } from './fanucMoves.js';
import { headerLines, zeroOf } from './header.js';
import { axisCountNotes, comment, karelProgram, OWN, stopPastLimits, targetParts } from './karelParts.js';
import { missingConfigurations } from './neutral.js';

const USUAL_REGISTERS = 100;

/** @param {NeutralProgram} program @param {WriteOptions} [options] @returns {Written} */
export const writePair = (program, options) => finished(writePairInSlices(program, options));

/** The same, some moves at a time. @param {NeutralProgram} program @param {WriteOptions} [options] @returns {Generator<null, Written>} */
export function* writePairInSlices(program, { programName = program.name, firstRegister = 1 } = {}) {
  const names = fanucNames(programName, Object.values(OWN));
  /** @type {Statement[]} */
  const body = [];
  let next = firstRegister;
  const place = (/** @type {NeutralTarget} */ target, /** @type {string | undefined} */ about) => {
    const { before, value, isJoint } = targetParts(target);
    const setter = isJoint ? 'SET_JPOS_REG' : 'SET_POS_REG';
    body.push(
      comment(about ? `PR[${next}]: ${about}` : `PR[${next}]`),
      ...before,
      ...(isJoint ? [stopPastLimits()] : []),
      call(setter, [integer(next), value, name(OWN.status)]),
      call(OWN.check, [{ kind: 'string', value: setter }]),
    );
    return register('PR', next++);
  };
  const lines = yield* linesFor(program, (move) => {
    const via = move.via && place(move.via, move.comment && `on the way to ${move.comment}`);
    return motionFor(move, place(move.target, move.comment), via);
  });
  const last = next - 1;
  const registers = `PR[${firstRegister}] to PR[${last}]`;
  const mover = names.tp.toLowerCase();
  /** @type {WriteNote[]} */
  const notes = [...(program.notes ?? []), ...missingConfigurations(program, 'fanuc'), ...fanucNotes(program)];
  const note = (
    /** @type {WriteNote['severity']} */ severity,
    /** @type {string} */ code,
    /** @type {string} */ message,
  ) => void notes.push({ severity, code, message });
  note(
    'note',
    'unverified-hold',
    'That HOLD and alarms stop the motion is not verified: the KAREL part goes on (%NOPAUSE), the TP part pauses.',
  );
  if (last > USUAL_REGISTERS)
    note(
      'warning',
      'many-registers',
      `The targets take registers up to PR[${last}]; a controller has ${USUAL_REGISTERS} unless it was set up for more.`,
    );
  notes.push(...axisCountNotes(program));

  const header = headerLines(program, {
    does: `${names.karel}.kl fills ${registers} of motion group 1, whatever they hold, and then calls ${names.tp} (${mover}.ls), which moves through them. Load ${names.tp} first, and never run it alone.`,
    world: `User frame 0 is ${zeroOf(program)}; tool 0 is the flange.`,
    notes,
  });
  const filler = karelProgram(
    names.karel,
    program,
    header,
    [
      { kind: 'directive', name: 'ENVIRONMENT', word: 'REGOPE' },
      { kind: 'directive', name: 'NOLOCKGROUP' },
      { kind: 'directive', name: 'NOPAUSE', value: { kind: 'words', words: ['ERROR', 'COMMAND', 'TPENABLE'] } },
    ],
    [],
    [{ kind: 'routine', name: mover, parameters: [], from: mover }],
    [...body, comment('All registers are filled: move.'), call(mover)],
  );
  const about = [`Run ${names.karel.toUpperCase()}, not this: it fills ${registers} and calls this.`];
  const listing = listingFor(names.tp, program, [...headRemarks(program, about), ...lines], []);
  return {
    files: [
      { name: `${names.karel}.kl`, language: 'karel', text: yield* printInSlices(filler) },
      { name: `${mover}.ls`, language: 'fanuc-tp', text: yield* printTpInSlices(listing) },
    ],
    notes,
  };
}
