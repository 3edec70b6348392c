/**
 * What is said of an effect of running code that nothing here carries out.
 *
 * @import { Effect } from '../../karel/run/machine.js'
 */
import { CODE } from '../words/code.js';

/** @param {Effect | undefined} effect */
export function effectText(effect) {
  switch (effect?.kind) {
    case 'call':
      return CODE.called(String(effect.program));
    case 'run-task':
      return (effect.runsAlready ? CODE.runsAlready : CODE.runs)(String(effect.program));
    case 'skipped':
      return CODE.skipped(Number(effect.line), String(effect.text));
    case 'error':
      return CODE.posted(String(effect.message || effect.code));
    case 'alarm':
      return CODE.taskAlarm(String(effect.task), /** @type {{ reason: string }} */ (effect.alarm).reason);
    case 'no-effect':
      return CODE.noEffect(String(effect.what));
    case 'assumed-date':
      return CODE.date;
    default:
      return CODE.effect(String(effect?.kind));
  }
}
