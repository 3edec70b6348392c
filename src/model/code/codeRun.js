/**
 * The programs of a document, made ready to run under a debugger: those of a FANUC controller, KAREL and TP, on one memory; KRL by
 * itself. Time, the arm and the person are outside.
 *
 * @import { ProgramDoc } from '../document.js'
 * @import { Diagnostic } from '../../karel/parse/cursor.js'
 * @import { CodeRun, Debugged } from './codeDebugger.js'
 * @import { ControllerOutcome } from '../../karel/controller.js'
 * @import { ControllerHost, Level } from '../../karel/controllerTurns.js'
 * @import { TpListing } from '../../karel/tp/tree.js'
 * @import { Program } from '../../karel/tree.js'
 * @import { CodeArm } from './codeArm.js'
 * @import { AlarmText } from '../../karel/run/values.js'
 */
import { createController, goOn, restoreController, saveController } from '../../karel/controller.js';
import { levelAt, levelsOf, memoryOf } from '../../karel/controllerTurns.js';
import { debugged } from './codeDebugger.js';
import { keyOf } from '../../karel/preprocess/files.js';
import { readPrograms } from './codePrograms.js';
import { setRegister } from './givenRegisters.js';
import { registerTexts, variablesOf, watched } from './codeShown.js';
import { UNSET } from './codeValues.js';
import { createKrlRun } from './krlRun.js';

/** Instructions, before a program is taken to be endless. */
const MOST_STEPS = 50_000_000;
/** @type {Diagnostic} of a text that others include */
const NO_PROGRAM = {
  ...{
    severity: 'error',
    code: 'no-program',
    message: 'Expected PROGRAM: this text can only be included by a program.',
  },
  span: { start: 0, end: 0, line: 1, column: 1 },
};
/** Tasks of a program at most, to tell those of different programs apart. */
const TASKS = 100;

/**
 * @param {readonly ProgramDoc[]} programs  of the document
 * @param {string} id                       the one to run
 * @param {CodeArm} arm
 * @param {Record<string, unknown>} [system]  what the controller's variables hold at first
 * @param {Pick<ControllerHost, 'steps' | 'traceSteps' | 'onScan' | 'endsWithFirst'>} [how]
 * @param {ReturnType<typeof readPrograms>} [read]  the programs, read before
 * @returns {{ run: CodeRun } | { diagnostics: readonly Diagnostic[] }}  the other way round where it cannot be run
 */
export function createCodeRun(programs, id, arm, system = {}, how = {}, read = undefined) {
  const chosen = programs.find((one) => one.id === id);
  if (chosen?.language === 'krl')
    return createKrlRun(programs, chosen, { steps: MOST_STEPS, traceSteps: true, ...how });
  const all = read ?? readPrograms(programs);
  const main = all.find((one) => one.id === id);
  if (!main) throw new RangeError(`Expected the name of a program, got "${id}".`);
  if (main.errors().length > 0) return { diagnostics: main.errors() };
  if (main.language === 'karel' && main.tree.kind === 'fragment') return { diagnostics: [NO_PROGRAM] };
  /** @type {Record<string, Program>} */
  const karel = {};
  /** @type {Record<string, TpListing>} */
  const listings = {};
  // The one that is run comes first, should another have its name.
  for (const one of [main, ...all]) {
    if (one.language === 'karel') {
      if (one.tree.kind === 'program') karel[one.name] ??= one.tree;
      for (const other of one.programs) karel[other.name] ??= other;
    } else listings[one.name] ??= one.tree;
  }
  const sources = Object.fromEntries(programs.map(({ id: name, text }) => [name, text]));
  const controller = createController(
    main.name,
    { karel, listings },
    {
      ...{
        sources,
        traceSteps: true,
        steps: MOST_STEPS,
        joints: arm.joints,
        kinematics: arm.kinematics,
        isInRange: arm.isInRange,
        ...how,
      },
      position: () => {
        const level = levelAt(controller, controller.turn);
        return arm.position(level.machine.state.system, level.language === 'tp');
      },
    },
  );
  if (controller.refusal) return { diagnostics: controller.refusal.diagnostics ?? [] };
  Object.assign(memoryOf(controller).system, system);
  return { run: debugged(fanuc(controller, all, sources)) };
}

