/**
 * A motion as an effect. It says where to, how fast and how it ends; whoever has the arm moves it.
 *
 * How offsets and increments are taken is not verified: an offset of a Cartesian position as `offset : position`, seen from the
 * user frame, a tool offset as `position : offset`, an increment added number by number to where the arm is.
 *
 * @import { Effect } from '../../run/machine.js'
 * @import { TpMotion, TpRegister } from '../tree.js'
 * @import { TpFrame, TpMachine } from './memory.js'
 * @import { Point } from './points.js'
 */
import { composed } from '../../run/positions.js';
import { Alarm, number, numbers } from '../../run/values.js';
import { operandText } from '../instructionText.js';
import { evaluate, indexOf, positionRegister } from './evaluate.js';
import { FRAME_KEYS } from './memory.js';
import { isJoint, pointValues } from './points.js';

/** mm/sec: the most that HandlingTool's manual has, for max_speed. */
const FASTEST = 2000;

/** @param {TpMotion} node @param {TpMachine} machine @param {TpFrame} frame @returns {Effect} */
export function moveEffect(node, machine, frame) {
  const target = placeOf(node.target, node, machine, frame);
  const via = node.via && placeOf(node.via, node, machine, frame);
  const option = (/** @type {string} */ name) => node.options.find((one) => one.name.toUpperCase() === name);
  const acceleration = option('ACC')?.value;
  const { speed, termination } = node;
  return {
    ...{ kind: 'move', to: 'TO', motion: node.motion, point: operandText(node.target) },
    ...{ position: target.values, isJoint: isJoint(target.values) },
    ...(via && { via: via.values, viaIsJoint: isJoint(via.values) }),
    speed: {
      value:
        speed.value.kind === 'word'
          ? speed.value.word === 'max_speed'
            ? FASTEST
            : null
          : number(evaluate(speed.value, machine, frame)),
      unit: speed.unit,
    },
    termination:
      termination.kind === 'FINE'
        ? { kind: 'FINE' }
        : { kind: termination.kind, value: number(evaluate(termination.value, machine, frame)) },
    ...(acceleration && { acceleration: number(evaluate(acceleration, machine, frame)) }),
    ...(option('WJNT') && { wristJoint: true }),
    ...{ userFrame: target.userFrame, toolFrame: target.toolFrame },
  };
}

/** @param {TpRegister} node @param {TpMotion} motion @param {TpMachine} machine @param {TpFrame} frame */
function placeOf(node, { options }, machine, frame) {
  const { state, host } = machine;
  const index = indexOf(node, machine, frame);
  /** @type {Point} */
  const point =
    node.bank === 'P'
      ? pointValues(node, machine, frame, index)
      : { values: [...numbers(positionRegister(machine, index))], userFrame: 'F', toolFrame: 'F' };
  const frames = {
    userFrame: frameOf('UFRAME_NUM', point.userFrame, node, machine),
    toolFrame: frameOf('UTOOL_NUM', point.toolFrame, node, machine),
  };
  let { values } = point;
  for (const { name, value } of options) {
    const upper = name.toUpperCase();
    if (upper === 'INC') {
      const here = isJoint(values) ? host.joints?.() : host.position?.();
      if (!here) throw new Alarm('INC needs to know where the arm is', 'motion');
      values = values.map((by, i) => (i < Math.min(6, here.length) ? here[i] + by : by));
    }
    if (upper !== 'OFFSET' && upper !== 'TOOL_OFFSET') continue;
    const register = value
      ? indexOf(/** @type {TpRegister} */ (value), machine, frame)
      : state.system[`${upper}_CONDITION`];
    if (typeof register !== 'number') throw new Alarm(`${upper} CONDITION was not set`, 'offset');
    const offset = numbers(positionRegister(machine, register));
    if (isJoint(offset) !== isJoint(values))
      throw new Alarm(`PR[${register}] and the position are not of one kind (Cartesian, joints)`, 'offset');
    if (isJoint(values)) values = values.map((one, i) => one + (offset[i] ?? 0));
    else {
      const moved = upper === 'OFFSET' ? composed(offset, values) : composed(values, offset);
      values = [...moved.slice(0, 6), ...values.slice(6)];
    }
  }
  return { values, ...frames };
}

/** The frame that a position is in: its own, which has to be the one that is chosen. @param {'UFRAME_NUM' | 'UTOOL_NUM'} which @param {number | 'F'} own @param {TpRegister} node @param {TpMachine} machine */
function frameOf(which, own, node, { state }) {
  const chosen = state.system[FRAME_KEYS[which]];
  if (own === 'F' || chosen === undefined) return own === 'F' ? number(chosen ?? 0) : own;
  if (chosen === own) return own;
  const what = which === 'UFRAME_NUM' ? 'user frame' : 'tool';
  throw new Alarm(
    `${operandText(node)} is taught in ${what} ${own}, and ${what} ${chosen} is chosen`,
    'frame-mismatch',
  );
}
