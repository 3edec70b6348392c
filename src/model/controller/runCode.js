/**
 * Files of code, read and run: the effects of their moves, each with its file and line, and everything that can be said against
 * the text before and while it runs. Where the arm is, whoever runs them says.
 *
 * @import { Diagnostic } from '../../karel/parse/cursor.js'
 * @import { Controller } from '../../karel/controllerTurns.js'
 * @import { Effect } from '../../karel/run/machine.js'
 * @import { TpListing } from '../../karel/tp/tree.js'
 * @import { Program } from '../../karel/tree.js'
 * @import { CodeFile } from '../../karel/write/neutral.js'
 * @import { SystemValues } from '../code/codeFrames.js'
 * @import { RegisterSetting } from '../code/givenRegisters.js'
 * @import { Deed, Where } from './deeds.js'
 *
 * @typedef {{ severity: 'error' | 'warning', code: string, message: string, file: string, line: number }} CodeFinding
 * @typedef {{ effects: Effect[], findings: CodeFinding[] }} CodeRun
 * @typedef {(deed: Deed, where: Where) => void} OnDeed
 *
 * @typedef {object} SimulatedArm   where it is by now, as a pendant counts
 * @property {() => readonly number[]} joints
 * @property {(system: SystemValues, isTp: boolean) => readonly number[]} position
 * @property {Record<string, unknown>} system   what the controller's variables hold at first
 * @property {readonly RegisterSetting[]} given  and its registers
 */
import { checkKarel } from '../../karel/checker.js';
import { createController, goOn } from '../../karel/controller.js';
import { levelAt, memoryOf } from '../../karel/controllerTurns.js';
import { runKrl } from '../../karel/krl/interpreter.js';
import { parseKrl } from '../../karel/krl/parser.js';
import { parseInSlices } from '../../karel/parser.js';
import { includesOf, keyOf } from '../../karel/preprocess/files.js';
import { linkInSlices } from '../../karel/run/link.js';
import { isJoints } from '../../karel/run/positions.js';
import { checkTp } from '../../karel/tp/checker.js';
import { parseTpInSlices } from '../../karel/tp/parser.js';
import { nameOf } from '../../karel/tp/tree.js';
import { comingInputs } from '../code/comingInputs.js';
import { deedsOfKrl, watchDeeds } from './deeds.js';
import { setRegister } from '../code/givenRegisters.js';
import { moveSettings } from './moveSettings.js';

const STEPS = 200_000;
/** What is set of another motion group than the first, which is the arm. */
const OF_OTHER_GROUPS = /\$GROUP\[(?!\s*1\s*\])[^\]]*\]\.\$U(FRAME|TOOL)/g;
/** Statements between two looks at the clock. */
const TURN = 100;

/** All at once, without an arm. @param {readonly CodeFile[]} files  the first is the one that is run @returns {CodeRun} */
export function runCode(files) {
  /** @type {CodeFinding[]} */
  const findings = [];
  const effects = [...runMoves(files, findings)].filter((effect) => effect !== null);
  return { effects, findings };
}

/**
 * Move by move.
 * @param {readonly CodeFile[]} files   the first is the one that is run
 * @param {CodeFinding[]} findings      are added to
 * @param {SimulatedArm} [arm]
 * @param {OnDeed} [onDeed]   hears what is done between moves, before the next of them comes
 * @returns {Generator<Effect | null, void>}   of KAREL's MOVE as it would stand in TP, and itself as `raw`; `system` of FANUC; null: it
 *   is still at what comes before a move
 */
export const runMoves = (files, findings, arm, onDeed) =>
  files[0].language === 'krl' ? runKrlFiles(files, findings, onDeed) : runFanucFiles(files, findings, arm, onDeed);

/** @param {string} file @param {readonly Diagnostic[]} diagnostics @returns {CodeFinding[]} */
const findingsOf = (file, diagnostics) =>
  diagnostics.map(({ severity, code, message, span }) => ({ severity, code, message, file, line: span.line }));

