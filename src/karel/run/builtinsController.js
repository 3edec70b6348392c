/**
 * Built-ins that speak to the controller: registers, ports, tasks, semaphores, time, files, messages.
 *
 * @import { Builtin, Machine } from './machine.js'
 */
import { put } from './builtinsMath.js';
import { abortTask } from './endings.js';
import { scanHandlers } from './occurrences.js';
import { packedClock } from './packedTime.js';
import { hasNumber } from './places.js';
import { asPosition, isJoints } from './positions.js';
import { Alarm, copied, list, number, numbers, record, single, text } from './values.js';

/** By the numbers of GET_PORT_VAL. */
const PORT_TYPES = /** @type {Readonly<Record<number, string>>} */ ({
  ...{ 1: 'DIN', 2: 'DOUT', 3: 'AIN', 4: 'AOUT', 8: 'RDI', 9: 'RDO', 11: 'OPIN', 12: 'OPOUT' },
  ...{ 18: 'GIN', 19: 'GOUT', 20: 'UIN', 21: 'UOUT', 35: 'FLG' },
});

/** What a variable says that was never set, and what is not there. */
const UNSET_STATUS = 12311;
/** Not zero; that of a controller is not known. */
const NO_REGISTER = 1;

/** @param {keyof Pick<Machine['state'], 'registers' | 'positionRegisters' | 'stringRegisters'>} bank @returns {Builtin} */
const setter =
  (bank) =>
  ([index, value, status], { state }) => {
    if (!hasNumber(number(index))) return put(status, NO_REGISTER);
    state[bank][number(index)] = bank === 'registers' ? { value: number(value), isReal: false } : copied(value);
    put(status, 0);
  };

/** @param {'XYZWPREXT' | 'JOINTPOS'} kind @returns {Builtin} */
const positionRegister =
  (kind) =>
  ([index, status], machine) => {
    const found = machine.state.positionRegisters[number(index)];
    put(status, found === undefined ? UNSET_STATUS : 0);
    return found && asPosition(copied(found), kind, machine);
  };

/** By POS_REG_TYPE. */
const XYZWPR_REGISTER = 2;
const JOINT_REGISTER = 9;

/** @param {string} bank @returns {Builtin} */
const setComment =
  (bank) =>
  ([index, comment, status], { state }) => {
    state.system[`${bank}_CMT[${number(index)}]`] = text(comment);
    put(status, 0);
  };
/** @param {string} bank @returns {Builtin} */
const getComment =
  (bank) =>
  ([index, target, status], { state }) => {
    put(target, state.system[`${bank}_CMT[${number(index)}]`] ?? '');
    put(status, 0);
  };

/** By GET_TPE_PRM; the last is a number that is not zero, that of a controller is not known. */
const PARAMETER = { integer: 1, real: 2, string: 3, missing: 17042 };

/** What a TP program has handed over: of what type, and the value where that type has its place. @type {Builtin} */
const parameterOf = ([index, type, integer, real, string, status], { state }) => {
  const value = state.args[number(index) - 1];
  put(status, value === undefined ? PARAMETER.missing : 0);
  if (value === undefined) return;
  const isWhole = Number.isInteger(value);
  const kind = typeof value === 'string' ? 'string' : isWhole ? 'integer' : 'real';
  put(type, PARAMETER[kind]);
  if (kind === 'string') put(string, value);
  else put(isWhole ? integer : real, isWhole ? value : single(number(value)));
};

/** Of POST_ERR. */
const ABORTS = 2;

/** Where the arm has no posture; the number of a controller is not known. */
const NO_POSTURE = 15018;

/** The frame and the tool that are handed over, among the system variables. @param {Machine} machine @param {unknown} frame @param {unknown} tool */
const framed = ({ state }, frame, tool) => ({
  ...state.system,
  'GROUP[1].UFRAME': numbers(frame),
  'GROUP[1].UTOOL': numbers(tool),
});

