/**
 * A law where the joints can follow it, and where they cannot, as fast as they can (timePath.js). Outside the stretches that are
 * slower it is the law itself, piece by piece, so that it is as smooth there.
 *
 * @import { PosturePath } from './posturePath.js'
 * @import { Limits, Slowed } from './timePath.js'
 * @import { TimeLaw } from './timeLaw.js'
 */
import { createSpan, writeSpan } from './hermite.js';
import { keepRounded } from './keepRounded.js';
import { TERMS, pathMoment, pathMomentAt } from './posturePath.js';
import { between, momentAt, timeAt, timeLaw } from './timeLaw.js';
import { IN_TIME, OVER, alongGrid, partsOf } from './timePath.js';

/** Samples in each stretch of a law between two of its pieces' or the path's ends. */
const SAMPLES = 8;

/** Rates that differ by this share are the same but for rounding. */
const SAME = 1e-9;

/**
 * @param {PosturePath} path
 * @param {TimeLaw} law     from 0 to the path's end
 * @param {Limits} limits
 * @param {number} acceleration   what the law's is at most
 * @param {{ sharp: TimeLaw, seconds: number, jerk: number } | null} [rounded]   of a law that limits the jerk: by how much, and
 *   the law that it is when that is rounded for so many seconds (roundedLaw.js)
 * @returns {{ law: TimeLaw, slowed: Slowed[] }}
 */
export function keepLaw(path, law, { jerks, ...limits }, acceleration, rounded = null) {
  const all = { ...limits, ...(rounded && jerks && { jerks }) };
  if (law.duration === 0 || isGentle(path, all, acceleration, rounded?.jerk ?? 0)) return { law, slowed: [] };
  if (keeps(path, law, all)(0, law.duration)) return { law, slowed: [] };
  const { sharp, seconds, jerk } = rounded ?? { sharp: law, seconds: 0, jerk: Infinity };
  const isKept = keeps(path, sharp, limits);
  const end = path.knots[path.knots.length - 1];
  // at both ends it rests, though rounding would find it there a moment before or after
  const rate = (/** @type {number} */ s) => (s > 0 && s < end ? momentAt(sharp, timeAt(sharp, s)).rate : 0);
  const inTime = Array.from(
    { length: IN_TIME + 1 },
    (_, k) => momentAt(sharp, (sharp.duration * k) / IN_TIME).position,
  );
  const sections = [{ to: end, acceleration, share: 1, ceiling: Infinity, jerk }];
  const found = alongGrid(path, limits, sections, rate, inTime);
  const { grid, plane } = found;
  const last = grid.length - 1;
  const times = Float64Array.from(grid, (s, i) => (i === 0 ? 0 : i === last ? sharp.duration : timeAt(sharp, s)));
  const isWithin = Array.from({ length: last }, (_, i) => isKept(times[i], times[i + 1]));
  const lawOf = (/** @type {Float64Array} */ x) => {
    const isLaw = Array.from(grid, (s, i) => Math.abs(Math.sqrt(x[i]) - rate(s)) <= SAME * rate(s));
    const parts = partsOf(grid, x).flatMap((part, i) =>
      isLaw[i] && isLaw[i + 1] && isWithin[i] ? between(sharp, times[i], times[i + 1]) : [part],
    );
    return timeLaw(0, end, parts);
  };
  if (!rounded) return { law: found.over > 1 ? found.law : lawOf(found.x), slowed: found.slowedBy(found.x) };
  const { law: kept, x, slowedFrom } = keepRounded(path, plane, all, sections, lawOf, seconds);
  return { law: kept, slowed: slowedFrom(found.slowedBy(x)) };
}

/** Says whether a law keeps limits from one moment to another. @param {PosturePath} path @param {TimeLaw} law @param {Limits} limits */
function keeps(path, law, limits) {
  const ends = [...law.pieces.map(({ start }) => start), ...Array.from(path.knots, (s) => timeAt(law, s))];
  ends.sort((a, b) => a - b);
  return (/** @type {number} */ from, /** @type {number} */ to) =>
    mostUse(path, law, limits, [from, ...ends.filter((t) => t > from && t < to), to]) <= 1 + OVER;
}

const span = createSpan();

/**
 * Whether bounds tell at once that no limit is near.
 * @param {PosturePath} path @param {Limits} limits @param {number} acceleration  the law's @param {number} jerk  the law's
 */
function isGentle({ dof, knots, coefficients }, { rates, accelerations, jerks }, acceleration, jerk) {
  for (let k = 0, at = 0; k < knots.length - 1; k++) {
    const width = knots[k + 1] - knots[k];
    for (let i = 0; i < dof; i++, at += TERMS) {
      writeSpan(coefficients, at, span);
      const [, first, second, third] = span.derivatives.map((value, order) => value / width ** order);
      if (first > rates[i] || second + first * acceleration > accelerations[i]) return false;
      if (jerks && third + 3 * second * acceleration + first * jerk > jerks[i]) return false;
    }
  }
  return true;
}

/** What of the limits the law uses at most. @param {PosturePath} path @param {TimeLaw} law @param {Limits} limits @param {readonly number[]} ends  of its stretches, ascending */
function mostUse(path, law, { rates, accelerations, jerks }, ends) {
  const now = pathMoment(path.dof);
  let most = 0;
  for (let k = 0; k < ends.length - 1; k++) {
    for (let j = 0; j <= SAMPLES; j++) {
      // a hair inside, since accelerations may jump at the ends
      const at = Math.min(1 - 1e-6, Math.max(1e-6, j / SAMPLES));
      const { position, rate, acceleration, jerk } = momentAt(law, ends[k] + at * (ends[k + 1] - ends[k]));
      pathMomentAt(path, position, now);
      for (let i = 0; i < path.dof; i++) {
        const [first, second] = [now.first[i], now.second[i]];
        const use = Math.abs(second * rate * rate + first * acceleration) / accelerations[i];
        most = Math.max(most, use, (Math.abs(first) * rate) / rates[i]);
        if (!jerks) continue;
        const sudden = Math.abs(now.third[i] * rate ** 3 + 3 * second * rate * acceleration + first * jerk);
        most = Math.max(most, sudden / jerks[i]);
      }
    }
  }
  return most;
}
