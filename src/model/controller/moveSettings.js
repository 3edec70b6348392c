/**
 * What a MOVE of KAREL is set to, by its own WITH or else by the group's variables, in the words of TP. Of joint moves `$SPEED` is
 * taken against `$SPEEDLIMJNT`, at which joints go at their full rates: not verified.
 *
 * @import { SystemValues } from '../code/codeFrames.js'
 * @import { Effect } from '../../karel/run/machine.js'
 *
 * @typedef {object} MoveSettings
 * @property {'J' | 'L' | 'C'} motion
 * @property {{ value: number, unit: '%' | 'mm/sec' | 'deg/sec' }} speed
 * @property {{ kind: 'FINE' | 'CR' } | { kind: 'CNT', value: number }} termination
 */
import { JOINT_SPEED_LIMIT } from '../../karel/run/systemVariables.js';

/** By $MOTYPE. @type {Readonly<Record<number, MoveSettings['motion']>>} */
const MOTIONS = { 6: 'J', 7: 'L', 8: 'C' };
/** By $TERMTYPE: what slows down by $DECELTOL, and what stops in its place; of the others nothing is verified. */
const VARDECEL = 5;
const FINE = 1;
const FIRST_DECELTOL = 100;
/** mm/s, where nothing says one. */
export const FIRST_SPEED = 300;

/** @param {Effect} effect  of a MOVE @param {SystemValues} system @returns {MoveSettings | { message: string }} */
export function moveSettings(effect, system) {
  const settings = /** @type {Record<string, unknown>} */ (effect.settings);
  const own = (/** @type {string} */ name) => settings[`$${name}`] ?? settings[`$GROUP[1].$${name}`];
  const set = (/** @type {string} */ name) => own(name) ?? system[`GROUP[1].${name}`] ?? system[name];
  const motion = effect.to === 'AXIS' ? 'J' : (MOTIONS[Number(set('MOTYPE'))] ?? 'J');
  const speed = speedOf(motion, own, set, Number(system['PARAM_GROUP[1].SPEEDLIMJNT'] ?? JOINT_SPEED_LIMIT));
  if ('message' in speed) return speed;
  const type = Number(set('TERMTYPE'));
  return {
    ...{ motion, speed },
    termination:
      type === FINE
        ? { kind: 'FINE' }
        : type === VARDECEL
          ? { kind: 'CNT', value: Number(set('DECELTOL') ?? FIRST_DECELTOL) }
          : { kind: 'CR' },
  };
}

/**
 * @param {MoveSettings['motion']} motion
 * @param {(name: string) => unknown} own  setting of the MOVE
 * @param {(name: string) => unknown} set
 * @param {number} limit                   mm/s
 * @returns {MoveSettings['speed'] | { message: string }}
 */
function speedOf(motion, own, set, limit) {
  // a move that turns in its place has no speed in mm/s
  const isTurn = motion !== 'J' && own('SPEED') === undefined && own('ROTSPEED') !== undefined;
  const name = isTurn ? 'ROTSPEED' : 'SPEED';
  const value = Number(set(name) ?? FIRST_SPEED);
  if (!(value > 0)) return { message: `Expected $${name} above 0, got ${value}.` };
  if (motion !== 'J') return { value, unit: isTurn ? 'deg/sec' : 'mm/sec' };
  if (!(limit > 0)) return { message: `Expected $PARAM_GROUP[1].$SPEEDLIMJNT above 0, got ${limit}.` };
  return { value: (100 * value) / limit, unit: '%' };
}
