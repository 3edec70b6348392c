/**
 * Moves that go on into each other without stopping, and how they are timed: a move alone by its law; several by the
 * quickest that their speeds and accelerations and the joints allow, which is a trapezoid where the joints have nothing against
 * it: the other laws are from rest to rest.
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
import { restLaw } from './restLaw.js';
import { quickestLaw } from './timePath.js';
import { timeLaw } from './timeLaw.js';

/** Parts of the way that are shorter than this share of a move are rounding. */
const NOTHING = 1e-9;

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
    const { law, slowed } = keepLaw(path, wanted, limits, acceleration);
    const bend = rate < 1 ? [{ from: 0, to: s, joint: null }] : [];
    const told = inShares(slowed.length > 0 ? slowed : bend, 0, s);
    return [{ move, path, law, slowed: told, timing: name, instead: null }];
  }
  const path = joined(laid.map((each) => each.path));
  const { law, slowed } = quickestLaw(path, limits, laid.map(sectionOf));
  const moves = [...new Set(laid.map((each) => each.move))];
  return moves.map((each) => {
    const own = laid.filter((stretch) => stretch.move === each);
    const [from, to] = [own[0].path.knots[0], own[own.length - 1].to];
    return {
      move: each,
      path: joined(own.map((stretch) => stretch.path)),
      law: lawBetween(law, from, to),
      slowed: inShares(slowed, from, to),
      ...timingOf(own[0].way.law),
    };
  });
}

/** By what a move is timed that goes on into another, or comes out of one. @param {PlanLaw} law @returns {Pick<TimedMove, 'timing' | 'instead'>} */
const timingOf = (law) =>
  law === 'timeOptimal' || law === 'trapezoid' ? { timing: law, instead: null } : { timing: 'trapezoid', instead: law };

/** @param {Stretch & { to: number }} stretch @returns {Section} */
const sectionOf = ({ way: { law, acceleration, share }, ceiling, to }) => ({
  to,
  acceleration: law === 'timeOptimal' ? Infinity : acceleration,
  share,
  ceiling,
});

/** What of a law is between two places that its pieces end at. @param {TimeLaw} law @param {number} from @param {number} to */
function lawBetween({ pieces }, from, to) {
  const margin = NOTHING * (to - from);
  return timeLaw(
    from,
    to,
    pieces.filter(({ coefficients: [s] }) => s >= from - margin && s < to - margin),
  );
}

/** Slow stretches between two places, by the share of the way between them. @param {readonly Slowed[]} slowed @param {number} from @param {number} to */
const inShares = (slowed, from, to) =>
  slowed
    .filter((each) => each.from < to && each.to > from)
    .map((each) => ({
      from: Math.max(0, (each.from - from) / (to - from)),
      to: Math.min(1, (each.to - from) / (to - from)),
      joint: each.joint,
    }));
