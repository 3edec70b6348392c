/**
 * What is wrong with the controller code of a document, and what its names are, for whoever types it.
 *
 * @import { ProgramDoc } from '../document.js'
 * @import { Diagnostic } from '../../karel/parse/cursor.js'
 *
 * @typedef {{ from: number, to: number, line: number, severity: 'error' | 'warning', message: string }} Problem  in characters of the text
 * @typedef {{ name: string, kind: 'routine' | 'variable' | 'constant' | 'built-in', detail: string }} KnownName
 */
import { analyse } from '../../karel/check/analysis.js';
import { BUILTINS, signatureText } from '../../karel/check/builtins.js';
import { typeText } from '../../karel/check/types.js';
import { checkKarel } from '../../karel/checker.js';
import { parseKarel } from '../../karel/parser.js';

/** More than a person reads. */
const MOST_PROBLEMS = 200;

/**
 * @param {readonly ProgramDoc[]} programs  what %INCLUDE may find
 * @param {ProgramDoc} program              the one that is looked at
 * @returns {Problem[]} in the order of the text; none for a language that is not read here
 */
export function problemsOf(programs, { language, text }) {
  if (language !== 'karel') return [];
  const files = Object.fromEntries(programs.map(({ id, text: of }) => [id, of]));
  const { tree, diagnostics } = parseKarel(text, { files });
  const isSound = !diagnostics.some(({ severity }) => severity === 'error');
  const all = isSound ? [...diagnostics, ...checkKarel(tree, { files })] : diagnostics;
  return all.slice(0, MOST_PROBLEMS).map((one) => placed(one, text));
}

/** One in a file that is included stands at the beginning. @param {Diagnostic} diagnostic @param {string} text @returns {Problem} */
function placed({ severity, message, span }, text) {
  const isElsewhere = 'file' in span && span.file !== undefined;
  if (isElsewhere) return { from: 0, to: 0, line: 1, severity, message: `${span.file}, line ${span.line}: ${message}` };
  const from = Math.min(span.start, text.length);
  return { from, to: Math.min(Math.max(span.end, from), text.length), line: span.line, severity, message };
}

/** @type {readonly KnownName[]} */
const BUILT_IN = [...BUILTINS.values()].map((one) => ({
  name: one.name,
  kind: 'built-in',
  detail: signatureText(one).slice(one.name.length),
}));

/** What a KAREL program may name: its own, and what is built in. @param {readonly ProgramDoc[]} programs @param {string} text @returns {KnownName[]} */
export function namesOf(programs, text) {
  const files = Object.fromEntries(programs.map(({ id, text: of }) => [id, of]));
  const { scope } = analyse(parseKarel(text, { files }).tree, files);
  const own = [...scope.globals.values()].map((symbol) => {
    const { name, kind } = symbol;
    if (kind !== 'routine') return { name, kind, detail: typeText(symbol.type) };
    const list = symbol.parameters.map((one) => `${one.name} : ${typeText(one.type)}`).join('; ');
    return { name, kind, detail: `(${list})` };
  });
  return [...own, ...BUILT_IN];
}
