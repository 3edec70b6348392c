/**
 * Single points: whether the TCP can be brought to a place, in which postures and how far from the limits, what is the nearest
 * place if not, and whether it can go straight from one place to another. Orientation does not count here.
 *
 * Proven: that a place is reached (a posture is given that is there by forward kinematics); that it is not, where at most
 * three joints move the TCP (closed form), or beyond the arm's reach. Otherwise *not found*: descents from many postures all
 * ended short of it; so is the nearest place.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { LimitMargin } from '../kinematics/turns.js'
 *
 * @typedef {object} PointPosture
 * @property {Float64Array} q   of all joints; those that do not move the TCP are at zero, or at the limit nearest to it
 * @property {LimitMargin | null} limitMargin  null if no joint has two limits
 *
 * @typedef {object} PointAnswer
 * @property {boolean} isReached
 * @property {boolean} isProven
 * @property {PointPosture[]} postures  all there are, if `areAll`; otherwise some, the one with most room to its limits first
 * @property {boolean} areAll
 * @property {number} distance      m, of the nearest place that was found; 0 if it is reached
 * @property {Float64Array} nearest that place, seen from the chain's root
 * @property {Float64Array | null} nearestPosture
 *
 * @typedef {object} LineStop
 * @property {Float64Array} place    where
 * @property {boolean} isReachedBeyond  the place just beyond is reached, but by another posture
 * @property {{ joint: number, bound: 'lower' | 'upper' }[]} held  the joints that are at a limit there
 *
 * @typedef {object} LineAnswer
 * @property {boolean} isTravelled  whether a posture was followed all along the line
 * @property {number} share         how much of the line the best posture went
 * @property {Float64Array | null} start  that posture, at the first place
 * @property {Float64Array | null} end    and where it came
 * @property {LineStop | null} stop       what it stopped at; null if it came to the end, or had nowhere to begin
 *
 * @typedef {object} PointOptions
 * @property {boolean} [withLimits]  of turning joints (true)
 * @property {number} [seed]
 */
import { limitMarginOf } from '../kinematics/turns.js';
import { wayBetween } from '../kinematics/way.js';
import { createDescent } from './descent.js';
import { createPlaceSolver, turnInside } from './exactPlaces.js';
import { createSampler } from './sampler.js';

/** A place missed by no more than this (arm lengths) is reached. */
const THERE = 1e-9;

/** Postures from which the nearest are taken, and how many descents start. */
const SAMPLES = 4000;
const STARTS = 24;

/** The best of them goes on until nothing is gained: how far away a place is hardly tells it from those beside it. */
const LAST = { steps: 600, gain: 1e-16 };

/** Postures nearer to each other than this (rad, arm lengths) are one. */
const SAME = 1e-4;

/** Some of infinitely many postures. */
const MOST_POSTURES = 8;

/** Along a line: the step at first, as a share of it and in arm lengths, and the least. */
const STEP = 0.02;
const LEAST_STEP = 1e-6;

/** Joints may turn by this much in a step; if more, the step is halved: else the arm might have changed its posture. */
const MOST_TURN = 0.1;

/** Just beyond where a line stops: this much of an arm's length. A joint this near to its limit (rad, arm lengths) is at it. */
const BEYOND = 1e-4;
const HELD = 1e-3;

/** The place is this near to the line while it is followed, arm lengths. */
const ON_LINE = 1e-8;

/**
 * @param {Chain} chain
 * @param {PointOptions} [options]
 */