/** @param {readonly CodeFile[]} files @param {CodeFinding[]} findings @param {OnDeed} [onDeed] @returns {Generator<Effect, void>} */
function* runKrlFiles(files, findings, onDeed) {
  const src = files.find(({ name }) => /\.src$/i.test(name)) ?? files[0];
  const dat = files.find(({ name }) => /\.dat$/i.test(name));
  const { tree, diagnostics, datDiagnostics } = parseKrl(src.text, dat?.text);
  findings.push(...findingsOf(src.name, diagnostics), ...(dat ? findingsOf(dat.name, datDiagnostics) : []));
  const first = tree.statements.findIndex(({ kind }) => kind === 'motion');
  const isSet = (/** @type {string} */ frame) =>
    tree.statements.slice(0, first).some((one) => one.kind === 'bas' && one.what === frame);
  if (first >= 0)
    findings.push(
      ...unsetFrames(
        ['TOOL', 'BASE'].filter((frame) => !isSet(frame)),
        src.name,
        tree.statements[first].span?.line,
      ),
    );
  const run = runKrl(tree, { input: (_, time) => Math.floor(time / 12) % 2 === 1 });
  let next = run.next();
  const deeds = deedsOfKrl(tree);
  let [moves, told] = [0, 0];
  const tell = () => {
    for (; deeds[told]?.after === moves; told++) onDeed?.(deeds[told].deed, { file: src.name, line: deeds[told].line });
    moves++;
  };
  // Inputs are taken to come at once.
  for (let count = 0; !next.done && count < STEPS; next = run.next(), count++) {
    const effect = next.value;
    if (effect.kind === 'call') findings.push(passedOver(effect, src.name));
    if (effect.kind !== 'move') continue;
    if (effect.motion === 'J' && effect.isJoint !== true && effect.status === undefined)
      findings.push({
        severity: 'warning',
        code: 'no-status',
        message: 'PTP to a position without S and T: the controller takes the nearest posture.',
        file: src.name,
        line: effect.line ?? 0,
      });
    tell();
    yield { ...effect, hasStatus: effect.status !== undefined, file: src.name };
  }
  if (next.done && !next.value.alarm) tell();
  if (next.done && next.value.alarm) {
    const { code, reason, line } = next.value.alarm;
    findings.push({ severity: 'error', code, message: reason, file: src.name, line });
  }
}

