/**
 * MOVE: an effect with what is wanted; whoever has the arm moves it, and says how long that takes. One motion is under way at a
 * time: the next waits for its end, as does the task that asked for it, unless it said NOWAIT. A task that moves the arm has the
 * motion group from then on, and no other may move it. What NEAR, AWAY and the others
 * mean in terms of the tool is not verified, and left to whoever has the arm.
 *
 * CANCEL ends the motion under way where it comes to rest, as UNTIL does. STOP keeps it: whoever waits for it waits on, others may
 * move the arm, and RESUME takes up what was stopped last. HOLD lets nothing move until UNHOLD. Of this only the words are published.
 *
 * @import { Expression, Move, Statement } from '../tree.js'
 * @import { Compiler } from './compiler.js'
 * @import { CompileBody } from './handlers.js'
 * @import { Effect, Frame, Machine } from './machine.js'
 */
import { expressionText } from '../expressionPrinter.js';
import { advanceArm, beginMotion, controlMotion, isUnderWay, needGroup, nextOfArm } from './arm.js';
import { taskName } from './endings.js';
import { compileExpression, compileReference } from './expressions.js';
import { compileClauses } from './handlers.js';
import { HALT, SCAN } from './machine.js';
import { watchMotion } from './occurrences.js';
import { copied, number, record } from './values.js';

/** @param {Move} move @param {Compiler} compiler @param {CompileBody} compileBody */
export function compileMove({ target, settings = [], nowait, when = [], until = [] }, compiler, compileBody) {
  const { line } = compiler;
  /** @type {[string, (machine: Machine, frame: Frame) => unknown][]} */
  const parts = Object.entries(target).flatMap(([name, node]) =>
    name === 'to' || name === 'path' ? [] : [[name, compileExpression(/** @type {Expression} */ (node), compiler)]],
  );
  const place = 'position' in target ? target.position : target.to === 'RELATIVE' ? target.by : null;
  const isJoint = place && compiler.typeOf(place).kind === 'JOINTPOS';
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
  // each is watched by itself: one that fires leaves the others
  const handlers = [
    ...when.map((clause) => compileClauses([clause], [], compiler, compileBody, true)),
    ...until.map((conditions) => compileClauses([], [conditions], compiler, compileBody)),
  ];
  const own = compiler.temporary();
  const begin = compiler.here();
  compiler.emit((machine, frame) => {
    const { state } = machine;
    frame.pc = begin;
    const task = taskName(state, state.current);
    needGroup(state.arm, task);
    if (isWaiting(machine)) return HALT;
    /** @type {Effect} */
    const effect = {
      kind: 'move',
      to: target.to,
      line,
      settings: Object.fromEntries(named.map(([name, value]) => [name, value(machine, frame)])),
    };
    for (const [name, value] of parts) effect[name] = copied(value(machine, frame));
    if (place) effect.isJoint = isJoint;
    if (nowait) effect.nowait = true;
    machine.effect = effect;
    const motion = beginMotion(state.arm, effect, state.time, task);
    frame.locals[own] = motion;
    for (const handler of handlers) watchMotion(machine, handler, motion);
    frame.pc = begin + 1;
    return HALT;
  });
  if (nowait) return;
  compiler.emit((machine, frame) => {
    frame.pc = begin + 1;
    if (isWaiting(machine, number(frame.locals[own]))) return HALT;
    frame.locals[own] = undefined;
    return begin + 2;
  });
}

/** Until a motion is over, or until the arm is free. @param {Machine} machine @param {number} [motion] */
function isWaiting({ state }, motion) {
  const { arm, time } = state;
  advanceArm(arm, time);
  if (motion === undefined ? !arm.motion : !isUnderWay(arm, motion)) return false;
  state.tasks[state.current].wake = Math.min(nextOfArm(arm), time + SCAN);
  return true;
}

/** @param {Extract<Statement, { kind: 'motion-control' }>} statement @param {Compiler} compiler */
export function compileMotionControl({ action }, compiler) {
  const { line } = compiler;
  const at = compiler.here();
  compiler.emit((machine, frame) => {
    const { state } = machine;
    const { arm } = state;
    advanceArm(arm, state.time);
    frame.pc = at;
    // what was stopped goes on when nothing else moves
    const isLater = action === 'RESUME' && arm.stopped.length > 0 && arm.motion?.ends !== 'STOP';
    if (isLater && isWaiting(machine)) return HALT;
    controlMotion(arm, action);
    machine.effect = { kind: 'motion-control', action, line };
    frame.pc = at + 1;
    return HALT;
  });
}
