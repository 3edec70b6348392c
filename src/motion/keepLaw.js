/**
 * A law where the joints can follow it, and where they cannot, as fast as they can (timePath.js). Outside the stretches that are
 * slower it is the law itself, piece by piece, so that it is as smooth there.
 *
 * @import { PosturePath } from './posturePath.js'
 * @import { Limits, Slowed } from './timePath.js'
 * @import { TimeLaw } from './timeLaw.js'
 */
import { createSpan, writeSpan } from './hermite.js';
import { TERMS, pathMoment, pathMomentAt } from './posturePath.js';
import { between, momentAt, timeLaw } from './timeLaw.js';
import { IN_TIME, OVER, alongGrid, partsOf } from './timePath.js';

/** Samples in each stretch of a law between two of its pieces' or the path's ends. */
const SAMPLES = 8;

const HALVINGS = 50;

/** Rates that differ by this share are the same but for rounding. */
const SAME = 1e-9;

/**
 * @param {PosturePath} path
 * @param {TimeLaw} law     from 0 to the path's end
 * @param {Limits} limits
 * @param {number} acceleration   what the law's is at most
 * @returns {{ law: TimeLaw, slowed: Slowed[] }}
 */
export function keepLaw(path, law, limits, acceleration) {
  if (law.duration === 0 || isGentle(path, limits, acceleration)) return { law, slowed: [] };
  const ends = [...law.pieces.map(({ start }) => start), ...Array.from(path.knots, (s) => timeAt(law, s))];
  ends.sort((a, b) => a - b);
  const isKept = (/** @type {number} */ from, /** @type {number} */ to) =>
    mostUse(path, law, limits, [from, ...ends.filter((t) => t > from && t < to), to]) <= 1 + OVER;
  if (isKept(0, law.duration)) return { law, slowed: [] };
  const end = path.knots[path.knots.length - 1];
  // at both ends it rests, though rounding would find it there a moment before or after
  const rate = (/** @type {number} */ s) => (s > 0 && s < end ? momentAt(law, timeAt(law, s)).rate : 0);
  const inTime = Array.from({ length: IN_TIME + 1 }, (_, k) => momentAt(law, (law.duration * k) / IN_TIME).position);
  const found = alongGrid(path, limits, [{ to: end, acceleration, share: 1, ceiling: Infinity }], rate, inTime);
  if (found.over > 1) return found;

  const { grid, x, slowed } = found;
  const last = grid.length - 1;
  const times = Float64Array.from(grid, (s, i) => (i === 0 ? 0 : i === last ? law.duration : timeAt(law, s)));
  const isLaw = Array.from(grid, (s, i) => Math.abs(Math.sqrt(x[i]) - rate(s)) <= SAME * rate(s));
  const parts = partsOf(grid, x).flatMap((part, i) => {
    const [from, to] = [times[i], times[i + 1]];
    const isOwn = isLaw[i] && isLaw[i + 1] && isKept(from, to);
    return isOwn ? between(law, from, to) : [part];
  });
  return { law: timeLaw(0, end, parts), slowed };
}

const span = createSpan();

/** Whether bounds tell at once that no limit is near. @param {PosturePath} path @param {Limits} limits @param {number} acceleration */
function isGentle({ dof, knots, coefficients }, { rates, accelerations }, acceleration) {
  for (let k = 0, at = 0; k < knots.length - 1; k++) {
    const width = knots[k + 1] - knots[k];
    for (let i = 0; i < dof; i++, at += TERMS) {
      writeSpan(coefficients, at, span);
      const [first, second] = [span.derivatives[1] / width, span.derivatives[2] / width ** 2];
      if (first > rates[i] || second + first * acceleration > accelerations[i]) return false;
    }
  }
  return true;
}

/** What of the limits the law uses at most. @param {PosturePath} path @param {TimeLaw} law @param {Limits} limits @param {readonly number[]} ends  of its stretches, ascending */
function mostUse(path, law, { rates, accelerations }, ends) {
  const now = pathMoment(path.dof);
  let most = 0;
  for (let k = 0; k < ends.length - 1; k++) {
    for (let j = 0; j <= SAMPLES; j++) {
      // a hair inside, since accelerations may jump at the ends
      const at = Math.min(1 - 1e-6, Math.max(1e-6, j / SAMPLES));
      const { position, rate, acceleration } = momentAt(law, ends[k] + at * (ends[k + 1] - ends[k]));
      pathMomentAt(path, position, now);
      for (let i = 0; i < path.dof; i++) {
        const use = Math.abs(now.second[i] * rate * rate + now.first[i] * acceleration) / accelerations[i];
        most = Math.max(most, use, (Math.abs(now.first[i]) * rate) / rates[i]);
      }
    }
  }
  return most;
}

/** When a law is at a place, by halving: it never goes back. @param {TimeLaw} law @param {number} s */
function timeAt(law, s) {
  let [low, high] = [0, law.duration];
  for (let k = 0; k < HALVINGS && low < high; k++) {
    const middle = (low + high) / 2;
    if (momentAt(law, middle).position < s) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}
