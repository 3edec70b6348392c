/**
 * Taught positions as values: ten numbers of a Cartesian one (x y z w p r, the configuration, three more axes), or the joints'.
 *
 * @import { TpRegister } from '../tree.js'
 * @import { TpFrame, TpMachine } from './memory.js'
 * @import { TpCode } from './program.js'
 *
 * @typedef {{ values: number[], userFrame: number | 'F', toolFrame: number | 'F' }} Point
 */
import { configOf } from '../../run/positions.js';
import { Alarm } from '../../run/values.js';
import { cartesianValues, jointValues } from '../positions.js';

/** Where the elements of a position register are in such a value: the configuration is none of them. */
export const CARTESIAN_SLOTS = [0, 1, 2, 3, 4, 5, 7, 8, 9];

/** Cartesian positions have ten numbers, motion groups at most nine axes. @param {readonly unknown[]} values */
export const isJoint = (values) => values.length < 10;

/** @param {TpRegister} node @param {TpMachine} machine @param {TpFrame} frame @param {number} index @returns {Point} */
export function pointValues({ group: wanted = 1 }, { codes }, frame, index) {
  const { positions } = /** @type {TpCode} */ (codes.get(frame.program));
  const found = positions.get(index)?.groups.find(({ group }) => group === wanted);
  if (!found) throw new Alarm(`P[${index}] is not among the positions`, 'position');
  const { userFrame, toolFrame, configuration, values: all } = found;
  const joints = jointValues(found);
  const values = joints ?? cartesianValues(found) ?? [];
  if (values.length === 0 || values.includes(null)) throw new Alarm(`P[${index}] is not taught`, 'uninitialised');
  const taught = /** @type {number[]} */ (values);
  if (joints) return { values: taught, userFrame, toolFrame };
  const config = configOf(configuration ?? '');
  if (config === null)
    throw new Alarm(`P[${index}] has no configuration that is known: ${configuration}`, 'configuration');
  const further = [1, 2, 3].map((n) => all.find(({ name }) => name === `E${n}`)?.value ?? 0);
  return { values: [...taught, config, ...further], userFrame, toolFrame };
}
