/**
 * Registers that a person gave a value before any program did: as on a controller, the next run finds them so.
 *
 * @import { CodeRun } from './codeDebugger.js'
 * @import { Memory } from '../../karel/tp/run/memory.js'
 *
 * @typedef {[bank: 'R' | 'PR', index: number, slot: number, value: number]} RegisterSetting   slot: of a position
 */

/** x y z w p r, the configuration, and the axes outside of the arm. */
const NO_POSITION = Array(10).fill(0);

/** @param {Pick<Memory, 'registers' | 'positionRegisters'>} memory @param {RegisterSetting} setting */
export function setRegister({ registers, positionRegisters }, ...[bank, index, slot, value]) {
  const now = /** @type {number[] | undefined} */ (positionRegisters[index]);
  const isReal = !Number.isInteger(value);
  if (bank === 'R') registers[index] = { value: isReal ? Math.fround(value) : value, isReal };
  else positionRegisters[index] = (now ?? NO_POSITION).with(slot, value);
}

export function createGivenRegisters() {
  /** @type {Map<string, RegisterSetting>} */
  const given = new Map();
  return {
    /** @param {CodeRun} run  before it is set @param {RegisterSetting} setting */
    note(run, setting) {
      const [bank, index, slot] = setting;
      const isHeld = run.registers().some((one) => one.bank === bank && one.index === index);
      const isGiven = [...given.keys()].some((key) => key.startsWith(`${bank} ${index} `));
      if (!isHeld || isGiven) given.set(`${bank} ${index} ${slot}`, setting);
    },
    /** What was given. */
    settings: () => [...given.values()],
    /** @param {CodeRun} run  that begins */
    giveTo(run) {
      for (const setting of given.values()) run.setRegister(...setting);
    },
  };
}
