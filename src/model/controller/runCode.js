/**
 * Files of code, read and run without an arm: the effects of their moves, each with its line, and everything that can be said
 * against the text before and while it runs.
 *
 * @import { Diagnostic } from '../../karel/parse/cursor.js'
 * @import { Effect, State } from '../../karel/run/machine.js'
 * @import { TpListing } from '../../karel/tp/tree.js'
 * @import { Program } from '../../karel/tree.js'
 * @import { CodeFile } from '../../karel/write/neutral.js'
 *
 * @typedef {{ severity: 'error' | 'warning', code: string, message: string, file: string, line: number }} CodeFinding
 * @typedef {{ effects: Effect[], findings: CodeFinding[], language: 'fanuc' | 'krl' }} CodeRun
 */
import { checkKarel } from '../../karel/checker.js';
import { createController, goOn } from '../../karel/controller.js';
import { runKrl } from '../../karel/krl/interpreter.js';
import { parseKrl } from '../../karel/krl/parser.js';
import { parseKarel } from '../../karel/parser.js';
import { checkTp } from '../../karel/tp/checker.js';
import { parseTp } from '../../karel/tp/parser.js';
import { nameOf } from '../../karel/tp/tree.js';

const STEPS = 200_000;

/** KAREL's motion types and how moves end, as TP has them. */
const MOTYPES = /** @type {Readonly<Record<number, string>>} */ ({ 6: 'J', 7: 'L', 8: 'C' });
const VARDECEL = 5;
const FINE = 1;

/** @param {readonly CodeFile[]} files  the first is the one that is run @returns {CodeRun} */
export function runCode(files) {
  return files[0].language === 'krl' ? runKrlFiles(files) : runFanucFiles(files);
}

/** @param {string} file @param {readonly Diagnostic[]} diagnostics @returns {CodeFinding[]} */
const findingsOf = (file, diagnostics) =>
  diagnostics.map(({ severity, code, message, span }) => ({ severity, code, message, file, line: span.line }));

/** @param {readonly CodeFile[]} files @returns {CodeRun} */
function runKrlFiles(files) {
  const src = files.find(({ name }) => /\.src$/i.test(name)) ?? files[0];
  const dat = files.find(({ name }) => /\.dat$/i.test(name));
  const { tree, diagnostics, datDiagnostics } = parseKrl(src.text, dat?.text);
  const findings = [...findingsOf(src.name, diagnostics), ...(dat ? findingsOf(dat.name, datDiagnostics) : [])];
  /** @type {Effect[]} */
  const effects = [];
  const run = runKrl(tree, { input: (_, time) => Math.floor(time / 12) % 2 === 1 });
  let next = run.next();
  // Inputs are taken to come at once.
  for (; !next.done && effects.length < STEPS; next = run.next())
    if (next.value.kind === 'move') effects.push({ ...next.value, hasStatus: next.value.status !== undefined });
  if (next.done && next.value.alarm) {
    const { code, reason, line } = next.value.alarm;
    findings.push({ severity: 'error', code, message: reason, file: src.name, line });
  }
  for (const effect of effects)
    if (effect.motion === 'J' && effect.isJoint !== true && effect.status === undefined)
      findings.push({
        severity: 'warning',
        code: 'no-status',
        message: 'PTP to a position without S and T: the controller takes the nearest posture.',
        file: src.name,
        line: effect.line ?? 0,
      });
  return { effects, findings, language: 'krl' };
}

