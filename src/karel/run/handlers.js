/**
 * Conditions and condition handlers, global ones and those of a MOVE, as code: what is watched, and what runs when it is met.
 *
 * @import { Body, Clause, Conditions, Statement, Term } from '../tree.js'
 * @import { Compiler } from './compiler.js'
 * @import { Code, ConditionTest, State } from './machine.js'
 */
import { createCompiler } from './compiler.js';
import { emitPlain } from './emit.js';
import { compileExpression, compileReference } from './expressions.js';
import { returnFromActions } from './machine.js';
import { CANCELS } from './occurrences.js';
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

/** @typedef {(body: Body, compiler: Compiler) => void} CompileBody */

/** Conditions with what is done where they are met; of a MOVE the actions share the variables of its routine. @param {readonly Clause[]} clauses @param {readonly Conditions[]} cancels  of the motion @param {Compiler} compiler @param {CompileBody} compileBody @param {boolean} [isOfMove] @returns {number} the handler's index */
export function compileClauses(clauses, cancels, compiler, compileBody, isOfMove = false) {
  const { image } = compiler.linker;
  const conditions = [...clauses.map((clause) => clause.conditions), ...cancels].map((one) =>
    compileConditions(one, compiler),
  );
  const actions = clauses.map((clause) => {
    /** @type {Code} */
    const code = {
      name: 'condition handler',
      program: compiler.code.program,
      slots: 0,
      instructions: [],
      lines: [],
      files: [],
      initial: [],
    };
    const inner = createCompiler(compiler.linker, compiler.analysis, code, null);
    if (isOfMove) inner.temporary = compiler.temporary;
    inner.at(clause.span ?? compiler);
    image.codes.push(code);
    const index = image.codes.length - 1;
    compileBody(clause.actions, inner);
    inner.emit(returnFromActions);
    code.slots = inner.slots();
    return index;
  });
  const lines = conditions.map((_, i) => clauses[i]?.span?.line ?? compiler.line);
  return image.handlers.push({ conditions, actions: [...actions, ...cancels.map(() => CANCELS)], lines }) - 1;
}

const MOST_HANDLERS = 1000;

/** @param {Extract<Statement, { kind: 'condition' }>} statement @param {Compiler} compiler @param {CompileBody} compileBody */
export function compileHandler({ number: node, clauses }, compiler, compileBody) {
  const handler = compileClauses(clauses, [], compiler, compileBody);
  const index = compileExpression(node, compiler);
  emitPlain(compiler, (machine, frame) => {
    const { state } = machine;
    const wanted = number(index(machine, frame));
    if (wanted < 1 || wanted > MOST_HANDLERS)
      throw new Alarm(`CONDITION[${wanted}] is not from 1 to ${MOST_HANDLERS}`, 'condition');
    if (handlerOf(state, wanted)) throw new Alarm(`CONDITION[${wanted}] is defined already`, 'condition');
    state.handlers.push({
      number: wanted,
      task: state.current,
      handler,
      isEnabled: false,
      before: clauses.map(() => []),
    });
  });
}

/** @param {State} state @param {number} wanted */
const handlerOf = ({ handlers, current }, wanted) =>
  handlers.find((one) => one.number === wanted && one.task === current && one.motion === undefined);

/** @param {Extract<Statement, { kind: 'handler-control' }>} statement @param {Compiler} compiler */
export function compileHandlerControl({ action, number: node }, compiler) {
  const index = compileExpression(node, compiler);
  emitPlain(compiler, (machine, frame) => {
    const { state } = machine;
    const wanted = number(index(machine, frame));
    const found = handlerOf(state, wanted);
    if (!found) throw new Alarm(`CONDITION[${wanted}] is not defined`, 'condition');
    found.isEnabled = action === 'ENABLE';
    if (action === 'ENABLE') found.before = found.before.map(() => []);
    if (action === 'PURGE') state.handlers.splice(state.handlers.indexOf(found), 1);
  });
}
