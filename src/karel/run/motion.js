/**
 * MOVE: an effect with what is wanted; whoever has the arm moves it. What NEAR, AWAY and the others mean in terms of the
 * tool is not verified, and left to that one.
 *
 * @import { Expression, Move } from '../tree.js'
 * @import { Compiler } from './compiler.js'
 * @import { Effect, Frame, Machine } from './machine.js'
 */
import { expressionText } from '../expressionPrinter.js';
import { compileExpression, compileReference } from './expressions.js';
import { HALT } from './machine.js';
import { copied, number, record } from './values.js';

/** @param {Move} move @param {Compiler} compiler */
export function compileMove({ target, settings = [], nowait }, compiler) {
  const { line } = compiler;
  /** @type {[string, (machine: Machine, frame: Frame) => unknown][]} */
  const parts = Object.entries(target).flatMap(([name, node]) =>
    name === 'to' || name === 'path' ? [] : [[name, compileExpression(/** @type {Expression} */ (node), compiler)]],
  );
  const isJoint = 'position' in target && compiler.typeOf(target.position).kind === 'JOINTPOS';
  if (target.to === 'ALONG') {
    const { path } = target;
    const at = compileReference(path.kind === 'range' ? path.target : path, compiler);
    const [from, to] =
      path.kind === 'range' ? [path.from, path.to].map((node) => compileExpression(node, compiler)) : [];
    parts.push([
      'nodes',
      (m, f) => {
        const { holder, key } = at(m, f);
        const nodes = /** @type {unknown[]} */ (record(holder[key]).nodes);
        return copied(from ? nodes.slice(number(from(m, f)) - 1, number(to(m, f))) : nodes);
      },
    ]);
  }
  const named = settings.map(
    ({ variable, value }) =>
      /** @type {const} */ ([expressionText(variable).toUpperCase(), compileExpression(value, compiler)]),
  );
  const next = compiler.here() + 1;
  compiler.emit((machine, frame) => {
    /** @type {Effect} */
    const effect = {
      kind: 'move',
      to: target.to,
      line,
      settings: Object.fromEntries(named.map(([name, value]) => [name, value(machine, frame)])),
    };
    for (const [name, value] of parts) effect[name] = copied(value(machine, frame));
    if ('position' in target) effect.isJoint = isJoint;
    if (nowait) effect.nowait = true;
    machine.effect = effect;
    frame.pc = next;
    return HALT;
  });
}
