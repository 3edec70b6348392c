/**
 * What a running program knows, as text: variables, registers, and what a person watches.
 *
 * @import { Level } from '../../karel/controllerTurns.js'
 * @import { Memory, TpFrame } from '../../karel/tp/run/memory.js'
 * @import { Reference } from '../../karel/run/values.js'
 *
 * @typedef {object} Shown
 * @property {string} name
 * @property {string} type
 * @property {string} value
 * @property {string} [owner]   the routine or the program that has it
 *
 * @typedef {object} ShownRegister
 * @property {'R' | 'PR' | 'SR'} bank
 * @property {number} index
 * @property {string} value
 * @property {readonly number[]} numbers        that can be set: of R one, of PR x y z w p r or the joints
 * @property {string | null} configuration      of a Cartesian position
 */
import { typeText } from '../../karel/check/types.js';
import { configText, isJoints } from '../../karel/run/positions.js';
import { evaluateIn } from '../../karel/run/watch.js';
import { Alarm, copiedState } from '../../karel/run/values.js';
import { createTpCursor, TpFault } from '../../karel/tp/cursor.js';
import { readExpression } from '../../karel/tp/operands.js';
import { evaluate } from '../../karel/tp/run/evaluate.js';
import { positionText, valueText } from './codeValues.js';

/** @param {Level} level @returns {Shown[]} */
export function variablesOf(level) {
  if (level.language === 'tp') {
    const frame = level.machine.state.frames.at(-1);
    return (frame?.args ?? []).map((value, i) => ({
      ...{ name: `AR[${i + 1}]`, type: typeof value === 'string' ? 'STRING' : 'REAL', value: plainText(value) },
      owner: frame?.program ?? '',
    }));
  }
  const { state, image, linker } = level.machine;
  const frame = state.tasks[state.current].frames.at(-1);
  const code = frame ? image.codes[frame.code] : { program: 0, name: '' };
  const { scope } = linker.analyses[code.program];
  const routine = scope.globals.get(code.name.toUpperCase());
  const locals = frame && routine?.kind === 'routine' ? [...routine.locals.values()] : [];
  return [...locals, ...scope.globals.values()].flatMap((symbol) => {
    if (symbol.kind !== 'variable' || symbol.from) return [];
    const { name, type, slot, isGlobal, isParameter } = symbol;
    const held = isGlobal ? state.globals[code.program][slot] : frame?.locals[slot];
    const at = /** @type {Reference | undefined} */ (held);
    const value = isParameter ? at?.holder[at.key] : held;
    return [{ name, type: typeText(type), value: valueText(value, type), ...(!isGlobal && { owner: code.name }) }];
  });
}

/** @param {Memory} memory @returns {ShownRegister[]} */
export function registerTexts({ registers, positionRegisters, stringRegisters }) {
  const inOrder = (/** @type {object} */ bank) =>
    Object.keys(bank)
      .map(Number)
      .sort((a, b) => a - b);
  return [
    ...inOrder(registers).map((index) => {
      const { value, isReal } = /** @type {{ value: number, isReal: boolean }} */ (registers[index]);
      const text = valueText(value, { kind: isReal ? 'REAL' : 'INTEGER' });
      return /** @type {const} */ ({ bank: 'R', index, value: text, numbers: [value], configuration: null });
    }),
    ...inOrder(positionRegisters).map((index) => {
      const values = /** @type {number[]} */ (positionRegisters[index]);
      const isCartesian = !isJoints(values);
      return /** @type {const} */ ({
        bank: 'PR',
        index,
        value: positionText(values),
        numbers: isCartesian ? values.slice(0, 6) : values,
        configuration: isCartesian ? configText(values[6] ?? 0) : null,
      });
    }),
    ...inOrder(stringRegisters).map((index) => {
      const value = `'${String(stringRegisters[index])}'`;
      return /** @type {const} */ ({ bank: 'SR', index, value, numbers: [], configuration: null });
    }),
  ];
}

/**
 * An expression where the program is, worked out on a copy of all that it knows.
 * @param {Level} level
 * @param {string} text
 * @returns {{ value: string } | { fault: string }}
 */
export function watched(level, text) {
  try {
    if (level.language === 'karel') {
      const found = evaluateIn(level.machine, text);
      return 'fault' in found ? found : { value: valueText(found.value, found.type) };
    }
    const { machine } = level;
    const state = copiedState(machine.state);
    const cursor = createTpCursor(text);
    const node = readExpression(cursor);
    if (!cursor.isAtEnd()) cursor.fail('the end of the expression');
    const frame =
      state.frames.at(-1) ?? /** @type {TpFrame} */ ({ program: level.name, at: 0, args: [], limits: {}, before: {} });
    return { value: plainText(evaluate(node, { ...machine, state }, frame)) };
  } catch (error) {
    if (error instanceof Alarm || error instanceof TpFault) return { fault: error.message };
    throw error;
  }
}

/** A value of TP. @param {unknown} value */
function plainText(value) {
  if (typeof value === 'boolean') return value ? 'ON' : 'OFF';
  if (Array.isArray(value)) return positionText(value);
  if (typeof value === 'string') return `'${value}'`;
  return typeof value === 'number' ? String(Number(value.toPrecision(9))) : String(value);
}
