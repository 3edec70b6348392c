/**
 * Expressions of TP: numbers, ON and OFF (true and false), texts, and positions as KAREL has them.
 *
 * @import { TpBinary, TpOperand, TpRegister } from '../tree.js'
 * @import { Value } from '../../run/values.js'
 * @import { TpFrame, TpMachine } from './memory.js'
 */
import { Alarm, copied, number, numbers, single } from '../../run/values.js';
import { operandText } from '../instructionText.js';
import { FRAME_KEYS, isNumberPort, PORTS, registerValue, systemKey, timerValue } from './memory.js';
import { CARTESIAN_SLOTS, isJoint, pointValues } from './points.js';

/** @param {TpOperand} node @param {TpMachine} machine @param {TpFrame} frame @returns {Value} */
export function evaluate(node, machine, frame) {
  switch (node.kind) {
    case 'number':
    case 'string':
      return node.value;
    case 'group':
      return evaluate(node.inner, machine, frame);
    case 'unary': {
      const value = evaluate(node.operand, machine, frame);
      if (node.operator === '!') return !truthOf(value);
      return node.operator === '-' ? -number(value) : number(value);
    }
    case 'binary':
      return combine(node, machine, frame);
    case 'word':
      return wordValue(node.word, machine);
    case 'system': {
      const value = machine.state.system[systemKey(node.name)];
      if (value === undefined) throw new Alarm(`${node.name} has no value here`, 'uninitialised');
      return copied(value);
    }
    case 'register':
      return readRegister(node, machine, frame);
    case 'pulse':
      throw new Alarm('PULSE is no value', 'operand');
  }
}

/** @param {string} word @param {TpMachine} machine @returns {Value} */
function wordValue(word, { state, host }) {
  if (word === 'ON' || word === 'TRUE' || word === 'ENABLE') return true;
  if (word === 'OFF' || word === 'FALSE' || word === 'DISABLE') return false;
  if (word === 'LPOS') return [...(host.position?.() ?? NOWHERE), 0, 0, 0, 0].slice(0, 10);
  if (word === 'JPOS') return [...(host.joints?.() ?? NOWHERE)];
  if (word === 'UFRAME_NUM' || word === 'UTOOL_NUM') return state.system[FRAME_KEYS[word]] ?? 0;
  throw new Alarm(`${word} is no value here`, 'operand');
}

const NOWHERE = [0, 0, 0, 0, 0, 0];

/** The number in the brackets. @param {TpRegister} node @param {TpMachine} machine @param {TpFrame} frame */
export function indexOf(node, machine, frame) {
  const index = number(evaluate(node.index, machine, frame));
  if (Number.isInteger(index) && index >= 0) return index;
  throw new Alarm(`${node.bank}[…] has the index ${index}`, 'index');
}

