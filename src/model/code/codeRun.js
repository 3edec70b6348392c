/**
 * A KAREL program under a debugger: it goes on to where it is asked to, says what it wants done, shows what it knows, and
 * goes back statement by statement. Time, the arm and the person are outside.
 *
 * @import { ProgramDoc } from '../document.js'
 * @import { Diagnostic } from '../../karel/parse/cursor.js'
 * @import { AlarmText, Outcome } from '../../karel/interpreter.js'
 * @import { Effect, State } from '../../karel/run/machine.js'
 * @import { Program } from '../../karel/tree.js'
 *
 * @typedef {{ program: string, routine: string, line: number, depth: number, task: number }} Place  program, routine: as they are written
 *
 * @typedef {object} Stop
 * @property {'line' | 'effect' | 'over' | 'busy'} kind   busy: so many statements were run, and it goes on
 * @property {Effect} [effect]      what is to be done before it goes on
 *
 * @typedef {object} Shown
 * @property {string} name
 * @property {string} type
 * @property {string} value
 * @property {string} [owner]   the routine or the program that has it
 *
 * @typedef {object} Moment     from which a statement can be run again
 * @property {State} state
 * @property {Place} place
 * @property {number} written   so much of the output was there
 * @property {unknown} mark     what the caller knew: where the arm stood
 */
import { typeText } from '../../karel/check/types.js';
import { createMachine, restoreState, runMachine, saveState } from '../../karel/interpreter.js';
import { parseKarel } from '../../karel/parser.js';
import { valueText } from './codeValues.js';

/** So many statements can be taken back. */
export const MOST_MOMENTS = 2000;
/** Statements, before a program is taken to be endless. */
const MOST_STEPS = 50_000_000;
const MOST_OUTPUT = 100_000;

/**
 * @param {readonly ProgramDoc[]} programs  of the document
 * @param {string} id                       the one to run
 * @param {{ joints: () => readonly number[], position: () => readonly number[] }} arm  as a pendant counts, degrees and millimetres
 * @returns {{ run: CodeRun } | { diagnostics: readonly Diagnostic[] }}  the other way round where it cannot be run
 */
export function createCodeRun(programs, id, arm) {
  const files = Object.fromEntries(programs.map(({ id: name, text }) => [name, text]));
  const parsed = new Map(
    programs
      .filter(({ language }) => language === 'karel')
      .map(({ id: name, text }) => [name, parseKarel(text, { files })]),
  );
  const main = parsed.get(id);
  if (!main) throw new RangeError(`Expected the name of a KAREL program, got "${id}".`);
  const errors = main.diagnostics.filter(({ severity }) => severity === 'error');
  if (errors.length > 0) return { diagnostics: errors };
  /** @type {Record<string, Program>} */
  const others = {};
  for (const { tree } of parsed.values()) if (tree.kind === 'program') others[tree.name] ??= tree;
  const made = createMachine(main.tree, {
    ...{ programs: others, sources: files, traceSteps: true, steps: MOST_STEPS },
    ...{ joints: arm.joints, position: arm.position },
  });
  if (made.errors.length > 0) return { diagnostics: made.errors };
  return { run: codeRun(made.machine) };
}

/** @param {ReturnType<typeof createMachine>['machine']} machine */
function codeRun(machine) {
  /** @type {Moment[]} */
  const moments = [];
  let going = runMachine(machine);
  let output = '';
  /** @type {Place | null} */
  let place = null;
  /** @type {Outcome | null} */
  let outcome = null;
  /** Whether the last moment is now: nothing of its statement has been run. */
  let isNow = false;

  /** @param {Effect} effect @returns {Place} */
  function placeOf({ line = 0 }) {
    const { state, image, linker } = machine;
    const task = state.tasks[state.current];
    const code = image.codes[task.frames[task.frames.length - 1].code];
    const program = linker.analyses[code.program].program.name;
    return { program, routine: code.name, line, depth: task.frames.length, task: state.current };
  }

  return {
    /** The statement that is next; null before the first, and when it is over. */
    place: () => place,
    /** How it ended; null while it has not. */
    outcome: () => outcome,
    output: () => output,
    state: () => machine.state,

    /**
     * @param {(place: Place) => boolean} isStop  whether to stop before a statement
     * @param {number} most                       statements
     * @param {() => unknown} mark                what is to be known of this moment when it comes back
     * @returns {Stop}
     */
    advance(isStop, most, mark) {
      for (let left = most; left > 0;) {
        isNow = false;
        const next = going.next();
        if (next.done) {
          outcome = next.value;
          place = null;
          return { kind: 'over' };
        }
        const effect = next.value;
        if (effect.kind === 'step') {
          left--;
          isNow = true;
          place = placeOf(effect);
          moments.push({ state: saveState(machine), place, written: output.length, mark: mark() });
          if (moments.length > MOST_MOMENTS) moments.shift();
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
      restoreState(machine, moment.state);
      going = runMachine(machine);
      output = output.slice(0, moment.written);
      place = moment.place;
      outcome = null;
      isNow = true;
      return moment.mark;
    },

    /** From the outermost to where it is. @returns {Omit<Place, 'depth' | 'task'>[]} */
    stack() {
      const { state, image, linker } = machine;
      const { frames } = state.tasks[state.current];
      return frames.map(({ code, pc }, i) => {
        const { name, program, lines } = image.codes[code];
        const isTop = i === frames.length - 1;
        const line = isTop ? (place?.line ?? 0) : (lines[pc - 1] ?? 0);
        return { program: linker.analyses[program].program.name, routine: name, line };
      });
    },

    /** What the routine and its program know; after the end, what the program knew. @returns {Shown[]} */
    variables() {
      const { state, image, linker } = machine;
      const frame = state.tasks[state.current].frames.at(-1);
      const code = frame ? image.codes[frame.code] : { program: 0, name: '' };
      const { scope } = linker.analyses[code.program];
      const routine = scope.globals.get(code.name.toUpperCase());
      const locals = frame && routine?.kind === 'routine' ? [...routine.locals.values()] : [];
      return [...locals, ...scope.globals.values()].flatMap((symbol) => {
        if (symbol.kind !== 'variable' || symbol.from) return [];
        const { name, type, slot, isGlobal, isParameter } = symbol;
        const held = isGlobal ? state.globals[code.program][slot] : frame?.locals[slot];
        const at = /** @type {{ holder: Record<string | number, unknown>, key: string | number } | undefined} */ (held);
        const value = isParameter ? at?.holder[at.key] : held;
        return [{ name, type: typeText(type), value: valueText(value, type), ...(!isGlobal && { owner: code.name }) }];
      });
    },

    /** @param {string} port @param {number} index @param {boolean | number} value */
    setPort(port, index, value) {
      (machine.state.ports[port] ??= {})[index] = value;
    },

    /** A line for READ. @param {string} line */
    answer(line) {
      machine.state.input.push(line);
    },
  };
}

/** @typedef {ReturnType<typeof codeRun>} CodeRun */
