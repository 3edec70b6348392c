/**
 * Runs the code that is open: in each of the page's frames some statements, and the arm where its motion is by then. What the
 * program wants done is done here, or said.
 *
 * @import { Page } from '../page.js'
 * @import { CodeRun, Place, Stop } from '../../model/code/codeDebugger.js'
 * @import { Problem } from '../../model/code/codeProblems.js'
 * @import { Planned } from '../../model/program/planned.js'
 *
 * @typedef {{ plan: Planned['plan'], time: number, start: readonly number[] }} Motion
 * @typedef {'idle' | 'running' | 'paused' | 'asks' | 'over'} Mode
 * @typedef {'run' | 'into' | 'over' | 'out'} Way   how far it goes
 */
import { codeArm } from '../../model/code/codeArm.js';
import { systemAtFirst } from '../../model/code/codeFrames.js';
import { planOfMove } from '../../model/code/codeMoves.js';
import { createCodeRun } from '../../model/code/codeRun.js';
import { LONGEST_FRAME } from '../../model/program/player.js';
import { postureAt } from '../../model/program/planPosture.js';
import { fromMilliseconds } from '../../model/units.js';
import { CODE } from '../words/code.js';

/** Statements a frame at most, and s of the page's time; so many statements are run before the clock is looked at. */
const STATEMENTS = 400;
const LONGEST_TURN = 0.008;
const AT_ONCE = 25;

/**
 * @param {Page} page
 * @param {object} acts
 * @param {() => void} acts.onChange      something of the run is another
 * @param {(place: Place) => boolean} acts.isBreakpoint
 */
