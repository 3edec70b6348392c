/**
 * Instructions of the two common kinds: one that does something and goes on, one that has an effect.
 *
 * @import { Compiler } from './compiler.js'
 * @import { Effect, Frame, Machine } from './machine.js'
 */
import { HALT } from './machine.js';

/** @param {Compiler} compiler @param {(machine: Machine, frame: Frame) => void} run */
export function emitPlain(compiler, run) {
  const next = compiler.here() + 1;
  compiler.emit((machine, frame) => {
    run(machine, frame);
    return next;
  });
}

/** @param {Compiler} compiler @param {(machine: Machine, frame: Frame) => Effect} make */
export function emitEffect(compiler, make) {
  const { line } = compiler;
  const next = compiler.here() + 1;
  compiler.emit((machine, frame) => {
    machine.effect = { ...make(machine, frame), line };
    frame.pc = next;
    return HALT;
  });
}
