/**
 * Tasks: programs that run side by side, by turns. A program is in one task at most, and all of them share the variables.
 *
 * @import { Builtin, Machine, OtherTask, State, Task } from './machine.js'
 */
import { PREDEFINED } from '../check/constants.js';
import { held, put } from './builtinsMath.js';
import { freeGroup, takeGroup } from './arm.js';
import { abortTask, changeTask, taskName } from './endings.js';
import { pushFrame } from './machine.js';
import { linkedProgram } from './programs.js';
import { number, text } from './values.js';

/** Numbers that are not zero; those of a controller are not known. */
const NO_PROGRAM = 7073;
const RUNS_ALREADY = 1;
const NO_TASK = 2;
/** PROG-040: another task has the motion group. */
const GROUP_IS_HELD = 3040;

/** @param {string} name of a predefined constant */
const constant = (name) => PREDEFINED.get(name)?.value;
const STATUS_OF = { running: 'PG_RUNNING', paused: 'PG_PAUSED', ended: 'PG_ABORTED' };

/** Whose turn it is: the next one that is neither over nor waiting; −1 where all are. @param {State} state */
export function nextTask({ tasks, current, time }) {
  for (let step = 1; step <= tasks.length; step++) {
    const index = (current + step) % tasks.length;
    const task = tasks[index];
    if (task.status === 'running' && task.wake <= time) return index;
  }
  return -1;
}

/** A task that is about to begin. @param {string} name @returns {Task} */
export const newTask = (name) => ({ name, frames: [], wake: 0, status: 'running', isAborted: false });

/** Its own, which runs by itself, or one of another program. @param {Machine} machine @param {unknown} name  none: that which asks @returns {OtherTask | null} */
function taskNamed(machine, name) {
  const { state, host } = machine;
  const wanted = text(name).toUpperCase() || taskName(state, state.current);
  const index = state.tasks.findIndex((task, i) => task.name === wanted && (i > 0 || state.task === undefined));
  return host.taskNamed?.(wanted) ?? (index < 0 ? null : ownTask(machine, index));
}

/** A task of a KAREL program. @param {Machine} machine @param {number} index @returns {OtherTask} */
export function ownTask(machine, index) {
  const { state, image } = machine;
  const { name, status, frames } = state.tasks[index];
  const frame = frames.at(-1);
  return {
    ...{ name, number: index + 1, status, program: name },
    line: frame ? (image.codes[frame.code].lines[frame.pc] ?? 0) : 0,
    routine: frame ? image.codes[frame.code].name.toUpperCase() : '',
    become(becomes) {
      if (becomes === 'ended') abortTask(machine, index);
      else changeTask(machine, index, becomes);
    },
  };
}

/** Of the groups that are to be locked the first is the arm. @param {unknown} mask */
export const isOfGroup = (mask) => (number(mask) & 1) === 1;

/** @type {Builtin} */
const runTask = ([name, line, , , mask, status], machine) => {
  const { state, linker, image } = machine;
  const program = text(name).toUpperCase();
  const running = taskNamed(machine, program);
  if (running && running.status !== 'ended') return put(status, RUNS_ALREADY);
  const index = linkedProgram(machine, program);
  const isFaulty = index >= 0 && linker.analyses[index].diagnostics.some(({ severity }) => severity === 'error');
  if (isFaulty) return put(status, NO_PROGRAM);
  if (isOfGroup(mask) && state.arm.holder !== null) return put(status, GROUP_IS_HELD);
  put(status, 0);
  // A TP program, or one that nobody has here.
  if (index < 0)
    return void (machine.effect = { kind: 'run-task', program, args: [], from: number(line), mask: number(mask) });
  const before = state.tasks.find((task) => task.name === program);
  const task = before ?? newTask(program);
  if (!before) state.tasks.push(task);
  Object.assign(task, { ...newTask(program), wake: state.time });
  if (isOfGroup(mask)) takeGroup(state.arm, program);
  pushFrame(machine, task, image.entries[`${program}.`], [], -1);
};

/** @param {Machine} machine @param {unknown} name @param {Task['status']} becomes @param {unknown} status */
function setTask(machine, name, becomes, status) {
  const task = taskNamed(machine, name);
  put(status, task ? 0 : NO_TASK);
  if (!task || task.status === 'ended') return;
  task.become(becomes);
  machine.effect = { kind: 'turn' }; // it may be the one that runs
}

/** @type {Readonly<Record<string, Builtin>>} */
export const TASKS = {
  RUN_TASK: runTask,
  ABORT_TASK: ([name, , , status], machine) => setTask(machine, name, 'ended', status),
  PAUSE_TASK: ([name, , , status], machine) => setTask(machine, name, 'paused', status),
  CONT_TASK: ([name, status], machine) => setTask(machine, name, 'running', status),
  GET_TSK_INFO: ([name, index, attribute, integer, string, status], machine) => {
    const task = taskNamed(machine, held(name) ?? '');
    put(status, task ? 0 : NO_TASK);
    if (!task) return;
    put(name, task.name);
    put(index, task.number);
    const asked = number(attribute);
    if (asked === constant('TSK_STATUS')) put(integer, constant(STATUS_OF[task.status]));
    if (asked === constant('TSK_LINENUM')) put(integer, task.line);
    if (asked === constant('TSK_PROGNAME')) put(string, task.program);
    if (asked === constant('TSK_ROUTNAME')) put(string, task.routine);
  },
  MOTION_CTL: (_, { state }) => state.arm.holder === taskName(state, state.current),
  LOCK_GROUP: ([mask, status], { state }) =>
    put(status, !isOfGroup(mask) || takeGroup(state.arm, taskName(state, state.current)) ? 0 : GROUP_IS_HELD),
  UNLOCK_GROUP: ([mask, status], { state }) => {
    if (isOfGroup(mask)) freeGroup(state.arm, taskName(state, state.current));
    put(status, 0);
  },
  CURR_PROG: (_, { state }) => state.tasks[state.current].name,
};
