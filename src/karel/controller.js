/**
 * KAREL and TP programs that call each other, run on one controller: its registers, ports, system variables and time are the
 * same for all. A program that was called runs until it ends; then its caller goes on. Effects are those of the two
 * interpreters, each with the name of its program; a call of a program that is not here stays an effect.
 *
 * @import { Outcome } from './interpreter.js'
 * @import { Effect, Host, Machine, State } from './run/machine.js'
 * @import { Value } from './run/values.js'
 * @import { Memory, TpMachine, TpState } from './tp/run/memory.js'
 * @import { TpListing } from './tp/tree.js'
 * @import { Program } from './tree.js'
 *
 * @typedef {{ name: string, language: 'karel', machine: Machine } | { name: string, language: 'tp', machine: TpMachine }} Level
 *
 * @typedef {object} Controller
 * @property {Programs} programs
 * @property {Host} host
 * @property {Level[]} levels    who runs, last, and who waits for whom
 * @property {Record<string, Value[][]>} globals   what variables of KAREL programs hold between their runs
 * @property {Map<string, ReturnType<typeof linkKarel>>} linked   KAREL programs that have run
 * @property {Outcome | null} refusal              of a program that cannot run
 *
 * @typedef {object} Programs   by their names
 * @property {Readonly<Record<string, Program>>} [karel]
 * @property {Readonly<Record<string, TpListing>>} [listings]
 *
 * @typedef {Omit<Outcome, 'state'> & { program: string, state: State | TpState | null }} ControllerOutcome
 */
import { createMachine, linkKarel, runMachine } from './interpreter.js';
import { copiedState } from './run/values.js';
import { createTpMachine, runTpMachine } from './tp/interpreter.js';

/** @param {string} start @param {Programs} programs @param {Host} [host] @returns {Generator<Effect, ControllerOutcome, unknown>} */
export function* runController(start, programs, host = {}) {
  return yield* goOn(createController(start, programs, host));
}

/** @param {string} start  the name of the first program @param {Programs} programs @param {Host} [host] @returns {Controller} */
export function createController(start, programs, host = {}) {
  /** @type {Controller} */
  const controller = {
    ...{ programs, host: { ...host, programs: programs.karel }, levels: [], globals: {}, refusal: null },
    linked: new Map(),
  };
  if (!enter(start.toUpperCase(), [], controller))
    throw new RangeError(`Expected a program that is here, got "${start}".`);
  return controller;
}

/** From where it is. @param {Controller} controller @returns {Generator<Effect, ControllerOutcome, unknown>} */
export function* goOn(controller) {
  const { levels } = controller;
  const running = levels.map(run);
  while (true) {
    const level = levels.at(-1);
    if (controller.refusal || !level)
      return {
        status: 'ended',
        ...controller.refusal,
        program: level?.name ?? '',
        state: level?.machine.state ?? null,
      };
    const next = running[running.length - 1].next();
    if (!next.done) {
      const effect = next.value;
      if (
        effect.kind === 'call' &&
        enter(String(effect.program), /** @type {Value[]} */ (effect.args ?? []), controller)
      )
        running.push(run(/** @type {Level} */ (levels.at(-1))));
      else yield { ...effect, in: level.name };
      continue;
    }
    const caller = levels.at(-2);
    if (next.value.status !== 'ended' || !caller) return { ...next.value, program: level.name };
    levels.pop();
    running.pop();
    handOver(level.machine.state, caller.machine.state);
  }
}

/** @param {Level} level @returns {Generator<Effect, Omit<Outcome, 'state'> & { state: State | TpState }, unknown>} */
const run = (level) => (level.language === 'karel' ? runMachine(level.machine) : runTpMachine(level.machine));

/** What is known of the controller, as it is now. @param {Controller} controller */
export const saveController = ({ levels, globals }) =>
  copiedState({ levels: levels.map((level) => ({ ...level, machine: null, state: level.machine.state })), globals });

/** @param {Controller} controller @param {ReturnType<typeof saveController>} saved */
export function restoreController(controller, saved) {
  const { levels, globals } = copiedState(saved);
  controller.globals = globals;
  controller.refusal = null;
  controller.levels.splice(
    0,
    Infinity,
    ...levels.map(({ name, language, state }) => {
      const level = levelFor(name, [], controller);
      if (!level || level.language !== language)
        throw new RangeError(`Expected a state of these programs, got one of "${name}".`);
      level.machine.state = /** @type {State & TpState} */ (state);
      return level;
    }),
  );
}

/** @param {string} name  in capitals @param {Value[]} args @param {Controller} controller @returns {boolean} whether it is here */
function enter(name, args, controller) {
  const caller = controller.levels.at(-1);
  const level = levelFor(name, args, controller);
  if (!level) return false;
  if (caller) handOver(caller.machine.state, level.machine.state);
  controller.levels.push(level);
  return true;
}

/** @param {string} name @param {Value[]} args @param {Controller} controller @returns {Level | null} */
function levelFor(name, args, controller) {
  const { programs, host, globals } = controller;
  const listing = named(programs.listings, name);
  if (listing)
    return { name, language: 'tp', machine: createTpMachine(listing, host, { listings: programs.listings, args }) };
  const tree = named(programs.karel, name);
  if (!tree) return null;
  // Linked once: what a state counts (programs, routines) is the same when it is put back.
  const linker = controller.linked.get(name) ?? linkKarel(tree, host);
  controller.linked.set(name, linker);
  const { machine, errors } = createMachine(tree, host, linker);
  if (errors.length) controller.refusal = { status: 'refused', state: machine.state, diagnostics: errors };
  machine.state.globals = globals[name] ??= machine.state.globals;
  machine.state.args = args;
  return { name, language: 'karel', machine };
}

/** @template T @param {Readonly<Record<string, T>> | undefined} all @param {string} name in capitals @returns {T | undefined} */
function named(all, name) {
  const key = Object.keys(all ?? {}).find((one) => one.toUpperCase() === name);
  return key === undefined ? undefined : all?.[key];
}

/** The controller's memory goes from one program to the other: what is in it is the same, not a copy. @param {Memory} from @param {Memory} to */
function handOver(from, to) {
  const { time, steps, ports, registers, positionRegisters, stringRegisters, system, pulses, timers } = from;
  Object.assign(to, { time, steps, ports, registers, positionRegisters, stringRegisters, system, pulses, timers });
}
