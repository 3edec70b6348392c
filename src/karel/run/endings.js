/**
 * How tasks end before their end, and pause: by ABORT, by an alarm, by another task. Condition handlers of the task may watch for it
 * (`WHEN ABORT DO`): what they do is still done, and NOABORT among it lets the task go on. An alarm lets nothing go on.
 *
 * @import { Machine } from './machine.js'
 * @import { AlarmText } from './values.js'
 */
import { scanHandlers } from './occurrences.js';

/** What a variable says that was never set; numbers of other alarms are not known. */
const UNSET_ERROR = 12311;

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
  const isOver = task.frames.length === depth;
  task.status = isOver ? 'ended' : 'running';
  if (!isOver) task.ending = depth;
}

/** @param {Machine} machine @param {number} index  of the task @param {'running' | 'paused'} becomes */
export function changeTask(machine, index, becomes) {
  machine.state.tasks[index].status = becomes;
  scanHandlers(machine, { name: becomes === 'paused' ? 'PAUSE' : 'CONTINUE', number: 0, task: index });
}
