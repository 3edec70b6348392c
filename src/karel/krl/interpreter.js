/**
 * A KRL module, run: a generator of the effects of a TP program. PTP is J, LIN is L, CIRC is C; a position has X Y Z and C B A as
 * x y z w p r, and with them `status` and `turn` where they are given.
 *
 * @import { Arm } from '../run/arm.js'
 * @import { Effect, Host } from '../run/machine.js'
 * @import { KrlDatum, KrlModule, KrlMotion } from './tree.js'
 *
 * All that it knows is one plain state.
 *
 * @typedef {object} KrlState
 * @property {number} at        the statement that is next, from 0
 * @property {number} time      ms
 * @property {number} steps
 * @property {Record<string, number>} set      BASE, TOOL and what the program assigns
 * @property {Record<number, boolean>} outputs
 * @property {Record<number, boolean>} inputs  that somebody has set
 * @property {boolean} isPlaced  a motion has said where all axes are
 * @property {boolean} isTold    that the statement is about to run
 * @property {Arm} arm
 * @typedef {{ module: KrlModule, state: KrlState, host: KrlHost }} KrlMachine
 * @typedef {Pick<Host, 'steps' | 'traceSteps'> & { input?: (index: number, time: number) => boolean }} KrlHost  input: instead of those of the state
 *
 * @typedef {object} KrlOutcome
 * @property {'ended' | 'alarm' | 'budget'} status
 * @property {{ code: string, reason: string, line: number, routine: string }} [alarm]
 * @property {KrlState} state
 */
import { advanceArm, beginMotion, newArm, nextOfArm } from '../run/arm.js';
import { copiedState } from '../run/values.js';

const MOTION = /** @type {const} */ ({ PTP: 'J', LIN: 'L', CIRC: 'C' });
const SCAN = 12; // ms, the interpolation cycle
const MOST = 100_000;

/** @param {KrlModule} module @param {KrlHost} [host] @returns {Generator<Effect, KrlOutcome, unknown>} */
export function* runKrl(module, host = {}) {
  return yield* runKrlMachine(createKrlMachine(module, host));
}

/** @param {KrlModule} module @param {KrlHost} [host] @returns {KrlMachine} */
export const createKrlMachine = (module, host = {}) => ({
  ...{ module, host },
  state: {
    ...{ at: 0, time: 0, steps: 0, set: { BASE: 0, TOOL: 0 }, outputs: {}, inputs: {} },
    ...{ isPlaced: false, isTold: false, arm: newArm() },
  },
});

/** @param {KrlMachine} machine */
export const saveKrlState = (machine) => copiedState(machine.state);

/** @param {KrlMachine} machine @param {KrlState} state */
export const restoreKrlState = (machine, state) => void (machine.state = copiedState(state));

/** From where the machine is. @param {KrlMachine} machine @returns {Generator<Effect, KrlOutcome, unknown>} */
export function* runKrlMachine(machine) {
  const { name, statements, data } = machine.module;
  const { host } = machine;
  const places = new Map(data.map((datum) => [datum.name.toUpperCase(), datum]));
  while (true) {
    const { state } = machine;
    advanceArm(state.arm, state.time);
    if (state.arm.motion) {
      const milliseconds = Math.min(SCAN, nextOfArm(state.arm) - state.time);
      state.time += milliseconds;
      yield { kind: 'wait', milliseconds, line: state.arm.motion.effect.line };
      continue;
    }
    const node = statements[state.at];
    if (!node) return { status: 'ended', state };
    const line = node.span?.line ?? 0;
    /** @param {string} code @param {string} reason @returns {KrlOutcome} */
    const alarm = (code, reason) => ({ status: 'alarm', state, alarm: { code, reason, line, routine: name } });
    if (host.traceSteps && !state.isTold && node.kind !== 'comment') {
      state.isTold = true;
      yield { kind: 'step', line, routine: name };
      continue;
    }
    switch (node.kind) {
      case 'motion': {
        const placeOf = (/** @type {string} */ text) =>
          node.places?.find((one) => one.name === text) ?? places.get(text.toUpperCase());
        const target = placeOf(node.target);
        const via = node.via === undefined ? undefined : placeOf(node.via);
        if (!target || (node.via !== undefined && !via))
          return alarm('position', `${target ? node.via : node.target} is not in the data list`);
        const effect = moveEffect(node, target, via, state.set);
        if (typeof effect === 'string') return alarm('position', effect);
        if (node.motion !== 'PTP' && !state.isPlaced) return alarm('first-motion', 'the first motion has to be PTP');
        state.isPlaced = true;
        pass(state);
        beginMotion(state.arm, { ...effect, line }, state.time, name);
        yield { ...effect, line, program: name };
        continue;
      }
      case 'bas':
        state.set[node.what] = node.value;
        break;
      case 'assign': {
        const output = /^\$OUT\[(\d+)\]$/.exec(node.target);
        if (output) state.outputs[Number(output[1])] = node.value === true;
        else state.set[node.target] = Number(node.value);
        break;
      }
      case 'wait': {
        const milliseconds = node.seconds * 10 ** 3;
        state.time += milliseconds;
        pass(state);
        yield { kind: 'wait', milliseconds, line };
        continue;
      }
      case 'wait-for': {
        const { input = (index) => state.inputs[index] === true } = host;
        if (input(node.input, state.time) === node.value) break;
        if (++state.steps > (host.steps ?? MOST)) return { status: 'budget', state };
        state.time += SCAN;
        yield { kind: 'wait', milliseconds: SCAN, line, input: node.input, value: node.value };
        continue;
      }
      case 'call':
        pass(state);
        yield { kind: 'call', program: node.program.toUpperCase(), args: [], line };
        continue;
    }
    pass(state);
  }
}

