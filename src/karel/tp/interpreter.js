/**
 * A TP program, run: a generator of the same effects as KAREL's interpreter (`../interpreter.js`), and of `skipped` for an
 * instruction that is not known. A move says where to as KAREL's does (`position`, `isJoint`), and with it the motion type, the
 * speed, how it ends and the frames. Other TP programs are in `listings`; a call of what is not there is an effect. All that it
 * knows is one plain state.
 *
 * @import { Outcome } from '../interpreter.js'
 * @import { Effect, Host, Idle, State } from '../run/machine.js'
 * @import { Value } from '../run/values.js'
 * @import { TpListing, TpMotion } from './tree.js'
 * @import { Memory, TpFrame, TpMachine, TpState } from './run/memory.js'
 * @import { TpCode } from './run/program.js'
 *
 * @typedef {Omit<Outcome, 'state'> & { state: TpState }} TpOutcome
 * @typedef {object} TpSetting
 * @property {Readonly<Record<string, TpListing>>} [listings]  by their names
 * @property {Memory} [memory]   the controller's, where it has been used already
 * @property {readonly Value[]} [args]
 */
import { cancelMotion, isUnderWay, newArm, nextOfArm } from '../run/arm.js';
import { DEFAULT_STEPS, passTime, SCAN, STATEMENT_TIME, waitUntil } from '../run/machine.js';
import { Alarm, copiedState } from '../run/values.js';
import { evaluate, truthOf } from './run/evaluate.js';
import { execute, frameFor, jump } from './run/execute.js';
import { prepareTp } from './run/program.js';
import { attributeOf, nameOf } from './tree.js';

/** @param {TpListing} listing @param {Host} [host] @param {TpSetting} [setting] @returns {Generator<Effect, TpOutcome, unknown>} */
export function* runTp(listing, host = {}, setting = {}) {
  return yield* runTpMachine(createTpMachine(listing, host, setting));
}

/** @param {TpListing} listing @param {Host} [host] @param {TpSetting} [setting] @returns {TpMachine} */
export function createTpMachine(listing, host = {}, { listings = {}, memory, args = [] } = {}) {
  const all = [...Object.entries(listings).map(([name, one]) => /** @type {const} */ ([name.toUpperCase(), one]))];
  const name = nameOf(listing);
  const codes = new Map([...all, /** @type {const} */ ([name, listing])].map(([key, one]) => [key, prepareTp(one)]));
  const own = memory ?? emptyMemory(hasTpGroup(listing) ? name : null);
  return { codes, host, state: { ...own, frames: [frameFor(name, args)], nextScan: SCAN, task: name } };
}

/** Whether a program has the motion group from its beginning. @param {TpListing} listing */
export const hasTpGroup = (listing) => !/^\s*\*/.test(attributeOf(listing, 'DEFAULT_GROUP') ?? '1');

/** @param {string | null} holder  of the motion group @returns {Memory} */
const emptyMemory = (holder) => ({
  ...{ time: 0, steps: 0, ports: {}, registers: {}, positionRegisters: {}, stringRegisters: {} },
  ...{ system: {}, pulses: [], timers: [], arm: newArm(holder) },
});

/** @param {TpMachine} machine */
export const saveTpState = (machine) => copiedState(machine.state);

/** @param {TpMachine} machine @param {TpState} state */
export const restoreTpState = (machine, state) => void (machine.state = copiedState(state));

/**
 * From where the machine is. Whatever is left to do after an effect is in the state, so that it may be put back there.
 * @param {TpMachine} machine
 * @returns {Generator<Effect, TpOutcome, unknown>}
 */
export function* runTpMachine(machine) {
  const turns = runTpTurns(machine);
  for (let next = turns.next(); ; next = turns.next()) {
    if (next.done) return next.value;
    const effect = next.value;
    if (effect.kind === 'turn') continue;
    yield effect.kind === 'idle' ? waitUntil(machine.state, /** @type {Idle} */ (effect)) : effect;
  }
}

/** Instructions before others have their turn. */
const TURN = 100;

