/**
 * WRITE and READ, and the files of a device that exists only here.
 *
 * @import { Designator, Item, Statement } from '../tree.js'
 * @import { Compiler } from './compiler.js'
 * @import { Frame, Locate, Machine } from './machine.js'
 * @import { Type } from '../check/types.js'
 */
import { PREDEFINED_FILES } from '../check/constants.js';
import { isDesignator } from '../check/context.js';
import { compileExpression, compileReference } from './expressions.js';
import { writtenText } from './format.js';
import { HALT } from './machine.js';
import { Alarm, number, record, single, text, whole } from './values.js';

/** IO_STATUS of a file that is not there, of one that has ended, and where a number was expected (as public programs know it). */
const NOT_THERE = 2014;
const ENDED = 2021;
const NO_NUMBER = 12333;
/** Not zero; that of a controller is not known. */
const NO_USAGE = 1;
const USAGES = new Set(['RO', 'RW', 'AP', 'UD']);
/** Of a file. */
const MOST_CHARACTERS = 10_000_000;

/** @param {Extract<Statement, { kind: 'write' | 'read' }>} statement @param {Compiler} compiler */
export function compileTransfer({ kind, file, items }, compiler) {
  const isDevice =
    file === undefined ||
    (typeof file === 'string' &&
      PREDEFINED_FILES.has(file.toUpperCase()) &&
      !compiler.analysis.scope.globals.has(file.toUpperCase()));
  const device = isDevice ? String(file ?? (kind === 'write' ? 'OUTPUT' : 'INPUT')).toUpperCase() : '';
  const at = isDevice
    ? null
    : compileReference(typeof file === 'string' ? nameOf(file, compiler) : /** @type {Designator} */ (file), compiler);
  if (kind === 'read') return compileRead(items, device, at, compiler);
  const pieces = items.map((item) => compilePiece(item, compiler));
  const { line } = compiler;
  const next = compiler.here() + 1;
  compiler.emit((machine, frame) => {
    const written = pieces.map((piece) => piece(machine, frame)).join('');
    frame.pc = next;
    if (at) {
      const { holder, key } = at(machine, frame);
      writeFile(machine, record(holder[key]), written);
      return next;
    }
    machine.effect = { kind: 'write', device, text: written, line };
    return HALT;
  });
}

/** @param {string} name @param {Compiler} compiler @returns {Designator} */
function nameOf(name, compiler) {
  const node = { kind: /** @type {const} */ ('name'), name };
  const symbol =
    compiler.routine?.locals.get(name.toUpperCase()) ?? compiler.analysis.scope.globals.get(name.toUpperCase());
  if (symbol) {
    compiler.analysis.symbolOf.set(node, symbol);
    if (symbol.kind === 'variable') compiler.analysis.typeOf.set(node, symbol.type);
  }
  return node;
}

/** @param {Item} item @param {Compiler} compiler @returns {(machine: Machine, frame: Frame) => string} */
function compilePiece(item, compiler) {
  if (item.kind === 'new-line') return () => '\n';
  const node = item.kind === 'format' ? item.value : item;
  const value = compileExpression(node, compiler);
  const formats = item.kind === 'format' ? item.formats.map((format) => compileExpression(format, compiler)) : [];
  const type = compiler.typeOf(node);
  const isReal = type.kind === 'REAL' || (type.kind === 'ARRAY' && type.of?.kind === 'REAL');
  return (m, f) => {
    const found = value(m, f);
    if (found === undefined) throw new Alarm('an uninitialised variable is read', 'uninitialised');
    return writtenText(
      found,
      isReal,
      formats.map((format) => number(format(m, f))),
    );
  };
}

/** @param {Machine} machine @param {Record<string, unknown>} file @param {string} written */
function writeFile({ state }, file, written) {
  if (typeof file.path !== 'string') throw new Alarm('the file is not open', 'file');
  const before = state.files[file.path] ?? '';
  if (before.length + written.length > MOST_CHARACTERS) throw new Alarm('the device is full', 'file');
  state.files[file.path] = before + written;
}