/** On to the next statement. @param {KrlState} state */
function pass(state) {
  state.at++;
  state.isTold = false;
}

/** @param {KrlMotion} node @param {KrlDatum} target @param {KrlDatum | undefined} via @param {Record<string, number>} set @returns {Effect | string} */
function moveEffect({ motion, target: point, approximation }, target, via, set) {
  const [to, past] = [valuesOf(target), via && valuesOf(via)];
  if (!to || (via && !past)) return `${point.startsWith('{') ? 'a position' : point} lacks members`;
  if (motion !== 'PTP' && (to.isJoint || past?.isJoint))
    return `${point.startsWith('{') ? 'a position' : point} has axis values: LIN and CIRC need X Y Z A B C`;
  const way = approximation[0];
  const value =
    way === 'C_PTP' && !approximation[1] ? set['$APO.CPTP'] : way === 'C_VEL' ? set['$APO.CVEL'] : set['$APO.CDIS'];
  const speed =
    motion === 'PTP'
      ? { value: set.VEL_PTP, unit: '%' }
      : {
          value: set['$VEL.CP'] === undefined ? null : set['$VEL.CP'] * 10 ** 3,
          unit: 'mm/sec',
          turn: set['$VEL.ORI1'],
        };
  return {
    ...{ kind: 'move', to: 'TO', motion: MOTION[motion], point, position: to.values, isJoint: to.isJoint },
    ...(to.status !== undefined && { status: to.status, turn: to.turn }),
    ...(past && { via: past.values, viaIsJoint: false }),
    speed,
    termination:
      way === undefined
        ? { kind: 'FINE' }
        : { kind: way === 'C_DIS' || approximation[1] === 'C_DIS' ? 'DIS' : 'CNT', value },
    ...(motion === 'PTP' && set.ACC_PTP !== undefined && { acceleration: set.ACC_PTP }),
    ...{ userFrame: set.BASE, toolFrame: set.TOOL },
  };
}

/** @param {KrlDatum} datum @returns {{ values: number[], isJoint: boolean, status?: number, turn?: number } | null} */
function valuesOf({ type, members }) {
  if (/AXIS$/.test(type)) {
    // by their names, in whatever order; A1 and A3 alone are no two axes
    const names = Object.keys(members).filter((name) => /^A\d$/.test(name));
    const values = names.map((_, i) => members[`A${i + 1}`]);
    return values.includes(/** @type {never} */ (undefined)) ? null : { values, isJoint: true };
  }
  const values = ['X', 'Y', 'Z', 'C', 'B', 'A'].map((name) => members[name]);
  if (values.includes(/** @type {never} */ (undefined))) return null;
  return { values: [...values, 0, 0, 0, 0], isJoint: false, status: members.S, turn: members.T };
}
