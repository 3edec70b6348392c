/**
 * A KAREL program of the document without MOVE: it fills a position register that no program names, and calls TP programs that come
 * with it (karel/write/tpCalls.js). Nothing is offered that would not check.
 *
 * @import { Doc, ProgramDoc } from '../document.js'
 */
import { parseKarel } from '../../karel/parser.js';
import { nodesOf } from '../../karel/write/knownSettings.js';
import { writeTpCalls } from '../../karel/write/tpCalls.js';
import { MAX_PROGRAMS } from '../documentRules.js';
import { problemsOf } from './codeProblems.js';
import { readPrograms } from './codePrograms.js';

/** How many a controller has unless it was set up for more; the last are the least used. */
const REGISTERS = 100;

/**
 * @param {Doc} doc
 * @param {string} id
 * @param {{ version: string, generatedAt: string }} written
 * @returns {{ programs: readonly ProgramDoc[], movers: readonly string[] } | { reason: string }}
 */
export function withTpCalls({ robot, programs }, id, written) {
  const index = programs.findIndex((one) => one.id === id);
  const program = programs[index];
  const files = Object.fromEntries(programs.map(({ id: one, text }) => [one, text]));
  const { tree } = parseKarel(program.text, { files });
  if (tree.kind !== 'program') return { reason: 'This is a part of a program: the program that includes it calls.' };
  const register = freeRegister(programs);
  if (register === null) return { reason: `All of PR[1] to PR[${REGISTERS}] are used.` };
  const taken = new Set([...programs.map((one) => one.id), ...readPrograms(programs).map(({ name }) => name)]);
  const options = { ...written, register, robotName: robot.name, files };
  const made = writeTpCalls(program.text, tree, {
    ...options,
    taken: new Set([...taken].map((name) => name.toUpperCase())),
  });
  if ('reason' in made) return made;
  if (programs.length + made.movers.length > MAX_PROGRAMS)
    return { reason: `The model would have more than ${MAX_PROGRAMS} programs.` };
  const movers = made.movers.map(
    ({ name, text }) => /** @type {ProgramDoc} */ ({ id: name, language: 'fanuc-tp', text }),
  );
  const all = [...programs.with(index, { ...program, text: made.text }), ...movers];
  const fault = [all[index], ...movers]
    .flatMap((one) => problemsOf(all, one))
    .find(({ severity }) => severity === 'error');
  if (fault) return { reason: `Line ${fault.line} would be: ${fault.message}` };
  const after = parseKarel(made.text, { files }).tree;
  if ([...nodesOf(after)].some(({ kind }) => kind === 'move')) return { reason: 'A MOVE stands in what a macro says.' };
  return { programs: all, movers: movers.map(({ id: one }) => one) };
}

/** The last that no text names. @param {readonly ProgramDoc[]} programs */
function freeRegister(programs) {
  const named = programs.flatMap(({ text }) =>
    [...text.matchAll(/(?:\bPR\[\s*|(?:\w*POS_REG\w*|PREG_CMT)\s*\(\s*)(\d+)/gi)].map(([, number]) => Number(number)),
  );
  for (let number = REGISTERS; number > 0; number--) if (!named.includes(number)) return number;
  return null;
}
