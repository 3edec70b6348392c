/**
 * A joint move: every joint from one value to another by the same kind of time law, all beginning and ending together. The
 * joint that takes longest goes as fast as its limits allow; the others take the same time by going slower.
 *
 * @import { MotionLimits } from './doubleS.js'
 * @import { Moment, TimeLaw } from './timeLaw.js'
 *
 * @typedef {'trapezoid' | 'doubleS' | 'cubic' | 'quintic'} LawName
 *
 * @typedef {object} JointMove
 * @property {number} duration  s
 * @property {readonly TimeLaw[]} laws   one a joint, all of that duration
 * @property {number | null} slowest     the joint that decides the duration; null where nothing moves
 */
import { doubleS } from './doubleS.js';
import { cubicLaw, leastDuration, quinticLaw } from './polynomialLaws.js';
import { momentAt, stretched, timeLaw } from './timeLaw.js';

/** s; a way that takes less is covered in this time: its powers would leave the range of numbers. */
const SHORTEST = 1e-9;

/** @type {Record<LawName, (from: number, to: number, limits: MotionLimits) => TimeLaw>} */
const LAWS = {
  trapezoid: (from, to, { rate, acceleration }) => doubleS(from, to, { rate, acceleration }),
  doubleS,
  cubic: (from, to, limits) => cubicLaw(from, to, timeFor('cubic', to - from, limits)),
  quintic: (from, to, limits) => quinticLaw(from, to, timeFor('quintic', to - from, limits)),
};

/**
 * @param {ArrayLike<number>} from
 * @param {ArrayLike<number>} to
 * @param {readonly MotionLimits[]} limits  one a joint
 * @param {{ law?: LawName, speed?: number, acceleration?: number }} [options]  speed and acceleration: shares of the limits,
 *   above 0 and at most 1; the jerk follows the acceleration
 * @returns {JointMove}
 */
export function planJointMove(from, to, limits, { law = 'doubleS', speed = 1, acceleration = 1 } = {}) {
  if (to.length !== from.length || limits.length !== from.length) {
    throw new RangeError(
      `Expected as many values to go to, and limits, as there are joints, ${from.length}; got ${to.length} and ${limits.length}.`,
    );
  }
  for (const [name, share] of Object.entries({ speed, acceleration })) {
    if (!(share > 0 && share <= 1))
      throw new RangeError(`${name}: expected a share above 0 and at most 1, got ${share}.`);
  }
  const own = limits.map((each, i) =>
    LAWS[law](from[i], to[i], {
      rate: each.rate * speed,
      acceleration: each.acceleration * acceleration,
      ...(each.jerk !== undefined && { jerk: each.jerk * acceleration }),
    }),
  );
  const longest = Math.max(0, ...own.map((each) => each.duration));
  const duration = longest === 0 ? 0 : Math.max(longest, 2 * SHORTEST); // a cubic in place of a quicker law needs more time
  const slowest = duration === 0 ? null : own.findIndex((each) => each.duration === longest);
  return { duration, laws: own.map((each) => lasting(each, duration)), slowest };
}

/** @param {'cubic' | 'quintic'} kind @param {number} way @param {MotionLimits} limits */
const timeFor = (kind, way, limits) => (way === 0 ? 0 : Math.max(SHORTEST, leastDuration(kind, way, limits)));

/** @param {TimeLaw} law @param {number} duration @returns {TimeLaw} */
function lasting(law, duration) {
  if (law.duration === duration) return law;
  if (law.duration === 0) return timeLaw(law.from, law.to, [{ duration, coefficients: [law.from] }]);
  if (law.duration < SHORTEST) return cubicLaw(law.from, law.to, duration);
  return { ...stretched(law, duration / law.duration), duration };
}

/**
 * Where the joints are at a moment.
 * @param {JointMove} move
 * @param {number} t  s, from the beginning
 * @returns {Moment[]}
 */
export const jointMomentsAt = ({ laws }, t) => laws.map((law) => momentAt(law, t));
