/**
 * What condition handlers watch for while programs run. A handler is disabled when it fires.
 *
 * @import { Machine, Occurred } from './machine.js'
 */
import { cancelMotion, isUnderWay } from './arm.js';
import { pushFrame } from './machine.js';
import { Alarm } from './values.js';

/** Instead of actions: the motion is cancelled. */
export const CANCELS = -1;

/** Those of a MOVE, watched for as long as it is under way; once it is stopped they are not. @param {Machine} machine @param {number} handler @param {number} motion */
export function watchMotion({ state, image }, handler, motion) {
  state.handlers.push({
    ...{ number: 0, task: state.current, handler, isEnabled: true, motion },
    before: image.handlers[handler].conditions.map(() => []),
    depth: state.tasks[state.current].frames.length - 1,
  });
}

/** Handlers whose conditions are met fire: they are disabled, and their actions run as an interrupt of their task. @param {Machine} machine @param {Occurred | null} event */
export function scanHandlers(machine, event) {
  const { state, image } = machine;
  const { arm } = state;
  if (state.handlers.some(({ motion }) => motion !== undefined && !isUnderWay(arm, motion)))
    state.handlers = state.handlers.filter(({ motion }) => motion === undefined || isUnderWay(arm, motion));
  for (const handler of state.handlers) {
    if (!handler.isEnabled || (handler.motion !== undefined && handler.motion !== arm.motion?.number)) continue;
    if (event?.task !== undefined && event.task !== handler.task) continue;
    const task = state.tasks[handler.task];
    const frame = task?.frames[handler.depth ?? 0] ?? task?.frames[0];
    if (!task || task.status === 'ended' || !frame) continue;
    const { conditions, actions, lines } = image.handlers[handler.handler];
    machine.globals = state.globals[image.codes[frame.code].program];
    let line = 0;
    try {
      for (const [i, isMet] of conditions.entries()) {
        line = lines[i];
        if (!isMet(machine, frame, handler.before[i], event)) continue;
        handler.isEnabled = false;
        if (actions[i] === CANCELS) cancelMotion(arm);
        else pushFrame(machine, task, actions[i], [], -1, handler.depth === undefined ? undefined : frame.locals);
        // What interrupts does not wait for what it interrupts; the wait is looked at again afterwards.
        task.wake = Math.min(task.wake, state.time);
        break;
      }
    } catch (alarm) {
      if (!(alarm instanceof Alarm)) throw alarm;
      const { code, message: reason } = alarm;
      Object.assign(task, { status: 'ended', isAborted: true });
      task.fault ??= { code, reason, line, routine: 'condition handler' };
    }
  }
}
