/**
 * The machine that runs compiled KAREL: its state, which is plain data, and the loop that executes it. Time is simulated:
 * statements take a little, DELAY and waiting take what they say; nothing here knows of a clock.
 *
 * @import { Program } from '../tree.js'
 * @import { Analysis } from '../check/analysis.js'
 * @import { AlarmText, Reference, Value } from './values.js'
 * @import { Arm } from './arm.js'
 *
 * @typedef {(machine: Machine, frame: Frame) => number} Instruction  gives the next program counter, or one of the marks below
 * @typedef {object} Code
 * @property {string} name
 * @property {number} program      whose globals it knows
 * @property {number} slots
 * @property {Instruction[]} instructions
 * @property {number[]} lines
 * @property {(string | undefined)[]} files   those that %INCLUDE has brought, where the lines are in such
 * @property {((machine: Machine) => Value)[]} initial  by slot: what a local holds at first
 *
 * @typedef {object} Frame
 * @property {number} code
 * @property {number} pc
 * @property {Value[]} locals
 * @property {number} result         where in the caller's locals
 * @property {boolean} [isCalling]   a program that runs elsewhere, and waits for its end
 *
 * @typedef {object} Task
 * @property {string} name
 * @property {Frame[]} frames
 * @property {number} wake
 * @property {'running' | 'paused' | 'ended'} status
 * @property {boolean} [isAborted]
 * @property {AlarmText} [fault]    why it ends, until that is told
 * @property {number} [ending]      it ends, once what its handlers do is done: so many frames are below that
 * @property {boolean} [noAbort]    NOABORT was said
 * @property {boolean} [noPause]    NOPAUSE, UNPAUSE or CONTINUE was said
 *
 * @typedef {object} Handler
 * @property {number} number
 * @property {number} task
 * @property {number} handler
 * @property {boolean} isEnabled
 * @property {boolean[][]} before
 * @property {number} [motion]   for how long it lasts: that of a MOVE
 * @property {number} [depth]    of the frame that it is in
 *
 * @typedef {object} State
 * @property {number} time            ms
 * @property {number} steps
 * @property {number} nextScan
 * @property {Value[][]} globals      by program
 * @property {Task[]} tasks
 * @property {number} current         the task that runs
 * @property {string} [task]          the task that the first one is part of: it was called by another program
 * @property {Handler[]} handlers
 * @property {Record<string, Record<string, Value>>} ports
 * @property {Record<string, Value>} registers
 * @property {Record<string, Value>} positionRegisters
 * @property {Record<string, Value>} stringRegisters
 * @property {Record<string, string>} files
 * @property {string[]} input         lines that wait to be read
 * @property {Value[]} args           with which a TP program has called it
 * @property {Record<string, number>} semaphores
 * @property {Record<string, boolean>} [simulatedPorts]  by their names, as DIN[1]
 * @property {{ code: number, message: string, severity: number, time: number, program: string, count: number }} [posted]  by POST_ERR, last
 * @property {Record<string, Value>} system     system variables by their text
 * @property {{ holder: Record<string | number, Value>, key: string | number, since: number, from: number }[]} timers
 * @property {{ kind: string, port: string, index: number, value: boolean, at: number }[]} pulses
 * @property {Arm} arm
 *
 * @typedef {{ kind: string, line?: number, file?: string, [detail: string]: unknown }} Effect  file: that %INCLUDE has brought, where the line is in one
 * @typedef {{ kind: 'idle', until: number, line: number, [detail: string]: unknown }} Idle  whoever says so has nothing to do until then
 * @typedef {{ codes: Code[], handlers: CompiledHandler[], entries: Record<string, number> }} Image
 * @typedef {{ conditions: ConditionTest[], actions: number[], lines: number[] }} CompiledHandler  actions: codes, or CANCELS
 * @typedef {(machine: Machine, frame: Frame, before: boolean[], event: Occurred | null) => boolean} ConditionTest
 * @typedef {{ name: string, number: number, task?: number }} Occurred  task: whose handlers alone it concerns
 *
 * @typedef {(machine: Machine, frame: Frame) => Value} Evaluate
 * @typedef {(machine: Machine, frame: Frame) => Reference} Locate
 * @typedef {(args: (Value | Reference)[], machine: Machine) => Value} Builtin
 *
 * @typedef {object} Machine
 * @property {Image} image
 * @property {{ analyses: readonly Analysis[], programNamed: (name: string) => number }} linker  programs as they are asked for
 * @property {State} state
 * @property {Host} host
 * @property {Effect | null} effect     set by an instruction that has one
 * @property {Value[]} globals          of the program that runs
 *
 * @typedef {object} OtherTask   that runs elsewhere on the controller
 * @property {string} name
 * @property {number} number
 * @property {Task['status']} status
 * @property {number} line
 * @property {string} program
 * @property {string} routine
 * @property {(status: Task['status']) => void} become
 *
 * @typedef {object} Kinematics   of the arm, in the frame and with the tool that $UFRAME and $UTOOL say
 * @property {(joints: readonly number[], system: State['system']) => readonly number[]} toPosition  x y z w p r and the configuration
 * @property {(position: readonly number[], system: State['system'], near?: readonly number[]) => readonly number[] | null} toJoints
 *   null: the arm has no posture there; near: joint values that are wanted near by
 *
 * @typedef {object} Host
 * @property {Readonly<Record<string, Program>>} [programs]  other KAREL programs by name
 * @property {Readonly<Record<string, string>>} [sources]     for %INCLUDE
 * @property {boolean} [hasGaps]                              of their texts something is missing: names that nobody declares
 *   refuse no program, and stop it where they are met
 * @property {Readonly<Record<string, Readonly<Record<string, Value>>>>} [variables]  what they hold at first, by program and name
 * @property {Readonly<Record<string, string>>} [files]       what is on the device at the start
 * @property {readonly string[]} [input]                      lines for READ
 * @property {number} [steps]                                 so many instructions at most; 10 million if nothing is said
 * @property {boolean} [traceSteps]                           an effect before each statement
 * @property {() => readonly number[]} [joints]               where the arm is: pendant values
 * @property {() => readonly number[]} [position]             x y z w p r of the tool
 * @property {Kinematics} [kinematics]
 * @property {(joints: readonly number[]) => boolean} [isInRange]  whether all are within their limits; pendant values
 * @property {(state: State) => void} [onScan]                inputs may change here
 * @property {(name: string) => OtherTask | null} [taskNamed]  a task of another program
 */
