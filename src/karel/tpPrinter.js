/**
 * TP program → `.LS` text, the listing that controllers with the ASCII upload option read. The only place where it is made.
 *
 * Field order, tabs, spaces before `;` and CRLF are those of listings that controllers exported. PROG_SIZE and MEMORY_SIZE
 * are 0: a controller works them out anew when it reads the listing. A tree that has no listing is a RangeError.
 *
 * @import { TpDate, TpLine, TpProgram } from './tpTree.js'
 */
import { MAX_COMMENT_LENGTH, MAX_REMARK_LENGTH } from './tpTree.js';

/** Line numbers have four places. */
const MAX_LINES = 9999;

/** PR[10001] and above mean something else, a program's own registers. */
const MAX_REGISTER = 10000;

const MAX_FRAME = 99;

/** Letters, digits and underscore; controllers from V9 on take 36. */
const PROGRAM_NAME = /^[A-Z][A-Z0-9_]{0,35}$/;

/** Printable ASCII that ends neither the quoted comment nor the instruction. */
const COMMENT = /^[ !#-:<-~]*$/;
const REMARK = /^[ -:<-~]*$/;

/** @param {TpProgram} program @returns {string} */
export function printTp({ name, comment, created, lines }) {
  if (lines.length > MAX_LINES) throw new RangeError(`Expected at most ${MAX_LINES} lines, got ${lines.length}.`);
  const moves = lines.some(({ kind }) => kind === 'joint-move');
  const text = [
    `/PROG  ${programName(name)}`,
    '/ATTR',
    'OWNER\t\t= MNEDITOR;',
    `COMMENT\t\t= "${fitting('a program comment', comment, 0, MAX_COMMENT_LENGTH, COMMENT)}";`,
    'PROG_SIZE\t= 0;',
    `CREATE\t\t= ${dateText(created)};`,
    `MODIFIED\t= ${dateText(created)};`,
    'FILE_NAME\t= ;',
    'VERSION\t\t= 0;',
    `LINE_COUNT\t= ${lines.length};`,
    'MEMORY_SIZE\t= 0;',
    'PROTECT\t\t= READ_WRITE;',
    'TCD:  STACK_SIZE\t= 0,',
    '      TASK_PRIORITY\t= 50,',
    '      TIME_SLICE\t= 0,',
    '      BUSY_LAMP_OFF\t= 0,',
    '      ABORT_REQUEST\t= 0,',
    '      PAUSE_REQUEST\t= 0;',
    `DEFAULT_GROUP\t= ${moves ? '1' : '*'},*,*,*,*;`,
    'CONTROL_CODE\t= 00000000 00000000;',
    '/MN',
    ...lines.map((line, i) => `${String(i + 1).padStart(4)}:${instruction(line)};`),
    '/POS',
    '/END',
  ];
  return text.map((line) => `${line}\r\n`).join('');
}

/** A motion begins right after the line number, everything else two places further. @param {TpLine} line @returns {string} */
function instruction(line) {
  switch (line.kind) {
    case 'remark':
      return `  !${fitting('a remark', line.text, 1, MAX_REMARK_LENGTH, REMARK)} `;
    case 'joint-move': {
      const speed = whole('a speed in percent', line.speedPercent, 1, 100);
      const end = line.termination === 'FINE' ? 'FINE' : `CNT${whole('a CNT value', line.termination, 0, 100)}`;
      return `J PR[${whole('a position register', line.register, 1, MAX_REGISTER)}] ${speed}% ${end}    `;
    }
    case 'call':
      return `  CALL ${programName(line.program)}    `;
    case 'user-frame':
      return `  UFRAME_NUM=${whole('a user frame', line.number, 0, MAX_FRAME)} `;
    case 'tool-frame':
      return `  UTOOL_NUM=${whole('a tool frame', line.number, 0, MAX_FRAME)} `;
    default: {
      /** @type {never} */
      const unknown = line;
      throw new TypeError(`Expected a line of a TP program, got ${JSON.stringify(unknown)}.`);
    }
  }
}

/** @param {string} name */
function programName(name) {
  if (PROGRAM_NAME.test(name)) return name;
  throw new RangeError(
    `Expected a TP program name (capital letters, digits, _; at most 36), got ${JSON.stringify(name)}.`,
  );
}

/** @param {string} what @param {string} text @param {number} shortest @param {number} longest @param {RegExp} pattern */
function fitting(what, text, shortest, longest, pattern) {
  if (text.length >= shortest && text.length <= longest && pattern.test(text)) return text;
  throw new RangeError(
    `Expected ${what} of ${shortest} to ${longest} characters of plain ASCII without " and ;, got ${JSON.stringify(text)}.`,
  );
}

/** @param {TpDate} date */
function dateText({ year, month, day, hour, minute, second }) {
  const two = (
    /** @type {string} */ what,
    /** @type {number} */ value,
    /** @type {number} */ from,
    /** @type {number} */ to,
  ) => String(whole(what, value, from, to)).padStart(2, '0');
  const shortYear = String(whole('a year', year, 2000, 2099) % 100).padStart(2, '0');
  const date = `${shortYear}-${two('a month', month, 1, 12)}-${two('a day', day, 1, 31)}`;
  return `DATE ${date}  TIME ${two('an hour', hour, 0, 23)}:${two('a minute', minute, 0, 59)}:${two('a second', second, 0, 59)}`;
}

/** @param {string} what @param {number} value @param {number} from @param {number} to */
function whole(what, value, from, to) {
  if (Number.isInteger(value) && value >= from && value <= to) return value === 0 ? 0 : value;
  throw new RangeError(`Expected ${what} from ${from} to ${to}, a whole number, got ${value}.`);
}