/** @param {readonly CodeFile[]} files @returns {CodeRun} */
function runFanucFiles(files) {
  /** @type {CodeFinding[]} */
  const findings = [];
  /** @type {Record<string, Program>} */
  const karel = {};
  /** @type {Record<string, TpListing>} */
  const listings = {};
  /** @type {Map<string, string>} */
  const fileOf = new Map();
  let start = '';
  for (const { name: file, language, text } of files) {
    if (language === 'karel') {
      const { tree, diagnostics } = parseKarel(text);
      findings.push(...findingsOf(file, [...diagnostics, ...checkKarel(tree)]));
      if (tree.kind !== 'program') continue;
      karel[tree.name] = tree;
      fileOf.set(tree.name.toUpperCase(), file);
      start ||= tree.name;
    } else {
      const { tree, diagnostics } = parseTp(text);
      findings.push(...findingsOf(file, [...diagnostics, ...checkTp(tree)]));
      listings[nameOf(tree)] = tree;
      fileOf.set(nameOf(tree), file);
      start ||= nameOf(tree);
    }
  }
  /** @type {Effect[]} */
  const effects = [];
  if (start === '') return { effects, findings, language: 'fanuc' };
  const main = /** @type {string} */ (fileOf.get(start.toUpperCase()));
  const controller = createController(start, { karel, listings }, { steps: STEPS, onScan: comingInputs(files) });
  const run = goOn(controller);
  let next = run.next();
  for (; !next.done; next = run.next()) {
    const effect = next.value;
    const file = fileOf.get(String(effect.in)) ?? main;
    if (effect.kind === 'write' && /TPERROR|OUTPUT/.test(String(effect.device ?? '')))
      findings.push({
        severity: 'warning',
        code: 'written',
        message: String(effect.text).trim(),
        file,
        line: effect.line ?? 0,
      });
    if (effect.kind !== 'move') continue;
    if (effect.settings) {
      findings.push({
        severity: 'warning',
        code: 'deprecated-move',
        message: 'MOVE is deprecated: later controllers may move unexpectedly, or refuse it.',
        file,
        line: effect.line ?? 0,
      });
      effects.push({ ...karelMove(effect, /** @type {State} */ (controller.levels.at(-1)?.machine.state)), file });
    } else effects.push({ ...effect, file });
  }
  const { status, alarm, diagnostics = [], program } = next.value;
  const file = fileOf.get(program.toUpperCase()) ?? main;
  if (alarm) findings.push({ severity: 'error', code: alarm.code, message: alarm.reason, file, line: alarm.line });
  else if (status !== 'ended')
    findings.push({
      severity: 'error',
      code: status,
      message: `The program was stopped: ${status}.`,
      file,
      line: diagnostics[0]?.span.line ?? 0,
    });
  return { effects, findings, language: 'fanuc' };
}

/** Inputs that are waited for are taken to come: they change at each look. @param {readonly CodeFile[]} files */
function comingInputs(files) {
  const indices = new Set(
    files.flatMap(({ text }) => [...text.matchAll(/\bDI[N]?\[(\d+)/gi)].map(([, index]) => Number(index))),
  );
  return (/** @type {State} */ { ports }) => {
    const inputs = (ports.DIN ??= {});
    for (const index of indices) inputs[index] = inputs[index] !== true;
  };
}

/** KAREL's MOVE as a move of TP. @param {Effect} effect @param {State} state @returns {Effect} */
function karelMove(effect, { system }) {
  const settings = /** @type {Record<string, unknown>} */ (effect.settings);
  const type = Number(settings.$TERMTYPE);
  return {
    ...effect,
    ...{ motion: MOTYPES[Number(settings.$MOTYPE)] ?? 'J' },
    viaIsJoint: Array.isArray(effect.via) && effect.via.length < 10,
    speed: {
      value: settings.$SPEED ?? settings.$ROTSPEED ?? null,
      unit: settings.$ROTSPEED === undefined ? 'mm/sec' : 'deg/sec',
    },
    termination:
      type === FINE
        ? { kind: 'FINE' }
        : type === VARDECEL
          ? { kind: 'CNT', value: settings.$DECELTOL }
          : { kind: 'CR' },
    ...{ userFrame: Number(system['MNUFRAMENUM[1]'] ?? 0), toolFrame: Number(system['MNUTOOLNUM[1]'] ?? 0) },
  };
}
