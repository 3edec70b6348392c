/**
 * The text of an instruction, without its line number.
 *
 * @import { TpInstruction, TpMotion, TpOperand, TpRegister } from './tree.js'
 */

/** What may stand in remarks, labels and texts: printable ASCII that ends neither the instruction nor its line. */
const FREE = /^[ -:<-~]*$/;
const PROGRAM = /^[A-Za-z_][A-Za-z0-9_$-]*$/;
const COMMENT = /^[ -:<-\\^-~]*$/;

/** @param {TpInstruction} node @returns {string} the two points of a circle with "\n" between them */
export function instructionText(node) {
  switch (node.kind) {
    case 'blank':
      return '';
    case 'remark':
      return `${node.language === undefined ? '!' : `--${node.language === '' ? '' : `${fitting('a language', node.language, /^[a-z]{2}$/)}:`}`}${fitting('a remark', node.text, FREE)}`;
    case 'disabled':
      return `//${fitting('a line that is taken out', node.text, FREE)}`;
    case 'unknown':
      return fitting('an instruction', node.text, FREE);
    case 'motion':
      return motionText(node);
    case 'assign':
      return `${operandText(node.target)}=${operandText(node.value)}${unitOf(node.target)}`;
    case 'label':
      return operandText(node.label);
    case 'jump':
      return `JMP ${operandText(node.label)}`;
    case 'call':
    case 'run': {
      const { program, args } = node;
      const name =
        typeof program === 'string' ? fitting('the name of a program', program, PROGRAM) : operandText(program);
      const list = args.length || node.parentheses ? `(${args.map(operandText).join(',')})` : '';
      return `${node.kind.toUpperCase()} ${name}${list}`;
    }
    case 'if':
      return `IF ${operandText(node.condition)},${instructionText(node.action)}`;
    case 'if-then':
      return `IF ${operandText(node.condition)} THEN`;
    case 'else':
    case 'endif':
    case 'endfor':
    case 'end':
    case 'abort':
    case 'pause':
      return node.kind.toUpperCase();
    case 'select':
      return `SELECT ${operandText(node.value)}=${operandText(node.choice)},${instructionText(node.action)}`;
    case 'case':
      return `       =${operandText(node.choice)},${instructionText(node.action)}`;
    case 'case-else':
      return `       ELSE,${instructionText(node.action)}`;
    case 'for':
      return `FOR ${operandText(node.variable)}=${operandText(node.from)} ${node.down ? 'DOWNTO' : 'TO'} ${operandText(node.to)}`;
    case 'wait': {
      const { seconds } = node;
      return seconds.kind === 'number'
        ? `WAIT ${seconds.value.toFixed(2).padStart(6)}(sec)`
        : `WAIT ${operandText(seconds)}`;
    }
    case 'wait-for':
      return `WAIT ${operandText(node.condition)}${node.timeout ? ` TIMEOUT,${operandText(node.timeout)}` : ''}`;
    case 'skip-condition':
      return `SKIP CONDITION ${operandText(node.condition)}`;
    case 'offset-condition':
      return `${node.isTool ? 'TOOL_OFFSET' : 'OFFSET'} CONDITION ${operandText(node.register)}`;
    case 'alarm':
      return `UALM[${operandText(node.number)}]`;
    case 'payload':
      return `PAYLOAD[${operandText(node.number)}]`;
    case 'message':
      return `MESSAGE[${fitting('a message', node.text, COMMENT)}]`;
  }
}

/** @param {TpMotion} motion */
function motionText({ motion, via, target, speed, termination, options }) {
  const points = via ? `${operandText(via)}\n${operandText(target)}` : operandText(target);
  const end = termination.kind === 'FINE' ? 'FINE' : `${termination.kind}${operandText(termination.value)}`;
  const more = options.map(({ name, value, text }) => {
    const glued = /^(ACC|EV)$/.test(name) ? '' : name === 'TB' || name === 'TA' || name === 'DB' ? ' ' : ',';
    const unit = name === 'DB' ? 'mm' : glued === ' ' ? 'sec' : '';
    const parts = [
      `${name}${value ? `${glued}${operandText(value)}${unit}` : ''}`,
      ...(text ? [fitting('an option', text, FREE)] : []),
    ];
    return ` ${parts.filter(Boolean).join(',')}`;
  });
  const isProcess = speed.value.kind === 'word';
  return `${motion} ${points} ${operandText(speed.value)}${isProcess ? '' : speed.unit} ${end}${more.join('')}`;
}

/** @param {TpOperand} target */
const unitOf = (target) => (target.kind === 'word' && target.word === 'OVERRIDE' ? '%' : '');

/** @param {TpOperand} node @returns {string} */
export function operandText(node) {
  switch (node.kind) {
    case 'register':
      return registerText(node);
    case 'number':
      return numberText(node.value);
    case 'string':
      return `'${fitting('a string', node.value, /^[ -&(-:<-~]*$/)}'`;
    case 'word':
      return fitting('a word', node.word, /^([A-Z_]+[+-]?|max_speed|\.\.\.)$/);
    case 'pulse':
      return node.seconds ? `PULSE,${operandText(node.seconds)}sec` : 'PULSE';
    case 'system':
      return fitting('a system variable', node.name, /^\$[A-Za-z0-9_$.[\],]+$/);
    case 'group':
      return `(${operandText(node.inner)})`;
    case 'unary':
      return `${node.operator}${operandText(node.operand)}`;
    case 'binary': {
      const space = /[A-Z]/.test(node.operator) ? ' ' : '';
      return `${operandText(node.left)}${space}${node.operator}${space}${operandText(node.right)}`;
    }
  }
}

/** @param {TpRegister} node */
function registerText({ bank, index, element, group, comment }) {
  const name = fitting('a bank of registers', bank, /^[A-Z_]+$/);
  const before = group === undefined ? '' : `GP${wholeNumber('a motion group', group, 1, 9)}:`;
  const behind = element ? `,${operandText(element)}` : '';
  const remark = comment === undefined ? '' : `:${fitting('a comment', comment, COMMENT)}`;
  return `${name}[${before}${operandText(index)}${behind}${remark}]`;
}

/** @param {number} value */
function numberText(value) {
  if (!Number.isFinite(value) || value < 0)
    throw new RangeError(`Expected 0 or more (a sign is an operator), got ${value}.`);
  const text = String(value);
  return text.includes('e') ? value.toFixed(6) : text;
}

/** @param {string} what @param {string} text @param {RegExp} pattern */
export function fitting(what, text, pattern) {
  if (pattern.test(text)) return text;
  throw new RangeError(`Expected ${what} that fits into a listing, got ${JSON.stringify(text)}.`);
}

/** @param {string} what @param {number} value @param {number} from @param {number} to */
export function wholeNumber(what, value, from, to) {
  if (Number.isInteger(value) && value >= from && value <= to) return value === 0 ? 0 : value;
  throw new RangeError(`Expected ${what} from ${from} to ${to}, a whole number, got ${value}.`);
}
