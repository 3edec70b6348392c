/**
 * GOTO and its labels: each label stands in the same routine, once.
 *
 * @import { Span, Statement } from '../tree.js'
 * @import { Scope } from './declarations.js'
 */

/** @param {readonly Statement[]} body @param {Scope} scope */
export function checkLabels(body, scope) {
  /** @type {Set<string>} */
  const labels = new Set();
  /** @type {{ label: string, span?: Span }[]} */
  const jumps = [];
  eachStatement(body, (statement) => {
    if (statement.kind === 'label') {
      if (labels.has(statement.name.toUpperCase()))
        scope.report('declared-twice', `The label "${statement.name}" stands here already.`, statement.span);
      labels.add(statement.name.toUpperCase());
    }
    if (statement.kind === 'goto') jumps.push(statement);
  });
  for (const { label, span } of jumps) {
    if (!labels.has(label.toUpperCase()))
      scope.report('unknown-label', `Expected a label of this routine, got "${label}".`, span);
  }
}

/** @param {readonly Statement[]} body @param {(statement: Statement) => void} visit */
function eachStatement(body, visit) {
  for (const statement of body) {
    visit(statement);
    if ('body' in statement) eachStatement(statement.body, visit);
    if (statement.kind === 'if') eachStatement(statement.then, visit);
    if (statement.kind === 'select') for (const one of statement.cases) eachStatement(one.body, visit);
    if ((statement.kind === 'if' || statement.kind === 'select') && statement.else)
      eachStatement(statement.else, visit);
  }
}
