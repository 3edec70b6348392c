/**
 * A KRL module, run: a generator of the effects of a TP program. PTP is J, LIN is L, CIRC is C; a position has X Y Z and C B A as
 * x y z w p r, and with them `status` and `turn` where they are given.
 *
 * @import { Effect, Host } from '../run/machine.js'
 * @import { KrlDatum, KrlModule, KrlMotion } from './tree.js'
 *
 * @typedef {object} KrlOutcome
 * @property {'ended' | 'alarm' | 'budget'} status
 * @property {{ code: string, reason: string, line: number, routine: string }} [alarm]
 * @property {{ outputs: Record<number, boolean>, time: number }} state
 */
const MOTION = /** @type {const} */ ({ PTP: 'J', LIN: 'L', CIRC: 'C' });
const SCAN = 12; // ms, the interpolation cycle
const MOST = 100_000;

/**
 * @param {KrlModule} module
 * @param {Pick<Host, 'steps'> & { input?: (index: number, time: number) => boolean }} [host]
 * @returns {Generator<Effect, KrlOutcome, unknown>}
 */
export function* runKrl({ name, statements, data }, host = {}) {
  const places = new Map(data.map((datum) => [datum.name.toUpperCase(), datum]));
  /** @type {Record<string, number>} */
  const set = { BASE: 0, TOOL: 0 };
  /** @type {KrlOutcome['state']} */
  const state = { outputs: {}, time: 0 };
  let isPlaced = false;
  let steps = 0;
  /** @param {string} code @param {string} reason @param {number} line @returns {KrlOutcome} */
  const alarm = (code, reason, line) => ({ status: 'alarm', state, alarm: { code, reason, line, routine: name } });
  for (const node of statements) {
    const line = node.span?.line ?? 0;
    switch (node.kind) {
      case 'motion': {
        const target = places.get(node.target.toUpperCase());
        const via = node.via === undefined ? undefined : places.get(node.via.toUpperCase());
        if (!target || (node.via !== undefined && !via))
          return alarm('position', `${target ? node.via : node.target} is not in the data list`, line);
        const effect = moveEffect(node, target, via, set);
        if (typeof effect === 'string') return alarm('position', effect, line);
        if (node.motion !== 'PTP' && !isPlaced) return alarm('first-motion', 'the first motion has to be PTP', line);
        isPlaced = true;
        yield { ...effect, line, program: name };
        break;
      }
      case 'bas':
        set[node.what] = node.value;
        break;
      case 'assign': {
        const output = /^\$OUT\[(\d+)\]$/.exec(node.target);
        if (output) state.outputs[Number(output[1])] = node.value === true;
        else set[node.target] = Number(node.value);
        break;
      }
      case 'wait':
        state.time += node.seconds * 10 ** 3;
        yield { kind: 'wait', milliseconds: node.seconds * 10 ** 3, line };
        break;
      case 'wait-for':
        while ((host.input?.(node.input, state.time) ?? false) !== node.value) {
          if (++steps > (host.steps ?? MOST)) return { status: 'budget', state };
          state.time += SCAN;
          yield { kind: 'wait', milliseconds: SCAN, line, input: node.input, value: node.value };
        }
        break;
      case 'call':
        yield { kind: 'call', program: node.program.toUpperCase(), args: [], line };
    }
  }
  return { status: 'ended', state };
}

/** @param {KrlMotion} node @param {KrlDatum} target @param {KrlDatum | undefined} via @param {Record<string, number>} set @returns {Effect | string} */
function moveEffect({ motion, target: point, approximation }, target, via, set) {
  const [to, past] = [valuesOf(target), via && valuesOf(via)];
  if (!to || (via && !past)) return `${point} lacks members`;
  if (motion !== 'PTP' && (to.isJoint || past?.isJoint))
    return `${point} has axis values: LIN and CIRC need X Y Z A B C`;
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
    ...{ userFrame: set.BASE, toolFrame: set.TOOL },
  };
}

/** @param {KrlDatum} datum @returns {{ values: number[], isJoint: boolean, status?: number, turn?: number } | null} */
function valuesOf({ type, members }) {
  if (/AXIS$/.test(type)) {
    const values = Object.entries(members).flatMap(([name, value]) => (/^A\d$/.test(name) ? [value] : []));
    return { values, isJoint: true };
  }
  const values = ['X', 'Y', 'Z', 'C', 'B', 'A'].map((name) => members[name]);
  if (values.includes(/** @type {never} */ (undefined))) return null;
  return { values: [...values, 0, 0, 0, 0], isJoint: false, status: members.S, turn: members.T };
}
