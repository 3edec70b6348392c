/**
 * Built-ins for files of the device that exists only here. What a status is that is not on record is a number of our own, not zero.
 *
 * @import { Builtin, State } from './machine.js'
 */
import { held, put } from './builtinsMath.js';
import { number, record, text, truth } from './values.js';

/** Of files; the second is a number of our own. */
const NOT_THERE = 2014;
const REFUSED = 1;

/** @param {(files: State['files'], source: string, target: string) => void} carryOut @returns {(from: unknown, to: unknown, mayReplace: boolean, status: unknown, state: State) => void} */
const onTwo =
  (carryOut) =>
  (from, to, mayReplace, status, { files }) => {
    const [source, target] = [from, to].map((path) => text(path).toUpperCase());
    const isThere = Object.hasOwn(files, source);
    const isFree = mayReplace || !Object.hasOwn(files, target);
    if (isThere && isFree) carryOut(files, source, target);
    put(status, isThere ? (isFree ? 0 : REFUSED) : NOT_THERE);
  };

const copy = onTwo((files, source, target) => void (files[target] = files[source]));
const rename = onTwo((files, source, target) => {
  files[target] = files[source];
  delete files[source];
});

/** What is still to be read. @param {unknown} file */
const restOf = (file) => text(record(held(file)).rest ?? '');

/** All that was there to be read when it was opened, or written since. @param {unknown} file @param {State} state */
const wholeOf = (file, { files }) => files[String(record(held(file)).path)] ?? '';

/** @type {Readonly<Record<string, Builtin>>} */
export const FILES = {
  IO_STATUS: ([file]) => record(held(file)).status ?? 0,
  CLR_IO_STAT: ([file]) => void (record(held(file)).status = 0),
  BYTES_AHEAD: ([file, count, status]) => {
    put(count, restOf(file).length);
    put(status, 0);
  },
  BYTES_LEFT: ([file]) => restOf(file).length,
  GET_FILE_POS: ([file], { state }) => wholeOf(file, state).length - restOf(file).length,
  SET_FILE_POS: ([file, position, status], { state }) => {
    const whole = wholeOf(file, state);
    const at = number(position);
    const isWithin = at >= 0 && at <= whole.length && record(held(file)).path !== undefined;
    if (isWithin) Object.assign(record(held(file)), { rest: whole.slice(at), isInLine: false });
    put(status, isWithin ? 0 : REFUSED);
  },
  COPY_FILE: ([from, to, mayReplace, , status], { state }) => copy(from, to, truth(mayReplace), status, state),
  RENAME_FILE: ([from, to, , status], { state }) => rename(from, to, false, status, state),
  DELETE_FILE: ([path, , status], { state }) => {
    const isThere = Object.hasOwn(state.files, text(path).toUpperCase());
    delete state.files[text(path).toUpperCase()];
    put(status, isThere ? 0 : NOT_THERE);
  },
};
