/**
 * What TP programs read and set on the controller: the same registers, ports and system variables that KAREL sees.
 *
 * @import { Host, State } from '../../run/machine.js'
 * @import { Value } from '../../run/values.js'
 * @import { TpCode } from './program.js'
 *
 * @typedef {object} TpFrame   a program that runs, or waits for one that it called
 * @property {string} program
 * @property {number} at                        its line, from 0
 * @property {readonly Value[]} args
 * @property {Record<number, number>} limits    of the loops, by their first line
 * @property {Record<string, boolean>} before   what ports were at the last look, for edges
 * @property {boolean} [isTold]                 that the line is about to run
 * @property {number} [motion]                  the number of the motion that it waits for
 * @property {number} [skip]                    the line of a move with Skip, while it is under way and when it has just ended
 * @property {boolean} [isSkipped]              that its condition was met on the way
 * @property {number} [since]                   when it began to wait, ms
 * @property {number} [wake]                    until when it waits, ms
 * @property {number} [look]                    when it looks at its motion again, ms
 *
 * @typedef {Pick<State, 'time' | 'steps' | 'ports' | 'registers' | 'positionRegisters' | 'stringRegisters' | 'system' | 'pulses' | 'timers' | 'arm'>} Memory
 * @typedef {Memory & { frames: TpFrame[], nextScan: number, task: string }} TpState   task: which the program is part of
 *
 * @typedef {object} TpMachine
 * @property {ReadonlyMap<string, TpCode>} codes   by name in capitals
 * @property {TpState} state
 * @property {Host} host
 */
import { Alarm, number, record, single } from '../../run/values.js';

/** Position registers that a controller can be set up for (HandlingTool operator's manual, section 19). */
export const MAX_REGISTERS = 2000;

/** By TP's names, KAREL's. */
export const PORTS = /** @type {Readonly<Record<string, string>>} */ ({
  ...{ DI: 'DIN', DO: 'DOUT', RI: 'RDI', RO: 'RDO', GI: 'GIN', GO: 'GOUT', AI: 'AIN', AO: 'AOUT', F: 'FLG', M: 'MRK' },
  ...{ UI: 'UIN', UO: 'UOUT', SI: 'OPIN', SO: 'OPOUT', WI: 'WDI', WO: 'WDO' },
});

export const isNumberPort = (/** @type {string} */ bank) => /^[GA][IO]$/.test(bank);

/**
 * A system variable's key, as KAREL has it.
 * @param {string} name  as `$MNUFRAME[1,2]`
 * @example
 * systemKey('$MCR.$GENOVERRIDE') // → 'MCR.GENOVERRIDE'
 */
export const systemKey = (name) => name.replaceAll('$', '').replaceAll(',', '][').toUpperCase();

/** Which user frame and which tool is chosen, and where they are. */
export const FRAME_KEYS = /** @type {const} */ ({
  UFRAME_NUM: 'MNUFRAMENUM[1]',
  UTOOL_NUM: 'MNUTOOLNUM[1]',
  UFRAME: 'MNUFRAME[1]',
  UTOOL: 'MNUTOOL[1]',
});

/** @param {Memory} memory @param {number} index */
export function registerValue({ registers }, index) {
  const found = registers[index];
  if (found === undefined) throw new Alarm(`R[${index}] has no value`, 'uninitialised');
  return number(record(found).value);
}

/** @param {Memory} memory @param {number} index @param {number} value */
export function setRegister({ registers }, index, value) {
  const isReal = !Number.isInteger(value);
  registers[index] = { value: isReal ? single(value) : value, isReal };
}

/** Seconds. @param {Memory} memory @param {number} index */
export function timerValue({ system, time }, index) {
  const timer = system[`TIMER[${index}]`];
  if (timer === undefined) return 0;
  const { value, since } = /** @type {{ value: number, since: number | null }} */ (timer);
  return (value + (since === null ? 0 : time - since)) / 10 ** 3;
}

/** @param {Memory} memory @param {number} index @param {string} what  START, STOP or RESET */
export function setTimer(memory, index, what) {
  const { system, time } = memory;
  const value = what === 'RESET' ? 0 : timerValue(memory, index) * 10 ** 3;
  const timer = /** @type {{ since: number | null } | undefined} */ (system[`TIMER[${index}]`]);
  const isOn = what === 'START' || (what === 'RESET' && typeof timer?.since === 'number');
  system[`TIMER[${index}]`] = { value, since: isOn ? time : null };
}
