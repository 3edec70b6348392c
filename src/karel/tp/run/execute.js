/**
 * One instruction of TP: what it does to the controller's memory, where the program goes on, and its effect, if it has one.
 *
 * @import { Effect } from '../../run/machine.js'
 * @import { Value } from '../../run/values.js'
 * @import { TpAction, TpAssign, TpCall, TpFor, TpLine, TpRegister, TpRun, TpWaitFor } from '../tree.js'
 * @import { TpFrame, TpMachine } from './memory.js'
 * @import { TpCode } from './program.js'
 */
import { beginMotion, needGroup } from '../../run/arm.js';
import { SCAN } from '../../run/machine.js';
import { Alarm, copied, number, numbers, text } from '../../run/values.js';
import { instructionText } from '../instructionText.js';
import { evaluate, indexOf, positionRegister, slotOf, truthOf } from './evaluate.js';
import { FRAME_KEYS, isNumberPort, PORTS, registerValue, setRegister, setTimer, systemKey } from './memory.js';
import { moveEffect } from './moves.js';

/** What `WAIT … TIMEOUT` waits for, in hundredths of a second, unless $WAITTMOUT was set: 30 s. */
const USUAL_TIMEOUT = 3000;

/** What a call of routines can go down to. */
const MAX_FRAMES = 100;

/**
 * @param {TpLine} line
 * @param {TpMachine} machine
 * @param {TpFrame} frame  its `at` is moved
 * @param {TpCode} code
 * @returns {Effect | null}
 */
export function execute({ instruction: node, span }, machine, frame, code) {
  const { state } = machine;
  const here = frame.at;
  switch (node.kind) {
    case 'blank':
    case 'remark':
    case 'disabled':
    case 'label':
    case 'endif':
      frame.at++;
      return null;
    case 'motion': {
      needGroup(state.arm, state.task);
      const effect = moveEffect(node, machine, frame);
      frame.motion = beginMotion(state.arm, { ...effect, line: span?.line ?? here + 1 }, state.time, state.task);
      frame.at++;
      return effect;
    }
    case 'if':
      frame.at++;
      return truthOf(evaluate(node.condition, machine, frame)) ? act(node.action, machine, frame, code) : null;
    case 'if-then':
      frame.at = truthOf(evaluate(node.condition, machine, frame)) ? here + 1 : blockEnd(here, code);
      return null;
    case 'else':
      // The lines before were carried out: those that follow are not.
      frame.at = blockEnd(here, code);
      return null;
    case 'select':
      return select(machine, frame, code);
    case 'case':
    case 'case-else':
      throw new Alarm('this line belongs to no SELECT', 'select');
    case 'for':
      return beginLoop(node, machine, frame, code);
    case 'endfor': {
      const begin = blockEnd(here, code);
      if (frame.limits[begin] === undefined) throw new Alarm('the FOR of this ENDFOR has not run', 'block');
      const loop = /** @type {TpFor} */ (code.lines[begin].instruction);
      const index = indexOf(loop.variable, machine, frame);
      const step = loop.down ? -1 : 1;
      const next = registerValue(state, index) + step;
      const isOver = (frame.limits[begin] - next) * step < 0;
      if (!isOver) setRegister(state, index, next);
      frame.at = isOver ? here + 1 : begin + 1;
      return null;
    }
    case 'wait':
      frame.wake = state.time + number(evaluate(node.seconds, machine, frame)) * 10 ** 3;
      return null;
    case 'wait-for':
      return waitFor(node, machine, frame, code);
    case 'skip-condition':
      state.system['SKIP_CONDITION'] = { program: frame.program, line: here };
      frame.at++;
      return null;
    case 'offset-condition':
      state.system[`${node.isTool ? 'TOOL_OFFSET' : 'OFFSET'}_CONDITION`] = indexOf(node.register, machine, frame);
      frame.at++;
      return null;
    case 'alarm': {
      frame.at++;
      const code_ = number(evaluate(node.number, machine, frame));
      return { kind: 'error', code: code_, message: `UALM[${code_}]`, severity: 1 };
    }
    case 'payload':
      state.system['PAYLOAD'] = number(evaluate(node.number, machine, frame));
      frame.at++;
      return null;
    case 'message':
      frame.at++;
      return { kind: 'write', device: 'TPUSER', text: `${node.text}\n` };
    case 'unknown':
      frame.at++;
      return { kind: 'skipped', text: node.text };
    default:
      frame.at++;
      return act(node, machine, frame, code);
  }
}

/** @param {number} at @param {TpCode} code */
function blockEnd(at, { further }) {
  const end = further.get(at);
  if (end === undefined) throw new Alarm('the block that begins or ends here has no other end', 'block');
  return end;
}

/** @param {TpAction} node @param {TpMachine} machine @param {TpFrame} frame @param {TpCode} code @returns {Effect | null} */
function act(node, machine, frame, code) {
  const { state } = machine;
  switch (node.kind) {
    case 'jump':
      jump(node.label, machine, frame, code);
      return null;
    case 'assign':
      assign(node, machine, frame);
      return null;
    case 'call':
    case 'run':
      return call(node, machine, frame);
    case 'end':
      state.frames.pop();
      return null;
    case 'abort':
      return { kind: 'abort' };
    case 'pause':
      return { kind: 'pause' };
    default:
      throw new Alarm(`${instructionText(node)} cannot stand behind a comma`, 'action');
  }
}

/** @param {TpRegister} label @param {TpMachine} machine @param {TpFrame} frame @param {TpCode} code */
export function jump(label, machine, frame, { labels }) {
  const index = indexOf(label, machine, frame);
  const at = labels.get(index);
  if (at === undefined) throw new Alarm(`LBL[${index}] is not in this program`, 'label');
  frame.at = at;
}

