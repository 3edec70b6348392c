/**
 * A KAREL program that moves by MOVE, as controllers since R-30iA want it: each MOVE becomes a position register that is filled and a
 * CALL of a TP program that moves there. All of them at once, since a program that holds the arm cannot have others move it; or
 * none, and then a sentence says why. What is written is printed from trees; the rest of the text stays as it is.
 *
 * @import { Declaration, Directive, Expression, Move, Program, Span, Statement } from '../tree.js'
 * @import { Files } from '../parser.js'
 * @import { Settings } from './knownSettings.js'
 *
 * @typedef {{ from: number, to: number, text: string }} Edit
 * @typedef {{ motion: 'joint' | 'linear', speed: number, ending: number | null, frames: readonly (number | 'chosen')[] }} Manner
 *   ending: % of CNT; null: FINE; frames: of the user, of the tool
 * @typedef {object} TpCallOptions
 * @property {number} register       a position register that nothing else uses
 * @property {string} robotName
 * @property {string} version        of the software that writes
 * @property {string} generatedAt    ISO 8601
 * @property {ReadonlySet<string>} taken  names of programs, in capitals
 * @property {Files} [files]
 */
import { analyse } from '../check/analysis.js';
import { fanucNames } from '../fanucNames.js';
import { declarationLines } from '../print/declarations.js';
import { joinedLines } from '../print/lines.js';
import { statementLines } from '../print/statements.js';
import { call, integer, name, string } from '../tree.js';
import { printTp } from '../tp/printer.js';
import { register as tpRegister } from '../tp/tree.js';
import { listingFor, motionFor, remarks, setting } from './fanucMoves.js';
import { checkRoutine } from './karelParts.js';
import { knownSettings, nodesOf, settingName, valueOf } from './knownSettings.js';

const [JOINT, LINEAR] = [6, 7];
/** CNT by $TERMTYPE; null: FINE, which COARSE becomes, too. NOSETTLE slows down, NODECEL does not. */
const ENDINGS = /** @type {Readonly<Record<number, number | null>>} */ ({ 1: null, 2: null, 3: 0, 4: 100 });
const VARDECEL = 5;
/** What $SPEED means for joints is not verified: slow. */
const JOINT_SHARE = 10;
const FASTEST = 2000;
const SETTER = { POSITION: 'SET_POS_REG', XYZWPR: 'SET_POS_REG', JOINTPOS: 'SET_JPOS_REG' };
/** Settings that a TP motion would not know of. */
const OTHERS =
  /^(SEGTERMTYPE|USE_CONFIG|ORIENT_TYPE|ROTSPEED|CONTAXISVEL|CNSTNT_PATH|SEG_TIME|USE\w*ACCEL|USE_CARTACC|USETIMESHFT|ACCEL_OVRD|TIME_SHIFT|ACCU_NUM)$/;

class Against extends Error {}

/** @param {string} reason @returns {never} */
function refuse(reason) {
  throw new Against(reason);
}

/**
 * @param {string} text
 * @param {Program} tree  that was read of it, without an error
 * @param {TpCallOptions} options
 * @returns {{ text: string, movers: { name: string, text: string }[] } | { reason: string }}
 */
export function writeTpCalls(text, tree, options) {
  try {
    return rewritten(text, tree, options);
  } catch (error) {
    if (error instanceof Against) return { reason: error.message };
    throw error;
  }
}