/** @param {TpRegister} node @param {TpMachine} machine @param {TpFrame} frame @returns {Value} */
function readRegister(node, machine, frame) {
  const { bank, element } = node;
  const { state } = machine;
  const index = indexOf(node, machine, frame);
  if (Object.hasOwn(PORTS, bank)) return state.ports[PORTS[bank]]?.[index] ?? (isNumberPort(bank) ? 0 : false);
  switch (bank) {
    case 'R':
      return registerValue(state, index);
    case 'PR': {
      const position = numbers(positionRegister(machine, index));
      if (!element) return [...position];
      return position[slotOf(number(evaluate(element, machine, frame)), position)];
    }
    case 'SR':
      return state.stringRegisters[index] ?? '';
    case 'AR':
      if (frame.args[index - 1] === undefined) throw new Alarm(`AR[${index}] was not handed over`, 'argument');
      return copied(frame.args[index - 1]);
    case 'TIMER':
      return timerValue(state, index);
    case 'P':
      return pointValues(node, machine, frame, index).values;
    case 'UFRAME':
    case 'UTOOL':
      return copied(state.system[`${FRAME_KEYS[bank]}[${index}]`] ?? [0, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
  }
  throw new Alarm(`${bank}[${index}] cannot be read here`, 'operand');
}

/** @param {TpMachine} machine @param {number} index */
export function positionRegister({ state }, index) {
  const found = state.positionRegisters[index];
  if (found === undefined) throw new Alarm(`PR[${index}] has no value`, 'uninitialised');
  return found;
}

/** Where element j of a position register is kept. @param {number} j  from 1 @param {readonly unknown[]} position */
export function slotOf(j, position) {
  const slots = isJoint(position) ? position.length : CARTESIAN_SLOTS.length;
  if (Number.isInteger(j) && j >= 1 && j <= slots) return isJoint(position) ? j - 1 : CARTESIAN_SLOTS[j - 1];
  throw new Alarm(`the element ${j} is not from 1 to ${slots}`, 'index');
}

/** @param {TpBinary} node @param {TpMachine} machine @param {TpFrame} frame @returns {Value} */
function combine(node, machine, frame) {
  const { operator } = node;
  if (operator === 'AND' || operator === 'OR') {
    // Both are looked at, so that edges are not missed.
    const [a, b] = [node.left, node.right].map((side) => truthOf(evaluate(side, machine, frame)));
    return operator === 'AND' ? a && b : a || b;
  }
  const left = evaluate(node.left, machine, frame);
  const edge = node.right.kind === 'word' && /^(ON|OFF)[+-]$/.exec(node.right.word);
  if (edge) return edgeSeen(operandText(node.left), truthOf(left), edge[1] === 'ON', frame);
  return calculate(operator, left, evaluate(node.right, machine, frame));
}

/** @param {string} key @param {boolean} now @param {boolean} wanted @param {TpFrame} frame */
function edgeSeen(key, now, wanted, frame) {
  const before = frame.before[key];
  frame.before[key] = now;
  return now === wanted && before === !wanted;
}

/** @param {TpBinary['operator']} operator @param {Value} left @param {Value} right @returns {Value} */
function calculate(operator, left, right) {
  if (operator === '=' || operator === '<>') {
    const isSame =
      typeof left === 'string' || typeof right === 'string' ? left === right : plain(left) === plain(right);
    return isSame === (operator === '=');
  }
  if (Array.isArray(left) && Array.isArray(right) && (operator === '+' || operator === '-'))
    return addPositions(numbers(left), numbers(right), operator === '+' ? 1 : -1);
  if (operator === '+' && typeof left === 'string') return left + String(right);
  const [a, b] = [plain(left), plain(right)];
  switch (operator) {
    case '+':
      return a + b;
    case '-':
      return a - b;
    case '*':
      return a * b;
    case '/':
      return a / nonZero(b);
    case 'DIV':
      return Math.trunc(a / nonZero(b));
    case 'MOD':
      return a % nonZero(b);
    case '<':
      return a < b;
    case '<=':
      return a <= b;
    case '>':
      return a > b;
    case '>=':
      return a >= b;
  }
  throw new Alarm(`${operator} does not go with these`, 'operand');
}

/** @param {number} value */
function nonZero(value) {
  if (value === 0) throw new Alarm('division by zero', 'division');
  return value;
}

/** Number by number; the configuration is the first one's. @param {number[]} a @param {number[]} b @param {1 | -1} sign */
function addPositions(a, b, sign) {
  if (a.length !== b.length) throw new Alarm('a Cartesian position and joint values are not added', 'operand');
  return a.map((value, i) => (!isJoint(a) && i === 6 ? value : single(value + sign * b[i])));
}

/** @param {Value} value */
const plain = (value) => (typeof value === 'boolean' ? Number(value) : number(value));

/** @param {Value} value @returns {boolean} */
export function truthOf(value) {
  if (typeof value === 'boolean') return value;
  return number(value) !== 0;
}