/** @param {TpCall | TpRun} node @param {TpMachine} machine @param {TpFrame} frame @returns {Effect | null} */
function call({ kind, program, args }, machine, frame) {
  const name = (typeof program === 'string' ? program : text(evaluate(program, machine, frame))).toUpperCase();
  const values = args.map((arg) => copied(evaluate(arg, machine, frame)));
  if (kind === 'run') return { kind: 'run-task', program: name, args: values };
  if (!machine.codes.has(name)) return { kind: 'call', program: name, args: values };
  if (machine.state.frames.length >= MAX_FRAMES) throw new Alarm('programs call each other too deeply', 'stack');
  machine.state.frames.push(frameFor(name, values));
  return null;
}

/** @param {string} program @param {readonly Value[]} args @returns {TpFrame} */
export const frameFor = (program, args) => ({ program, at: 0, args, limits: {}, before: {} });

/** @param {TpMachine} machine @param {TpFrame} frame @param {TpCode} code @returns {Effect | null} */
function select(machine, frame, code) {
  const head = code.lines[frame.at].instruction;
  if (head.kind !== 'select') return null;
  const value = evaluate(head.value, machine, frame);
  /** @type {TpAction | null} */
  let chosen = null;
  let at = frame.at;
  for (; at < code.lines.length; at++) {
    const one = code.lines[at].instruction;
    if (one !== head && one.kind !== 'case' && one.kind !== 'case-else') break;
    if (one.kind !== 'select' && one.kind !== 'case' && one.kind !== 'case-else') break;
    if (!chosen && (one.kind === 'case-else' || evaluate(one.choice, machine, frame) === value)) chosen = one.action;
  }
  frame.at = at;
  return chosen && act(chosen, machine, frame, code);
}

/** @param {TpFor} node @param {TpMachine} machine @param {TpFrame} frame @param {TpCode} code */
function beginLoop({ variable, from, to, down }, machine, frame, code) {
  const first = number(evaluate(from, machine, frame));
  const last = number(evaluate(to, machine, frame));
  const end = blockEnd(frame.at, code);
  setRegister(machine.state, indexOf(variable, machine, frame), first);
  frame.limits[frame.at] = last;
  frame.at = (last - first) * (down ? -1 : 1) >= 0 ? frame.at + 1 : end + 1;
  return null;
}

/** @param {TpWaitFor} node @param {TpMachine} machine @param {TpFrame} frame @param {TpCode} code @returns {Effect | null} */
function waitFor({ condition, timeout }, machine, frame, code) {
  const { state } = machine;
  if (truthOf(evaluate(condition, machine, frame))) {
    delete frame.since;
    frame.before = {};
    frame.at++;
    return null;
  }
  frame.since ??= state.time;
  const limit = 10 * number(state.system['WAITTMOUT'] ?? USUAL_TIMEOUT);
  if (timeout && state.time - frame.since >= limit) {
    delete frame.since;
    frame.before = {};
    jump(timeout, machine, frame, code);
    return null;
  }
  frame.wake = state.time + SCAN;
  return null;
}

/** @param {TpAssign} node @param {TpMachine} machine @param {TpFrame} frame */
function assign({ target, value: node }, machine, frame) {
  const { state } = machine;
  if (target.kind === 'word') {
    const value = number(evaluate(node, machine, frame));
    if (target.word === 'UFRAME_NUM' || target.word === 'UTOOL_NUM') state.system[FRAME_KEYS[target.word]] = value;
    else state.system[target.word] = value;
    return;
  }
  if (target.kind === 'system') {
    state.system[systemKey(target.name)] = evaluate(node, machine, frame);
    return;
  }
  const { bank, element } = target;
  const index = indexOf(target, machine, frame);
  if (bank === 'TIMER' && node.kind === 'word') return setTimer(state, index, node.word);
  if (Object.hasOwn(PORTS, bank)) return setPort(bank, index, node, machine, frame);
  const value = evaluate(node, machine, frame);
  switch (bank) {
    case 'R':
      return setRegister(state, index, typeof value === 'boolean' ? Number(value) : number(value));
    case 'PR':
      if (!element) return void (state.positionRegisters[index] = [...numbers(value)]);
      return setElement(machine, index, number(evaluate(element, machine, frame)), number(value));
    case 'SR':
      return void (state.stringRegisters[index] = typeof value === 'string' ? value : String(value));
    case 'UFRAME':
    case 'UTOOL':
      return void (state.system[`${FRAME_KEYS[bank]}[${index}]`] = [...numbers(value)]);
  }
  throw new Alarm(`${bank}[${index}] cannot be set`, 'assignment');
}

/** @param {TpMachine} machine @param {number} index @param {number} element @param {number} value */
function setElement(machine, index, element, value) {
  const position = numbers(positionRegister(machine, index));
  position[slotOf(element, position)] = value;
}

/** @param {string} bank @param {number} index @param {TpAssign['value']} node @param {TpMachine} machine @param {TpFrame} frame */
function setPort(bank, index, node, machine, frame) {
  const { state } = machine;
  const port = PORTS[bank];
  const values = (state.ports[port] ??= {});
  if (node.kind !== 'pulse') {
    const value = evaluate(node, machine, frame);
    values[index] = isNumberPort(bank) ? number(value) : truthOf(value);
    return;
  }
  // Without a time of its own a pulse is as long as the controller is set up for: taken as a tenth of a second.
  const seconds = node.seconds ? number(evaluate(node.seconds, machine, frame)) : 1 / 10;
  values[index] = true;
  state.pulses.push({ kind: 'pulse', port, index, value: false, at: state.time + seconds * 10 ** 3 });
}