/** @param {ReturnType<typeof createController>} controller @param {ReturnType<typeof readPrograms>} read @param {Readonly<Record<string, string>>} sources  all texts by their ids @returns {Debugged<ReturnType<typeof saveController>>} */
function fanuc(controller, read, sources) {
  const ids = Object.keys(sources);
  const top = () => /** @type {Level} */ (levelsOf(controller).at(-1));
  const readOf = (/** @type {string} */ program) =>
    read.find(({ name }) => name.toUpperCase() === program.toUpperCase());
  /** Text that %INCLUDE has brought is in a file of its own. */
  const idOf = (/** @type {string} */ program, /** @type {string | undefined} */ file) =>
    (file !== undefined && keyOf(ids, file)) || (readOf(program)?.id ?? '');
  /** Which variable it is, where the line tells. @param {AlarmText} alarm */
  function named({ reason, line, file }) {
    const frame = framesOf(top()).at(-1);
    const text = sources[idOf(frame?.program ?? '', file)]?.split('\n')[line - 1] ?? '';
    const words = new Set(
      text
        .replace(/'[^']*'|--.*/g, ' ')
        .toUpperCase()
        .split(/\W+/),
    );
    const unset = variablesOf(top()).filter(({ name, value }) => value === UNSET && words.has(name.toUpperCase()));
    return unset.length > 0 ? `${reason}: ${[...new Set(unset.map(({ name }) => name))].join(' or ')}` : reason;
  }

  return {
    *go() {
      const ended = yield* goOn(controller);
      if (ended.diagnostics?.length) return refusalOf(ended);
      const { alarm } = ended;
      return alarm?.code === 'uninitialised' ? { ...ended, alarm: { ...alarm, reason: named(alarm) } } : ended;
    },
    save: () => saveController(controller),
    restore: (saved) => restoreController(controller, saved),
    placeOf({ line = 0 }) {
      const levels = levelsOf(controller);
      const level = levels[levels.length - 1];
      const below = levels.slice(0, -1).reduce((sum, one, i) => sum + framesOf(one, levels[i + 1]).length, 0);
      const frames = framesOf(level);
      const { program, routine, file } = frames[frames.length - 1];
      const { current = 0 } = level.language === 'karel' ? level.machine.state : {};
      const { thread } = controller.told;
      const task = current === 0 && thread === 0 ? 0 : TASKS * (TASKS * thread + levels.length) + current;
      return { id: idOf(program, file), program, routine, line, depth: below + frames.length, task };
    },
    faultAt({ program }) {
      const [fault] = readOf(program)?.errors() ?? [];
      return fault ? faultIn(program, fault) : null;
    },
    frames: () =>
      levelsOf(controller)
        .flatMap((level, i, all) => framesOf(level, all[i + 1]))
        .map(({ file, ...frame }) => ({ ...frame, id: idOf(frame.program, file) })),
    memory: () => /** @type {ReturnType<Debugged<unknown>['memory']>} */ (memoryOf(controller)),
    variables: () => variablesOf(top()),
    registers: () => registerTexts(memoryOf(controller)),
    watch: (text) => watched(top(), text),
    setPort(port, index, value) {
      (memoryOf(controller).ports[port] ??= {})[index] = value;
    },
    setRegister: (...setting) => setRegister(memoryOf(controller), ...setting),
    answer(line) {
      const level = top();
      if (level.language === 'karel') level.machine.state.input.push(line);
    },
  };
}

/** @param {string} program @param {Diagnostic} fault */
const faultIn = (program, { span, message }) => `${program} has an error in line ${span.line}: ${message}`;

/** A program that was called, and that the checker has something against. @param {ControllerOutcome} outcome */
function refusalOf({ program, diagnostics = [] }) {
  const reason = faultIn(program, diagnostics[0]);
  return /** @type {const} */ ({ status: 'alarm', alarm: { code: 'faulty', reason, line: 0, routine: program } });
}

/** Routines and programs that wait for each other, the outermost first. @param {Level} level @param {Level} [called]  by it @returns {{ program: string, routine: string, line: number, file?: string }[]} */
function framesOf(level, called) {
  if (level.language === 'tp') {
    const { codes, state } = level.machine;
    return state.frames.map(({ program, at }, i) => {
      // the frames below stand behind their CALL
      const line = codes.get(program)?.lines[i < state.frames.length - 1 ? at - 1 : at]?.span?.line ?? 0;
      return { program, routine: program, line };
    });
  }
  const { state, image, linker } = level.machine;
  return state.tasks[called?.caller?.task ?? state.current].frames.map(({ code, pc }) => {
    const { name, program, lines, files } = image.codes[code];
    const at = { line: lines[pc - 1] ?? 0, file: files[pc - 1] };
    return { program: linker.analyses[program].program.name, routine: name, ...at };
  });
}
