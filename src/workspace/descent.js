/**
 * Brings the TCP to a place, or as near to it as the joints can: damped least squares on the three coordinates, with joints
 * that are pushed against a limit left out. It ends in the nearest place from where it starts, which need not be the nearest
 * of all: whoever wants that starts it from many postures.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Placement } from './placement.js'
 *
 * @typedef {object} Descent
 * @property {Placement} placement
 * @property {(place: ArrayLike<number>, x: Float64Array, steps?: number, slow?: number) => number} bring  x is changed in place, inside the
 *   limits all along; answers how far the TCP is from the place in the end, m
 */
import { createPlacement, writePlacement } from './placement.js';

const STEPS = 60;

/** At the place within this (arm lengths) is there. */
const THERE = 1e-12;

/** A step that brings it nearer by less than this share is the last one. */
const SLOW = 1e-9;

/** Of no account next to the arm's length, squared. */
const LEAST_DAMPING = 1e-14;

/**
 * @param {Chain} chain
 * @param {boolean} withLimits
 * @param {number} [unbound]  a joint that has no limits, by its place in the ranges
 * @returns {Descent}
 */
export function createDescent(chain, withLimits, unbound = -1) {
  const placement = createPlacement(chain, withLimits);
  const { ranges, place: here, J } = placement;
  const { lower, upper, slides } = ranges;
  const m = ranges.joints.length;
  const isFree = ranges.isClosed.map((closed, k) => closed || k === unbound);
  const scale = chain.characteristicLength;
  /** A slide's metres count as radians of an arm's length. */
  const weights = slides.map((slide) => (slide ? scale * scale : 1));
  const next = new Float64Array(m);
  const step = new Float64Array(m);
  const isHeld = new Uint8Array(m);
  const r = new Float64Array(3);
  const y = new Float64Array(3);

  /** @param {ArrayLike<number>} place */
  const miss = (place) => {
    for (let i = 0; i < 3; i++) r[i] = place[i] - here[i];
    return Math.sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
  };

  /** The damped step of the joints that are not held. @param {number} damping */
  const writeStep = (damping) => {
    let [a, b, c, d, e, f] = [damping, 0, 0, damping, 0, damping];
    for (let k = 0; k < m; k++) {
      if (isHeld[k]) continue;
      const w = weights[k];
      const [x0, x1, x2] = [J[3 * k], J[3 * k + 1], J[3 * k + 2]];
      a += w * x0 * x0;
      b += w * x0 * x1;
      c += w * x0 * x2;
      d += w * x1 * x1;
      e += w * x1 * x2;
      f += w * x2 * x2;
    }
    const [A, B, C] = [d * f - e * e, c * e - b * f, b * e - c * d];
    const determinant = a * A + b * B + c * C;
    y[0] = (A * r[0] + B * r[1] + C * r[2]) / determinant;
    y[1] = (B * r[0] + (a * f - c * c) * r[1] + (b * c - a * e) * r[2]) / determinant;
    y[2] = (C * r[0] + (b * c - a * e) * r[1] + (a * d - b * b) * r[2]) / determinant;
    for (let k = 0; k < m; k++)
      step[k] = isHeld[k] ? 0 : weights[k] * (J[3 * k] * y[0] + J[3 * k + 1] * y[1] + J[3 * k + 2] * y[2]);
  };

  return {
    placement,
    bring(place, x, steps = STEPS, slow = SLOW) {
      writePlacement(placement, x);
      let off = miss(place);
      let damping = 1e-3 * scale * scale;
      for (let count = 0; count < steps && off > THERE * scale; count++) {
        isHeld.fill(0);
        for (let round = 0; round < m; round++) {
          writeStep(damping);
          let holds = false;
          for (let k = 0; k < m; k++) {
            if (isFree[k] || isHeld[k]) continue;
            if ((step[k] < 0 && x[k] <= lower[k]) || (step[k] > 0 && x[k] >= upper[k])) {
              isHeld[k] = 1;
              holds = true;
            }
          }
          if (!holds) break;
        }
        for (let k = 0; k < m; k++) {
          const to = x[k] + step[k];
          next[k] = isFree[k] ? to : Math.min(upper[k], Math.max(lower[k], to));
        }
        writePlacement(placement, next);
        const then = miss(place);
        if (then < off) {
          const gained = off - then;
          x.set(next);
          off = then;
          damping = Math.max(LEAST_DAMPING * scale * scale, damping / 8);
          if (gained < slow * off) break;
        } else {
          damping *= 4;
          writePlacement(placement, x);
          miss(place);
          if (damping > 1e6 * scale * scale) break;
        }
      }
      return off;
    },
  };
}
