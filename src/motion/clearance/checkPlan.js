/**
 * Whether a planned motion keeps clear, move by move, by proof (clearWay.js): where each move first comes too near to something,
 * and when. A wait stands where the move before it ended, and is not told of again.
 *
 * @import { NearestLinks, Workcell } from './workcell.js'
 * @import { MotionPart, MotionPlan } from '../plan.js'
 *
 * @typedef {object} PlanTouch   of one move
 * @property {number} move
 * @property {number} time      s, from the beginning of the plan
 * @property {number} share     of the part of its way that it is in
 * @property {Float64Array} posture
 * @property {NearestLinks} near
 * @property {boolean} isTouch  not merely nearer than the margin
 */
import { momentAt } from '../timeLaw.js';
import { firstTouchOnPath } from './clearWay.js';
import { byLinks } from './workcell.js';

const HALVINGS = 50;

/**
 * Yields the share that is done, so that whoever asks can show progress, or stop.
 * @param {(move: number) => Workcell} cellOf  the arm with the tool that it has in a move, among the obstacles
 * @param {Pick<MotionPlan, 'parts'>} plan
 * @param {{ margin?: number, resolution?: number }} [options]  m
 * @returns {Generator<number, PlanTouch[], void>}
 */
export function* checkPlan(cellOf, { parts }, { margin = 0, resolution } = {}) {
  /** @type {Map<number, PlanTouch>} */
  const found = new Map();
  const finely = resolution === undefined ? {} : { resolution };
  for (const [i, part] of parts.entries()) {
    const known = found.get(part.move);
    if (part.kind !== 'wait' && !known?.isTouch) {
      const cell = cellOf(part.move);
      const near = firstTouchOnPath(cell, part.path, { ...finely, margin });
      // what comes near and then touches, touches
      const touch = near && margin > 0 ? firstTouchOnPath(cell, part.path, finely) : near;
      const place = touch ?? (known ? null : near);
      if (place) {
        const { s, share, posture } = place;
        const time = part.begin + timeAt(part, s);
        const isTouch = touch !== null;
        found.set(part.move, { move: part.move, time, share, posture, near: byLinks(cell.bodies, place), isTouch });
      }
    }
    yield (i + 1) / parts.length;
  }
  return [...found.values()];
}

/** When a part is so far along its way; it never goes back. @param {Pick<MotionPart, 'law'>} part @param {number} s */
function timeAt({ law }, s) {
  let [low, high] = [0, law.duration];
  for (let k = 0; k < HALVINGS; k++) {
    const middle = (low + high) / 2;
    if (momentAt(law, middle).position < s) low = middle;
    else high = middle;
  }
  return high;
}
