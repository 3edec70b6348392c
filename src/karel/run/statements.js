/**
 * Statements as instructions.
 *
 * @import { Expression, Statement } from '../tree.js'
 * @import { Compiler } from './compiler.js'
 */
import { compileAssignment } from './assignment.js';
import { emitEffect, emitPlain } from './emit.js';
import { compileCall, emitCall, compileExpression, compileReference } from './expressions.js';
import { compileHalt, compilePosted } from './halt.js';
import { compileConditions, compileHandler, compileHandlerControl } from './handlers.js';
import { HALT, OVER, pushFrame, SCAN, SWITCH } from './machine.js';
import { compileMotionControl, compileMove } from './motion.js';
import { scanHandlers } from './occurrences.js';
import { linkedProgram } from './programs.js';
import { compileDelay, compilePend, compilePulse, compileTimer } from './time.js';
import { compileFileStatement, compileTransfer } from './transfer.js';
import { Alarm, copied, number, single, text, truth } from './values.js';

/** @param {readonly Statement[]} body @param {Compiler} compiler */
export function compileBody(body, compiler) {
  for (const statement of body) {
    compiler.at(statement.span);
    if (compiler.linker.host.traceSteps && statement.kind !== 'comment' && statement.kind !== 'directive')
      emitStep(compiler);
    compileStatement(statement, compiler);
  }
}

/** @param {Compiler} compiler */
function emitStep(compiler) {
  const { line, code } = compiler;
  const next = compiler.here() + 1;
  compiler.emit((machine, frame) => {
    machine.effect = { kind: 'step', line, routine: code.name };
    frame.pc = next;
    return HALT;
  });
}

/** @param {Statement} statement @param {Compiler} compiler */
function compileStatement(statement, compiler) {
  switch (statement.kind) {
    case 'assign':
      return compileAssignment(
        statement.target,
        compileExpression(statement.value, compiler),
        compiler,
        compiler.typeOf(statement.value),
      );
    case 'call':
      return compileCallStatement(statement, compiler);
    case 'if':
      return compileIf(statement, compiler);
    case 'select':
      return compileSelect(statement, compiler);
    case 'for':
      return compileFor(statement, compiler);
    case 'while': {
      const start = compiler.here();
      const jump = emitBranch(statement.condition, compiler);
      compileBody(statement.body, compiler);
      compiler.emit(() => start);
      jump.to(compiler.here());
      return;
    }
    case 'repeat': {
      const start = compiler.here();
      compileBody(statement.body, compiler);
      compiler.at(statement.until.span);
      emitBranch(statement.until, compiler).to(start);
      return;
    }
    case 'label':
      compiler.labels.set(statement.name.toUpperCase(), compiler.here());
      return;
    case 'goto': {
      const { labels } = compiler;
      const label = statement.label.toUpperCase();
      compiler.emit(() => labels.get(label) ?? missingLabel(label));
      return;
    }
    case 'return':
      return compileReturn(statement.value, compiler);
    case 'abort':
    case 'pause':
      return compileHalt(statement, compiler);
    case 'delay':
      return compileDelay(compileExpression(statement.milliseconds, compiler), compiler);
    case 'wait': {
      const isMet = compileConditions(statement.conditions, compiler);
      const before = compiler.temporary();
      const at = compiler.here();
      return void compiler.emit((machine, frame) => {
        const memory = /** @type {boolean[]} */ (frame.locals[before] ??= []);
        if (isMet(machine, frame, memory, null)) {
          frame.locals[before] = undefined;
          return at + 1;
        }
        machine.state.tasks[machine.state.current].wake = machine.state.time + SCAN;
        frame.pc = at;
        return HALT;
      });
    }
    case 'pulse':
      return compilePulse(statement, compiler);
    case 'write':
    case 'read':
      return compileTransfer(statement, compiler);
    case 'open-file':
    case 'close-file':
    case 'cancel-file':
      return compileFileStatement(statement, compiler);
    case 'using':
      return compileBody(statement.body, compiler);
    case 'condition':
      return compileHandler(statement, compiler, compileBody);
    case 'handler-control':
      return compileHandlerControl(statement, compiler);
    case 'signal': {
      const index = compileExpression(statement.number, compiler);
      const isEvent = statement.what === 'EVENT';
      const after = compiler.here() + 1;
      return void compiler.emit((machine, frame) => {
        const wanted = number(index(machine, frame));
        frame.pc = after;
        if (isEvent) scanHandlers(machine, { name: 'EVENT', number: wanted });
        else machine.state.semaphores[wanted] = (machine.state.semaphores[wanted] ?? 0) + 1;
        return SWITCH;
      });
    }
    case 'timer':
      return compileTimer(statement, compiler);
    case 'motion-control':
      return compileMotionControl(statement, compiler);
    case 'hand': {
      const { action } = statement;
      const index = compileExpression(statement.number, compiler);
      return emitEffect(compiler, (machine, frame) => ({
        kind: 'hand',
        action,
        number: number(index(machine, frame)),
      }));
    }
    case 'move':
      return compileMove(statement, compiler, compileBody);
    case 'action': {
      const { action } = statement;
      return emitPlain(compiler, ({ state }) => {
        if (action === 'NOABORT') state.tasks[state.current].noAbort = true;
        else if (/PAUSE|CONTINUE/.test(action)) state.tasks[state.current].noPause = true;
      });
    }
    case 'comment':
    case 'directive':
  }
}

/** @param {string} label @returns {never} */
function missingLabel(label) {
  throw new Alarm(`the label "${label}" is not in this routine`, 'label');
}

