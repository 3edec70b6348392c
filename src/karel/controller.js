/**
 * KAREL and TP programs that call each other and run side by side, on one controller: its registers, ports, system variables, arm
 * and time are the same for all. A program that was called runs until it ends; then its caller goes on. Meanwhile other tasks of a
 * KAREL program that called go on, its condition handlers are looked at, and programs that RUN and RUN_TASK began have their turns.
 * Effects are those of the two interpreters, each with the name of its program; a call of a program that is not here stays an effect.
 *
 * @import { Refusal } from './controllerTasks.js'
 * @import { Caller, Controller, ControllerHost, Level, Programs } from './controllerTurns.js'
 * @import { Outcome } from './interpreter.js'
 * @import { Effect, Host, Idle, State } from './run/machine.js'
 * @import { Value } from './run/values.js'
 * @import { TpState } from './tp/run/memory.js'
 * @import { TpCode } from './tp/run/program.js'
 *
 * @typedef {Omit<Outcome, 'state'> & { program: string, state: State | TpState | null }} ControllerOutcome
 */
import { createMachine, linkKarel, runTurns } from './interpreter.js';
import { endThread, groupFor, refuse, taskAt, taskOnController } from './controllerTasks.js';
import { handOver, isAtEnd, levelAt, memoryOf, nextLevel, passTurn, share, turnsOf } from './controllerTurns.js';
import { freeGroup } from './run/arm.js';
import { finishMotion, SCAN, waitUntil } from './run/machine.js';
import { copiedState } from './run/values.js';
import { createTpMachine, runTpTurns } from './tp/interpreter.js';

const FIRST = { thread: 0, level: 0 };

/** @param {string} start @param {Programs} programs @param {ControllerHost} [host] @returns {Generator<Effect, ControllerOutcome, unknown>} */
export function* runController(start, programs, host = {}) {
  return yield* goOn(createController(start, programs, host));
}

/** @param {string} start  the name of the first program @param {Programs} programs @param {ControllerHost} [host] @param {Controller['linked']} [linked]  KAREL programs that are linked already, by names in capitals @returns {Controller} */
export function createController(start, programs, host = {}, linked = new Map()) {
  /** @type {Controller} */
  const controller = {
    ...{
      programs,
      host: {
        ...{ ...host, programs: programs.karel, ...lookingOnce(host) },
        taskNamed: (/** @type {string} */ name) => taskOnController(controller, name),
      },
      threads: [],
      globals: {},
      idle: new Map(),
      refusal: null,
    },
    ...{ turn: FIRST, last: FIRST, told: FIRST, linked },
  };
  const level = levelFor(start.toUpperCase(), [], controller);
  if (!level) throw new RangeError(`Expected a program that is here, got "${start}".`);
  controller.threads.push({ levels: [level], isOver: false });
  return controller;
}

/** Several programs look at their inputs, which change once. @param {Host} host @returns {Pick<Host, 'onScan'>} */
function lookingOnce({ onScan }) {
  let last = -1;
  return {
    onScan(state) {
      const look = Math.floor(state.time / SCAN);
      if (look !== last) onScan?.(state);
      last = look;
    },
  };
}

