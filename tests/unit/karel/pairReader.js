/**
 * Reads the two files of a FANUC pair line by line, by a grammar of their lines written down here: what it does not know
 * it throws at.
 */

/** What a KAREL program of a pair consists of, besides comments and empty lines, up to its body. */
const KAREL_HEAD = [
  /^PROGRAM ([a-z][a-z0-9_]{0,7})$/,
  /^%COMMENT = '([A-Za-z0-9 _.:()*@-]{1,16})'$/,
  /^%ENVIRONMENT REGOPE$/,
  /^%NOLOCKGROUP$/,
  /^%NOPAUSE = ERROR \+ COMMAND \+ TPENABLE$/,
  /^VAR$/,
  /^ {2}joints : ARRAY\[([1-9])\] OF REAL$/,
  /^ {2}target : JOINTPOS$/,
  /^ {2}status : INTEGER$/,
  /^ROUTINE ([a-z][a-z0-9_]{0,7}) FROM \1$/,
  /^ROUTINE fill\(reg_no : INTEGER\)$/,
  /^BEGIN$/,
  /^ {2}CNV_REL_JPOS\(joints, target, status\)$/,
  /^ {2}IF status <> 0 THEN$/,
  /^ {4}WRITE\('[^']*', reg_no, '[^']*', status, CR\)$/,
  /^ {4}ABORT$/,
  /^ {2}ENDIF$/,
  /^ {2}IF NOT J_IN_RANGE\(target\) THEN$/,
  /^ {4}WRITE\('[^']*', reg_no, '[^']*', CR\)$/,
  /^ {4}ABORT$/,
  /^ {2}ENDIF$/,
  /^ {2}SET_JPOS_REG\(reg_no, target, status\)$/,
  /^ {2}IF status <> 0 THEN$/,
  /^ {4}WRITE\('[^']*', reg_no, '[^']*', status, CR\)$/,
  /^ {4}ABORT$/,
  /^ {2}ENDIF$/,
  /^END fill$/,
  /^BEGIN$/,
];
const KAREL_COMMENT = /^ *--( [!-~]([ -~]*[!-~])?| {2,}[!-~]([ -~]*[!-~])?)?$/;

/** Lines, the last of them ended, too; no other kind of line end. @param {string} text @param {string} end */
function linesOf(text, end) {
  if (!text.endsWith(end)) throw new Error('The last line has no end.');
  const lines = text.slice(0, -end.length).split(end);
  for (const line of lines) if (!/^[\t -~]*$/.test(line)) throw new Error(`Not plain: ${JSON.stringify(line)}`);
  return lines;
}

/** @param {string} line @param {RegExp} pattern */
function matched(line, pattern) {
  const match = pattern.exec(line);
  if (!match) throw new Error(`Expected ${pattern}, got ${JSON.stringify(line)}`);
  return match;
}

/** @param {string} text */
export function readKarelPair(text) {
  const statements = linesOf(text, '\n').filter((line) => line !== '' && !KAREL_COMMENT.test(line));
  const take = (/** @type {RegExp} */ pattern) => matched(statements.shift() ?? 'nothing', pattern);
  const head = KAREL_HEAD.map(take);
  const [program, axes, calls] = [head[0][1], Number(head[6][1]), head[9][1]];

  /** @type {{ register: number, values: number[] }[]} */
  const points = [];
  while (statements.length > 2) {
    const values = Array.from({ length: axes }, (_, i) => {
      const [, index, value] = take(/^ {2}joints\[(\d)\] = (-?\d{1,5}\.\d{3})$/);
      if (Number(index) !== i + 1 || value === '-0.000') throw new Error(`Unexpected ${value} in joints[${index}]`);
      return Number(value);
    });
    points.push({ register: Number(take(/^ {2}fill\(([1-9]\d{0,3})\)$/)[1]), values });
  }
  matched(take(/^ {2}(.*)$/)[1], new RegExp(`^${calls}$`));
  matched(take(/^END (.*)$/)[1], new RegExp(`^${program}$`));
  return { program, axes, calls, points };
}

const TP_HEAD = [
  /^\/PROG {2}([A-Z][A-Z0-9_]{0,7})$/,
  /^\/ATTR$/,
  /^OWNER\t\t= MNEDITOR;$/,
  /^COMMENT\t\t= "[^";]{0,16}";$/,
  /^PROG_SIZE\t= 0;$/,
  /^CREATE\t\t= DATE \d\d-\d\d-\d\d {2}TIME \d\d:\d\d:\d\d;$/,
  /^MODIFIED\t= DATE \d\d-\d\d-\d\d {2}TIME \d\d:\d\d:\d\d;$/,
  /^FILE_NAME\t= ;$/,
  /^VERSION\t\t= 0;$/,
  /^LINE_COUNT\t= (\d+);$/,
  /^MEMORY_SIZE\t= 0;$/,
  /^PROTECT\t\t= READ_WRITE;$/,
  /^TCD: {2}STACK_SIZE\t= 0,$/,
  /^ {6}TASK_PRIORITY\t= 50,$/,
  /^ {6}TIME_SLICE\t= 0,$/,
  /^ {6}BUSY_LAMP_OFF\t= 0,$/,
  /^ {6}ABORT_REQUEST\t= 0,$/,
  /^ {6}PAUSE_REQUEST\t= 0;$/,
  /^DEFAULT_GROUP\t= 1,\*,\*,\*,\*;$/,
  /^CONTROL_CODE\t= 00000000 00000000;$/,
  /^\/MN$/,
];

/** @param {string} text */
export function readTpPair(text) {
  const lines = linesOf(text, '\r\n');
  const head = TP_HEAD.map((pattern) => matched(lines.shift() ?? 'nothing', pattern));
  matched(lines.splice(-2).join(' '), /^\/POS \/END$/);
  if (Number(head[9][1]) !== lines.length) throw new Error(`LINE_COUNT ${head[9][1]} for ${lines.length} lines`);

  /** @type {{ register: number, speed: number, end: string }[]} */
  const moves = [];
  lines.forEach((line, i) => {
    const [, number, instruction] = matched(line, /^ *(\d+):(.*)$/);
    if (Number(number) !== i + 1 || line.indexOf(':') !== 4) throw new Error(`Numbered wrongly: ${line}`);
    if (/^ {2}![^;]{1,32} ;$/.test(instruction)) return;
    const [, register, speed, end] = matched(instruction, /^J PR\[(\d+)\] (\d+)% (FINE|CNT\d+) {4};$/);
    moves.push({ register: Number(register), speed: Number(speed), end });
  });
  return { program: head[0][1], moves };
}
