/**
 * Lengths, areas and volumes of a map in words, with as many digits as their errors leave.
 *
 * @import { Units } from '../../model/document.js'
 */
import { fromKernel } from '../../model/units.js';
import { compact, fixed, poseNumber, unitSign, withUnit } from '../parts/format.js';

/** Digits of a length that is known to a cube, and its characters. */
const SHORT = 4;
const WIDEST = 9;

/** Decimals of a square or cubic metre at most. */
const MOST_DECIMALS = 6;

/** Smaller than this (m², m³), and centimetres say it better. */
const SMALL = { area: 0.01, volume: 0.001 };
const LARGER = { area: 1e4, volume: 1e6 };
const UNIT = { area: ['m²', 'cm²'], volume: ['m³', 'cm³'] };

/**
 * A number and its error, both to the error's first digit, which is rounded up: 0.82690 ± 0.00007.
 * @param {number} value
 * @param {number} error  not negative
 * @returns {[value: string, error: string]}
 */
export function withError(value, error) {
  const least = 10 ** -MOST_DECIMALS;
  const shown = Math.max(error, least);
  // an error that begins with 1 has another digit, so that it is not stated twice as large
  const first = Math.floor(Math.log10(shown));
  const digits = shown / 10 ** first < 2 ? 1 - first : -first;
  const decimals = Math.min(MOST_DECIMALS, Math.max(0, digits));
  const up = Math.ceil(Number((shown * 10 ** decimals).toPrecision(12))) / 10 ** decimals;
  return [fixed(value, decimals), fixed(up, decimals)];
}

/** "0.8269 ± 0.0001 m²" @param {'area' | 'volume'} kind @param {number} value  m², m³ @param {number} error */
export function measureText(kind, value, error) {
  const isSmall = value > 0 && value < SMALL[kind];
  const scale = isSmall ? LARGER[kind] : 1;
  const [number, off] = withError(value * scale, error * scale);
  return `${number} ± ${off} ${UNIT[kind][Number(isSmall)]}`;
}

/** "812.50 mm" @param {number} metres @param {Units} units */
export const lengthText = (metres, units) =>
  withUnit(poseNumber(fromKernel('length', metres, units), units.length), units.length);

/** A length as it is chosen: 50 mm, 2.5 cm. @param {number} metres @param {Units} units */
export const shortLength = (metres, units) => withUnit(shortNumber(metres, units), units.length);

/** The same without its unit. @param {number} metres @param {Units} units */
const shortNumber = (metres, units) =>
  compact(Number(fromKernel('length', metres, units).toPrecision(SHORT)), WIDEST).text;

/** @param {Units} units */
export const lengthSign = ({ length }) => unitSign(length);

/** 12 345 @param {number} count */
export const grouped = (count) => String(Math.round(count)).replace(/\B(?=(\d{3})+$)/g, ' ');

/**
 * What stands at a line of a drawing's grid.
 * @param {number} metres
 * @param {number} step  m, between lines; 0 where there is one only, which is written as any length is
 * @param {Units} units
 */
export function tickText(metres, step, units) {
  if (step === 0) return poseNumber(fromKernel('length', metres, units), units.length);
  const decimals = Math.max(0, -Math.floor(Math.log10(fromKernel('length', step, units)) + 1e-9));
  return fixed(fromKernel('length', metres, units), decimals);
}
