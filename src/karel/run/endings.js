/**
 * How tasks end, and pause: by ABORT, by an alarm, by another task. Condition handlers of the task may watch for it
 * (`WHEN ABORT DO`): what they do is still done, and NOABORT among it lets the task go on. An alarm lets nothing go on.
 *
 * The motion of a task goes with it: it is cancelled where the task is aborted, and held while it is paused. The motion group is
 * free again when the task that has it is over.
 *
 * @import { Machine, State } from './machine.js'
 * @import { AlarmText } from './values.js'
 */
import { advanceArm, cancelMotionsOf, freeGroup, pauseMotionOf } from './arm.js';
import { scanHandlers } from './occurrences.js';

/** What a variable says that was never set; numbers of other alarms are not known. */
const UNSET_ERROR = 12311;

/** The task as the controller has it: that of whoever called the program, where it was called. @param {Pick<State, 'tasks' | 'task'>} state @param {number} index */
export const taskName = ({ tasks, task }, index) => (index === 0 && task !== undefined ? task : tasks[index].name);

/** @param {Machine} machine @param {number} index  of the task @param {AlarmText} [fault]  why it ends */
export function abortTask(machine, index, fault) {
  const task = machine.state.tasks[index];
  const isEnding = task.isAborted;
  const depth = task.frames.length;
  Object.assign(task, { isAborted: true, noAbort: false, wake: 0 }, fault && { fault });
  if (!isEnding) {
    if (fault) scanHandlers(machine, { name: 'ERROR', number: fault.code === 'uninitialised' ? UNSET_ERROR : 0 });
    scanHandlers(machine, { name: 'ABORT', number: 0, task: index });
  }
  if (task.frames.length === depth) return endTask(machine, index);
  task.status = 'running';
  task.ending = depth;
}

/** @param {Machine} machine @param {number} index  of the task */
export function endTask({ state }, index) {
  const task = state.tasks[index];
  task.status = 'ended';
  if (index === 0 && state.task !== undefined) return; // the task goes on where this was called
  advanceArm(state.arm, state.time);
  if (task.isAborted) cancelMotionsOf(state.arm, task.name);
  freeGroup(state.arm, task.name);
}

/** @param {Machine} machine @param {number} index  of the task @param {'running' | 'paused'} becomes */
export function changeTask(machine, index, becomes) {
  const { state } = machine;
  state.tasks[index].status = becomes;
  advanceArm(state.arm, state.time);
  pauseMotionOf(state.arm, taskName(state, index), becomes === 'paused');
  scanHandlers(machine, { name: becomes === 'paused' ? 'PAUSE' : 'CONTINUE', number: 0, task: index });
}
