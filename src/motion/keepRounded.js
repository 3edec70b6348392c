/**
 * The quickest way along a path with a limited jerk: the quickest without (phasePlane.js), rounded (roundedLaw.js). Rounded, the arm is at
 * each place a little later than the sharp law would have it, so limits that differ along the way are looked at again; where one is passed,
 * the sharp law is held lower around there.
 *
 * @import { Plane } from './phasePlane.js'
 * @import { PosturePath } from './posturePath.js'
 * @import { Limits, Section, Slowed } from './timePath.js'
 * @import { TimeLaw } from './timeLaw.js'
 */
import { quickestProfile } from './phasePlane.js';
import { pathMoment, pathMomentAt, pieceAt } from './posturePath.js';
import { roundedLaw } from './roundedLaw.js';
import { derivatives, momentAt, stretched, timeAt } from './timeLaw.js';

/** By this share of it a rate may pass its limit; twice that an acceleration, thrice a jerk. */
const OVER = 2e-4;

/** So many times the sharp law is held lower at most; what is left is taken out by stretching the time. */
const ROUNDS = 8;

/** How often the time that it is rounded for is halved at most. */
const HALVINGS = 20;

/** It is held lower by so much more than was passed. */
const BEYOND = 1e-4;

/** Where each polynomial of a law is looked at: a hair inside, since jerks may jump at its ends. */
const INSIDE = [1e-6, 0.5];

/**
 * By how many times limits are passed; at most 1 where they are not. `jerk` is the joints', `own` the way's.
 * @typedef {{ rate: number, acceleration: number, jerk: number, own: number }} Passed
 */

/**
 * @param {PosturePath} path
 * @param {Plane} plane     changed: its ceilings and its limits of acceleration are lowered
 * @param {Limits} limits
 * @param {readonly Section[]} sections   one with a limit of jerk at least
 * @param {(x: Float64Array) => TimeLaw} lawOf   by the squares of the rate at the points of the grid
 * @param {number} [seconds]   to round for
 * @returns {{ law: TimeLaw, x: Float64Array, slowedFrom: (slowed: readonly Slowed[]) => Slowed[] }}   x: the sharp law's; slowedFrom:
 *   where it is slower than it could be, when that of the sharp law is known
 */
export function keepRounded(path, plane, limits, sections, lawOf, seconds = chooseSeconds(plane, sections, lawOf)) {
  for (let round = 0; ; round++) {
    const x = quickestProfile(plane);
    const sharp = lawOf(x);
    const law = roundedLaw(sharp, seconds);
    const uses = usesOf(path, law, limits, sections);
    if (uses.most <= 1 + OVER || round === ROUNDS) {
      const slowedFrom = (/** @type {readonly Slowed[]} */ slowed) => roundedStretches(slowed, sharp, law, seconds);
      return { law: uses.most <= 1 + OVER ? law : stretched(law, uses.most), x, slowedFrom };
    }
    lower(plane, x, sharp, seconds, uses.over);
  }
}

/**
 * Holds the sharp law lower: what is passed at a moment comes from the last seconds before it.
 * @param {Plane} plane @param {Float64Array} x @param {TimeLaw} sharp @param {number} seconds @param {readonly (Passed & { t: number })[]} over
 */
function lower({ grid, ceiling, shares, own }, x, sharp, seconds, over) {
  const strength = Float64Array.from(shares, (_, i) => Math.abs(x[i + 1] - x[i]) / (2 * (grid[i + 1] - grid[i])));
  const stronger = new Float64Array(shares.length).fill(1);
  for (const { t, rate, acceleration, jerk, own: sudden } of over) {
    const [before, now] = [t - seconds, t].map((at) => pieceAt(grid, momentAt(sharp, at).position));
    const [first, last] = [Math.max(0, before - 1), Math.min(shares.length - 1, now + 1)];
    // the way's own jerk is the difference of two accelerations: from one to its opposite is twice as far as to none
    if (sudden > 1) for (const i of [before, now]) weaken(own, i, strength[i] / (sudden * (1 + BEYOND)));
    const slower = Math.max(rate, Math.cbrt(jerk));
    const most = jerk > 1 ? strength.subarray(first, last + 1).reduce((a, b) => Math.max(a, b), 0) : 0;
    for (let i = first; i <= last; i++) {
      if (slower > 1) {
        for (const k of [i, i + 1]) ceiling[k] = Math.min(ceiling[k], x[k] / (slower * (1 + BEYOND)) ** 2);
      }
      if (jerk > 1) weaken(own, i, most / Math.cbrt(jerk) ** 2);
      stronger[i] = Math.max(stronger[i], acceleration);
    }
  }
  for (let i = 0; i < shares.length; i++) if (stronger[i] > 1) shares[i] /= stronger[i] * (1 + BEYOND);
}

