/**
 * GOTO and its labels: each label stands in the same routine, once, and nobody jumps into a loop.
 *
 * @import { Span, Statement } from '../tree.js'
 * @import { Scope } from './declarations.js'
 *
 * @typedef {(statement: Statement, loops: readonly Statement[]) => void} Visit   loops: those around it
 */

/** @param {readonly Statement[]} body @param {Scope} scope */
export function checkLabels(body, scope) {
  /** @type {Map<string, readonly Statement[]>} */
  const labels = new Map();
  /** @type {{ label: string, span?: Span, loops: readonly Statement[] }[]} */
  const jumps = [];
  eachStatement(body, [], (statement, loops) => {
    if (statement.kind === 'label') {
      const upper = statement.name.toUpperCase();
      if (labels.has(upper))
        scope.report('declared-twice', `The label "${statement.name}" stands here already.`, statement.span);
      labels.set(upper, loops);
    }
    if (statement.kind === 'goto') jumps.push({ ...statement, loops });
  });
  for (const { label, span, loops } of jumps) {
    const around = labels.get(label.toUpperCase());
    if (!around) scope.report('unknown-label', `Expected a label of this routine, got "${label}".`, span);
    else if (!around.every((loop) => loops.includes(loop)))
      scope.report('label-in-loop', `Expected a label outside of loops that GOTO is not in, got "${label}".`, span);
  }
}

/** @param {readonly Statement[]} body @param {readonly Statement[]} loops @param {Visit} visit */
function eachStatement(body, loops, visit) {
  for (const statement of body) {
    visit(statement, loops);
    const inner = /^(for|while|repeat)$/.test(statement.kind) ? [...loops, statement] : loops;
    if ('body' in statement) eachStatement(statement.body, inner, visit);
    if (statement.kind === 'if') eachStatement(statement.then, loops, visit);
    if (statement.kind === 'select') for (const one of statement.cases) eachStatement(one.body, loops, visit);
    if ((statement.kind === 'if' || statement.kind === 'select') && statement.else)
      eachStatement(statement.else, loops, visit);
  }
}
