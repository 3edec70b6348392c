/**
 * Registers that a person gave a value before any program did: as on a controller, the next run finds them so.
 *
 * @import { CodeRun } from './codeDebugger.js'
 */
export function createGivenRegisters() {
  /** @type {Map<string, Parameters<CodeRun['setRegister']>>} */
  const given = new Map();
  return {
    /** @param {CodeRun} run  before it is set @param {Parameters<CodeRun['setRegister']>} setting */
    note(run, setting) {
      const [bank, index, slot] = setting;
      const isHeld = run.registers().some((one) => one.bank === bank && one.index === index);
      const isGiven = [...given.keys()].some((key) => key.startsWith(`${bank} ${index} `));
      if (!isHeld || isGiven) given.set(`${bank} ${index} ${slot}`, setting);
    },
    /** @param {CodeRun} run  that begins */
    giveTo(run) {
      for (const setting of given.values()) run.setRegister(...setting);
    },
  };
}