/** @param {Machine} machine */
function kinematicsOf({ host }) {
  if (host.kinematics) return host.kinematics;
  throw new Alarm('of the kinematics of an arm nothing is known here', 'kinematics');
}

/** @param {readonly number[]} joints @param {Machine} machine */
function areInRange(joints, { host }) {
  if (host.isInRange) return host.isInRange(joints);
  throw new Alarm('of the limits of an arm nothing is known here', 'kinematics');
}

/** Wrist joint configurations and axes outside of the arm are not known here: they are left as they are. @type {Builtin} */
const jointToPosition = ([joints, frame, tool, , position, , , status], machine) => {
  const system = framed(machine, frame, tool);
  put(position, [...kinematicsOf(machine).toPosition(numbers(joints), system), 0, 0, 0]);
  return put(status, 0);
};

/** @type {Builtin} */
const positionToJoint = ([reference, position, frame, tool, , , , joints, status], machine) => {
  const system = framed(machine, frame, tool);
  const near = isJoints(reference) ? numbers(reference) : undefined;
  const found = kinematicsOf(machine).toJoints(numbers(position), system, near);
  if (found) put(joints, [...found]);
  return put(status, found ? 0 : NO_POSTURE);
};

/**
 * Taken to succeed, though nothing is done: there is nothing here that it could act on.
 * @param {string} what
 * @param {number} [at]   its argument that takes the status
 * @returns {Builtin}
 */
const taken = (what, at) => (args, machine) => {
  if (at !== undefined) put(args[at], 0);
  machine.effect = { kind: 'no-effect', what };
};