import { advanceArm, nextOfArm } from './arm.js';
import { Alarm } from './values.js';

/** The frame changed: go on with the top one. */
export const SWITCH = -1;
/** There is an effect, or the task waits. */
export const HALT = -2;
/** The task is over. */
export const OVER = -3;

/** The shortest time between two looks at the conditions, by the manual. */
export const SCAN = 8;

/** What a statement takes, in ms. A guess: without it a loop that waits for a timer would never end. */
export const STATEMENT_TIME = 0.01;

/** Instructions before other tasks, handlers and timers are looked at. */
const SLICE = 400;

export const DEFAULT_STEPS = 10_000_000;

/** Run the current task for a while. @param {Machine} machine @param {number} most  instructions @returns {'slice' | 'halt' | 'over'} */
export function runSlice(machine, most) {
  const { state, image } = machine;
  const task = state.tasks[state.current];
  let left = Math.min(most, SLICE);
  const planned = left;
  let frame = task.frames[task.frames.length - 1];
  let { instructions } = image.codes[frame.code];
  machine.globals = state.globals[image.codes[frame.code].program];
  let { pc } = frame;
  try {
    if (frame.isCalling) return callOn(task);
    while (left > 0) {
      left--;
      const next = instructions[pc](machine, frame);
      if (next >= 0) pc = next;
      else if (next === SWITCH) {
        frame = task.frames[task.frames.length - 1];
        instructions = image.codes[frame.code].instructions;
        machine.globals = state.globals[image.codes[frame.code].program];
        pc = frame.pc;
        if (frame.isCalling) return callOn(task);
      } else {
        pc = frame.pc;
        return next === OVER ? 'over' : 'halt';
      }
    }
    return 'slice';
  } finally {
    frame.pc = pc;
    state.steps += planned - left;
    state.time += (planned - left) * STATEMENT_TIME;
  }
}

