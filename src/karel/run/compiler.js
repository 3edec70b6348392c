/**
 * What the compiler of one routine knows, and where it puts its instructions.
 *
 * @import { Expression } from '../tree.js'
 * @import { Analysis } from '../check/analysis.js'
 * @import { RoutineSymbol, Symbol, VariableSymbol } from '../check/declarations.js'
 * @import { Code, Host, Image, Instruction } from './machine.js'
 *
 * @typedef {ReturnType<typeof createCompiler>} Compiler
 * @typedef {object} Linker
 * @property {Image} image
 * @property {Host} host
 * @property {Analysis[]} analyses      by program
 * @property {string[]} names
 * @property {(name: string) => number} programNamed  compiled when it is first asked for; -1 if it is not at hand
 */
import { UNKNOWN } from '../check/types.js';

/** @param {Linker} linker @param {Analysis} analysis @param {Code} code @param {RoutineSymbol | null} routine */
export function createCompiler(linker, analysis, code, routine) {
  let slots = routine?.slots ?? 0;
  const compiler = {
    linker,
    analysis,
    code,
    routine,
    line: 0,
    file: /** @type {string | undefined} */ (undefined),
    labels: new Map(),
    jumps: /** @type {{ at: number, label: string }[]} */ ([]),
    slots: () => slots,
    temporary: () => slots++,
    /** @param {Instruction} instruction @returns {number} where it is */
    emit(instruction) {
      code.lines.push(compiler.line);
      code.files.push(compiler.file);
      return code.instructions.push(instruction) - 1;
    },
    /** What follows is of this place in the text. @param {{ line: number, file?: string } | undefined} span */
    at(span) {
      if (span) [compiler.line, compiler.file] = [span.line, span.file];
    },
    here: () => code.instructions.length,
    /** @param {Expression | object} node */
    typeOf: (node) => analysis.typeOf.get(node) ?? UNKNOWN,
    /** @param {object} node @returns {Symbol | undefined} */
    symbolOf: (node) => analysis.symbolOf.get(node),
    /** @param {object} node */
    isUsing: (node) => analysis.usingOf.get(node),
    /** @param {string} name @returns {RoutineSymbol | null} */
    routineNamed(name) {
      const symbol = analysis.scope.globals.get(name.toUpperCase());
      return symbol?.kind === 'routine' ? symbol : null;
    },
    /** Where a global variable is. @param {VariableSymbol} symbol */
    programOf(symbol) {
      if (!symbol.from) return { index: linker.analyses.indexOf(analysis), slot: symbol.slot };
      const index = linker.programNamed(symbol.from);
      const other = index < 0 ? undefined : linker.analyses[index].scope.globals.get(symbol.name.toUpperCase());
      if (other?.kind !== 'variable' || other.from)
        return { index: linker.analyses.indexOf(analysis), slot: symbol.slot };
      return { index, slot: other.slot };
    },
  };
  return compiler;
}
