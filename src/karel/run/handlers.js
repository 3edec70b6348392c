/**
 * Conditions and condition handlers: what is watched, and what runs when it is met. A handler is disabled when it fires.
 *
 * @import { Body, Conditions, Statement, Term } from '../tree.js'
 * @import { Compiler } from './compiler.js'
 * @import { Code, ConditionTest } from './machine.js'
 */
import { createCompiler } from './compiler.js';
import { compileExpression, compileReference } from './expressions.js';
import { returnNothing } from './machine.js';
import { Alarm, number, truth } from './values.js';

/** @param {Conditions} conditions @param {Compiler} compiler @returns {ConditionTest} */
export function compileConditions({ operator, terms }, compiler) {
  const tests = terms.map((term, i) => compileTerm(term, i, compiler));
  if (operator === 'OR') return (m, f, before, event) => tests.map((test) => test(m, f, before, event)).some(Boolean);
  return (m, f, before, event) => tests.map((test) => test(m, f, before, event)).every(Boolean);
}

/** @param {Term} term @param {number} i @param {Compiler} compiler @returns {ConditionTest} */
function compileTerm(term, i, compiler) {
  if (term.kind === 'edge') {
    const at = compileReference(term.port, compiler);
    return (m, f, before) => {
      const { holder, key } = at(m, f);
      const now = holder[key] === true;
      const was = before[i] ?? now;
      before[i] = now;
      return was !== now && now === term.rising;
    };
  }
  if (term.kind === 'occurrence') {
    const { name, argument } = term;
    if (name === 'SEMAPHORE' && argument && argument !== '*') {
      const index = compileExpression(argument, compiler);
      return (m, f) => (m.state.semaphores[number(index(m, f))] ?? 0) > 0;
    }
    if (!argument || argument === '*') return (_m, _f, _b, event) => event?.name === name;
    const index = compileExpression(argument, compiler);
    return (m, f, _, event) => event?.name === name && event.number === number(index(m, f));
  }
  const value = compileExpression(term, compiler);
  return (m, f) => truth(value(m, f));
}

/** @param {Extract<Statement, { kind: 'condition' }>} statement @param {Compiler} compiler @param {(body: Body, compiler: Compiler) => void} compileBody */
export function compileHandler({ number: node, clauses }, compiler, compileBody) {
  const { image } = compiler.linker;
  const conditions = clauses.map((clause) => compileConditions(clause.conditions, compiler));
  const actions = clauses.map((clause) => {
    /** @type {Code} */
    const code = {
      name: 'condition handler',
      program: compiler.code.program,
      slots: 0,
      instructions: [],
      lines: [],
      initial: [],
    };
    const inner = createCompiler(compiler.linker, compiler.analysis, code, null);
    inner.line = clause.span?.line ?? compiler.line;
    image.codes.push(code);
    const index = image.codes.length - 1;
    compileBody(clause.actions, inner);
    inner.emit(returnNothing);
    code.slots = inner.slots();
    return index;
  });
  const handler = image.handlers.push({ conditions, actions }) - 1;
  const index = compileExpression(node, compiler);
  const next = compiler.here() + 1;
  compiler.emit((machine, frame) => {
    const { state } = machine;
    const wanted = number(index(machine, frame));
    if (state.handlers.some((one) => one.number === wanted && one.task === state.current)) {
      throw new Alarm(`CONDITION[${wanted}] is defined already`, 'condition');
    }
    state.handlers.push({
      number: wanted,
      task: state.current,
      handler,
      isEnabled: false,
      before: conditions.map(() => []),
    });
    return next;
  });
}
