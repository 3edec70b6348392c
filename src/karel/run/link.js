/**
 * Programs → code for the machine. Each routine becomes a list of instructions; calls, waiting and jumps are instructions,
 * so that whatever a program is doing is one number, the program counter.
 *
 * @import { Program, Statement } from '../tree.js'
 * @import { RoutineSymbol } from '../check/declarations.js'
 * @import { Compiler, Linker } from './compiler.js'
 * @import { Diagnostic } from '../parse/cursor.js'
 * @import { Code, Host, Instruction, Machine } from './machine.js'
 * @import { Value } from './values.js'
 */
import { analyseInSlices } from '../check/analysis.js';
import { finished, inPieces } from '../slices.js';
import { createCompiler } from './compiler.js';
import { returnNothing } from './machine.js';
import { compileBody } from './statements.js';
import { Alarm, unsetValue } from './values.js';

/** @param {Program} tree @param {Host} host */
export const link = (tree, host) => finished(linkInSlices(tree, host));

/** The same, some statements at a time. @param {Program} tree @param {Host} host @returns {Generator<null, Linker>} */
export function* linkInSlices(tree, host) {
  /** @type {Linker} */
  const linker = {
    image: { codes: [], handlers: [], entries: {} },
    host,
    analyses: [],
    names: [],
    programNamed: (name) => programNamed(name, linker),
  };
  yield* addProgram(tree, linker);
  return linker;
}

/** @param {Program} tree @param {Linker} linker @returns {Generator<null, number>} its index */
function* addProgram(tree, linker) {
  const analysis = yield* analyseInSlices(tree, linker.host.sources ?? {}, linker.host.hasGaps);
  const index = linker.analyses.length;
  linker.analyses.push(analysis);
  linker.names.push(analysis.program.name.toUpperCase());
  const { scope } = analysis;
  const routines = [...scope.globals.values()].filter((symbol) => symbol.kind === 'routine' && symbol.node);
  const entry = (/** @type {string} */ name) => `${scope.program}.${name.toUpperCase()}`;
  /** @type {[Code, Compiler, readonly Statement[]][]} */
  const bodies = [];
  const begin = (
    /** @type {string} */ name,
    /** @type {RoutineSymbol | null} */ routine,
    /** @type {readonly Statement[]} */ body,
  ) => {
    /** @type {Code} */
    const code = {
      name,
      program: index,
      slots: routine?.slots ?? 0,
      instructions: [],
      lines: [],
      files: [],
      initial: initialValues(routine),
    };
    linker.image.entries[entry(routine ? name : '')] = linker.image.codes.length;
    linker.image.codes.push(code);
    bodies.push([code, createCompiler(linker, analysis, code, routine), body]);
  };
  begin(analysis.program.name, null, analysis.program.body);
  for (const symbol of routines) if (symbol.kind === 'routine') begin(symbol.name, symbol, symbol.node?.body ?? []);
  const fault = analysis.diagnostics.find(({ severity }) => severity === 'error');
  for (const [code, compiler, body] of bodies) {
    if (fault) {
      code.lines.push(fault.span.line);
      code.instructions.push(() => faulty(analysis.program.name, fault));
      continue;
    }
    yield* inPieces(body, (piece) => compileBody(piece, compiler));
    const needsValue = compiler.routine && compiler.routine.returns.kind !== 'NOTHING';
    compiler.at(body.at(-1)?.span ?? compiler.routine?.node?.span);
    compiler.emit(needsValue ? missingReturn : returnNothing);
    code.slots = Math.max(code.slots, compiler.slots());
  }
  return index;
}

/** @param {string} program @param {Diagnostic} fault @returns {never} */
function faulty(program, { span, message }) {
  throw new Alarm(`the program "${program}" has an error in line ${span.line}: ${message}`, 'faulty');
}

/** @type {Instruction} */
function missingReturn() {
  throw new Alarm('the function ends without RETURN of a value', 'return');
}

/** By slot, what locals hold at first. @param {RoutineSymbol | null} routine */
function initialValues(routine) {
  /** @type {((machine: Machine) => Value)[]} */
  const initial = [];
  for (const symbol of routine?.locals.values() ?? []) {
    if (symbol.kind === 'variable') initial[symbol.slot] = () => unsetValue(symbol.type);
  }
  return initial;
}

/** A program among those at hand, compiled when it is first asked for. @param {string} name @param {Linker} linker @returns {number} */
function programNamed(name, linker) {
  const upper = name.toUpperCase();
  const known = linker.names.indexOf(upper);
  if (known >= 0) return known;
  const { programs = {} } = linker.host;
  const key = Object.keys(programs).find((one) => one.toUpperCase() === upper);
  return key === undefined ? -1 : finished(addProgram(programs[key], linker));
}
