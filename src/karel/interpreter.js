/**
 * A KAREL program, run: a generator of effects. It moves nothing, writes nowhere and waits for nobody; it says what should
 * happen, and goes on when it is asked to. Everything that it knows is one plain state, which can be copied and put back.
 *
 * Effects: `write` { device, text }, `read` (put lines into `machine.state.input`, then go on), `wait` { milliseconds } (time
 * passed: inputs may change), `move` (say with `takeTime` of run/arm.js how long it takes, then go on), `call` { program, args } of what is no KAREL here (TP), `run-task`, `error` (POST_ERR), `alarm` { task } of a task that is
 * not the program's own,
 * `motion-control`, `hand`, `pause`, `step` { line } where they are wanted, and with them `turn` where a loop runs without any. The generator's value says how it ended:
 * `ended`, `aborted`, `alarm` with line and reason, `budget`, or `refused` with what the checker has against the program.
 *
 * @import { Fragment, Program } from './tree.js'
 * @import { Diagnostic } from './parse/cursor.js'
 * @import { Effect, Host, Idle, Machine, State } from './run/machine.js'
 * @import { AlarmText } from './run/values.js'
 *
 * @typedef {object} Outcome
 * @property {'ended' | 'aborted' | 'alarm' | 'budget' | 'refused'} status
 * @property {State} state
 * @property {AlarmText} [alarm]  of the program itself; that of another task is an effect
 * @property {Diagnostic[]} [diagnostics]
 */
import { Alarm, copiedState } from './run/values.js';
import { link } from './run/link.js';
import { firstGlobals } from './run/programs.js';
import { firstSystem } from './run/systemVariables.js';
import { abortTask, endTask } from './run/endings.js';
import { newTask, nextTask } from './run/tasks.js';
import { newArm } from './run/arm.js';
import { scanHandlers } from './run/occurrences.js';
import {
  currentLine,
  DEFAULT_STEPS,
  fileAt,
  finishMotion,
  passTime,
  pushFrame,
  runSlice,
  SCAN,
  waitUntil,
} from './run/machine.js';

/** @param {Program | Fragment} tree @param {Host} [host] @returns {Generator<Effect, Outcome, unknown>} */
export function* runKarel(tree, host = {}) {
  const { machine, errors } = createMachine(tree, host);
  if (errors.length) return { status: 'refused', state: machine.state, diagnostics: errors };
  return yield* runMachine(machine);
}

/** Its code, which machines can share. @param {Program | Fragment} tree @param {Host} [host] */
export const linkKarel = (tree, host = {}) =>
  link(
    tree.kind === 'program' ? tree : { kind: 'program', comments: [], name: 'fragment', declarations: [], body: [] },
    host,
  );

/** Whether a program has the motion group from its beginning. @param {Program | Fragment} tree */
export const hasGroup = (tree) =>
  tree.kind !== 'program' ||
  !tree.declarations.some((one) => one.kind === 'directive' && one.name.toUpperCase() === 'NOLOCKGROUP');

/** A machine that is about to begin. @param {Program | Fragment} tree @param {Host} [host] @param {ReturnType<typeof linkKarel>} [linker] */
export function createMachine(tree, host = {}, linker = linkKarel(tree, host)) {
  const { image } = linker;
  const [main] = linker.names;
  /** @type {State} */
  const state = {
    ...{ time: 0, steps: 0, nextScan: SCAN, current: 0 },
    globals: linker.analyses.map((analysis) => firstGlobals(analysis, host)),
    tasks: [newTask(main)],
    ...{ handlers: [], ports: {}, registers: {}, positionRegisters: {}, stringRegisters: {} },
    files: Object.fromEntries(Object.entries(host.files ?? {}).map(([name, text]) => [name.toUpperCase(), text])),
    input: [...(host.input ?? [])],
    args: [],
    ...{ semaphores: {}, system: firstSystem(), timers: [], pulses: [], arm: newArm(hasGroup(tree) ? main : null) },
  };
  /** @type {Machine} */
  const machine = { image, linker, state, host, effect: null, globals: state.globals[0] };
  pushFrame(machine, state.tasks[0], 0, [], -1);
  return {
    machine,
    errors: linker.analyses.flatMap(({ diagnostics }) => diagnostics.filter(({ severity }) => severity === 'error')),
  };
}