/** @param {readonly Item[]} items @param {string} device @param {Locate | null} at @param {Compiler} compiler */
function compileRead(items, device, at, compiler) {
  const targets = items.map((item) => {
    if (item.kind === 'new-line') return null;
    const node = item.kind === 'format' ? item.value : item;
    const width = item.kind === 'format' ? compileExpression(item.formats[0], compiler) : null;
    const isRaw = item.kind === 'format' && item.formats.length > 1;
    if (!isDesignator(node)) throw new RangeError('READ reads into variables.');
    return { at: compileReference(node, compiler), type: compiler.typeOf(node), width, isRaw };
  });
  const { line } = compiler;
  const here = compiler.here();
  compiler.emit((machine, frame) => {
    const { state } = machine;
    const reference = at?.(machine, frame);
    const file = reference && record(reference.holder[reference.key]);
    if (file && typeof file.path !== 'string') throw new Alarm('the file is not open', 'file');
    if (!file && state.input.length === 0) {
      // Whoever runs the program may put lines into the state and go on.
      machine.effect = { kind: 'read', device, line };
      frame.pc = here;
      return HALT;
    }
    let rest = file ? text(file.rest ?? '') : (state.input.shift() ?? '');
    if (file) file.status = 0;
    let isInLine = file?.isInLine === true;
    let isFaulty = false;
    for (const target of targets) {
      if (!target) {
        rest = rest.replace(/^[^\n]*\n?/, '');
        isInLine = isFaulty = false;
        continue;
      }
      const { holder, key } = target.at(machine, frame);
      if (file && (isFaulty || rest.slice(Number(isInLine && !target.isRaw && rest.startsWith('\n'))) === '')) {
        // What cannot be read has no value then, nor has what follows up to a CR.
        if (!isFaulty) file.status = ENDED;
        isFaulty = true;
        holder[key] = undefined;
      } else if (target.type.kind === 'STRING') {
        const most = Math.min(target.width ? number(target.width(machine, frame)) : 254, target.type.length ?? 254);
        // By two formats so many characters, line ends among them; otherwise a line at most, the next one at the end of one.
        if (!target.isRaw && isInLine && rest.startsWith('\n')) rest = rest.slice(1);
        const [found] = target.isRaw ? [rest] : (/^[^\n]*/.exec(rest) ?? ['']);
        const taken = found.slice(0, most);
        holder[key] = taken;
        rest = rest.slice(taken.length);
        isInLine = !taken.endsWith('\n');
      } else {
        const [taken, found] = /^\s*([^\s,]+),?/.exec(rest) ?? ['', ''];
        const value = /^[+-]?(\d+\.?\d*|\.\d+)(E[+-]?\d+)?$/i.test(found) ? Number(found) : NaN;
        const isRight = target.type.kind === 'BOOLEAN' ? found !== '' : !Number.isNaN(value);
        if (!isRight && !file) throw new Alarm(`a number was expected to be read, got "${rest}"`, 'read');
        if (!isRight && file) file.status = found === '' ? ENDED : NO_NUMBER;
        isFaulty = !isRight;
        holder[key] = isRight ? valueOf(target.type, found, value) : undefined;
        rest = rest.slice(taken.length);
        isInLine = true;
      }
    }
    if (file) Object.assign(file, { rest, isInLine });
    return here + 1;
  });
}

/** @param {Type} type @param {string} word  as it was read @param {number} value */
function valueOf({ kind }, word, value) {
  if (kind === 'BOOLEAN') return /^(ON|TRUE)$/i.test(word);
  return kind === 'REAL' ? single(value) : whole(Math.trunc(value));
}

/** @param {Extract<Statement, { kind: 'open-file' | 'close-file' | 'cancel-file' }>} statement @param {Compiler} compiler */
export function compileFileStatement(statement, compiler) {
  const at = compileReference(statement.file, compiler);
  const next = compiler.here() + 1;
  if (statement.kind !== 'open-file') {
    compiler.emit((m, f) => {
      const { holder, key } = at(m, f);
      holder[key] = { status: record(holder[key]).path === undefined ? 1 : 0 };
      return next;
    });
    return;
  }
  const usage = compileExpression(statement.usage, compiler);
  const path = compileExpression(statement.path, compiler);
  compiler.emit((m, f) => {
    const { files } = m.state;
    const name = text(path(m, f)).toUpperCase();
    const mode = text(usage(m, f)).toUpperCase();
    const { holder, key } = at(m, f);
    const isThere = Object.hasOwn(files, name);
    if (!USAGES.has(mode)) holder[key] = { status: NO_USAGE };
    else if (mode === 'RO' && !isThere) holder[key] = { status: NOT_THERE };
    else {
      if (mode === 'RW') files[name] = '';
      else if (!isThere) files[name] = '';
      holder[key] = { path: name, mode, rest: mode === 'RO' || mode === 'UD' ? files[name] : '', status: 0 };
    }
    return next;
  });
}
