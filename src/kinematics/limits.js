/**
 * Joint limits: what is inside them, and how to get there. A turning joint is also inside if some number of full turns
 * brings it there, since that moves nothing else.
 * @import { Packed } from './packed.js'
 */
import { ROW, SLIDES } from './packed.js';

const FULL_TURN = 2 * Math.PI;

/** @param {Packed} packed @param {number} i */
export const isSlide = ({ rows }, i) => rows[ROW * i + SLIDES] === 1;

/**
 * @param {Packed} packed
 * @param {number} i  the joint
 * @param {number} value
 * @returns {number} the value itself if it is inside, or full turns away from it inside, or else the limit it went past
 */
export function bringInside(packed, i, value) {
  const low = packed.lower[i];
  const high = packed.upper[i];
  if (value >= low && value <= high) return value;
  if (!isSlide(packed, i)) {
    const turned =
      value < low
        ? value + FULL_TURN * Math.ceil((low - value) / FULL_TURN)
        : value - FULL_TURN * Math.ceil((value - high) / FULL_TURN);
    if (turned >= low && turned <= high) return turned;
  }
  return value < low ? low : high;
}

/**
 * How far a joint value is past its limits, full turns aside; 0 inside.
 * @param {Packed} packed
 * @param {number} i
 * @param {number} value
 * @returns {{ by: number, bound: 'lower' | 'upper' }} radians or metres, by the joint's type
 */
export function excessOf(packed, i, value) {
  const low = packed.lower[i];
  const high = packed.upper[i];
  if (isSlide(packed, i))
    return value < low ? { by: low - value, bound: 'lower' } : { by: Math.max(0, value - high), bound: 'upper' };
  if (low === -Infinity || high === Infinity) return { by: 0, bound: 'upper' };
  const away = value - (low + high) / 2;
  const turned = away - FULL_TURN * Math.round(away / FULL_TURN); // at most half a turn either way
  return { by: Math.max(0, Math.abs(turned) - (high - low) / 2), bound: turned < 0 ? 'lower' : 'upper' };
}

/**
 * The same posture, each turning joint taken by full turns to where it is nearest to `target` and still inside.
 * @param {Packed} packed
 * @param {Float64Array} q  inside the limits; changed in place
 * @param {ArrayLike<number>} target
 */
export function unwindTowards(packed, q, target) {
  for (let i = 0; i < q.length; i++) {
    if (Math.abs(target[i] - q[i]) < Math.PI || isSlide(packed, i)) continue;
    const wanted = Math.round((target[i] - q[i]) / FULL_TURN);
    const most = Math.floor((packed.upper[i] - q[i]) / FULL_TURN);
    const least = Math.ceil((packed.lower[i] - q[i]) / FULL_TURN);
    const turns = Math.min(most, Math.max(least, wanted));
    q[i] = Math.min(packed.upper[i], Math.max(packed.lower[i], q[i] + turns * FULL_TURN));
  }
}

/**
 * The middle of the limits; where one side is unlimited, zero, or the limit if zero is past it.
 * @param {Packed} packed
 * @param {Float64Array} [q]  filled
 * @returns {Float64Array}
 */
export function middlePosture({ lower, upper }, q = new Float64Array(lower.length)) {
  for (let i = 0; i < q.length; i++) {
    const middle = (lower[i] + upper[i]) / 2;
    q[i] = Number.isFinite(middle) ? middle : Math.min(upper[i], Math.max(lower[i], 0));
  }
  return q;
}

/**
 * A posture anywhere inside the limits. A turning joint without limits takes any angle, a slide without limits anything
 * up to `travel` from zero; with one limit, from there on.
 * @param {Packed} packed
 * @param {() => number} random
 * @param {number} travel  metres
 * @param {Float64Array} q  filled
 */
export function fillRandomPosture(packed, random, travel, q) {
  for (let i = 0; i < q.length; i++) {
    let low = packed.lower[i];
    let high = packed.upper[i];
    const width = isSlide(packed, i) ? 2 * travel : FULL_TURN;
    if (low === -Infinity) low = high === Infinity ? -width / 2 : high - width;
    if (high === Infinity) high = low + width;
    q[i] = low + (high - low) * random();
  }
}