/** From where it is. @param {Controller} controller @returns {Generator<Effect, ControllerOutcome, unknown>} */
export function* goOn(controller) {
  /** @type {Map<Level, ReturnType<typeof runTurns> | ReturnType<typeof runTpTurns>>} */
  const going = new Map();
  const { host, threads } = controller;
  const idle = (controller.idle = new Map());
  while (true) {
    const { refusal } = controller;
    if (refusal) return { ...refusal, state: memoryOf(controller) };
    if (isAtEnd(controller) || (host.endsWithFirst && threads[0].isOver)) {
      share(controller, FIRST);
      yield* finishMotion(memoryOf(controller), threads[0].levels[0].name);
      return { status: 'ended', program: threads[0].levels[0].name, state: memoryOf(controller) };
    }
    const level = nextLevel(controller);
    if (!level) {
      const waiting = turnsOf(controller).map((turn) => levelAt(controller, turn));
      const until = (/** @type {Level} */ one) => idle.get(one)?.until ?? Infinity;
      const first = waiting.reduce((least, one) => (until(one) < until(least) ? one : least));
      const waits = /** @type {Idle} */ (idle.get(first));
      const effect = { ...waitUntil(memoryOf(controller), waits), in: first.name };
      share(controller, FIRST); // who goes on first does not depend on who was asked last
      controller.turn = FIRST;
      yield effect;
      continue;
    }
    share(controller);
    let run = going.get(level);
    if (!run)
      going.set(level, (run = level.language === 'karel' ? runTurns(level.machine) : runTpTurns(level.machine)));
    const next = run.next();
    /** @type {Omit<Outcome, 'state'> | null} */
    let ended = next.done ? next.value : null;
    if (!next.done) {
      const effect = next.value;
      if (effect.kind === 'idle') idle.set(level, /** @type {Idle} */ (effect));
      if (effect.kind === 'idle' || effect.kind === 'turn') passTurn(controller);
      if (effect.kind === 'idle' || (effect.kind === 'turn' && !host.traceSteps)) continue;
      if (effect.kind !== 'turn') {
        controller.told = controller.turn;
        const begun = begin(effect, controller);
        if (begun === true) {
          if (effect.isPaused) yield { kind: 'pause', line: firstLine(effect), in: String(effect.program) };
          continue;
        }
        const alarm = begun && refuse(controller, begun, Number(effect.line));
        if (begun && !alarm) continue;
        if (alarm) ended = { status: 'alarm', alarm };
      }
      if (!ended) {
        yield { ...effect, in: level.name };
        continue;
      }
    }
    if (!ended) continue;
    going.delete(level);
    const { turn } = controller;
    const thread = threads[turn.thread];
    const { status, alarm } = ended;
    const isOwn = turn.thread === 0 || thread.levels[0].caller !== null;
    if (status === 'budget' || (status !== 'ended' && isOwn))
      return { ...ended, state: level.machine.state, program: level.name };
    if (status === 'ended') idle.delete(release(level, controller));
    if (level.hasTaken) freeGroup(memoryOf(controller).arm, String(level.machine.state.task));
    if (status === 'ended' && thread.levels.length > 1) {
      const caller = { thread: turn.thread, level: turn.level - 1 };
      share(controller, caller);
      thread.levels.pop();
      controller.turn = controller.told = caller;
    } else endThread(controller, thread, status !== 'ended');
    if (thread.isOver) passTurn(controller);
    if (alarm) yield { kind: 'alarm', task: level.name, line: alarm.line, alarm, in: level.name };
  }
}

/** A call, or a program that is to run beside: begun, if it is here. @param {Effect} effect @param {Controller} controller @returns {boolean | Refusal} */
function begin(effect, controller) {
  if (effect.kind !== 'call' && effect.kind !== 'run-task') return false;
  const { threads, turn } = controller;
  const name = String(effect.program).toUpperCase();
  const before = threads.findIndex(
    ({ levels, isOver }) => effect.kind === 'run-task' && levels[0].name === name && !isOver,
  );
  if (before >= 0) {
    effect.runsAlready = true;
    return false;
  }
  const level = levelFor(name, /** @type {Value[]} */ (effect.args ?? []), controller);
  if (!level) return false;
  if (!goTo(level, firstLine(effect)))
    return { code: 'line', reason: `${name} has no line ${firstLine(effect)} to begin at` };
  const group = groupFor(controller, effect, name);
  if ('reason' in group) return group;
  handOver(memoryOf(controller), level.machine.state);
  level.machine.state.task = effect.kind === 'call' ? taskAt(controller) : level.language === 'tp' ? name : undefined;
  level.hasTaken = effect.kind === 'call' && group.isTaken;
  if (effect.kind === 'call') level.caller = callerAt(controller);
  const { levels } = threads[turn.thread];
  const isTop = turn.level === levels.length - 1;
  if (effect.kind === 'call' && isTop && !level.caller?.task) {
    levels.push(level);
    controller.turn = { thread: turn.thread, level: levels.length - 1 };
    return true;
  }
  const free = threads.findIndex(({ isOver }, i) => i > 0 && isOver);
  threads.splice(free < 0 ? threads.length : free, 1, { levels: [level], isOver: false });
  return true;
}

