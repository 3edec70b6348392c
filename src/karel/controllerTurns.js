/**
 * Whose turn it is among the programs of a controller, and its memory, which goes with the turn.
 *
 * @import { Outcome } from './interpreter.js'
 * @import { Linker } from './run/compiler.js'
 * @import { Host, Idle, Machine, State } from './run/machine.js'
 * @import { Value } from './run/values.js'
 * @import { Memory, TpMachine, TpState } from './tp/run/memory.js'
 * @import { TpListing } from './tp/tree.js'
 * @import { Program } from './tree.js'
 *
 * @typedef {{ thread: number, level: number }} Turn
 * @typedef {Turn & { task: number, depth: number }} Caller   of KAREL: a frame of one of its tasks
 * @typedef {{ language: 'karel', machine: Machine } | { language: 'tp', machine: TpMachine }} Run
 * @typedef {Run & { name: string, caller: Caller | null, isPaused?: boolean, hasTaken?: boolean }} Level   hasTaken: the motion group, until it ends
 * @typedef {{ levels: Level[], isOver: boolean }} Thread   levels: who runs, last, and who waits for whom
 *
 * @typedef {object} Controller
 * @property {Programs} programs
 * @property {ControllerHost} host
 * @property {Thread[]} threads  the first is that of the program that was begun
 * @property {Turn} turn         whose turn it is
 * @property {Turn} last         who ran last: its memory is the controller's
 * @property {Turn} told         who had an effect last
 * @property {Map<Level, Idle>} idle   who has nothing to do, and until when
 * @property {Record<string, Value[][]>} globals   what variables of KAREL programs hold between their runs
 * @property {Map<string, Linker>} linked   KAREL programs that have run
 * @property {(Outcome & { program: string }) | null} refusal   of a program that cannot run
 *
 * @typedef {Host & { endsWithFirst?: boolean }} ControllerHost   endsWithFirst: what it began beside itself ends with it
 *
 * @typedef {object} Programs   by their names
 * @property {Readonly<Record<string, Program>>} [karel]
 * @property {Readonly<Record<string, TpListing>>} [listings]
 */

/** Who had an effect last, and above it whoever waits for that. @param {Controller} controller @returns {Level[]} */
export const levelsOf = ({ threads, told }) => threads[told.thread].levels.slice(0, told.level + 1);

/** What is known to all programs. @param {Controller} controller @returns {State | TpState} */
export const memoryOf = (controller) => levelAt(controller, controller.last).machine.state;

/** @param {Controller} controller @param {Turn} turn @returns {Level} */
export const levelAt = ({ threads }, { thread, level }) =>
  threads[thread].levels[Math.min(level, threads[thread].levels.length - 1)];

/** In the order of their turns: of each thread the last level, and whichever has something to do while it waits. @param {Controller} controller @returns {Turn[]} */
export const turnsOf = ({ threads }) =>
  threads.flatMap(({ levels, isOver }, thread) =>
    isOver
      ? []
      : levels.flatMap((one, level) =>
          !one.isPaused && (level === levels.length - 1 || isBusy(one)) ? [{ thread, level }] : [],
        ),
  );

/** Whether a KAREL program that waits for what it called has other tasks, or something to watch. @param {Level} level */
const isBusy = ({ language, machine }) =>
  language === 'karel' &&
  (machine.state.handlers.some(({ isEnabled }) => isEnabled) ||
    machine.state.tasks.some(({ status, wake }) => status === 'running' && wake < Infinity));

/** @param {Turn} a @param {Turn} b */
const inOrder = (a, b) => a.thread - b.thread || a.level - b.level;

/** Whoever can go on, from the one whose turn it is. @param {Controller} controller @returns {Level | null} */
export function nextLevel(controller) {
  const { idle } = controller;
  const turns = turnsOf(controller);
  const from = turns.findIndex((one) => inOrder(one, controller.turn) >= 0);
  for (let i = 0; i < turns.length; i++) {
    const turn = turns[(Math.max(0, from) + i) % turns.length];
    const level = levelAt(controller, turn);
    if ((idle.get(level)?.until ?? 0) > memoryOf(controller).time) continue;
    controller.turn = turn;
    return level;
  }
  return null;
}

/** Whether nobody goes on any more: all is over, or paused for good. @param {Controller} controller */
export const isAtEnd = (controller) =>
  turnsOf(controller).length === 0 || controller.threads.every(({ levels, isOver }) => isOver || levels.every(isStill));

/** @param {Level} level */
function isStill({ language, machine, isPaused }) {
  if (isPaused || language === 'tp') return isPaused === true;
  const { tasks } = machine.state;
  return (
    tasks.some(({ status }) => status === 'paused') &&
    tasks.every(({ status, wake, fault }) => !fault && (status !== 'running' || wake === Infinity))
  );
}

/** @param {Controller} controller */
export function passTurn(controller) {
  const turns = turnsOf(controller);
  controller.turn = turns.find((one) => inOrder(one, controller.turn) > 0) ?? turns[0] ?? controller.turn;
}

/** The controller's memory goes to whoever has the turn: what is in it is the same, not a copy. @param {Controller} controller @param {Turn} [turn] */
export function share(controller, turn = controller.turn) {
  const [from, to] = [memoryOf(controller), levelAt(controller, turn).machine.state];
  if (from !== to) handOver(from, to);
  controller.last = turn;
}

/** @param {Memory} from @param {Memory} to */
export function handOver(from, to) {
  const { time, steps, ports, registers, positionRegisters, stringRegisters, system, pulses, timers, arm } = from;
  Object.assign(to, { time, steps, ports, registers, positionRegisters, stringRegisters, system, pulses, timers, arm });
}
