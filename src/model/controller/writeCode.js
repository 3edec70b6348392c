/**
 * A program of the document as files for a controller: in which form, with which options, and what is against it. Where code has
 * not been verified yet, its header says so.
 *
 * @import { CodeFormat, Doc } from '../document.js'
 * @import { Issue } from '../issues.js'
 * @import { CodeSource } from './codeSource.js'
 * @import { MadeProgram } from './neutralProgram.js'
 * @import { CodeFile, WriteNote, Written } from '../../karel/write/neutral.js'
 * @import { SlicedWriter } from './certificate.js'
 *
 * @typedef {object} CodeOptions
 * @property {string} [programName]     absent: from what it is written of
 * @property {number} [firstRegister]   of the pair
 * @property {number} [speed]           % (codeSource.js)
 * @property {string} [userFrame]       in which all positions are; '' for the world; absent: as the steps have it
 * @property {Readonly<Record<string, number>>} [numbers]  of frames, by frameKey
 *
 * @typedef {object} WriteRequest
 * @property {CodeSource} source
 * @property {CodeFormat} format
 * @property {CodeOptions} options
 * @property {readonly number[]} start   where the arm stands at first
 * @property {string} version
 * @property {string} generatedAt   ISO 8601
 *
 * @typedef {object} WrittenCode
 * @property {Doc} doc              as it was written of: with speeds as asked
 * @property {WriteRequest} request
 * @property {readonly CodeFile[]} files   none where an issue is an error
 * @property {readonly WriteNote[]} notes
 * @property {readonly Issue[]} issues
 * @property {MadeProgram | null} made
 */
import { MAX_REGISTERS } from '../../karel/tp/run/memory.js';
import { writeKarelMoveInSlices } from '../../karel/write/karelMove.js';
import { writeKrlInSlices } from '../../karel/write/krl.js';
import { LARGEST_VALUE } from '../../karel/write/neutral.js';
import { writePairInSlices } from '../../karel/write/pair.js';
import { writeTpInSlices } from '../../karel/write/tp.js';
import { postureFromKernel } from '../compile.js';
import { within } from '../inSlices.js';
import { issue } from '../refusalParts.js';
import { certifiedInSlices, uncheckedLines } from './certificate.js';
import { postureIssues, robotIssues } from './controllerIssues.js';
import { firstName, sourceProgram } from './codeSource.js';
import { neutralInSlices } from './neutralProgram.js';

/** In the order in which they are offered. @type {Readonly<Record<CodeFormat, { brand: 'fanuc' | 'kuka', write: SlicedWriter }>>} */
export const FORMATS = {
  pair: { brand: 'fanuc', write: writePairInSlices },
  tp: { brand: 'fanuc', write: writeTpInSlices },
  'karel-move': { brand: 'fanuc', write: writeKarelMoveInSlices },
  krl: { brand: 'kuka', write: writeKrlInSlices },
};

/**
 * What code is to be held against: the moves of what it is, or was, written of.
 * @param {Doc} doc
 * @param {CodeSource} source
 * @param {'fanuc' | 'kuka'} brand
 * @param {Omit<WriteRequest, 'source' | 'format'>} request
 * @returns {Generator<number, { doc: Doc, made: MadeProgram | null, issues: readonly Issue[] }>}
 */
export function* madeOf(doc, source, brand, { options, start, version, generatedAt }) {
  const { doc: asked, program } = sourceProgram(doc, source, options.speed);
  const { userFrame, numbers } = options;
  const given = { brand, version, generatedAt, start, numbers, ...(userFrame !== undefined && { userFrame }) };
  return { doc: asked, ...(yield* neutralInSlices(asked, program, given)) };
}

/**
 * @param {Doc} doc
 * @param {WriteRequest} request
 * @returns {Generator<number, WrittenCode>}
 */
export function* writeCode(doc, request) {
  const { source, format, options, version } = request;
  const { brand, write } = FORMATS[format];
  const { doc: asked, made, issues } = yield* madeOf(doc, source, brand, request);
  const none = { doc: asked, request, files: [], notes: [], made: null };
  if (!made) return { ...none, issues };
  const all = [...robotIssues(doc.robot, brand), ...targetIssues(asked, made), ...registerIssues(made, request)];
  yield 1;
  if (all.some(({ severity }) => severity === 'error')) return { ...none, issues: all };
  const checked = { ...made.program, check: uncheckedLines(doc.robot, version) };
  const options_ = { ...options, programName: options.programName ?? firstName(doc, source) };
  const written = yield* within(write(checked, options_), 1);
  return { ...written, doc: asked, request, issues: all, made };
}

/**
 * The same files with what a run of them has shown.
 * @param {WrittenCode} written  with files
 * @param {{ deviation: { millimetres: number, degrees: number } }} verification
 * @returns {Generator<number, readonly CodeFile[]>}
 */
export function* certified({ doc, request, made }, { deviation }) {
  const { source, format, options } = request;
  if (!made) throw new RangeError('Expected code that was written, got none.');
  const asked = { ...options, programName: options.programName ?? firstName(doc, source) };
  return (yield* within(certifiedInSlices(made.program, FORMATS[format].write, asked, doc.robot, deviation), 1)).files;
}

/** What is to be known of the postures that become joint values. @param {Doc} doc @param {MadeProgram} made @returns {Issue[]} */
function targetIssues({ robot }, { moves }) {
  return moves.flatMap(({ move, followed }) => {
    const { joints, position, isJoint } = move.target;
    const id = move.step < 0 ? 'the start' : `step ${move.step + 1}`;
    const far = position.find((value) => Math.abs(value) > LARGEST_VALUE);
    if (far !== undefined && !isJoint)
      return [
        issue(
          'value-too-large',
          `steps.${move.step}`,
          `Step ${move.step + 1} is ${far} mm away; a controller takes ±${LARGEST_VALUE}.`,
        ),
      ];
    if (move.motion !== 'joint') return [];
    const q = postureFromKernel(robot, followed.end);
    return postureIssues(robot, { id, q, pendant: joints, index: move.step });
  });
}

/** @param {MadeProgram} made @param {WriteRequest} request @returns {Issue[]} */
function registerIssues({ moves }, { format, options: { firstRegister = 1 } }) {
  if (format !== 'pair') return [];
  const count = moves.reduce((sum, { move }) => sum + (move.via ? 2 : 1), 0);
  const last = firstRegister + count - 1;
  if (last <= MAX_REGISTERS) return [];
  const message = `The targets take ${count} position registers, PR[${firstRegister}] to PR[${last}]; a controller has ${MAX_REGISTERS} at most. Begin with a lower one, or write TP alone.`;
  return [issue('registers', 'firstRegister', message)];
}
