/**
 * Runs the code that is open: in each of the page's frames as much of the program's time as the frame took, and the arm where its
 * motion is by then. What the program wants done is done here, or said.
 *
 * @import { Page } from '../page.js'
 * @import { CodeRun, Place, Stop } from '../../model/code/codeDebugger.js'
 * @import { Begun, MotionMark } from '../../model/code/codeMotions.js'
 * @import { Problem } from '../../model/code/codeProblems.js'
 *
 * @typedef {'idle' | 'running' | 'paused' | 'asks' | 'over'} Mode
 * @typedef {'run' | 'into' | 'over' | 'out'} Way   how far it goes
 */
import { codeArm } from '../../model/code/codeArm.js';
import { systemAtFirst } from '../../model/code/codeFrames.js';
import { createCodeMotions } from '../../model/code/codeMotions.js';
import { createCodeRun } from '../../model/code/codeRun.js';
import { createGivenRegisters } from '../../model/code/givenRegisters.js';
import { LONGEST_FRAME } from '../../model/program/player.js';
import { fromMilliseconds, toMilliseconds } from '../../model/units.js';
import { CODE } from '../words/code.js';
import { effectText } from './effectText.js';

/** Statements a frame at most, unless the arm moves; s of the page's time; so many statements are run before the clock is looked at. */
const STATEMENTS = 400;
const LONGEST_TURN = 0.008;
const AT_ONCE = 25;

/**
 * @param {Page} page
 * @param {object} acts
 * @param {() => void} acts.onChange      something of the run is another
 * @param {() => void} acts.onGiven       a register has a value that the next run finds
 * @param {(place: Place) => boolean} acts.isBreakpoint
 */
