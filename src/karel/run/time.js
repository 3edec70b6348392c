/**
 * DELAY, PULSE, timers, and waiting for a semaphore.
 *
 * @import { Expression, Statement } from '../tree.js'
 * @import { Compiler } from './compiler.js'
 * @import { Evaluate } from './machine.js'
 */
import { emitPlain } from './emit.js';
import { compileExpression, compileReference } from './expressions.js';
import { isDesignator } from '../check/context.js';
import { HALT, SCAN } from './machine.js';
import { Alarm, number } from './values.js';

/** @param {Evaluate} milliseconds @param {Compiler} compiler */
export function compileDelay(milliseconds, compiler) {
  const until = compiler.temporary();
  const at = compiler.here();
  compiler.emit((machine, frame) => {
    const { state } = machine;
    const end = /** @type {number} */ (frame.locals[until] ??= state.time + number(milliseconds(machine, frame)));
    if (state.time >= end) {
      frame.locals[until] = undefined;
      return at + 1;
    }
    state.tasks[state.current].wake = end;
    frame.pc = at;
    return HALT;
  });
}

/** @param {Extract<Statement, { kind: 'pulse' }>} statement @param {Compiler} compiler */
export function compilePulse({ port, milliseconds, nowait }, compiler) {
  const time = compileExpression(milliseconds, compiler);
  const at = compileReference(port, compiler);
  emitPlain(compiler, (machine, frame) => {
    const { holder, key } = at(machine, frame);
    const { ports, pulses, time: now } = machine.state;
    const until = now + number(time(machine, frame));
    const port = Object.keys(ports).find((name) => ports[name] === holder) ?? '';
    const index = Number(key);
    const under = pulses.find((one) => one.port === port && one.index === index);
    if (under) {
      under.at = until; // one goes on
      return;
    }
    const value = holder[key] === true;
    holder[key] = !value;
    pulses.push({ kind: 'pulse', port, index, value, at: until });
  });
  if (!nowait) compileDelay(time, compiler);
}

/** PEND_SEMA(number, most milliseconds, timed out): a negative time waits for ever. @param {readonly Expression[]} args @param {Compiler} compiler */
export function compilePend([index, most, isLate], compiler) {
  const wanted = compileExpression(index, compiler);
  const longest = compileExpression(most, compiler);
  const target = isDesignator(isLate) ? compileReference(isLate, compiler) : null;
  const until = compiler.temporary();
  const at = compiler.here();
  compiler.emit((machine, frame) => {
    const { state } = machine;
    const semaphore = number(wanted(machine, frame));
    const limit = number(longest(machine, frame));
    const end = /** @type {number} */ (frame.locals[until] ??= limit < 0 ? Infinity : state.time + limit);
    const isFree = (state.semaphores[semaphore] ?? 0) > 0;
    if (!isFree && state.time < end) {
      state.tasks[state.current].wake = Math.min(end, state.time + SCAN);
      frame.pc = at;
      return HALT;
    }
    if (isFree) state.semaphores[semaphore]--;
    frame.locals[until] = undefined;
    if (target) {
      const { holder, key } = target(machine, frame);
      holder[key] = !isFree;
    }
    return at + 1;
  });
}

/** More than a controller has. */
const MOST_TIMERS = 1000;

/** @param {Extract<Statement, { kind: 'timer' }>} statement @param {Compiler} compiler */
export function compileTimer({ variable, action }, compiler) {
  const at = compileReference(variable, compiler);
  emitPlain(compiler, (machine, frame) => {
    const { state } = machine;
    const { holder, key } = at(machine, frame);
    state.timers = state.timers.filter((timer) => timer.holder !== holder || timer.key !== key);
    if (action === 'DISCONNECT') return;
    if (state.timers.length >= MOST_TIMERS) throw new Alarm(`more than ${MOST_TIMERS} timers run`, 'timer');
    state.timers.push({ holder, key, since: state.time, from: number(holder[key] ?? 0) });
  });
}