/** @param {string} text @param {Program} tree @param {TpCallOptions} options */
function rewritten(text, tree, options) {
  const { program, typeOf } = analyse(tree, options.files ?? {});
  const known = knownSettings(program);
  /** @type {(Move & { span: Span })[]} */
  const moves = [];
  for (const node of nodesOf(program)) {
    const one = /** @type {Statement} */ (node);
    const line = one.span?.line;
    if (one.kind === 'motion-control') refuse(`Line ${line}: ${one.action} is for motions of KAREL's own.`);
    if (one.kind === 'assign' && OTHERS.test(settingName(one.target)))
      refuse(`Line ${line}: $${settingName(one.target)} has no meaning for TP.`);
    if (one.kind === 'move') moves.push(/** @type {Move & { span: Span }} */ (one));
  }
  const words = new Set(text.toUpperCase().match(/[A-Z_]\w*/g) ?? []);
  const free = (/** @type {string} */ wanted) => {
    let one = wanted;
    for (let i = 2; words.has(one.toUpperCase()) || options.taken.has(one.toUpperCase()); i++) one = `${wanted}${i}`;
    words.add(one.toUpperCase());
    return one;
  };
  const [status, check] = [free('mv_stat'), free('mv_check')];
  const base = fanucNames(tree.name).tp.toLowerCase();
  /** By what they do. @type {Map<string, { name: string, manner: Manner }>} */
  const movers = new Map();
  const edits = moves.map((move) => {
    const { span } = move;
    const settings = known.get(move);
    const at = text.slice(span.start, span.end);
    if (span.file !== undefined || !settings || !/^(WITH|MOVE)\b/i.test(at) || at.includes('--'))
      refuse(`Line ${span.line}: this MOVE does not stand by itself in the program's text.`);
    const { position, setter, manner } = wanted(move, settings, typeOf);
    const key = JSON.stringify(manner);
    const mover = movers.get(key) ?? { name: free(base), manner };
    movers.set(key, mover);
    const begin = text.lastIndexOf('\n', span.start - 1) + 1;
    const [indent] = /^[ \t]*/.exec(text.slice(begin)) ?? [''];
    /** @type {Statement[]} */
    const statements = [
      call(setter, [integer(options.register), position, name(status)]),
      call(check, [string(setter)]),
      call(mover.name),
    ];
    return {
      ...{ from: span.start, to: span.end },
      text: linesOf(statements.flatMap(statementLines)).join(`\n${indent}`),
    };
  });
  const names = [...movers.values()];
  /** @type {Declaration[]} */
  const declared = [
    { kind: 'variables', entries: [{ names: [status], type: { kind: 'type', name: 'INTEGER' } }] },
    ...names.map((one) => /** @type {const} */ ({ kind: 'routine', name: one.name, parameters: [], from: one.name })),
    checkRoutine(status, check),
  ];
  return {
    text: applied(text, [...edits, ...headEdits(text, tree, declared)]),
    movers: names.map((one) => ({ name: one.name, text: listing(one, tree.name, options) })),
  };
}

/** @param {Move & { span: Span }} move @param {Settings} before @param {Map<object, { kind: string }>} typeOf */
function wanted({ span: { line }, target, settings = [], nowait, when, until }, before, typeOf) {
  const refuseHere = (/** @type {string} */ reason) => refuse(`Line ${line}: ${reason}`);
  if (target.to !== 'TO' || target.via)
    return refuseHere(`only MOVE TO becomes a TP call, not ${target.to === 'TO' ? 'VIA' : target.to}.`);
  if (nowait || when || until)
    refuseHere(`a TP call ends with its motion: ${nowait ? 'NOWAIT' : 'WHEN and UNTIL'} cannot stay.`);
  /** @type {Record<string, unknown>} */
  const now = { ...before };
  for (const { variable, value } of settings) {
    const called = settingName(variable);
    if (called === 'UFRAME' || called === 'UTOOL') refuseHere(`$${called} is to be set before, not by WITH.`);
    if (!['MOTYPE', 'SPEED', 'TERMTYPE', 'DECELTOL'].includes(called)) refuseHere(`$${called} has no meaning for TP.`);
    now[called] = valueOf(value, /** @type {'SPEED'} */ (called));
  }
  const need = (/** @type {string} */ called) => {
    const value = now[called];
    return typeof value === 'number'
      ? value
      : refuseHere(`$${called} is no number that is known here: set it right before.`);
  };
  const { kind } = typeOf.get(target.position) ?? { kind: '' };
  const setter = SETTER[/** @type {'XYZWPR'} */ (kind)];
  if (!setter) refuseHere('expected a POSITION, XYZWPR or JOINTPOS to move to.');
  const motion = need('MOTYPE');
  const isLinear = motion === LINEAR;
  if ((motion !== JOINT && !isLinear) || (isLinear && kind === 'JOINTPOS'))
    refuseHere(`expected $MOTYPE JOINT, or LINEAR to a position.`);
  const speed = isLinear ? Math.floor(need('SPEED')) : JOINT_SHARE;
  if (!(speed >= 1 && speed <= FASTEST)) refuseHere(`expected $SPEED from 1 to ${FASTEST}.`);
  const type = need('TERMTYPE');
  const ending = type === VARDECEL ? Math.round(need('DECELTOL')) : ENDINGS[type];
  if (ending === undefined || (ending !== null && !(ending >= 0 && ending <= 100)))
    refuseHere('expected a $TERMTYPE such as FINE or NODECEL, and $DECELTOL from 0 to 100.');
  const frames = ['UFRAME', 'UTOOL'].map((called) => {
    const value = now[called] === undefined ? 'chosen' : now[called];
    if (value === 'chosen' || typeof value === 'number') return value;
    return refuseHere(`$${called} is not known here: set it to $MNU${called.slice(1)} with a number, or to $NILPOS.`);
  });
  /** @type {Manner} */
  const manner = { motion: isLinear ? 'linear' : 'joint', speed, ending, frames };
  return { position: target.position, setter, manner };
}

