/**
 * Statements, checked one by one.
 *
 * @import { Designator, Expression, Item, MoveTarget, Statement } from '../tree.js'
 * @import { Context } from './context.js'
 * @import { Type } from './types.js'
 */
import { PREDEFINED_FILES } from './constants.js';
import { isIncomplete } from './calls.js';
import { checkClauses, checkConditions, need } from './conditions.js';
import { isDesignator, markSet } from './context.js';
import { typeOfCall, typeOfExpression } from './expressions.js';
import * as types from './types.js';

/** @param {readonly Statement[]} body @param {Context} context */
export function checkBody(body, context) {
  for (const statement of body) checkStatement(statement, context);
}

const isBoolean = (/** @type {Type} */ { kind }) => kind === 'BOOLEAN';
const isFile = (/** @type {Type} */ { kind }) => kind === 'FILE';

/** @param {Expression} node @param {Context} context */
const needWhole = (node, context) => need(node, context, 'a whole number', types.isWhole);

/** @param {Designator} target @param {Context} context */
function checkTarget(target, context) {
  const before =
    target.kind === 'name'
      ? (context.locals.get(target.name.toUpperCase()) ?? context.scope.globals.get(target.name.toUpperCase()))
      : undefined;
  const wasUsed = before?.kind === 'variable' && before.isUsed;
  if (before?.kind === 'routine' || before?.kind === 'constant') {
    context.scope.report(
      'target',
      `Expected a variable before "=", got the ${before.kind} "${before.name}".`,
      target.span,
    );
    return types.UNKNOWN;
  }
  const type = typeOfExpression(target, context);
  // To be set is not to be used.
  if (before?.kind === 'variable' && !wasUsed) before.isUsed = false;
  markSet(target, context);
  return type;
}

/** @param {Statement} statement @param {Context} context */
function checkStatement(statement, context) {
  const { report } = context.scope;
  switch (statement.kind) {
    case 'assign': {
      const to = checkTarget(statement.target, context);
      const from = typeOfExpression(statement.value, context);
      if (!types.fits(from, to.kind === 'PATH' && from.kind === 'STRUCTURE' ? (to.header ?? to) : to)) {
        const hint = types.isWhole(to) && from.kind === 'REAL' ? ' Use ROUND or TRUNC.' : '';
        report(
          'assignment',
          `Expected ${types.typeText(to)}, got ${types.typeText(from)}.${hint}`,
          statement.value.span,
        );
      }
      return;
    }
    case 'call':
      typeOfCall(statement, context, false);
      return;
    case 'if':
      need(statement.condition, context, 'BOOLEAN between IF and THEN', isBoolean);
      checkBody(statement.then, context);
      checkBody(statement.else ?? [], context);
      return;
    case 'select':
      needWhole(statement.value, context);
      for (const { values, body } of statement.cases) {
        for (const value of values) needWhole(value, context);
        checkBody(body, context);
      }
      checkBody(statement.else ?? [], context);
      return;
    case 'for':
      checkTarget(statement.variable, context);
      needWhole(statement.variable, context);
      needWhole(statement.from, context);
      needWhole(statement.to, context);
      checkBody(statement.body, context);
      return;
    case 'while':
      need(statement.condition, context, 'BOOLEAN between WHILE and DO', isBoolean);
      checkBody(statement.body, context);
      return;
    case 'repeat':
      checkBody(statement.body, context);
      need(statement.until, context, 'BOOLEAN behind UNTIL', isBoolean);
      return;
    case 'return': {
      if (context.routine && isIncomplete(context.routine, context.scope)) {
        if (statement.value) typeOfExpression(statement.value, context);
        return;
      }
      const wanted = context.routine?.returns ?? types.NOTHING;
      if (!statement.value) {
        if (wanted.kind !== 'NOTHING')
          report('return', `Expected RETURN with a value of type ${types.typeText(wanted)}.`, statement.span);
        return;
      }
      const type = typeOfExpression(statement.value, context);
      if (wanted.kind === 'NOTHING')
        report('return', 'Expected RETURN without a value: this is no function.', statement.span);
      else if (!types.fits(type, wanted))
        report('return', `Expected ${types.typeText(wanted)}, got ${types.typeText(type)}.`, statement.value.span);
      return;
    }
    case 'delay':
      need(statement.milliseconds, context, 'a number', types.isNumber);
      return;
    case 'wait':
      checkConditions(statement.conditions, context);
      return;
    case 'pulse':
      need(statement.port, context, 'a port that is ON or OFF', isBoolean);
      need(statement.milliseconds, context, 'a number', types.isNumber);
      return;
    case 'open-file':
      need(statement.file, context, 'FILE', isFile);
      markSet(statement.file, context);
      for (const node of [statement.usage, statement.path])
        need(node, context, 'STRING', ({ kind }) => kind === 'STRING');
      return;
    case 'close-file':
    case 'cancel-file':
      need(statement.file, context, 'FILE', isFile);
      markSet(statement.file, context);
      return;
    case 'write':
    case 'read':
      checkTransfer(statement, context);
      return;
    case 'using': {
      const structures = statement.variables.map((variable) => typeOfExpression(variable, context));
      for (const variable of statement.variables) markSet(variable, context);
      context.using.push(...structures);
      context.usingNodes.push(...statement.variables);
      checkBody(statement.body, context);
      context.using.length -= structures.length;
      context.usingNodes.length -= structures.length;
      return;
    }
    case 'condition':
      needWhole(statement.number, context);
      for (const { value } of statement.settings ?? []) needWhole(value, context);
      checkClauses(statement.clauses, context, checkBody, true);
      return;
    case 'handler-control':
    case 'signal':
      needWhole(statement.number, context);
      return;
    case 'timer':
      needWhole(statement.variable, context);
      markSet(statement.variable, context);
      return;
    case 'hand':
      needWhole(statement.number, context);
      return;
    case 'abort':
    case 'pause':
      if (statement.task) needWhole(statement.task, context);
      return;
    case 'move':
      for (const { value } of statement.settings ?? []) typeOfExpression(value, context);
      checkMove(statement.target, context);
      checkClauses(statement.when ?? [], context, checkBody);
      for (const conditions of statement.until ?? []) checkConditions(conditions, context);
      return;
    case 'motion-control':
      for (const group of statement.groups ?? []) needWhole(group, context);
      return;
    case 'comment':
    case 'directive':
    case 'label':
    case 'goto':
    case 'action':
  }
}

