/**
 * Whatever runs, under a debugger: it goes on to where it is asked to, says what it wants done, and goes back statement by statement.
 *
 * @import { Effect } from '../../karel/run/machine.js'
 * @import { AlarmText } from '../../karel/run/values.js'
 * @import { Arm } from '../../karel/run/arm.js'
 * @import { Shown, ShownRegister } from './codeShown.js'
 *
 * @typedef {object} Place
 * @property {string} id        of the document's program
 * @property {string} program   as its text calls it
 * @property {string} routine
 * @property {number} line
 * @property {number} depth     how many wait for it to end, and itself
 * @property {number} task      0: the one that was begun, whichever program it is in by now
 *
 * @typedef {object} Stop
 * @property {'line' | 'effect' | 'over' | 'busy'} kind   busy: so many statements were run, and it goes on
 * @property {Effect} [effect]      what is to be done before it goes on
 *
 * @typedef {{ status: string, alarm?: AlarmText }} Ended
 */

/**
 * @template Saved
 * @typedef {object} Debugged   what is debugged
 * @property {() => Generator<Effect, Ended, unknown>} go   from where it is
 * @property {() => Saved} save
 * @property {(saved: Saved) => void} restore
 * @property {(effect: Effect) => Place} placeOf
 * @property {(place: Place) => string | null} faultAt      why it cannot go on in the program that it has come to
 * @property {() => Omit<Place, 'depth' | 'task'>[]} frames  from the outermost to where it is; the line of the last may be another
 * @property {() => { ports: Record<string, Record<string, unknown>>, system: Record<string, unknown>, time: number, arm: Arm }} memory  the controller's
 * @property {() => Shown[]} variables      what the routine and its program know; after the end, what the program knew
 * @property {() => ShownRegister[]} registers  that have a value
 * @property {(text: string) => { value: string } | { fault: string }} watch  what a text comes to; nothing changes by it
 * @property {(port: string, index: number, value: boolean | number) => void} setPort
 * @property {(bank: 'R' | 'PR', index: number, slot: number, value: number) => void} setRegister  or one number of a position register
 * @property {(line: string) => void} answer   a line for READ
 */

/** So many statements can be taken back. */
const MOST_MOMENTS = 2000;
const MOST_OUTPUT = 100_000;
/** So many statements a loop without any counts for. */
const TURN = 100;

/**
 * @template Saved
 * @param {Debugged<Saved>} inner
 */
export function debugged(inner) {
  /** From each a statement can be run again. mark: what the caller knew: where the arm stood. @type {{ state: Saved, place: Place, written: number, mark: unknown }[]} */
  const moments = [];
  let going = inner.go();
  let output = '';
  /** @type {Place | null} */
  let place = null;
  /** @type {Ended | null} */
  let outcome = null;
  /** Whether the last moment is now: nothing of its statement has been run. */
  let isNow = false;

  /** What a person has changed is part of the moment. */
  function keep() {
    const moment = moments.at(-1);
    if (isNow && moment) moment.state = inner.save();
  }

  return {
    /** The statement that is next; null before the first, and when it is over. */
    place: () => place,
    /** How it ended; null while it has not. */
    outcome: () => outcome,
    output: () => output,
    state: inner.memory,
    variables: inner.variables,
    registers: inner.registers,
    watch: inner.watch,
    answer: inner.answer,

    /**
     * @param {(place: Place) => boolean} isStop  whether to stop before a statement
     * @param {number} most                       statements
     * @param {() => unknown} mark                what is to be known of this moment when it comes back
     * @returns {Stop}
     */
    advance(isStop, most, mark) {
      for (let left = most; left > 0;) {
        if (outcome) return { kind: 'over' };
        isNow = false;
        const next = going.next();
        if (next.done) {
          outcome = next.value;
          place = null;
          return { kind: 'over' };
        }
        const effect = next.value;
        if (effect.kind === 'turn') left -= TURN;
        else if (effect.kind === 'step') {
          left--;
          isNow = true;
          place = inner.placeOf(effect);
          moments.push({ state: inner.save(), place, written: output.length, mark: mark() });
          if (moments.length > MOST_MOMENTS) moments.shift();
          const reason = inner.faultAt(place);
          if (reason !== null) {
            outcome = { status: 'alarm', alarm: { code: 'faulty', reason, line: place.line, routine: place.routine } };
            return { kind: 'over' };
          }
          if (isStop(place)) return { kind: 'line' };
        } else if (effect.kind === 'write') output = (output + String(effect.text)).slice(-MOST_OUTPUT);
        else return { kind: 'effect', effect };
      }
      return { kind: 'busy' };
    },

    canGoBack: () => moments.length > (isNow ? 1 : 0),

    /** To before the statement that was run last. @returns {unknown} the mark of that moment */
    back() {
      if (isNow) moments.pop();
      const moment = moments.at(-1);
      if (!moment) return null;
      inner.restore(moment.state);
      going = inner.go();
      output = output.slice(0, moment.written);
      place = moment.place;
      outcome = null;
      isNow = true;
      return moment.mark;
    },

    /** From the outermost to where it is. */
    stack: () => {
      const frames = inner.frames();
      return frames.map((frame, i) => (i === frames.length - 1 ? { ...frame, line: place?.line ?? 0 } : frame));
    },

    /** @param {string} port @param {number} index @param {boolean | number} value */
    setPort(port, index, value) {
      inner.setPort(port, index, value);
      keep();
    },

    /** @param {'R' | 'PR'} bank @param {number} index @param {number} slot @param {number} value */
    setRegister(bank, index, slot, value) {
      inner.setRegister(bank, index, slot, value);
      keep();
    },
  };
}

/** @typedef {ReturnType<typeof debugged>} CodeRun */
