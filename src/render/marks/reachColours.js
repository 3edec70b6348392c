/**
 * Numbers as colours, for the graphics card: the five colours of the ramp, each going over into the next as the eye sees it.
 *
 * @import { Skin } from '../skins.js'
 * @import { ReachValues } from '../../model/workspace/reachValues.js'
 */
import { Color } from 'three';

const STEPS = 128;

/** As much of a channel as a number of 16 bits holds. */
const FULL = 65535;

/**
 * @param {Skin['ramp']} ramp
 * @returns {Uint16Array} r, g, b of each step
 */
export function rampOf(ramp) {
  const stops = ramp.map((colour) => new Color(colour).convertLinearToSRGB());
  const table = new Uint16Array(3 * STEPS);
  for (let i = 0; i < STEPS; i++) {
    const at = (i / (STEPS - 1)) * (stops.length - 1);
    const from = Math.min(stops.length - 2, Math.floor(at));
    const colour = stops[from]
      .clone()
      .lerp(stops[from + 1], at - from)
      .convertSRGBToLinear();
    table.set([colour.r * FULL, colour.g * FULL, colour.b * FULL].map(Math.round), 3 * i);
  }
  return table;
}

/** One colour for all. @param {string} colour @returns {Uint16Array} */
export const plainRamp = (colour) => rampOf([colour, colour]);

/** Where the colour of a cube stands in the table. @param {ReachValues} values @param {number} cube */
export function stepOf({ of, least, most }, cube) {
  const share = most > least ? (of(cube) - least) / (most - least) : 0.5;
  return 3 * Math.min(STEPS - 1, Math.max(0, Math.round(share * (STEPS - 1))));
}
