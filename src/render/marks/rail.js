/**
 * The face of a slide's gauge: a rail beside the axis from stop to stop, filled from zero to the present value, and a
 * pointer. Where there is no stop, the rail just ends.
 *
 * @import { Face, FaceOptions } from './gaugeFace.js'
 */
import { fatLines, movableLine, spanLine } from '../fatLines.js';

const ORDER = 35;

/** @param {FaceOptions} options @returns {Face} */
export function railFace({ joint: { d, lower, upper }, seat, size, skin }) {
  const aside = Math.max(0.05 * size, 3.2 * seat.radius);
  const tick = Math.max(0.012 * size, 0.5 * seat.radius);
  /** @param {number} q @param {number} across @returns {[number, number, number]} */
  const at = (q, across) => [0, aside + across, d + q];
  const stops = [lower, upper].filter(Number.isFinite);
  const fill = movableLine({ color: skin.accent, width: 7, opacity: 0.5, order: ORDER });
  const pointer = movableLine({ color: skin.ink, width: 2.5, order: ORDER + 2 });
  const ticks = stops.flatMap((q) => [...at(q, -tick), ...at(q, tick)]);
  return {
    still: [
      fatLines([...at(seat.low - d, 0), ...at(seat.high - d, 0)], { color: skin.accent, width: 1.5, order: ORDER + 1 }),
      ...(ticks.length ? [fatLines(ticks, { color: skin.accent, width: 2.5, order: ORDER + 1 })] : []),
    ],
    moving: [fill, pointer],
    stops,
    turnTo(q) {
      fill.visible = q !== 0;
      spanLine(fill, at(0, 0), at(q, 0));
      spanLine(pointer, at(q, -1.6 * tick), at(q, 1.6 * tick));
    },
    beyond: (limit, value) => [
      fatLines([...at(limit, 0), ...at(value, 0)], { color: skin.bad, width: 7, opacity: 0.5, order: ORDER }),
      fatLines([...at(value, -tick), ...at(value, tick)], { color: skin.bad, width: 2.5, order: ORDER + 2 }),
    ],
    tip: (q) => at(q, 1.6 * tick),
    centre: (q) => at(q, 0),
    besideStop: (q) => q,
  };
}