/** @param {Extract<Statement, { kind: 'write' | 'read' }>} statement @param {Context} context */
function checkTransfer({ kind, file, items }, context) {
  if (typeof file === 'string') {
    if (!PREDEFINED_FILES.has(file.toUpperCase()))
      need({ kind: 'name', name: file, span: items[0]?.span }, context, 'FILE', isFile);
  } else if (file) need(file, context, 'FILE', isFile);
  for (const item of items) checkItem(item, kind, context);
}

/** @param {Item} item @param {'write' | 'read'} kind @param {Context} context */
function checkItem(item, kind, context) {
  if (item.kind === 'new-line') return;
  const value = item.kind === 'format' ? item.value : item;
  const type = typeOfExpression(value, context);
  if (kind === 'read') {
    markSet(value, context);
    if (!isDesignator(value)) context.scope.report('read', 'Expected a variable to READ into.', value.span);
  }
  const isPart = type.kind === 'VECTOR' || type.kind === 'ARRAY' || type.kind === 'CONFIG' || types.isPosition(type);
  if (type.kind === 'STRUCTURE' || type.kind === 'PATH' || type.kind === 'FILE' || (kind === 'read' && isPart)) {
    context.scope.report(
      'item',
      `Expected something that can be ${kind === 'read' ? 'read' : 'written'}, got ${types.typeText(type)}.`,
      value.span,
    );
  }
  if (item.kind === 'format') for (const format of item.formats) needWhole(format, context);
}

/** @param {MoveTarget} target @param {Context} context */
function checkMove(target, context) {
  const position = (/** @type {Expression} */ node) =>
    need(
      node,
      context,
      'a position',
      (type) => types.isPosition(type) || type.kind === 'STRUCTURE' || type.kind === 'PATH',
    );
  const number = (/** @type {Expression} */ node) => need(node, context, 'a number', types.isNumber);
  if ('position' in target) position(target.position);
  if ('via' in target && target.via) position(target.via);
  if (target.to === 'NEAR' || target.to === 'AWAY' || target.to === 'ABOUT' || target.to === 'AXIS') number(target.by);
  if (target.to === 'RELATIVE')
    need(target.by, context, 'VECTOR or a position', (type) => type.kind === 'VECTOR' || types.isPosition(type));
  if (target.to === 'ABOUT') need(target.vector, context, 'VECTOR', ({ kind }) => kind === 'VECTOR');
  if (target.to === 'AXIS') needWhole(target.axis, context);
  if (target.to === 'ALONG') typeOfExpression(target.path.kind === 'range' ? target.path.target : target.path, context);
}