/** Jump where a condition is not met. @param {Expression} condition @param {Compiler} compiler */
function emitBranch(condition, compiler) {
  const value = compileExpression(condition, compiler);
  const next = compiler.here() + 1;
  let target = next;
  compiler.emit((machine, frame) => (truth(value(machine, frame)) ? next : target));
  return { to: (/** @type {number} */ place) => void (target = place) };
}

/** @param {Extract<Statement, { kind: 'if' }>} statement @param {Compiler} compiler */
function compileIf({ condition, then, else: otherwise }, compiler) {
  const jump = emitBranch(condition, compiler);
  compileBody(then, compiler);
  if (!otherwise) return jump.to(compiler.here());
  let end = 0;
  compiler.emit(() => end);
  jump.to(compiler.here());
  compileBody(otherwise, compiler);
  end = compiler.here();
}

/** @param {Extract<Statement, { kind: 'select' }>} statement @param {Compiler} compiler */
function compileSelect({ value, cases, else: otherwise }, compiler) {
  const slot = compiler.temporary();
  const wanted = compileExpression(value, compiler);
  emitPlain(compiler, (machine, frame) => void (frame.locals[slot] = number(wanted(machine, frame))));
  let end = 0;
  for (const { values, body } of cases) {
    const choices = values.map((choice) => compileExpression(choice, compiler));
    const next = compiler.here() + 1;
    let further = 0;
    compiler.emit((machine, frame) =>
      choices.some((choice) => choice(machine, frame) === frame.locals[slot]) ? next : further,
    );
    compileBody(body, compiler);
    compiler.emit(() => end);
    further = compiler.here();
  }
  if (otherwise) compileBody(otherwise, compiler);
  else {
    compiler.emit((_, frame) => {
      throw new Alarm(`no CASE for ${frame.locals[slot]}, and no ELSE`, 'select');
    });
  }
  end = compiler.here();
}

/** @param {Extract<Statement, { kind: 'for' }>} statement @param {Compiler} compiler */
function compileFor({ variable, from, to, down, body }, compiler) {
  const first = compileExpression(from, compiler);
  const last = compileExpression(to, compiler);
  const at = compileReference(variable, compiler);
  const limit = compiler.temporary();
  const step = down ? -1 : 1;
  emitPlain(compiler, (machine, frame) => {
    const { holder, key } = at(machine, frame);
    holder[key] = number(first(machine, frame));
    frame.locals[limit] = number(last(machine, frame));
  });
  const next = compiler.here() + 1;
  let end = 0;
  compiler.emit((machine, frame) => {
    const { holder, key } = at(machine, frame);
    return (number(frame.locals[limit]) - number(holder[key])) * step >= 0 ? next : end;
  });
  compileBody(body, compiler);
  compiler.emit((machine, frame) => {
    const { holder, key } = at(machine, frame);
    const further = number(holder[key]) + step;
    if (further !== (further | 0)) return end; // it was the last INTEGER
    holder[key] = further;
    return next - 1;
  });
  end = compiler.here();
}

/** @param {Expression | undefined} value @param {Compiler} compiler */
function compileReturn(value, compiler) {
  const result = value ? compileExpression(value, compiler) : null;
  const isReal = compiler.routine?.returns.kind === 'REAL';
  compiler.emit((machine, frame) => {
    const task = machine.state.tasks[machine.state.current];
    const given = result && copied(result(machine, frame));
    task.frames.pop();
    const caller = task.frames.at(-1);
    if (!caller) return OVER;
    if (frame.result >= 0) caller.locals[frame.result] = isReal ? single(number(given)) : given;
    return SWITCH;
  });
}

/** @param {Extract<Statement, { kind: 'call' }>} statement @param {Compiler} compiler */
function compileCallStatement(statement, compiler) {
  const symbol = compiler.routineNamed(statement.name);
  if (symbol) return emitCall(statement, symbol, -1, compiler);
  const upper = statement.name.toUpperCase();
  if (upper === 'CALL_PROG' || upper === 'CALL_PROGLIN') return compileCallProgram(statement.args, compiler);
  if (upper === 'PEND_SEMA') return compilePend(statement.args, compiler);
  const run = compileCall(statement, compiler);
  const { line } = compiler;
  const next = compiler.here() + 1;
  compiler.emit((machine, frame) => {
    run(machine, frame);
    if (!machine.effect) return next;
    machine.effect.line = line;
    frame.pc = next;
    return HALT;
  });
  if (upper === 'POST_ERR') compilePosted(statement.args[3], compiler);
}

/**
 * CALL_PROG: a program by its name as text, in this task; CALL_PROGLIN: one of TP from a line on, and paused before that if asked.
 * @param {readonly Expression[]} args @param {Compiler} compiler
 */
function compileCallProgram(args, compiler) {
  const name = compileExpression(args[0], compiler);
  const [from, pause] = args.length < 4 ? [] : [args[1], args[3]].map((node) => compileExpression(node, compiler));
  const { line } = compiler;
  const next = compiler.here() + 1;
  compiler.emit((machine, frame) => {
    const called = text(name(machine, frame)).toUpperCase();
    const asked = from && { from: number(from(machine, frame)), isPaused: pause?.(machine, frame) === true };
    frame.pc = next;
    if (linkedProgram(machine, called) < 0) {
      machine.effect = { kind: 'call', program: called, args: [], ...asked, line };
      return HALT;
    }
    const { state, image } = machine;
    pushFrame(machine, state.tasks[state.current], image.entries[`${called}.`], [], -1);
    if (!asked?.isPaused) return SWITCH;
    machine.effect = { kind: 'pause', line };
    return HALT;
  });
}
