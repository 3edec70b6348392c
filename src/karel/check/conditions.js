/**
 * Conditions, and what handlers do: a controller looks at ports and variables by itself, and knows no routine's own variables then.
 *
 * @import { Clause, Conditions, Expression, Statement } from '../tree.js'
 * @import { Context } from './context.js'
 * @import { Type } from './types.js'
 */
import { isDesignator } from './context.js';
import { typeOfExpression } from './expressions.js';
import * as types from './types.js';

const ACTIONS = new Set(
  'assign call pulse handler-control signal motion-control abort pause action comment directive hand timer'.split(' '),
);

/**
 * @param {readonly Clause[]} clauses
 * @param {Context} context
 * @param {(body: readonly Statement[], context: Context) => void} checkBody
 * @param {boolean} [isGlobal]  not those of a MOVE, whose routine still runs
 */
export function checkClauses(clauses, context, checkBody, isGlobal = false) {
  const inside = isGlobal ? { ...context, isHandler: true } : context;
  for (const { conditions, actions } of clauses) {
    checkConditions(conditions, inside);
    for (const action of actions) {
      const hasArguments = action.kind === 'call' && action.args.length > 0;
      if (ACTIONS.has(action.kind) && !hasArguments) continue;
      const got = hasArguments ? `"${action.name}" with arguments` : wordOf(action.kind);
      context.scope.report(
        'action',
        `Expected an action behind DO (an assignment, a port, conditions, motion, a routine without arguments), got ${got}: a controller may refuse it outside of a routine.`,
        action.span,
        'warning',
      );
    }
    checkBody(actions, inside);
  }
}

const wordOf = (/** @type {string} */ kind) => kind.replace('-', ' ').toUpperCase();

/** @param {Conditions} conditions @param {Context} context */
export function checkConditions({ terms }, context) {
  const inside = { ...context, isCondition: true };
  for (const term of terms) {
    if (term.kind === 'occurrence') {
      if (term.argument && term.argument !== '*') need(term.argument, inside, 'a whole number', types.isWhole);
    } else if (term.kind === 'edge') typeOfExpression(term.port, inside);
    else {
      need(term, inside, 'a condition', ({ kind }) => kind === 'BOOLEAN');
      const sides = term.kind === 'binary' ? [term.left, term.right] : [term];
      const odd = sides.find((side) => !isPlain(side));
      if (odd)
        context.scope.report(
          'condition-form',
          'Expected a port or a variable, compared with a variable or a constant, in a condition: a controller may refuse this.',
          odd.span,
          'warning',
        );
    }
  }
}

/** @param {Expression} node @returns {boolean} */
const isPlain = (node) =>
  isDesignator(node) ||
  /^(integer|real|string)$/.test(node.kind) ||
  (node.kind === 'unary' && node.operator !== 'NOT' && isPlain(node.operand));

/** @param {Expression} node @param {Context} context @param {string} expected @param {(type: Type) => boolean} isRight */
export function need(node, context, expected, isRight) {
  const type = typeOfExpression(node, context);
  if (!types.isUnknown(type) && !isRight(type)) {
    context.scope.report('type', `Expected ${expected}, got ${types.typeText(type)}.`, node.span);
  }
  return type;
}
