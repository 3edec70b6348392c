/**
 * What is plotted and tabled of a planned motion, in document units: groups of columns, each with its unit and with the limits
 * that hold for it.
 *
 * @import { AngleUnit, LengthUnit, RobotDoc } from '../document.js'
 * @import { PlanSeries } from './planSeries.js'
 * @import { JointLimits } from '../../motion/plan.js'
 *
 * @typedef {typeof GROUPS[number]} Group
 * @typedef {{ readonly unit: LengthUnit | AngleUnit | '', readonly power: number, readonly per: number }} ColumnUnit  mm², per s²
 *
 * @typedef {object} Column
 * @property {string} name
 * @property {ColumnUnit} unit
 * @property {Float64Array} values
 * @property {number} least   limits; infinite where there are none
 * @property {number} most
 *
 * @typedef {Pick<JointLimits, 'rates' | 'accelerations' | 'jerks'>} Limits  of the joints, in metres and radians
 */
import { isSliding, limitsOf } from '../document.js';
import { fromKernel } from '../units.js';

export const GROUPS = /** @type {const} */ ([
  'values',
  'rates',
  'accelerations',
  'jerks',
  'place',
  'orientation',
  'speed',
  'turnSpeed',
  'manipulability',
]);

const OF_JOINTS = /** @type {const} */ (['values', 'rates', 'accelerations', 'jerks']);

/** @param {Group} group @returns {group is typeof OF_JOINTS[number]} */
export const isOfJoints = (group) => OF_JOINTS.some((one) => one === group);

/**
 * @param {RobotDoc} robot
 * @param {PlanSeries} series
 * @param {Group} group
 * @param {Limits | null} limits  that the plan was made with
 * @returns {Column[]}
 */
export function columnsOf(robot, series, group, limits) {
  const { units, joints } = robot;
  if (isOfJoints(group)) {
    const per = OF_JOINTS.indexOf(group);
    return joints.map((joint, i) => {
      const quantity = isSliding(joint) ? 'length' : 'angle';
      const bound = group === 'values' ? undefined : limits?.[group]?.[i];
      const most = bound === undefined ? Infinity : fromKernel(quantity, bound, units);
      const { lower, upper } = limitsOf(joint);
      return {
        name: `J${i + 1}`,
        unit: { unit: units[quantity], power: 1, per },
        values: series[group][i].map((value) => fromKernel(quantity, value, units)),
        ...(group === 'values' ? { least: lower, most: upper } : { least: -most, most }),
      };
    });
  }
  /** @param {string} name @param {'length' | 'angle'} quantity @param {Float64Array} values @param {number} per @returns {Column} */
  const column = (name, quantity, values, per) => ({
    ...{ name, unit: { unit: units[quantity], power: 1, per } },
    values: values.map((value) => fromKernel(quantity, value, units)),
    ...{ least: -Infinity, most: Infinity },
  });
  switch (group) {
    case 'place':
      return series.place.map((values, i) => column('XYZ'[i], 'length', values, 0));
    case 'orientation':
      return series.orientation.map((values, i) => column('WPR'[i], 'angle', values, 0));
    case 'speed':
      return [column('v', 'length', series.speed, 1)];
    case 'turnSpeed':
      return [column('ω', 'angle', series.turnSpeed, 1)];
    case 'manipulability': {
      const { freedoms, isLinear } = series;
      const power = isLinear ? freedoms : 0;
      const scale = fromKernel('length', 1, units) ** power;
      const values = series.manipulability.map((value) => value * scale);
      return [
        { name: 'w', unit: { unit: isLinear ? units.length : '', power, per: 0 }, values, least: 0, most: Infinity },
      ];
    }
    default: {
      /** @type {never} */
      const unknown = group;
      throw new TypeError(`Unknown group: ${unknown}`);
    }
  }
}

const RAISED = ['', '', '²', '³', '⁴', '⁵', '⁶'];

/** "mm/s²", "°/s", "mm³", "rad", "". @param {ColumnUnit} given @param {(unit: LengthUnit | AngleUnit) => string} [sign]  how a unit is written */
export function unitText({ unit, power, per }, sign = (one) => one) {
  const above = unit === '' || power === 0 ? '' : sign(unit) + RAISED[power];
  return per === 0 ? above : `${above || '1'}/s${RAISED[per]}`;
}

/** Digits of numbers in a file: more than anybody measures, fewer than rounding leaves behind. */
const DIGITS = 10;

/**
 * All groups over time as comma-separated values, with a head.
 * @param {RobotDoc} robot
 * @param {PlanSeries} series
 * @param {(move: number) => string} stepOf  what a move is called in the first lines of its row
 * @param {(group: Group, name: string) => string} heading
 */
export function planCsv(robot, series, stepOf, heading) {
  const columns = GROUPS.flatMap((group) =>
    columnsOf(robot, series, group, null).map((column) => ({ ...column, group })),
  );
  const heads = columns.map(({ group, name, unit }) => {
    const text = unitText(unit);
    return `${heading(group, name)}${text && ` [${text}]`}`;
  });
  const number = (/** @type {number} */ value) => String(Number(value.toPrecision(DIGITS)));
  const rows = Array.from(series.times, (time, k) =>
    [number(time), stepOf(series.moves[k]), ...columns.map(({ values }) => number(values[k]))].map(quoted).join(),
  );
  return [['t [s]', 'step', ...heads].map(quoted).join(), ...rows, ''].join('\r\n');
}

/** @param {string} text */
const quoted = (text) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