/** The state as it is, to be put back with `restoreState`. @param {Machine} machine */
export const saveState = (machine) => copiedState(machine.state);

/** @param {Machine} machine @param {State} state */
export function restoreState(machine, state) {
  machine.state = copiedState(state);
  machine.effect = null;
}

/** From where the machine is. @param {Machine} machine @returns {Generator<Effect, Outcome, unknown>} */
export function* runMachine(machine) {
  const turns = runTurns(machine);
  for (let next = turns.next(); ; next = turns.next()) {
    if (next.done) {
      if (next.value.status === 'ended') yield* finishMotion(machine.state);
      return next.value;
    }
    const effect = next.value;
    if (effect.kind === 'turn' && !machine.host.traceSteps) continue;
    yield effect.kind === 'idle' ? waitUntil(machine.state, /** @type {Idle} */ (effect)) : effect;
  }
}

/** The same, for whoever has the time: `turn` where others may have theirs, and `idle` where it has nothing to do. @param {Machine} machine @returns {Generator<Effect, Outcome, unknown>} */
export function* runTurns(machine) {
  const most = machine.host.steps ?? DEFAULT_STEPS;
  while (true) {
    scan(machine);
    const { state } = machine;
    const failed = state.tasks.findIndex(({ status, fault }) => fault && status === 'ended');
    if (failed >= 0) {
      const { name, fault } = state.tasks[failed];
      delete state.tasks[failed].fault;
      const alarm = /** @type {AlarmText} */ (fault);
      if (failed === 0) return { status: 'alarm', state, alarm };
      yield { kind: 'alarm', task: name, line: alarm.line, alarm };
      continue; // as from a state that is put back: others may have had their turn meanwhile
    }
    if (state.steps >= most) return { status: 'budget', state };
    const turn = nextTask(state);
    if (turn >= 0) {
      state.current = turn;
      const effect = runTurn(machine, most - state.steps);
      if (effect) yield effect;
      continue;
    }
    const wakes = state.tasks.flatMap(({ status, wake }) => (status === 'running' ? [wake] : []));
    // another program of the controller may let it go on
    const isPaused = machine.host.taskNamed !== undefined && state.tasks.some(({ status }) => status === 'paused');
    if (wakes.length === 0 && !isPaused) return { status: state.tasks[0].isAborted ? 'aborted' : 'ended', state };
    yield { kind: 'idle', until: Math.min(...wakes, state.nextScan), line: currentLine(machine) };
  }
}

/** One turn of the current task. @param {Machine} machine @param {number} most  instructions @returns {Effect | null} */
function runTurn(machine, most) {
  const task = machine.state.tasks[machine.state.current];
  try {
    const how = runSlice(machine, most);
    const { effect } = machine;
    machine.effect = null;
    if (how === 'slice') return { kind: 'turn', line: currentLine(machine) };
    if (effect) {
      const frame = task.frames.at(-1);
      const file = fileAt(machine, frame, (frame?.pc ?? 0) - 1);
      if (file !== undefined) effect.file = file;
    }
    if (how !== 'over') return effect;
    endTask(machine, machine.state.current);
    return null;
  } catch (alarm) {
    if (!(alarm instanceof Alarm)) throw alarm;
    const frame = task.frames.at(-1);
    const routine = frame ? machine.image.codes[frame.code].name : '';
    const file = fileAt(machine, frame);
    const at = { line: currentLine(machine), routine, ...(file !== undefined && { file }) };
    abortTask(machine, machine.state.current, { code: alarm.code, reason: alarm.message, ...at });
    return null;
  }
}

/** @param {Machine} machine */
function scan(machine) {
  const { state, host } = machine;
  passTime(machine);
  if (state.time < state.nextScan) return;
  state.nextScan = Math.floor(state.time / SCAN + 1) * SCAN;
  host.onScan?.(state);
  scanHandlers(machine, null);
}
