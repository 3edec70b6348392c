/**
 * What is wrong with the controller code of a document, for whoever types it.
 *
 * @import { ProgramDoc } from '../document.js'
 * @import { Diagnostic } from '../../karel/parse/cursor.js'
 * @import { Files } from '../../karel/parser.js'
 * @import { Move } from '../../karel/tree.js'
 *
 * @typedef {ReturnType<typeof import('../../karel/parser.js').parseKarel>} Parsed
 * @typedef {{ from: number, to: number, line: number, severity: 'error' | 'warning', message: string, isMove?: true }} Problem  in
 *   characters of the text; of a MOVE that is deprecated
 */
import { checkInSlices } from '../../karel/checker.js';
import { isKrlData, parseKrl } from '../../karel/krl/parser.js';
import { parseInSlices } from '../../karel/parser.js';
import { includesOf, keyOf } from '../../karel/preprocess/files.js';
import { lineStarts, placeOf } from '../../karel/scan/places.js';
import { checkTp } from '../../karel/tp/checker.js';
import { parseTpInSlices } from '../../karel/tp/parser.js';
import { finished } from '../../karel/slices.js';
import { includerOf } from '../controller/codeSets.js';
import { ASSUMED } from './codeOffsets.js';

/** More than a person reads. */
const MOST_PROBLEMS = 200;

/**
 * @param {readonly ProgramDoc[]} programs  what %INCLUDE may find
 * @param {ProgramDoc} program              the one that is looked at
 * @returns {Problem[]} in the order of the text
 */
export const problemsOf = (programs, program) => finished(problemsInSlices(programs, program));

/**
 * The same, some statements at a time.
 * @param {readonly ProgramDoc[]} programs
 * @param {ProgramDoc} program
 * @returns {Generator<null, Problem[]>}
 */
export function* problemsInSlices(programs, { id, language, text }) {
  const now = programs.map((one) => (one.id === id ? { ...one, text } : one));
  const diagnostics = yield* DIAGNOSTICS[language](text, now, id);
  return diagnostics
    .slice(0, MOST_PROBLEMS)
    .map((one) => placed(one, text))
    .sort((a, b) => a.from - b.from);
}

/** @type {Readonly<Record<ProgramDoc['language'], (text: string, programs: readonly ProgramDoc[], id: string) => Generator<null, readonly Diagnostic[]>>>} */
const DIAGNOSTICS = {
  *karel(text, programs, id) {
    const files = filesOf(programs);
    const parsed = yield* parseInSlices(text, { files });
    const { tree, diagnostics } = parsed;
    if (diagnostics.some(isError)) return diagnostics;
    const whole = tree.kind === 'fragment' ? yield* inItsProgram(programs, id) : null;
    return [...(whole ?? (yield* checked(parsed, files))), ...deprecated(tree)];
  },
  *'fanuc-tp'(text) {
    const { tree, diagnostics } = yield* parseTpInSlices(text);
    return [...diagnostics, ...checkTp(tree)];
  },
  // eslint-disable-next-line require-yield -- its texts are read at once
  *krl(text) {
    if (!isKrlData(text)) return parseKrl(text).diagnostics;
    return parseKrl('', text).datDiagnostics;
  },
};

/** @param {readonly ProgramDoc[]} programs */
const filesOf = (programs) => Object.fromEntries(programs.map(({ id, text }) => [id, text]));

/** @param {Diagnostic} diagnostic */
const isError = ({ severity }) => severity === 'error';

/** @param {Parsed} parsed @param {Files} files @returns {Generator<null, readonly Diagnostic[]>} */
function* checked({ tree, diagnostics, hasGaps }, files) {
  return [...diagnostics, ...(diagnostics.some(isError) ? [] : yield* checkInSlices(tree, { files, hasGaps }))];
}

/** What is against a text where a program includes it, which knows more names than it does. @param {readonly ProgramDoc[]} programs @param {string} id @returns {Generator<null, Diagnostic[] | null>} null: no program does */
function* inItsProgram(programs, id) {
  const part = programs.find((one) => one.id === id);
  const program = part && includerOf(programs, part);
  if (!program) return null;
  const ids = programs.map((one) => one.id);
  const isHere = (/** @type {Diagnostic} */ { span }) => span.file !== undefined && keyOf(ids, span.file) === id;
  const files = filesOf(programs);
  const parsed = yield* parseInSlices(program.text, { files });
  return (yield* checked(parsed, files)).flatMap((one) =>
    isHere(one) ? [{ ...one, span: { ...one.span, file: undefined } }] : [],
  );
}

/** Statements that controllers since R-30iA are not to run. @param {object} tree @returns {Diagnostic[]} */
function deprecated(tree) {
  /** @type {Diagnostic[]} */
  const found = [];
  const look = (/** @type {unknown} */ node) => {
    if (Array.isArray(node)) return node.forEach(look);
    if (typeof node !== 'object' || node === null) return;
    const { kind, span, target } = /** @type {Partial<Move> & { span?: Diagnostic['span'] }} */ (node);
    if (kind === 'move' && span) {
      const assumed = ASSUMED[target?.to ?? ''];
      const message = assumed ? `${DEPRECATED} ${assumed}` : DEPRECATED;
      found.push({ severity: 'warning', code: MOVE_CODE, message, span });
    }
    for (const [name, inner] of Object.entries(node)) if (name !== 'span') look(inner);
  };
  look(tree);
  return found;
}

const MOVE_CODE = 'deprecated-move';
const DEPRECATED = 'MOVE is deprecated since R-30iA: a controller may refuse it, or move unexpectedly. It runs here.';

/** One in a file that is included stands where that is. @param {Diagnostic} diagnostic @param {string} text @returns {Problem} */
function placed({ severity, code, message, span }, text) {
  if (span.file !== undefined) {
    const [{ from, to } = { from: 0, to: 0 }] = includesOf(text).filter(({ path }) => path === span.file);
    const { line } = placeOf(lineStarts(text), from);
    return { from, to, line, severity, message: `${span.file}, line ${span.line}: ${message}` };
  }
  const from = Math.min(span.start, text.length);
  const to = Math.min(Math.max(span.end, from), text.length);
  return {
    from,
    to,
    line: span.line,
    severity,
    message,
    ...(code === MOVE_CODE && { isMove: /** @type {const} */ (true) }),
  };
}
