/**
 * ABORT and PAUSE of the own task, or of another by its number.
 *
 * @import { Expression, Statement } from '../tree.js'
 * @import { Compiler } from './compiler.js'
 */
import { abortTask, changeTask } from './endings.js';
import { compileExpression } from './expressions.js';
import { HALT, OVER, SWITCH } from './machine.js';
import { scanHandlers } from './occurrences.js';
import { Alarm, number } from './values.js';

/** By POST_ERR. */
const PAUSES = 1;

/** POST_ERR pauses by its severity. @param {Expression} severity @param {Compiler} compiler */
export function compilePosted(severity, compiler) {
  const value = compileExpression(severity, compiler);
  const next = compiler.here() + 1;
  let end = 0;
  compiler.emit((machine, frame) => (value(machine, frame) === PAUSES ? next : end));
  compileHalt({ kind: 'pause' }, compiler);
  end = compiler.here();
}

/** First what handlers do about it. @param {Extract<Statement, { kind: 'abort' | 'pause' }>} statement @param {Compiler} compiler */
export function compileHalt({ kind, task: node }, compiler) {
  const index = node ? compileExpression(node, compiler) : null;
  const { line } = compiler;
  const at = compiler.here();
  compiler.emit((machine, frame) => {
    const { tasks, current } = machine.state;
    const halted = index ? number(index(machine, frame)) - 1 : current;
    const task = tasks[halted];
    if (!task) throw new Alarm(`there is no task ${halted + 1}`, 'task');
    const isOther = halted !== current;
    frame.pc = isOther || kind === 'abort' ? at + 3 : at + 1;
    task.noPause = false;
    if (task.status !== 'ended') {
      if (kind === 'abort') abortTask(machine, halted);
      else if (isOther) changeTask(machine, halted, 'paused');
      else scanHandlers(machine, { name: 'PAUSE', number: 0, task: current });
    }
    return task.status === 'ended' && !isOther ? OVER : SWITCH;
  });
  compiler.emit((machine, frame) => {
    const { tasks, current } = machine.state;
    if (tasks[current].noPause) return at + 3;
    machine.effect = { kind: 'pause', line };
    frame.pc = at + 2;
    return HALT;
  });
  compiler.emit((machine, frame) => {
    frame.pc = at + 3;
    scanHandlers(machine, { name: 'CONTINUE', number: 0, task: machine.state.current });
    return SWITCH;
  });
}
