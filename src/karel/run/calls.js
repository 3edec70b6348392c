/**
 * Calls, from closures of their arguments.
 *
 * @import { RoutineSymbol } from '../check/declarations.js'
 * @import { Compiler } from './compiler.js'
 * @import { Evaluate, Locate } from './machine.js'
 */
import { BUILTINS } from '../check/builtins.js';
import { RUN } from './builtins.js';
import { HALT, pushFrame, SWITCH } from './machine.js';
import { Alarm, copied } from './values.js';

/** @param {string} name @param {number} argument */
export const parameterOf = (name, argument) => BUILTINS.get(name.toUpperCase())?.parameters[argument];

/** Whether a built-in is handed the place of an argument and not its value. @param {string} name @param {number} argument */
export function isSetByBuiltin(name, argument) {
  const upper = name.toUpperCase();
  const parameter = parameterOf(name, argument);
  return parameter?.isSet || upper === 'UNINIT' || parameter?.type === 'H' || parameter?.type === 'F';
}

/** @param {string} name @param {(Evaluate | Locate)[]} args @returns {Evaluate} */
export function runBuiltin(name, args) {
  const upper = name.toUpperCase();
  const run = Object.hasOwn(RUN, upper) ? RUN[upper] : null;
  if (!run) {
    return () => {
      throw new Alarm(`"${name}" is not built in here`, 'unknown-routine');
    };
  }
  return (m, f) =>
    run(
      args.map((value) => value(m, f)),
      m,
    );
}

/** @param {RoutineSymbol} symbol @param {Locate[]} args @param {number} result  the slot of the value @param {Compiler} compiler */
export function emitCallOf(symbol, args, result, compiler) {
  const { analysis, linker } = compiler;
  const program = symbol.from ?? analysis.scope.program;
  if (symbol.from) linker.programNamed(symbol.from);
  const key = `${program.toUpperCase()}.${symbol.name.toUpperCase()}`;
  const { entries } = linker.image;
  const line = compiler.line;
  const next = compiler.here() + 1;
  compiler.emit((machine, frame) => {
    const target = entries[key];
    const values = args.map((arg) => arg(machine, frame));
    frame.pc = next;
    if (target === undefined) {
      // A TP program, or one that nobody has here.
      machine.effect = {
        kind: 'call',
        program: (symbol.from ?? symbol.name).toUpperCase(),
        args: values.map(({ holder, key: at }) => copied(holder[at])),
        line,
      };
      return HALT;
    }
    pushFrame(machine, machine.state.tasks[machine.state.current], target, values, result);
    return SWITCH;
  });
}