/** The line at which a program of TP is to begin: 0 is its first. @param {Effect} effect */
const firstLine = ({ from }) => Number(from) || 1;

/** Programs of KAREL begin at their beginning. @param {Level} level @param {number} line @returns {boolean} whether there is such a line */
function goTo({ language, machine }, line) {
  if (language === 'karel') return true;
  const [frame] = machine.state.frames;
  const { lines } = /** @type {TpCode} */ (machine.codes.get(frame.program));
  frame.at = line - 1;
  return line === 1 || (line > 0 && line <= lines.length);
}

/** Who calls waits. @param {Controller} controller @returns {Caller | null} null: a TP program, which waits by itself */
function callerAt(controller) {
  const { turn } = controller;
  const { language, machine } = levelAt(controller, turn);
  if (language !== 'karel') return null;
  const { tasks, current } = machine.state;
  const { frames } = tasks[current];
  frames[frames.length - 1].isCalling = true;
  tasks[current].wake = Infinity;
  return { ...turn, task: current, depth: frames.length - 1 };
}

/** Whoever called a program that is over goes on. @param {Level} level @param {Controller} controller @returns {Level} who that is, or itself */
function release(level, controller) {
  if (!level.caller) return level;
  const caller = levelAt(controller, level.caller);
  const task = caller.language === 'karel' ? caller.machine.state.tasks[level.caller.task] : undefined;
  if (!task) return level;
  delete task.frames[level.caller.depth]?.isCalling;
  task.wake = 0;
  return caller;
}

/** What is known of the controller, as it is now. @param {Controller} controller */
export function saveController(controller) {
  const { threads, globals, turn, told } = controller;
  const memory = memoryOf(controller);
  for (const { levels } of threads) for (const { machine } of levels) handOver(memory, machine.state);
  const saved = threads.map(({ levels, isOver }) => ({
    isOver,
    levels: levels.map((level) => ({ ...level, machine: null, state: level.machine.state })),
  }));
  return copiedState({ threads: saved, globals, turn, told });
}

/** @param {Controller} controller @param {ReturnType<typeof saveController>} saved */
export function restoreController(controller, saved) {
  const { threads, globals, turn, told } = copiedState(saved);
  Object.assign(controller, { globals, refusal: null, turn, last: turn, told });
  const restored = threads.map(({ levels, isOver }) => ({
    isOver,
    levels: levels.map(({ name, language, state, caller, isPaused, hasTaken }) => {
      const level = levelFor(name, [], controller);
      if (!level || level.language !== language)
        throw new RangeError(`Expected a state of these programs, got one of "${name}".`);
      level.machine.state = /** @type {State & TpState} */ (state);
      return Object.assign(level, { caller, isPaused, hasTaken });
    }),
  }));
  controller.threads.splice(0, Infinity, ...restored);
}

/** @param {string} name  in capitals @param {Value[]} args @param {Controller} controller @returns {Level | null} */
function levelFor(name, args, controller) {
  const { programs, host, globals } = controller;
  const listing = named(programs.listings, name);
  if (listing) {
    const machine = createTpMachine(listing, host, { listings: programs.listings, args });
    return { name, language: 'tp', machine, caller: null };
  }
  const tree = named(programs.karel, name);
  if (!tree) return null;
  // Linked once: what a state counts (programs, routines) is the same when it is put back.
  const linker = controller.linked.get(name) ?? linkKarel(tree, host);
  controller.linked.set(name, linker);
  const { machine, errors } = createMachine(tree, host, linker);
  if (errors.length)
    controller.refusal = { status: 'refused', program: name, state: machine.state, diagnostics: errors };
  machine.state.globals = globals[name] ??= machine.state.globals;
  machine.state.args = args;
  return { name, language: 'karel', machine, caller: null };
}

/** @template T @param {Readonly<Record<string, T>> | undefined} all @param {string} name in capitals @returns {T | undefined} */
function named(all, name) {
  const key = Object.keys(all ?? {}).find((one) => one.toUpperCase() === name);
  return key === undefined ? undefined : all?.[key];
}
