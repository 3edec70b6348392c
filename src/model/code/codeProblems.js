/**
 * What is wrong with the controller code of a document, for whoever types it.
 *
 * @import { ProgramDoc } from '../document.js'
 * @import { Diagnostic } from '../../karel/parse/cursor.js'
 * @import { Move } from '../../karel/tree.js'
 *
 * @typedef {{ from: number, to: number, line: number, severity: 'error' | 'warning', message: string, isMove?: true }} Problem  in
 *   characters of the text; of a MOVE that is deprecated
 */
import { checkKarel } from '../../karel/checker.js';
import { isKrlData, parseKrl } from '../../karel/krl/parser.js';
import { parseKarel } from '../../karel/parser.js';
import { checkTp } from '../../karel/tp/checker.js';
import { parseTp } from '../../karel/tp/parser.js';
import { ASSUMED } from './codeOffsets.js';

/** More than a person reads. */
const MOST_PROBLEMS = 200;

/**
 * @param {readonly ProgramDoc[]} programs  what %INCLUDE may find
 * @param {ProgramDoc} program              the one that is looked at
 * @returns {Problem[]} in the order of the text
 */
export function problemsOf(programs, { language, text }) {
  const diagnostics = DIAGNOSTICS[language](text, programs);
  return diagnostics
    .slice(0, MOST_PROBLEMS)
    .map((one) => placed(one, text))
    .sort((a, b) => a.from - b.from);
}

/** @type {Readonly<Record<ProgramDoc['language'], (text: string, programs: readonly ProgramDoc[]) => readonly Diagnostic[]>>} */
const DIAGNOSTICS = {
  karel(text, programs) {
    const files = Object.fromEntries(programs.map(({ id, text: of }) => [id, of]));
    const { tree, diagnostics, hasGaps } = parseKarel(text, { files });
    const isSound = !diagnostics.some(({ severity }) => severity === 'error');
    return isSound ? [...diagnostics, ...checkKarel(tree, { files, hasGaps }), ...deprecated(tree)] : diagnostics;
  },
  'fanuc-tp'(text) {
    const { tree, diagnostics } = parseTp(text);
    return [...diagnostics, ...checkTp(tree)];
  },
  krl(text) {
    if (!isKrlData(text)) return parseKrl(text).diagnostics;
    return parseKrl('', text).datDiagnostics;
  },
};

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

/** One in a file that is included stands at the beginning. @param {Diagnostic} diagnostic @param {string} text @returns {Problem} */
function placed({ severity, code, message, span }, text) {
  const isElsewhere = 'file' in span && span.file !== undefined;
  if (isElsewhere) return { from: 0, to: 0, line: 1, severity, message: `${span.file}, line ${span.line}: ${message}` };
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
