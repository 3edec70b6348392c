/**
 * Moves that go on into each other without stopping, and how they are timed: a move alone by its law; several by the
 * quickest that their speeds and accelerations and the joints allow, which is a trapezoid where the joints have nothing against
 * it, and where one of them is to go by the S-curve, an S-curve. The other laws are from rest to rest.
 *
 * @import { JointLimits, PlanLaw, ViaLaw } from './moves.js'
 * @import { MoveWay } from './moveWay.js'
 * @import { PosturePath } from './posturePath.js'
 * @import { Section, Slowed } from './timePath.js'
 * @import { TimeLaw } from './timeLaw.js'
 *
 * @typedef {object} Stretch   of the run's way, within one move
 * @property {number} move
 * @property {MoveWay} way
 * @property {PosturePath} path   by seconds of the ways
 * @property {number} ceiling     what its rate is at most
 *
 * @typedef {object} TimedMove
 * @property {number} move     index
 * @property {PosturePath} path
 * @property {TimeLaw} law     how far along the path
 * @property {PlanLaw | ViaLaw} timing  by which law it is timed: the move's, unless it goes on into another, or comes out of one
 * @property {PlanLaw | null} instead   the move's law, if it is timed by another
 * @property {Slowed[]} slowed   where it is slower than that, from share to share of the way, and because of which joint
 */
import { keepLaw } from './keepLaw.js';
import { joined, measuredBy } from './posturePath.js';
import { quickestLaw } from './quickestLaw.js';
import { restLaw } from './restLaw.js';
import { between, timeAt, timeLaw } from './timeLaw.js';

/** Stretches of the way that are shorter than this share of a move are rounding. */
const NOTHING = 1e-6;

/**
 * @param {readonly Stretch[]} stretches   1 or more, in their order
 * @param {JointLimits} limits
 * @returns {TimedMove[]}   one a move
 */
export function timeRun(stretches, limits) {
  let s = 0;
  const laid = stretches.map(({ path, ...each }) => {
    const own = measuredBy(path, s, 1);
    s = own.knots[own.knots.length - 1];
    return { ...each, path: own, to: s };
  });
  const [{ way, move }] = laid;
  if (laid.length === 1 && way.law !== 'timeOptimal') {
    const [{ path }] = laid;
    const { ceiling: rate, acceleration, jerk, law: name } = way;
    const wanted = restLaw(name, s, { rate, acceleration, jerk });
    const rounded = name === 'doubleS' && jerk < Infinity ? sharpOf(wanted, jerk, rate) : null;
    const { law, slowed } = keepLaw(path, wanted, limits, acceleration, rounded);
    const bend = rate < 1 ? [{ from: 0, to: s, joint: null }] : [];
    const told = inShares(slowed.length > 0 ? slowed : bend, 0, s);
    return [{ move, path, law, slowed: told, timing: name, instead: null }];
  }
  const path = joined(laid.map((each) => each.path));
  const { law, slowed } = quickestLaw(path, limits, laid.map(sectionOf));
  const isRounded = laid.some((each) => each.way.law === 'doubleS');
  const moves = [...new Set(laid.map((each) => each.move))];
  return moves.map((each) => {
    const own = laid.filter((stretch) => stretch.move === each);
    const [from, to] = [own[0].path.knots[0], own[own.length - 1].to];
    return {
      move: each,
      path: joined(own.map((stretch) => stretch.path)),
      law: lawBetween(law, from, to),
      slowed: inShares(slowed, from, to),
      ...timingOf(own[0].way.law, isRounded),
    };
  });
}

/**
 * What an S-curve is when its corners are not rounded: until its jerk ends, its acceleration grows.
 * @param {TimeLaw} law  from rest to rest @param {number} jerk @param {number} rate
 */
function sharpOf({ pieces, to }, jerk, rate) {
  const seconds = pieces.length > 0 ? pieces[0].duration : 0;
  return { sharp: restLaw('trapezoid', to, { rate, acceleration: jerk * seconds }), seconds, jerk };
}

/**
 * By what a move is timed that goes on into another, or comes out of one.
 * @param {PlanLaw} law
 * @param {boolean} isRounded   one of these moves limits the jerk
 * @returns {Pick<TimedMove, 'timing' | 'instead'>}
 */
function timingOf(law, isRounded) {
  /** @type {PlanLaw} */
  const timing = isRounded ? 'doubleS' : law === 'timeOptimal' ? law : 'trapezoid';
  return { timing, instead: law === timing ? null : law };
}

/** @param {Stretch & { to: number }} stretch @returns {Section} */
const sectionOf = ({ way: { law, acceleration, share, jerk }, ceiling, to }) => ({
  to,
  acceleration: law === 'timeOptimal' ? Infinity : acceleration,
  share,
  ceiling,
  jerk: law === 'doubleS' ? jerk : Infinity,
});

/** What of a law is between two places. @param {TimeLaw} law @param {number} from @param {number} to */
function lawBetween(law, from, to) {
  const { duration, from: begin, to: end } = law;
  const first = from === begin ? 0 : timeAt(law, from);
  const last = to === end ? duration : timeAt(law, to);
  return timeLaw(from, to, between(law, first, last));
}

/** Slow stretches between two places, by the share of the way between them. @param {readonly Slowed[]} slowed @param {number} from @param {number} to */
const inShares = (slowed, from, to) =>
  slowed
    .filter((each) => each.from < to - NOTHING * (to - from) && each.to > from + NOTHING * (to - from))
    .map((each) => ({
      from: Math.max(0, (each.from - from) / (to - from)),
      to: Math.min(1, (each.to - from) / (to - from)),
      joint: each.joint,
    }));