/** The same, for whoever has the time: `turn` where others may have theirs, and `idle` where it has nothing to do. @param {TpMachine} machine @returns {Generator<Effect, TpOutcome, unknown>} */
export function* runTpTurns(machine) {
  const { host, codes } = machine;
  const most = host.steps ?? DEFAULT_STEPS;
  while (true) {
    const { state } = machine;
    passTime({ state });
    const frame = state.frames.at(-1);
    if (!frame) return { status: 'ended', state };
    if (state.steps >= most) return { status: 'budget', state };
    const code = codes.get(frame.program);
    waken(frame, state.time, code);
    const line = code?.lines[frame.at];
    const move = frame.skip === undefined ? undefined : code?.lines[frame.skip];
    const place = (move ?? line)?.span?.line ?? frame.at + 1;
    /** @type {Effect | null} */
    let effect;
    try {
      const until = waitsUntil(machine, frame, code);
      if (until > state.time) {
        yield { kind: 'idle', until, line: place, program: frame.program };
        continue;
      }
      if (code && move) {
        skipOrGoOn(machine, frame, code);
        continue;
      }
      if (!code || !line) {
        state.frames.pop();
        continue;
      }
      if (host.traceSteps && !frame.isTold && frame.since === undefined && !SILENT.has(line.instruction.kind)) {
        frame.isTold = true;
        yield { kind: 'step', line: place, routine: frame.program };
      }
      frame.isTold = false;
      state.steps++;
      state.time += STATEMENT_TIME;
      const before = frame.at;
      effect = execute(line, machine, frame, code);
      if (line.instruction.kind === 'motion' && skipOf(line.instruction)) frame.skip = before;
    } catch (alarm) {
      if (!(alarm instanceof Alarm)) throw alarm;
      const { code: kind, message } = alarm;
      return { status: 'alarm', state, alarm: { code: kind, reason: message, line: place, routine: frame.program } };
    }
    if (effect?.kind === 'abort') return { status: 'aborted', state };
    if (effect) yield { ...effect, line: place, program: effect.program ?? frame.program };
    else if (state.steps % TURN === 0) yield { kind: 'turn', line: place };
  }
}

const SILENT = new Set(['blank', 'remark', 'disabled', 'label']);

/** What it waited for is there. @param {TpFrame} frame @param {number} time @param {TpCode} [code] */
function waken(frame, time, code) {
  if (frame.wake === undefined || frame.wake > time) return;
  delete frame.wake;
  if (code?.lines[frame.at]?.instruction.kind === 'wait') frame.at++;
}

/** Until when a program waits: for some time, for its motion, or for the arm. Not after now: it goes on. @param {TpMachine} machine @param {TpFrame} frame @param {TpCode} [code] */
function waitsUntil(machine, frame, code) {
  const { state } = machine;
  if (frame.wake !== undefined) return frame.wake;
  if (frame.look !== undefined && frame.look > state.time) return frame.look;
  const isLook = scan(machine);
  const isMoving = frame.motion !== undefined && isUnderWay(state.arm, frame.motion);
  if (isMoving && isLook && code) watchSkip(machine, frame, code);
  const isNext =
    code?.lines[frame.at]?.instruction.kind === 'motion' && (state.arm.holder ?? state.task) === state.task;
  if (isMoving || (state.arm.motion && isNext)) return (frame.look = Math.min(nextOfArm(state.arm), state.nextScan));
  delete frame.motion;
  delete frame.look;
  return -Infinity;
}

/** @param {TpMachine} machine @returns {boolean} whether it is time to look at what is watched */
function scan({ state, host }) {
  if (state.time < state.nextScan) return false;
  state.nextScan = state.time + SCAN;
  host.onScan?.(/** @type {State} */ (/** @type {unknown} */ (state)));
  return true;
}

/** @param {TpMotion} motion */
const skipOf = ({ options }) => options.find(({ name }) => name.toUpperCase() === 'SKIP')?.value;

/** Skip,LBL[n]: a move whose condition is met comes to rest on its way. @param {TpMachine} machine @param {TpFrame} frame @param {TpCode} code */
function watchSkip(machine, frame, code) {
  const { arm } = machine.state;
  if (frame.skip === undefined || frame.isSkipped || arm.motion?.number !== frame.motion) return;
  if (!isSkipMet(machine, frame, code)) return;
  frame.isSkipped = true;
  cancelMotion(arm);
}

/**
 * Where the condition was not met until the move had ended, the program goes on at the label.
 * @param {TpMachine} machine
 * @param {TpFrame} frame
 * @param {TpCode} code
 */
function skipOrGoOn(machine, frame, code) {
  const motion = code.lines[frame.skip ?? 0].instruction;
  const label = motion.kind === 'motion' ? skipOf(motion) : undefined;
  const isMet = frame.isSkipped || label?.kind !== 'register' || isSkipMet(machine, frame, code);
  delete frame.skip;
  delete frame.isSkipped;
  if (!isMet && label?.kind === 'register') jump(label, machine, frame, code);
}

/** @param {TpMachine} machine @param {TpFrame} frame @param {TpCode} code @returns {boolean} */
function isSkipMet(machine, frame, { lines }) {
  const motion = lines[frame.skip ?? 0].instruction;
  if (motion.kind !== 'motion' || skipOf(motion)?.kind !== 'register') return false;
  const at = /** @type {{ program: string, line: number } | undefined} */ (machine.state.system['SKIP_CONDITION']);
  const node = at && machine.codes.get(at.program)?.lines[at.line]?.instruction;
  if (node?.kind !== 'skip-condition') throw new Alarm('SKIP CONDITION was not set', 'skip');
  return truthOf(evaluate(node.condition, machine, frame));
}