/** What interrupted a call is over; the call is not. @param {Task} task @returns {'halt'} */
function callOn(task) {
  task.wake = Infinity;
  return 'halt';
}

/** The line that the current task is at. @param {Machine} machine */
export function currentLine({ state, image }) {
  const frame = state.tasks[state.current]?.frames.at(-1);
  return frame ? (image.codes[frame.code].lines[frame.pc] ?? 0) : 0;
}

/** The file that %INCLUDE has brought, where an instruction is in one. @param {Machine} machine @param {Frame | undefined} frame @param {number} [pc] */
export const fileAt = ({ image }, frame, pc = frame?.pc ?? 0) =>
  frame ? image.codes[frame.code].files[pc] : undefined;

/** Push a routine onto a task. @param {Machine} machine @param {Task} task @param {number} code @param {Value[]} args references @param {number} result @param {Value[]} [shared]  instead of locals of its own */
export function pushFrame(machine, task, code, args, result, shared) {
  if (task.frames.length > 500) throw new Alarm('routines call each other too deeply', 'stack');
  const { slots, initial } = machine.image.codes[code];
  const locals = shared ?? new Array(slots);
  for (let i = 0; i < args.length; i++) locals[i] = args[i];
  for (let i = args.length; i < initial.length; i++) locals[i] = initial[i](machine);
  task.frames.push({ code, pc: 0, locals, result });
}

/** What time brings: the arm moves, pulses end, timers run. @param {{ state: Pick<State, 'time' | 'timers' | 'pulses' | 'ports' | 'arm'> }} machine */
export function passTime({ state }) {
  advanceArm(state.arm, state.time);
  for (const { holder, key, since, from } of state.timers) holder[key] = Math.trunc(from + state.time - since) | 0;
  const over = state.pulses.filter(({ at }) => at <= state.time);
  if (over.length === 0) return;
  for (const { port, index, value } of over) (state.ports[port] ??= {})[index] = value;
  state.pulses = state.pulses.filter(({ at }) => at > state.time);
}

/** Nobody has anything to do: time goes on. @param {Pick<State, 'time' | 'steps'>} state @param {Idle} idle @returns {Effect} */
export function waitUntil(state, { until, line, program }) {
  const milliseconds = until - state.time;
  if (milliseconds > 0) state.time = until;
  state.steps++;
  return { kind: 'wait', milliseconds, line, ...(program !== undefined && { program }) };
}

/** Programs are over; a motion that nobody waits for is made to its end. @param {Pick<State, 'time' | 'steps' | 'arm' | 'timers' | 'pulses' | 'ports'>} state @param {string} [name]  of the program @returns {Generator<Effect, void>} */
export function* finishMotion(state, name) {
  for (passTime({ state }); nextOfArm(state.arm) < Infinity; passTime({ state })) {
    const until = Math.min(nextOfArm(state.arm), state.time + SCAN);
    yield {
      ...waitUntil(state, { kind: 'idle', until, line: state.arm.motion?.effect.line ?? 0 }),
      ...(name && { in: name }),
    };
  }
}

/** The actions of a handler are over, and with them the task, if it was ending. @type {Instruction} */
export function returnFromActions(machine) {
  const task = machine.state.tasks[machine.state.current];
  task.frames.pop();
  if (task.frames.length === 0) return OVER;
  if (task.ending === undefined || task.frames.length > task.ending) return SWITCH;
  delete task.ending;
  if (task.fault || !task.noAbort) return OVER;
  task.isAborted = false;
  return SWITCH;
}

/** @type {Instruction} */
export function returnNothing(machine) {
  const task = machine.state.tasks[machine.state.current];
  task.frames.pop();
  return task.frames.length ? SWITCH : OVER;
}
