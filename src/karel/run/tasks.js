/**
 * Tasks: programs that run side by side, by turns. A program is in one task at most, and all of them share the variables.
 *
 * @import { Builtin, Machine, State, Task } from './machine.js'
 */
import { PREDEFINED } from '../check/constants.js';
import { held, put } from './builtinsMath.js';
import { abortTask, changeTask } from './endings.js';
import { pushFrame } from './machine.js';
import { linkedProgram } from './programs.js';
import { number, text, truth } from './values.js';

/** Numbers that are not zero; those of a controller are not known. */
const NO_PROGRAM = 7073;
const RUNS_ALREADY = 1;
const NO_TASK = 2;

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

/** @param {State} state @param {unknown} name */
const taskNamed = ({ tasks }, name) => tasks.find((task) => task.name === text(name).toUpperCase());

/** @type {Builtin} */
const runTask = ([name, , isPaused, , , status], machine) => {
  const { state, linker, image } = machine;
  const program = text(name).toUpperCase();
  const index = linkedProgram(machine, program);
  if (index < 0) {
    // A TP program, or one that nobody has here.
    machine.effect = { kind: 'run-task', program, args: [] };
    return put(status, 0);
  }
  if (linker.analyses[index].diagnostics.some(({ severity }) => severity === 'error')) return put(status, NO_PROGRAM);
  const before = taskNamed(state, program);
  if (before && before.status !== 'ended') return put(status, RUNS_ALREADY);
  const task = before ?? newTask(program);
  if (!before) state.tasks.push(task);
  Object.assign(task, { ...newTask(program), wake: state.time, status: truth(isPaused) ? 'paused' : 'running' });
  pushFrame(machine, task, image.entries[`${program}.`], [], -1);
  return put(status, 0);
};

/** @param {Machine} machine @param {unknown} name @param {Task['status']} becomes @param {unknown} status */
function setTask(machine, name, becomes, status) {
  const task = taskNamed(machine.state, name);
  put(status, task ? 0 : NO_TASK);
  if (!task || task.status === 'ended') return;
  const index = machine.state.tasks.indexOf(task);
  if (becomes === 'ended') abortTask(machine, index);
  else changeTask(machine, index, becomes);
}

/** @type {Readonly<Record<string, Builtin>>} */
export const TASKS = {
  RUN_TASK: runTask,
  ABORT_TASK: ([name, , , status], machine) => setTask(machine, name, 'ended', status),
  PAUSE_TASK: ([name, , , status], machine) => setTask(machine, name, 'paused', status),
  CONT_TASK: ([name, status], machine) => setTask(machine, name, 'running', status),
  GET_TSK_INFO: ([name, index, attribute, integer, string, status], { state, image }) => {
    const wanted = held(name) ?? '';
    const task = text(wanted) === '' ? state.tasks[state.current] : taskNamed(state, wanted);
    put(status, task ? 0 : NO_TASK);
    if (!task) return;
    put(name, task.name);
    put(index, state.tasks.indexOf(task) + 1);
    const frame = task.frames.at(-1);
    const asked = number(attribute);
    if (asked === constant('TSK_STATUS')) put(integer, constant(STATUS_OF[task.status]));
    if (asked === constant('TSK_LINENUM')) put(integer, frame ? (image.codes[frame.code].lines[frame.pc] ?? 0) : 0);
    if (asked === constant('TSK_PROGNAME')) put(string, task.name);
    if (asked === constant('TSK_ROUTNAME')) put(string, frame ? image.codes[frame.code].name.toUpperCase() : '');
  },
  CURR_PROG: (_, { state }) => state.tasks[state.current].name,
};
