/**
 * Scales of plots: what they show at least, and where the numbers stand.
 * @import { Column } from '../../model/program/planColumns.js'
 */

/** Of its range a curve keeps so much free at each side. */
const ROOM = 0.08;

/** A limit is shown where the curve comes so near to it, in ranges of the curve. */
const NEAR = 0.25;

/**
 * What an axis shows of these columns.
 * @param {readonly Column[]} columns  of one unit
 * @param {boolean} withLimits  whether their limits are shown, however far
 * @param {number} smallest   what is shown at least, so that nothing looks like something
 * @returns {[least: number, most: number]}
 */
export function rangeOf(columns, withLimits, smallest) {
  let [least, most] = [Infinity, -Infinity];
  for (const { values } of columns) {
    for (const value of values) {
      if (value < least) least = value;
      if (value > most) most = value;
    }
  }
  if (!(least <= most)) return [-smallest / 2, smallest / 2];
  const near = withLimits ? Infinity : NEAR * (most - least);
  const bounds = columns.flatMap((column) => [column.least, column.most]).filter(Number.isFinite);
  const shown = bounds.filter((bound) => bound >= least - near && bound <= most + near);
  [least, most] = [Math.min(least, ...shown), Math.max(most, ...shown)];
  const room = Math.max(ROOM * (most - least), (smallest - (most - least)) / 2);
  return [least - room, most + room];
}

/**
 * Round numbers of a range: 1, 2 or 5 times a power of ten apart, no more than so many.
 * @param {readonly [number, number]} range
 * @param {number} most
 */
export function ticksOf([least, greatest], most) {
  const rough = (greatest - least) / Math.max(1, most);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((one) => one * power).find((one) => one >= rough * (1 - 1e-9)) ?? 10 * power;
  const first = Math.ceil(least / step - 1e-9);
  const count = Math.floor(greatest / step + 1e-9) - first + 1;
  return Array.from({ length: Math.max(0, count) }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}