/** @type {Readonly<Record<string, Builtin>>} */
export const CONTROLLER = {
  CHECK_EPOS: ([position, frame, tool, status], machine) => {
    const system = framed(machine, frame, tool);
    put(status, kinematicsOf(machine).toJoints(numbers(position), system) ? 0 : NO_POSTURE);
  },
  JOINT2POS: jointToPosition,
  POS2JOINT: positionToJoint,
  GET_TPE_PRM: parameterOf,
  SET_INT_REG: setter('registers'),
  SET_REAL_REG: ([index, value, status], { state }) => {
    if (!hasNumber(number(index))) return put(status, NO_REGISTER);
    state.registers[number(index)] = { value: single(number(value)), isReal: true };
    put(status, 0);
  },
  GET_REG: ([index, isReal, integer, real, status], { state }) => {
    const found = state.registers[number(index)];
    put(status, found === undefined ? UNSET_STATUS : 0);
    if (found === undefined) return;
    const register = record(found);
    put(isReal, register.isReal);
    put(register.isReal ? real : integer, register.value);
  },
  SET_POS_REG: setter('positionRegisters'),
  SET_EPOS_REG: setter('positionRegisters'),
  SET_JPOS_REG: setter('positionRegisters'),
  GET_POS_REG: positionRegister('XYZWPREXT'),
  GET_JPOS_REG: positionRegister('JOINTPOS'),
  POS_REG_TYPE: ([index, , type, axes, status], { state }) => {
    const found = state.positionRegisters[number(index)];
    put(status, found === undefined ? UNSET_STATUS : 0);
    if (found === undefined) return;
    put(type, isJoints(found) ? JOINT_REGISTER : XYZWPR_REGISTER);
    put(axes, isJoints(found) ? list(found).length : 0);
  },
  CLR_POS_REG: ([index, , status], { state }) => {
    delete state.positionRegisters[number(index)];
    put(status, 0);
  },
  SET_STR_REG: ([index, value, status], { state }) => {
    state.stringRegisters[number(index)] = text(value);
    put(status, 0);
  },
  GET_STR_REG: ([index, target, status], { state }) => {
    put(target, state.stringRegisters[number(index)] ?? '');
    put(status, 0);
  },
  SET_REG_CMT: setComment('R'),
  GET_REG_CMT: getComment('R'),
  SET_PREG_CMT: setComment('PR'),
  GET_PREG_CMT: getComment('PR'),
  SET_SREG_CMT: setComment('SR'),
  GET_SREG_CMT: getComment('SR'),

  GET_PORT_VAL: ([type, index, value, status], { state }) => {
    const port = PORT_TYPES[number(type)];
    put(value, Number(state.ports[port]?.[number(index)] ?? 0));
    put(status, port ? 0 : 1);
  },
  SET_PORT_VAL: ([type, index, value, status], { state }) => {
    const port = PORT_TYPES[number(type)];
    const isThere = port && hasNumber(number(index), 0);
    if (isThere) (state.ports[port] ??= {})[number(index)] = /^[GA]/.test(port) ? number(value) : number(value) !== 0;
    put(status, isThere ? 0 : 1);
  },

  GET_PORT_SIM: ([type, index, isSimulated, status], { state }) => {
    const port = PORT_TYPES[number(type)];
    put(isSimulated, state.simulatedPorts?.[`${port}[${number(index)}]`] === true);
    put(status, port ? 0 : 1);
  },
  SET_PORT_SIM: ([type, index, value, status], machine) => {
    const port = PORT_TYPES[number(type)];
    if (port) (machine.state.simulatedPorts ??= {})[`${port}[${number(index)}]`] = true;
    CONTROLLER.SET_PORT_VAL([type, index, value, status], machine);
  },

  IN_RANGE: ([position], machine) => {
    const own = numbers(position);
    const joints = isJoints(position) ? own : kinematicsOf(machine).toJoints(own, machine.state.system);
    return joints !== null && areInRange(joints, machine);
  },
  J_IN_RANGE: ([joints], machine) => areInRange(numbers(joints), machine),
  CURJPOS: (_, { host }) => [...(host.joints?.() ?? [0, 0, 0, 0, 0, 0])],
  CURPOS: (_, { host }) => [...(host.position?.() ?? [0, 0, 0, 0, 0, 0]), 0, 0, 0, 0].slice(0, 10),
  CLEAR_SEMA: ([index], { state }) => void (state.semaphores[number(index)] = 0),
  POST_SEMA: ([index], { state }) =>
    void (state.semaphores[number(index)] = (state.semaphores[number(index)] ?? 0) + 1),
  SEMA_COUNT: ([index], { state }) => state.semaphores[number(index)] ?? 0,

  GET_TIME: ([target], machine) => {
    put(target, packedClock(machine.state.time));
    machine.effect = { kind: 'assumed-date' };
  },
  GET_USEC_TIM: (_, { state }) => Math.trunc(state.time * 10 ** 3) | 0,

  SET_FILE_ATR: taken('SET_FILE_ATR'),
  POST_ERR: ([code, message, , severity], machine) => {
    const posted = { code: number(code), message: text(message), severity: number(severity) };
    const { time, tasks, current, posted: before } = machine.state;
    machine.state.posted = { ...posted, time, program: tasks[current].name, count: (before?.count ?? 0) + 1 };
    machine.effect = { kind: 'error', ...posted };
    scanHandlers(machine, { name: 'ERROR', number: posted.code });
    if (posted.severity === ABORTS) abortTask(machine, machine.state.current);
  },
  ERR_DATA: ([count, code, message, cause, causeText, time, severity, program], { state: { posted } }) => {
    put(count, posted?.count ?? 0);
    put(code, posted?.code ?? 0);
    put(message, posted?.message ?? '');
    put(cause, 0);
    put(causeText, '');
    put(time, packedClock(posted?.time ?? 0));
    put(severity, posted?.severity ?? 0);
    put(program, posted?.program ?? '');
  },
  SET_PERCH: taken('SET_PERCH', 2),
  MSG_CONNECT: taken('MSG_CONNECT', 1),
  MSG_DISCO: taken('MSG_DISCO', 1),
  MSG_PING: taken('MSG_PING', 1),
  FORCE_SPMENU: taken('FORCE_SPMENU'),
  KCL_NO_WAIT: taken('KCL_NO_WAIT', 1),
  KCL: taken('KCL', 1),
};
