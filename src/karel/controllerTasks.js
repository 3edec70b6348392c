/**
 * Tasks of a controller: programs that RUN and RUN_TASK began, the program that was begun first, and the tasks of KAREL programs. What
 * a program calls is part of its task: it ends, pauses and goes on with it. One task has the motion group at a time.
 *
 * @import { Controller, Level, Programs, Thread } from './controllerTurns.js'
 * @import { Effect, OtherTask } from './run/machine.js'
 * @import { AlarmText } from './run/values.js'
 *
 * @typedef {Pick<AlarmText, 'code' | 'reason'>} Refusal   why a controller begins nothing
 */
import { levelAt, memoryOf, share } from './controllerTurns.js';
import { hasGroup } from './interpreter.js';
import { advanceArm, cancelMotionsOf, freeGroup, heldText, pauseMotionOf, takeGroup } from './run/arm.js';
import { abortTask, taskName } from './run/endings.js';
import { isOfGroup, ownTask } from './run/tasks.js';
import { hasTpGroup } from './tp/interpreter.js';

/** The task of whoever has the turn. @param {Controller} controller @returns {string} */
export function taskAt(controller) {
  const { language, machine } = levelAt(controller, controller.turn);
  return language === 'tp' ? machine.state.task : taskName(machine.state, machine.state.current);
}

/** All of them, in an order that lasts while they do. @param {Controller} controller @returns {OtherTask[]} */
const tasksOf = (controller) =>
  controller.threads
    .flatMap((thread, at) =>
      thread.levels.flatMap((one, level) => {
        if (one.language === 'tp') return level === 0 && !one.caller ? [listingTask(controller, thread)] : [];
        const { tasks, task } = one.machine.state;
        return tasks.flatMap((_, index) =>
          index === 0 && task !== undefined ? [] : [karelTask(controller, at, level, index)],
        );
      }),
    )
    .map((task, i) => ({ ...task, number: i + 1 }));

/** @param {Controller} controller @param {string} name  in capitals @returns {OtherTask | null} */
export const taskOnController = (controller, name) => tasksOf(controller).find((task) => task.name === name) ?? null;

/** A program of TP, and what it has called. @param {Controller} controller @param {Thread} thread @returns {OtherTask} */
function listingTask(controller, thread) {
  const [{ name, isPaused }] = thread.levels;
  return {
    ...{ name, number: 0, ...whereabouts(thread.levels[thread.levels.length - 1]) },
    status: thread.isOver ? 'ended' : isPaused ? 'paused' : 'running',
    become(status) {
      const { arm } = memoryOf(controller);
      if (status === 'ended') endThread(controller, thread, true);
      else {
        advanceArm(arm, memoryOf(controller).time);
        pauseMotionOf(arm, name, status === 'paused');
      }
      pause(thread.levels, status === 'paused');
    },
  };
}

/** @param {Level} level @returns {Pick<OtherTask, 'program' | 'routine' | 'line'>} */
function whereabouts({ language, machine, name }) {
  if (language === 'karel') return { ...ownTask(machine, 0), program: name };
  const frame = machine.state.frames.at(-1);
  return { program: frame?.program ?? name, routine: frame?.program ?? name, line: (frame?.at ?? -1) + 1 };
}

/** @param {Controller} controller @param {number} thread @param {number} level @param {number} index @returns {OtherTask} */
function karelTask(controller, thread, level, index) {
  const { machine } = /** @type {Extract<Level, { language: 'karel' }>} */ (levelAt(controller, { thread, level }));
  const own = ownTask(machine, index);
  const { levels } = controller.threads[thread];
  const above = levels.slice(level + 1).filter(() => (levels[level + 1].caller?.task ?? 0) === index);
  const beside = controller.threads.filter(
    ({ levels: [{ caller }], isOver }) =>
      !isOver && caller?.thread === thread && caller.level === level && caller.task === index,
  );
  const called = above.at(-1) ?? beside[0]?.levels.at(-1);
  return {
    ...own,
    ...(called && whereabouts(called)),
    become(status) {
      // its handlers are looked at, and see the controller's memory
      share(controller, { thread, level });
      controller.idle.delete(levelAt(controller, { thread, level }));
      own.become(status);
      if (status === 'ended' && machine.state.tasks[index].status === 'ended') {
        levels.length -= above.length;
        for (const one of beside) one.isOver = true;
      } else pause([...above, ...beside.flatMap((one) => one.levels)], status === 'paused');
      share(controller);
    },
  };
}

/** @param {readonly Level[]} levels @param {boolean} isPaused */
function pause(levels, isPaused) {
  for (const level of levels) level.isPaused = isPaused;
}

/** @param {Controller} controller @param {Thread} thread @param {boolean} isAborted */
export function endThread(controller, thread, isAborted) {
  const { arm } = memoryOf(controller);
  const [root] = thread.levels;
  thread.isOver = true;
  if (root.caller) return; // the task goes on where this was called
  advanceArm(arm, memoryOf(controller).time);
  if (isAborted) cancelMotionsOf(arm, root.name);
  freeGroup(arm, root.name);
}

/** Whether a program has the motion group from its beginning. @param {Programs} programs @param {string} name */
function isForGroup({ karel = {}, listings = {} }, name) {
  const own = (/** @type {readonly string[]} */ names) => names.find((one) => one.toUpperCase() === name);
  const listing = own(Object.keys(listings));
  if (listing !== undefined) return hasTpGroup(listings[listing]);
  const program = own(Object.keys(karel));
  return program !== undefined && hasGroup(karel[program]);
}

/**
 * The motion group goes to a program that begins, where it is to have it.
 * @param {Controller} controller
 * @param {Effect} effect   of kind call or run-task
 * @param {string} name     of the program, in capitals
 * @returns {{ isTaken: boolean } | Refusal}   isTaken: nobody had it; reason: another task has it, so that a controller
 *   begins nothing
 */
export function groupFor(controller, { kind, mask }, name) {
  const { arm } = memoryOf(controller);
  const isWanted = mask === undefined ? isForGroup(controller.programs, name) : isOfGroup(mask);
  if (!isWanted) return { isTaken: false };
  const wasFree = arm.holder === null;
  if (takeGroup(arm, kind === 'call' ? taskAt(controller) : name)) return { isTaken: wasFree };
  return { code: 'motion-group', reason: `${name} is to have the motion group, but ${heldText(arm)}` };
}

/** A program cannot begin what it asked for. @param {Controller} controller @param {Refusal} refusal @param {number} line @returns {AlarmText | null} null: KAREL, which tells by itself */
export function refuse(controller, refusal, line) {
  const level = levelAt(controller, controller.turn);
  const alarm = { ...refusal, line, routine: level.name };
  if (level.language === 'tp') return alarm;
  abortTask(level.machine, level.machine.state.current, alarm);
  return null;
}