/** @param {readonly CodeFile[]} files @param {CodeFinding[]} findings @param {SimulatedArm} [arm] @param {OnDeed} [onDeed] @returns {Generator<Effect | null, void>} */
function* runFanucFiles(files, findings, arm, onDeed) {
  /** @type {Record<string, Program>} */
  const karel = {};
  /** @type {Record<string, TpListing>} */
  const listings = {};
  /** @type {Map<string, string>} */
  const fileOf = new Map();
  /** Those whose first MOVE has been looked at. @type {Set<string>} */
  const framed = new Set();
  const sources = Object.fromEntries(files.map(({ name, text }) => [name, text]));
  const names = Object.keys(sources);
  /** Text that is included is in a file of its own. */
  const fileIn = (/** @type {string | undefined} */ name, /** @type {string} */ file) =>
    (name !== undefined && keyOf(names, name)) || file;
  const told = (/** @type {string} */ file, /** @type {readonly Diagnostic[]} */ list) =>
    list.forEach((one) => findings.push(...findingsOf(fileIn(one.span.file, file), [one])));
  const included = new Set(
    files.flatMap(({ language, text }) =>
      (language === 'karel' ? includesOf(text) : []).map(({ path }) => keyOf(names, path)),
    ),
  );
  let start = '';
  for (const { name: file, language, text } of files) {
    if (included.has(file)) continue; // it is read where it is included
    if (language === 'karel') {
      const { tree, diagnostics, hasGaps } = yield* parseInSlices(text, { files: sources });
      told(file, diagnostics);
      if (tree.kind !== 'program') {
        told(file, checkKarel(tree, { files: sources, hasGaps }));
        continue;
      }
      karel[tree.name] = tree;
      fileOf.set(tree.name.toUpperCase(), file);
      start ||= tree.name;
    } else {
      const { tree, diagnostics } = yield* parseTpInSlices(text);
      yield null;
      findings.push(...findingsOf(file, [...diagnostics, ...checkTp(tree)]));
      yield null;
      listings[nameOf(tree)] = tree;
      fileOf.set(nameOf(tree), file);
      start ||= nameOf(tree);
    }
  }
  /** @type {Controller['linked']} */
  const linked = new Map();
  for (const [name, tree] of Object.entries(karel)) {
    const linker = yield* linkInSlices(tree, { traceSteps: true, programs: karel, sources });
    linked.set(name.toUpperCase(), linker);
    const file = /** @type {string} */ (fileOf.get(name.toUpperCase()));
    told(file, linker.analyses[0].diagnostics);
  }
  if (start === '') return;
  const main = /** @type {string} */ (fileOf.get(start.toUpperCase()));
  const system = () => memoryOf(controller).system;
  const controller = createController(
    start,
    { karel, listings },
    {
      ...{ steps: STEPS, traceSteps: true, endsWithFirst: true, onScan: comingInputs(files) },
      isInRange: () => true, // so that the program goes on: margins are told move by move
      ...(arm && {
        joints: arm.joints,
        position: () => arm.position(system(), levelAt(controller, controller.turn).language === 'tp'),
      }),
    },
    linked,
  );
  if (arm && !controller.refusal) {
    Object.assign(system(), arm.system);
    for (const setting of arm.given) setRegister(memoryOf(controller), ...setting);
    const names = [...new Set(arm.given.map(([bank, index]) => `${bank}[${index}]`))].join(', ');
    if (names)
      findings.push({
        severity: 'warning',
        code: 'given',
        file: main,
        line: 0,
        message: `Taken as they were set by hand: ${names}.`,
      });
  }
  yield null;
  const run = goOn(controller);
  let count = 0;
  let at = { file: main, line: 0 };
  const deeds = onDeed && !controller.refusal ? watchDeeds(memoryOf(controller), (deed) => onDeed(deed, at)) : null;
  let next = run.next();
  for (; !next.done; next = run.next()) {
    const effect = next.value;
    if (effect.kind === 'step') {
      deeds?.flush();
      at = { file: fileIn(effect.file, fileOf.get(String(effect.in)) ?? main), line: effect.line ?? 0 };
      if (++count % TURN === 0) yield null;
      continue;
    }
    deeds?.note(effect);
    const file = fileIn(effect.file, fileOf.get(String(effect.in)) ?? main);
    if (effect.kind === 'write' && /TPERROR|OUTPUT/.test(String(effect.device ?? '')))
      findings.push({
        severity: 'warning',
        code: 'written',
        message: String(effect.text).trim(),
        file,
        line: effect.line ?? 0,
      });
    if (effect.kind === 'call') findings.push(passedOver(effect, file));
    if (effect.kind !== 'move') continue;
    if (effect.settings) {
      findings.push({
        severity: 'warning',
        code: 'deprecated-move',
        message: 'MOVE is deprecated from R-30iA on: later controllers may move unexpectedly, or refuse it.',
        file,
        line: effect.line ?? 0,
      });
      if (!framed.has(file)) {
        framed.add(file);
        const text = files.find(({ name }) => name === file)?.text ?? '';
        const own = text.toUpperCase().replace(OF_OTHER_GROUPS, '');
        const missing = ['$UTOOL', '$UFRAME'].filter((frame) => !own.includes(frame));
        findings.push(...unsetFrames(missing, file, effect.line));
      }
      const settings = moveSettings(effect, system());
      if ('message' in settings) {
        const { message } = settings;
        findings.push({ severity: 'error', code: 'move-settings', message, file, line: effect.line ?? 0 });
        continue;
      }
      const { 'MNUFRAMENUM[1]': userFrame, 'MNUTOOLNUM[1]': toolFrame } = system();
      yield {
        ...{ ...effect, ...settings, viaIsJoint: isJoints(effect.via) },
        ...{ userFrame: Number(userFrame ?? 0), toolFrame: Number(toolFrame ?? 0) },
        ...{ raw: effect, system: system(), file },
      };
    } else yield { ...effect, system: system(), file };
  }
  deeds?.flush();
  const { status, alarm, diagnostics = [], program } = next.value;
  const file = fileIn(alarm?.file, fileOf.get(program.toUpperCase()) ?? main);
  if (alarm) findings.push({ severity: 'error', code: alarm.code, message: alarm.reason, file, line: alarm.line });
  else if (diagnostics.length > 0)
    findings.push({
      severity: 'error',
      code: status,
      message: diagnostics[0].message,
      file,
      line: diagnostics[0].span.line,
    });
  else if (status !== 'ended')
    findings.push({ severity: 'error', code: status, message: STOPPED[status] ?? status, ...at });
}

/** Why a program was not run to its end. @type {Readonly<Record<string, string>>} */
const STOPPED = {
  budget: `The program does not come past here, or never ends: it was stopped after ${STEPS} instructions. Inputs and flags are taken to come; registers and numbers from outside are not.`,
  aborted: 'The program ends by ABORT here.',
};

/** @param {readonly string[]} missing  frames that nothing has chosen before the first move @param {string} file @param {number} [line] @returns {CodeFinding[]} */
const unsetFrames = (missing, file, line = 0) =>
  missing.length === 0
    ? []
    : [
        {
          ...{ severity: 'warning', code: 'frames', file, line },
          message: `${missing.join(' and ')} ${missing.length === 1 ? 'is' : 'are'} not set before this move: whatever was chosen last holds.`,
        },
      ];

/** @param {Effect} effect  of a program that is not at hand @param {string} file @returns {CodeFinding} */
const passedOver = ({ program, line = 0 }, file) => ({
  ...{ severity: 'warning', code: 'not-at-hand', file, line },
  message: `${String(program)} is not at hand: it is passed over, and what it does is not verified.`,
});