/** @param {{ name: string, manner: Manner }} mover @param {string} caller @param {TpCallOptions} options */
function listing({ name: called, manner }, caller, { register, robotName, version, generatedAt }) {
  const { motion, speed, ending, frames } = manner;
  const [userFrame, tool] = frames;
  const lines = [
    ...remarks(`Go to PR[${register}]. Run ${caller.toUpperCase()}, not this: it fills the register, and calls this.`),
    ...remarks(`Written by Denavit ${version}.`),
    ...remarks('CAUTION: no controller has run this. Check it at low speed first.'),
    ...(motion === 'joint' ? remarks(`Joints at ${JOINT_SHARE} %: what $SPEED means for them is not verified.`) : []),
    ...(userFrame === 'chosen' ? [] : [setting('UFRAME_NUM', userFrame)]),
    ...(tool === 'chosen' ? [] : [setting('UTOOL_NUM', tool)]),
    motionFor(
      {
        ...{ motion, acceleration: 100 },
        speed: { value: speed, unit: motion === 'joint' ? '%' : 'mm/s' },
        ending: ending === null ? { kind: 'fine' } : { kind: 'percent', value: ending },
      },
      tpRegister('PR', register),
    ),
  ];
  return printTp(listingFor(called.toUpperCase(), { robotName, generatedAt }, lines, [])).replaceAll('\r\n', '\n');
}

/** Directives behind the program's name, declarations before its body. @param {string} text @param {Program} tree @param {readonly Declaration[]} declared @returns {Edit[]} */
function headEdits(text, tree, declared) {
  const own = tree.declarations.filter(({ span }) => span && span.file === undefined);
  const directives = /** @type {Directive[]} */ (own.filter(({ kind }) => kind === 'directive'));
  const holds = directives.find(({ name: called }) => called === 'LOCKGROUP');
  /** @type {Directive[]} */
  const missing = [
    ...(directives.some(({ word }) => word?.toUpperCase() === 'REGOPE')
      ? []
      : [/** @type {const} */ ({ kind: 'directive', name: 'ENVIRONMENT', word: 'REGOPE' })]),
    ...(holds || directives.some(({ name: called }) => called === 'NOLOCKGROUP')
      ? []
      : [/** @type {const} */ ({ kind: 'directive', name: 'NOLOCKGROUP' })]),
  ];
  const head = /^[ \t]*PROGRAM\b[^\n]*\n/im.exec(text);
  if (!head) return refuse('The program does not begin with PROGRAM in its own text.');
  const behindName = head.index + head[0].length;
  const last = Math.max(behindName - 1, ...own.map(({ span }) => /** @type {Span} */ (span).end));
  const lineEnd = text.indexOf('\n', last) + 1;
  const at = (/** @type {number} */ from, /** @type {string[]} */ lines) => ({
    ...{ from, to: from },
    text: lines.map((line) => `${line}\n`).join(''),
  });
  return [
    at(behindName, linesOf(declarationLines(missing))),
    at(lineEnd, linesOf(declarationLines(declared).filter((line) => line !== ''))),
    ...(holds?.span ? [{ from: holds.span.start, to: holds.span.end, text: '%NOLOCKGROUP' }] : []),
  ];
}

/** @param {string[]} printed */
const linesOf = (printed) => (printed.length === 0 ? [] : joinedLines(printed).trimEnd().split('\n'));

/** @param {string} text @param {readonly Edit[]} edits */
const applied = (text, edits) =>
  edits
    .map((edit, i) => ({ ...edit, i }))
    .sort((a, b) => b.from - a.from || b.i - a.i)
    .reduce((now, { from, to, text: by }) => now.slice(0, from) + by + now.slice(to), text);