/** @param {Float64Array} own @param {number} i @param {number} most */
function weaken(own, i, most) {
  own[i] = Math.min(own[i], most);
}

/**
 * How long to round for: with less, accelerations have to be lower; with more, it arrives later. Sets what the way's accelerations are
 * at most.
 * @param {Plane} plane @param {readonly Section[]} sections @param {(x: Float64Array) => TimeLaw} lawOf
 */
function chooseSeconds(plane, sections, lawOf) {
  const { grid, own } = plane;
  const most = own.slice();
  const jerks = most.map((_, i) => (sections.find(({ to }) => grid[i] < to) ?? sections[sections.length - 1]).jerk);
  const setOwn = (/** @type {number} */ seconds) => {
    for (let i = 0; i < own.length; i++) own[i] = Math.min(most[i], jerks[i] * seconds);
    return seconds;
  };
  const whole = Math.max(...sections.map(({ acceleration, jerk }) => (jerk < Infinity ? acceleration / jerk : 0)));
  let best = { seconds: whole, duration: Infinity };
  for (let k = 0; k < HALVINGS; k++) {
    const seconds = setOwn(whole / 2 ** k);
    const duration = seconds + lawOf(quickestProfile(plane)).duration;
    if (duration >= best.duration) break;
    best = { seconds, duration };
  }
  return setOwn(best.seconds);
}

/**
 * What is slower in the sharp law makes the rounded one slower from then on until the mean has no more of it.
 * @param {readonly Slowed[]} slowed @param {TimeLaw} sharp @param {TimeLaw} law @param {number} seconds
 */
function roundedStretches(slowed, sharp, law, seconds) {
  /** @type {Slowed[]} */
  const found = [];
  for (const { from, to, joint } of slowed) {
    const own = {
      from: momentAt(law, timeAt(sharp, from)).position,
      to: momentAt(law, timeAt(sharp, to) + seconds).position,
      joint,
    };
    if (!(own.to > own.from)) continue;
    const before = found[found.length - 1];
    if (before && before.joint === joint && own.from <= before.to) before.to = own.to;
    else found.push(own);
  }
  return found;
}

/**
 * What a law uses of the limits: of a rate as it is, of an acceleration its root, of a jerk its third root, for so much more time
 * would do.
 * @param {PosturePath} path @param {TimeLaw} law @param {Limits} limits @param {readonly Section[]} sections
 * @returns {{ most: number, over: (Passed & { t: number })[] }}   over: where they are passed
 */
function usesOf(path, { pieces }, { rates, accelerations, jerks }, sections) {
  const now = pathMoment(path.dof);
  let [most, section] = [1, 0];
  const over = [];
  for (const { start, duration, coefficients } of pieces) {
    for (const at of INSIDE) {
      const { position, rate, acceleration, jerk } = derivatives(coefficients, at * duration);
      while (section < sections.length - 1 && position >= sections[section].to) section++;
      const { ceiling, share, jerk: limit } = sections[section];
      pathMomentAt(path, position, now);
      const by = { rate: rate / ceiling, acceleration: 0, jerk: 0, own: Math.abs(jerk) / limit };
      for (let i = 0; i < path.dof; i++) {
        const [first, second, third] = [now.first[i], now.second[i], now.third[i]];
        by.rate = Math.max(by.rate, (Math.abs(first) * rate) / rates[i]);
        const force = Math.abs(first * acceleration + second * rate * rate);
        by.acceleration = Math.max(by.acceleration, force / (share * accelerations[i]));
        if (!jerks || limit === Infinity) continue;
        const sudden = Math.abs(first * jerk + 3 * second * rate * acceleration + third * rate ** 3);
        by.jerk = Math.max(by.jerk, sudden / (share * jerks[i]));
      }
      const use = Math.max(by.rate, Math.sqrt(by.acceleration), Math.cbrt(Math.max(by.jerk, by.own)));
      most = Math.max(most, use);
      if (use > 1 + OVER) over.push({ t: start + at * duration, ...by });
    }
  }
  return { most, over };
}