export function createRunControl({ store, clock, announce, messages }, { onChange, isBreakpoint }) {
  /** @type {CodeRun | null} */
  let run = null;
  /** @type {Mode} */
  let mode = 'idle';
  let status = CODE.status.ready;
  /** @type {Motion | null} */
  let motion = null;
  /** s that the program has waited less than it said. */
  let owed = 0;
  /** @type {(place: Place) => boolean} */
  let isStop = () => false;
  /** @type {readonly string[]} */
  let said = [];
  let isRunning = false;
  /** @type {readonly number[] | null} where the run has put the arm last: the document's own list */
  let standing = null;

  const line = () => run?.place()?.line ?? 0;
  const arm = codeArm(() => store.state.doc);

  /** @param {Mode} next @param {string} text */
  function become(next, text) {
    const isOther = next !== mode || text !== status;
    mode = next;
    status = text;
    onChange();
    if (isOther && next !== 'running') announce(text);
  }

  /** @param {string} text */
  const say = (text) => void (said = [...said, text].slice(-100));

  /** @param {readonly number[]} posture */
  function put(posture) {
    store.dispatch({ type: 'stand', posture });
    standing = store.state.doc.posture;
  }

  /** @param {Stop} stop @returns {boolean} whether it goes on in this frame */
  function heed({ kind, effect }) {
    if (kind === 'over') {
      over();
      return false;
    }
    if (kind === 'line') {
      become('paused', CODE.status.paused(line()));
      return false;
    }
    switch (effect?.kind) {
      case 'wait':
        owed += fromMilliseconds(Number(effect.milliseconds));
        return owed <= 0;
      case 'move': {
        const { doc } = store.state;
        const planned = planOfMove(doc, doc.posture, effect, run?.state().system ?? {});
        const reason =
          'message' in planned ? planned.message : planned.plan.refused && CODE.refused[planned.plan.refused.reason];
        if (reason) {
          become('paused', CODE.status.noMove(Number(effect.line), reason));
          return false;
        }
        if ('plan' in planned) {
          motion = { plan: planned.plan, time: 0, start: doc.posture };
          for (const frame of planned.missing) if (!said.includes(CODE.noFrame(frame))) say(CODE.noFrame(frame));
        }
        standing = doc.posture;
        return false;
      }
      case 'read':
        become('asks', CODE.status.asks(Number(effect.line)));
        return false;
      case 'pause':
        become('paused', CODE.status.paused(line()));
        return false;
      case 'call':
        say(CODE.called(String(effect.program)));
        return true;
      case 'run-task':
        say(CODE.runs(String(effect.program)));
        return true;
      case 'skipped':
        say(CODE.skipped(Number(effect.line), String(effect.text)));
        return true;
      case 'error':
        say(CODE.posted(String(effect.message || effect.code)));
        return true;
      case 'alarm':
        say(CODE.taskAlarm(String(effect.task), /** @type {{ reason: string }} */ (effect.alarm).reason));
        return true;
      default:
        say(CODE.effect(String(effect?.kind)));
        return true;
    }
  }

  function over() {
    const outcome = run?.outcome();
    const { ended, aborted, budget, alarm } = CODE.status;
    if (outcome?.alarm) become('over', alarm(outcome.alarm.line, outcome.alarm.reason));
    else become('over', outcome?.status === 'aborted' ? aborted : outcome?.status === 'budget' ? budget : ended);
  }

  /** One frame. @param {number} seconds */
  function frame(seconds) {
    if (motion) {
      if (store.state.doc.posture !== standing || store.state.gesture) {
        motion = null;
        return become('paused', CODE.status.moved);
      }
      motion.time = Math.min(motion.time + seconds, motion.plan.duration);
      put(postureAt(store.state.doc.robot, motion.plan, motion));
      if (motion.time < motion.plan.duration) return become('running', CODE.status.moving(line()));
      motion = null;
    }
    owed = Math.max(-seconds, owed - seconds); // what is waited for within a frame is waited for
    if (owed > 0) return become('running', CODE.status.waiting(line()));
    const begun = clock.now();
    for (let left = STATEMENTS; left > 0 && mode === 'running' && run; left -= AT_ONCE) {
      const stop = run.advance(isStop, AT_ONCE, () => store.state.doc.posture);
      if (stop.kind !== 'busy' && !heed(stop)) break;
      if (clock.now() - begun > LONGEST_TURN) break;
    }
    if (mode !== 'running') return;
    const { moving, waiting, running } = CODE.status;
    become('running', (motion ? moving : owed > 0 ? waiting : running)(line()));
  }

  function goOn() {
    if (isRunning) return;
    isRunning = true;
    let last = clock.now();
    const next = () => {
      if (mode !== 'running') {
        isRunning = false;
        return;
      }
      clock.onFrame(next);
      const seconds = Math.min(LONGEST_FRAME, clock.now() - last);
      last = clock.now();
      try {
        frame(seconds);
      } catch (error) {
        become('over', CODE.status.stopped);
        messages.fault(error);
      }
    };
    clock.onFrame(next);
  }

  const control = {
    mode: () => mode,
    status: () => status,
    run: () => run,
    said: () => said,
    /** The statement that is next. */
    place: () => (mode === 'over' || mode === 'idle' ? null : (run?.place() ?? null)),
    /** Whether a statement takes its time: the arm moves by it, or it waits. */
    isHolding: () => motion !== null || owed > 0,
    canGoBack: () => Boolean(run?.canGoBack()) && mode !== 'running',

    /**
     * @param {Way} way
     * @param {() => [Parameters<typeof createCodeRun>[0], string]} program  what to begin with, where nothing runs
     * @returns {readonly Pick<Problem, 'line' | 'message'>[]} what is in its way
     */
    go(way, program) {
      const isFirst = !run || mode === 'over' || mode === 'idle';
      if (isFirst) {
        const [programs, id] = program();
        const made = createCodeRun(programs, id, arm, systemAtFirst(store.state.doc));
        if (!('run' in made)) {
          run = null;
          become('idle', CODE.status.faulty(made.diagnostics.length));
          return made.diagnostics.map(({ span, message }) => ({ line: span.line, message }));
        }
        run = made.run;
        [said, owed, motion, standing] = [[], 0, null, null];
      }
      const from = run?.place();
      const isHere = (/** @type {Place} */ place) => place.task === (from?.task ?? 0);
      if (way === 'run') isStop = isBreakpoint;
      else if (way === 'into' || isFirst) isStop = () => true;
      else if (way === 'over')
        isStop = (place) => isBreakpoint(place) || (isHere(place) && place.depth <= (from?.depth ?? 1));
      else isStop = (place) => isBreakpoint(place) || (isHere(place) && place.depth < (from?.depth ?? 1));
      become('running', CODE.status.running(line()));
      goOn();
      return [];
    },

    pause() {
      if (mode !== 'running') return;
      become('paused', CODE.status.paused(line()));
    },

    /** It is over, and begins anew when it is run again. */
    stop() {
      if (mode === 'idle') return;
      [run, motion] = [null, null];
      become('idle', CODE.status.stopped);
    },

    /** One statement back, with the arm. */
    back() {
      if (!run || !control.canGoBack()) return;
      const posture = run.back();
      [motion, owed] = [null, 0];
      if (Array.isArray(posture)) put(posture);
      become('paused', CODE.status.paused(line()));
    },

    /** A line for READ. @param {string} text */
    answer(text) {
      if (mode !== 'asks' || !run) return;
      run.answer(text);
      become('running', CODE.status.running(line()));
      goOn();
    },

    /** While it stands still. @param {'R' | 'PR'} bank @param {number} index @param {number} slot @param {number} value */
    setRegister(bank, index, slot, value) {
      if (mode !== 'running') run?.setRegister(bank, index, slot, value);
      onChange();
    },

    /** @param {string} port @param {number} index @param {boolean | number} value */
    setPort(port, index, value) {
      run?.setPort(port, index, value);
      onChange();
    },
  };
  return control;
}

/** @typedef {ReturnType<typeof createRunControl>} RunControl */
