/**
 * A KRL program of a document with its data list, under the debugger: as far as KRL is read here.
 *
 * @import { CodeRun, Debugged } from './codeDebugger.js'
 * @import { ProgramDoc } from '../document.js'
 * @import { Diagnostic } from '../../karel/parse/cursor.js'
 * @import { KrlHost, KrlMachine } from '../../karel/krl/interpreter.js'
 */
import { createKrlMachine, restoreKrlState, runKrlMachine, saveKrlState } from '../../karel/krl/interpreter.js';
import { isKrlData, parseKrl } from '../../karel/krl/parser.js';
import { codeSet } from '../controller/codeSets.js';
import { debugged } from './codeDebugger.js';

/**
 * @param {readonly ProgramDoc[]} programs
 * @param {ProgramDoc} chosen  the program, or its data list
 * @param {KrlHost} host
 * @returns {{ run: CodeRun } | { diagnostics: readonly Diagnostic[] }}
 */
export function createKrlRun(programs, chosen, host) {
  const set = codeSet(programs, chosen).map(({ program }) => program);
  const main = set.find(({ text }) => !isKrlData(text)) ?? chosen;
  const data = set.find(({ text }) => isKrlData(text));
  const { tree, diagnostics, datDiagnostics } = parseKrl(main.text, data?.text);
  const [fault] = datDiagnostics;
  const all = [
    ...diagnostics,
    ...(fault ? [{ ...fault, message: `${data?.id}, line ${fault.span.line}: ${fault.message}`, span: FIRST }] : []),
  ];
  if (all.length > 0) return { diagnostics: all };
  return { run: debugged(krl(createKrlMachine(tree, host), main.id)) };
}

const FIRST = { start: 0, end: 0, line: 1, column: 1 };

/** @param {KrlMachine} machine @param {string} id @returns {Debugged<KrlMachine['state']>} */
function krl(machine, id) {
  const { name } = machine.module;
  const frame = { id, program: name, routine: name };
  return {
    *go() {
      const going = runKrlMachine(machine);
      for (;;) {
        const next = going.next();
        if (next.done) return next.value;
        const effect = next.value;
        // a position without S and T is gone to in the posture that is nearest
        yield effect.kind === 'move' ? { ...effect, brand: 'kuka', hasStatus: effect.status !== undefined } : effect;
      }
    },
    save: () => saveKrlState(machine),
    restore: (saved) => restoreKrlState(machine, saved),
    placeOf: ({ line = 0 }) => ({ ...frame, line, depth: 1, task: 0 }),
    faultAt: () => null,
    // a motion of the last statement goes on behind that
    frames: () =>
      machine.state.arm.motion || machine.state.at < machine.module.statements.length ? [{ ...frame, line: 0 }] : [],
    memory: () => ({
      ports: { IN: machine.state.inputs, OUT: machine.state.outputs },
      system: {},
      ...{ time: machine.state.time, arm: machine.state.arm },
    }),
    variables: () =>
      Object.entries(machine.state.set).map(([variable, value]) => ({
        name: variable,
        type: '',
        value: String(value),
      })),
    registers: () => [],
    watch(text) {
      const value = machine.state.set[text.trim().toUpperCase()];
      return value === undefined ? { fault: `"${text}" has no value here` } : { value: String(value) };
    },
    setPort(port, index, value) {
      if (port === 'IN') machine.state.inputs[index] = value === true;
    },
    setRegister: () => {},
    answer: () => {},
  };
}