export function createRunControl({ store, clock, announce, messages }, { onChange, onGiven, isBreakpoint }) {
  /** @type {CodeRun | null} */
  let run = null;
  /** @type {Mode} */
  let mode = 'idle';
  let status = CODE.status.ready;
  /** Where the motion under way was asked for. @type {{ line: number, stack: ReturnType<CodeRun['stack']> } | null} */
  let asked = null;
  /** s that the program's time is ahead. */
  let owed = 0;
  /** @type {(place: Place) => boolean} */
  let isStop = () => false;
  /** @type {readonly string[]} */
  let said = [];
  let isRunning = false;
  /** @type {readonly number[] | null} where the run has put the arm last: the document's own list */
  let standing = null;

  const given = createGivenRegisters();
  const line = () => run?.place()?.line ?? 0;
  const motions = createCodeMotions(
    () => store.state.doc,
    () => run,
  );
  const arm = codeArm(motions.doc);

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
        return true;
      case 'move':
        put(motions.posture());
        asked = { line: Number(effect.line), stack: run?.stack() ?? [] };
        return began(motions.begin(effect), asked.line);
      case 'motion-control':
        if (/^(ATTACH|RELEASE)$/.test(String(effect.action))) say(CODE.effect(String(effect.action)));
        if (effect.action !== 'RESUME') return true;
        put(motions.posture());
        return began(motions.resume(), Number(effect.line));
      case 'read':
        become('asks', CODE.status.asks(Number(effect.line)));
        return false;
      case 'pause':
        become('paused', CODE.status.paused(line()));
        return false;
      default:
        if (!/^(no-effect|assumed-date)$/.test(effect?.kind ?? '') || !said.includes(effectText(effect)))
          say(effectText(effect));
        return true;
    }
  }

  /** @param {Begun} begun @param {number} at  its line @returns {boolean} */
  function began(begun, at) {
    if ('missing' in begun) {
      const notes = [...begun.missing.map(CODE.noFrame), begun.assumed ?? ''];
      for (const note of notes) if (note && !said.includes(note)) say(note);
      return true;
    }
    const { reason, isRefusal } = begun;
    become('paused', CODE.status.noMove(at, isRefusal ? CODE.refused[/** @type {'limit'} */ (reason)] : reason));
    return false;
  }

  /** The arm stands where its motion has it; while it moves, when the page's time has it there. */
  function show() {
    const motion = run?.state().arm.motion;
    const lag = motion && mode === 'running' ? toMilliseconds(Math.max(0, owed)) * motion.rate : 0;
    const posture = motions.posture(lag);
    if (posture !== store.state.doc.posture) put(posture);
    motions.settle();
  }

  function over() {
    const outcome = run?.outcome();
    const { ended, aborted, budget, alarm } = CODE.status;
    if (outcome?.alarm) become('over', alarm(outcome.alarm.line, outcome.alarm.reason));
    else become('over', outcome?.status === 'aborted' ? aborted : outcome?.status === 'budget' ? budget : ended);
  }

  /** One frame. @param {number} seconds */
  function frame(seconds) {
    if (motions.isMoving() && (store.state.doc.posture !== standing || store.state.gesture)) {
      motions.giveUp();
      return become('paused', CODE.status.moved);
    }
    owed = Math.max(-seconds, owed - seconds); // what takes less than a frame is over within it
    if (owed <= 0) turn();
    show();
    if (mode === 'running') become('running', doing());
  }

  /** As much as this frame has room for. */
  function turn() {
    const begun = clock.now();
    let left = STATEMENTS;
    while (mode === 'running' && run && owed <= 0 && (left > 0 || motions.isMoving())) {
      const [isMoving, before] = [motions.isMoving(), run.state().time];
      const stop = run.advance(isStop, AT_ONCE, motions.mark);
      if (isMoving || stop.effect?.kind === 'wait') owed += fromMilliseconds(run.state().time - before);
      left -= AT_ONCE;
      if ((stop.kind !== 'busy' && !heed(stop)) || clock.now() - begun > LONGEST_TURN) return;
    }
  }

  /** What it is at, in words. */
  function doing() {
    const { moving, held, halted, waiting, running } = CODE.status;
    const { motion, isHeld, stopped } = run?.state().arm ?? { motion: null, isHeld: false, stopped: [] };
    if (motion) return (isHeld ? held : moving)(Number(motion.effect.line));
    const last = stopped.at(-1);
    if (last && owed > 0) return halted(Number(last.effect.line));
    return (owed > 0 ? waiting : running)(line());
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
    given: given.settings,
    /** The statement that is next. */
    place: () => (mode === 'over' || mode === 'idle' ? null : (run?.place() ?? null)),
    /** The line of the alarm that ended it. */
    alarmLine: () => (mode === 'over' && run?.outcome()?.alarm?.line) || null,
    /** From the outermost to where it is; while the arm moves, to where that was asked for. */
    stack: () => (mode === 'running' && asked && motions.isMoving() ? asked.stack : (run?.stack() ?? [])),
    /** Whether a statement takes its time: the arm moves by it, or it waits. */
    isHolding: () => motions.isMoving() || owed > 0,
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
          const isPart = made.diagnostics[0]?.code === 'no-program';
          become('idle', isPart ? CODE.status.noProgram : CODE.status.faulty(made.diagnostics.length));
          return made.diagnostics.map(({ span, message }) => ({ line: span.line, message }));
        }
        run = made.run;
        given.giveTo(run);
        [said, owed, asked, standing] = [[], 0, null, null];
        motions.clear();
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
      run = null;
      motions.clear();
      become('idle', CODE.status.stopped);
    },

    /** One statement back, with the arm. */
    back() {
      if (!run || !control.canGoBack()) return;
      const mark = /** @type {MotionMark | null} */ (run.back());
      owed = 0;
      if (mark) {
        motions.restore(mark);
        put(mark.posture);
      }
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
      if (run && mode !== 'running') {
        given.note(run, [bank, index, slot, value]);
        run.setRegister(bank, index, slot, value);
        onGiven();
      }
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
