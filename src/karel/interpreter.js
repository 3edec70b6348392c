/**
 * A KAREL program, run: a generator of effects. It moves nothing, writes nowhere and waits for nobody; it says what should
 * happen, and goes on when it is asked to. Everything that it knows is one plain state, which can be copied and put back.
 *
 * Effects: `write` { device, text }, `read` (put lines into `machine.state.input`, then go on), `wait` { milliseconds } (time
 * passed: inputs may change), `move`, `call` { program, args } of what is no KAREL here (TP), `run-task`, `error` (POST_ERR),
 * `motion-control`, `hand`, `pause`, `step` { line } where they are wanted. The generator's value says how it ended:
 * `ended`, `aborted`, `alarm` with line and reason, `budget`, or `refused` with what the checker has against the program.
 *
 * @import { Fragment, Program } from './tree.js'
 * @import { Diagnostic } from './parse/cursor.js'
 * @import { Effect, Host, Machine, State } from './run/machine.js'
 *
 * @typedef {object} Outcome
 * @property {'ended' | 'aborted' | 'alarm' | 'budget' | 'refused'} status
 * @property {State} state
 * @property {{ code: string, reason: string, line: number, routine: string }} [alarm]
 * @property {Diagnostic[]} [diagnostics]
 */
import { Alarm, copiedState, unsetValue } from './run/values.js';
import { link } from './run/link.js';
import { currentLine, DEFAULT_STEPS, passTime, pushFrame, runSlice, SCAN, scanHandlers } from './run/machine.js';

/** @param {Program | Fragment} tree @param {Host} [host] @returns {Generator<Effect, Outcome, unknown>} */
export function* runKarel(tree, host = {}) {
  const { machine, errors } = createMachine(tree, host);
  if (errors.length) return { status: 'refused', state: machine.state, diagnostics: errors };
  return yield* runMachine(machine);
}

/** A machine that is about to begin. @param {Program | Fragment} tree @param {Host} [host] */
export function createMachine(tree, host = {}) {
  const program =
    tree.kind === 'program'
      ? tree
      : { kind: /** @type {const} */ ('program'), comments: [], name: 'fragment', declarations: [], body: [] };
  const { image, analyses } = link(program, host);
  /** @type {State} */
  const state = {
    ...{ time: 0, steps: 0, nextScan: SCAN, current: 0 },
    globals: analyses.map(({ scope }) => {
      const values = new Array(scope.globalSlots);
      for (const symbol of scope.globals.values())
        if (symbol.kind === 'variable') values[symbol.slot] = unsetValue(symbol.type);
      return values;
    }),
    tasks: [{ name: program.name.toUpperCase(), frames: [], wake: 0, status: 'running' }],
    ...{ handlers: [], ports: {}, registers: {}, positionRegisters: {}, stringRegisters: {} },
    files: Object.fromEntries(Object.entries(host.files ?? {}).map(([name, text]) => [name.toUpperCase(), text])),
    input: [...(host.input ?? [])],
    ...{ semaphores: {}, system: {}, timers: [], pulses: [] },
  };
  /** @type {Machine} */
  const machine = { image, state, host, effect: null, globals: state.globals[0] };
  pushFrame(machine, state.tasks[0], 0, [], -1);
  return {
    machine,
    errors: analyses.flatMap(({ diagnostics }) => diagnostics.filter(({ severity }) => severity === 'error')),
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
  const { host } = machine;
  const most = host.steps ?? DEFAULT_STEPS;
  try {
    while (true) {
      const { state } = machine;
      if (state.steps >= most) return { status: 'budget', state };
      const task = state.tasks[state.current];
      if (task.wake > state.time) {
        const milliseconds = Math.min(task.wake, state.nextScan) - state.time;
        if (milliseconds > 0) state.time += milliseconds;
        state.steps++;
        yield { kind: 'wait', milliseconds, line: currentLine(machine) };
      } else {
        const how = runSlice(machine, most - state.steps);
        const effect = takeEffect(machine);
        if (how === 'over') return { status: effect?.kind === 'abort' ? 'aborted' : 'ended', state: machine.state };
        if (effect) yield effect;
      }
      scan(machine);
    }
  } catch (alarm) {
    if (!(alarm instanceof Alarm)) throw alarm;
    const { state, image } = machine;
    const frame = state.tasks[state.current].frames.at(-1);
    const routine = frame ? image.codes[frame.code].name : '';
    return {
      status: 'alarm',
      state,
      alarm: { code: alarm.code, reason: alarm.message, line: currentLine(machine), routine },
    };
  }
}

/** @param {Machine} machine */
function takeEffect(machine) {
  const { effect } = machine;
  machine.effect = null;
  return effect;
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