export function createPointFinder(chain, { withLimits = true, seed = 1 } = {}) {
  const solve = createPlaceSolver(chain, withLimits);
  const descent = createDescent(chain, withLimits);
  const { ranges } = descent.placement;
  const sampler = createSampler(chain, { withLimits, seed });
  const places = new Float32Array(3 * SAMPLES);
  sampler.fill(0, places);
  const { shoulder, reach, characteristicLength: scale } = chain;

  /** @param {ArrayLike<number>} x @returns {Float64Array} */
  const postureOf = (x) => {
    const q = sampler.postureAt(0);
    ranges.joints.forEach((joint, k) => (q[joint] = x[k]));
    return q;
  };

  /** Descents from those of the sampled postures that are nearest, and from some anywhere. @param {ArrayLike<number>} place */
  function* arrivals(place) {
    const away = Float64Array.from({ length: SAMPLES }, (_, k) =>
      Math.hypot(places[3 * k] - place[0], places[3 * k + 1] - place[1], places[3 * k + 2] - place[2]),
    );
    const order = Array.from(away.keys()).sort((a, b) => away[a] - away[b]);
    for (let start = 0; start < STARTS; start++) {
      const index = start % 2 === 0 ? order[start / 2] : order[Math.floor((start / STARTS) * SAMPLES)];
      const q = sampler.postureAt(index);
      const x = Float64Array.from(ranges.joints, (joint) => q[joint]);
      const off = descent.bring(place, x);
      turnInside(ranges, x);
      yield { x, off, place: descent.placement.place.slice() };
    }
  }

  /** @param {Float64Array[]} found @returns {PointPosture[]} */
  const listed = (found) => {
    /** @type {PointPosture[]} */
    const list = [];
    for (const q of found) {
      if (!list.some((other) => wayBetween(chain, other.q, q) < SAME))
        list.push({ q, limitMargin: limitMarginOf(chain, q) });
    }
    return list.sort((a, b) => (b.limitMargin?.share ?? 0) - (a.limitMargin?.share ?? 0));
  };

  /** @param {ArrayLike<number>} place  seen from the chain's root @returns {PointAnswer} */
  function ask(place) {
    const target = Float64Array.from(place);
    const exact = solve?.(place).filter(({ isInside }) => isInside);
    if (exact && exact.length > 0) {
      const postures = listed(exact.map(({ x }) => postureOf(x)));
      return reached(
        target,
        postures,
        exact.every(({ loose }) => loose.length === 0),
      );
    }
    /** @type {Float64Array[]} */
    const there = [];
    let best = null;
    for (const arrival of arrivals(place)) {
      if (arrival.off <= THERE * scale) there.push(postureOf(arrival.x));
      if (there.length === MOST_POSTURES) break;
      if (!best || arrival.off < best.off) best = arrival;
    }
    if (there.length > 0) return reached(target, listed(there), false);
    if (best) {
      const off = descent.bring(place, best.x, LAST.steps, LAST.gain);
      turnInside(ranges, best.x);
      best = { x: best.x, off, place: descent.placement.place.slice() };
    }
    const beyond = Math.hypot(place[0] - shoulder[0], place[1] - shoulder[1], place[2] - shoulder[2]) > reach;
    return {
      isReached: false,
      isProven: beyond || Boolean(solve),
      postures: [],
      areAll: true,
      distance: best?.off ?? Infinity,
      nearest: best?.place ?? target,
      nearestPosture: best && postureOf(best.x),
    };
  }

  /** @param {Float64Array} place @param {PointPosture[]} postures @param {boolean} areAll @returns {PointAnswer} */
  const reached = (place, postures, areAll) => ({
    isReached: true,
    isProven: true,
    postures,
    areAll,
    distance: 0,
    nearest: place,
    nearestPosture: postures[0].q,
  });

  /**
   * Along the line from a posture at its first place, as far as it goes. The posture moves on continuously: a place that is only
   * reached otherwise stops it.
   * @param {ArrayLike<number>} from
   * @param {ArrayLike<number>} to
   * @param {Float64Array} q
   */
  function follow(from, to, q) {
    let x = Float64Array.from(ranges.joints, (joint) => q[joint]);
    const length = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    const first = Math.min(0.25, (STEP * scale) / (length || 1));
    let share = 0;
    for (let step = first; share < 1;) {
      const next = Math.min(1, share + step);
      const target = [0, 1, 2].map((i) => from[i] + next * (to[i] - from[i]));
      const trial = x.slice();
      const off = descent.bring(target, trial);
      const turn = trial.reduce(
        (most, value, k) => Math.max(most, Math.abs(value - x[k]) / (ranges.slides[k] ? scale : 1)),
        0,
      );
      if (off <= ON_LINE * scale && turn <= MOST_TURN) {
        x = trial;
        share = next;
        step = Math.min(first, step * 1.5);
      } else if ((step /= 2) < LEAST_STEP) break;
    }
    return { share, end: postureOf(x) };
  }

  /** @param {ArrayLike<number>} from @param {ArrayLike<number>} to @param {number} share @param {Float64Array} q @returns {LineStop} */
  function stopAt(from, to, share, q) {
    const along = (/** @type {number} */ part) =>
      Float64Array.from({ length: 3 }, (_, i) => from[i] + part * (to[i] - from[i]));
    const length = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    const held = ranges.joints.flatMap((joint, k) => {
      if (ranges.isClosed[k]) return [];
      const slack = HELD * (ranges.slides[k] ? scale : 1);
      return /** @type {const} */ (['lower', 'upper'])
        .filter((bound) => Math.abs(q[joint] - ranges[bound][k]) <= slack)
        .map((bound) => ({ joint, bound }));
    });
    const beyond = along(Math.min(1, share + (BEYOND * scale) / length));
    return { place: along(share), isReachedBeyond: ask(beyond).isReached, held };
  }

  return {
    ask,
    /**
     * @param {ArrayLike<number>} from
     * @param {ArrayLike<number>} to
     * @returns {LineAnswer}
     */
    askLine(from, to) {
      /** @type {LineAnswer} */
      let best = { isTravelled: false, share: 0, start: null, end: null, stop: null };
      for (const { q } of ask(from).postures) {
        const { share, end } = follow(from, to, q);
        if (share > best.share || !best.start) best = { isTravelled: share === 1, share, start: q, end, stop: null };
        if (share === 1) break;
      }
      if (best.end && !best.isTravelled) best.stop = stopAt(from, to, best.share, best.end);
      return best;
    },
  };
}
