/**
 * An expression that a person asks for while a program stands still: read, checked and worked out where the program is, on a copy
 * of its state. Functions of the program itself are not called: they would have to run.
 *
 * @import { Expression } from '../tree.js'
 * @import { Context } from '../check/context.js'
 * @import { Type } from '../check/types.js'
 * @import { Diagnostic } from '../parse/cursor.js'
 * @import { Linker } from './compiler.js'
 * @import { Code, Frame, Machine } from './machine.js'
 * @import { Value } from './values.js'
 */
import { typeOfExpression } from '../check/expressions.js';
import { UNKNOWN } from '../check/types.js';
import { createCursor, FAULT } from '../parse/cursor.js';
import { readExpression } from '../parse/expressions.js';
import { scan } from '../scan/scanner.js';
import { createCompiler } from './compiler.js';
import { compileExpression } from './expressions.js';
import { Alarm, copiedState } from './values.js';

/**
 * @param {Machine} machine  stands still
 * @param {string} text
 * @returns {{ value: Value, type: Type } | { fault: string }}
 */
export function evaluateIn(machine, text) {
  const read = readText(text);
  if ('fault' in read) return read;
  const { image, linker } = machine;
  const state = copiedState(machine.state);
  const frame = state.tasks[state.current].frames.at(-1);
  const where = frame ? image.codes[frame.code] : { program: 0, name: '' };
  const analysis = linker.analyses[where.program];
  const symbol = frame && analysis.scope.globals.get(where.name.toUpperCase());
  const routine = symbol?.kind === 'routine' ? symbol : null;
  /** @type {string[]} */
  const faults = [];
  /** @type {Context} */
  const context = {
    scope: {
      ...analysis.scope,
      report: (_, message, span, severity = 'error') => void (severity === 'error' && faults.push(message)),
    },
    locals: routine?.locals ?? new Map(),
    ...{ using: [], usingNodes: [], routine, typeOf: new Map(), symbolOf: new Map(), usingOf: new Map() },
  };
  const type = typeOfExpression(read.node, context);
  if (faults.length > 0) return { fault: faults[0] };
  /** @type {Code} */
  const code = { name: '', program: where.program, slots: 0, instructions: [], lines: [], files: [], initial: [] };
  const compiler = {
    ...createCompiler(/** @type {Linker} */ (linker), analysis, code, routine),
    typeOf: (/** @type {object} */ node) => context.typeOf.get(node) ?? UNKNOWN,
    symbolOf: (/** @type {object} */ node) => context.symbolOf.get(node),
    isUsing: () => undefined,
  };
  try {
    const value = compileExpression(read.node, compiler);
    if (code.instructions.length > 0) return { fault: 'Functions of the program are not called to be watched.' };
    const globals = state.globals[where.program];
    return { value: value({ ...machine, state, globals }, frame ?? EMPTY), type };
  } catch (alarm) {
    if (!(alarm instanceof Alarm)) throw alarm;
    return { fault: alarm.message };
  }
}

/** @type {Frame} */
const EMPTY = { code: 0, pc: 0, locals: [], result: -1 };

/** @param {string} text @returns {{ node: Expression } | { fault: string }} */
function readText(text) {
  /** @type {Diagnostic[]} */
  const diagnostics = [];
  const locate = (/** @type {number} */ start, /** @type {number} */ end) => ({
    start,
    end,
    line: 1,
    column: start + 1,
  });
  try {
    const cursor = createCursor(
      scan(
        text,
        (_, message) => void diagnostics.push({ severity: 'error', code: 'scan', message, span: locate(0, 0) }),
      ),
      locate,
      diagnostics,
    );
    const node = readExpression(cursor);
    if (diagnostics.length === 0 && cursor.peek().type !== 'end') cursor.fail('the end of the expression');
    if (diagnostics.length === 0) return { node };
  } catch (fault) {
    if (fault !== FAULT) throw fault;
  }
  return { fault: diagnostics[0].message };
}
