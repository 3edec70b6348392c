/**
 * A law whose acceleration jumps, made into one whose acceleration is continuous: its rate becomes the mean of the rates of the last so
 * many seconds. Rate and acceleration are then never more than they were, the jerk is at most their jump over those seconds, and it
 * arrives as much later. Of constant accelerations from rest to rest this makes the S-curve.
 *
 * @import { TimeLaw } from './timeLaw.js'
 */
import { pieceAt, shifted, timeLaw } from './timeLaw.js';

/** Moments that are nearer to each other, by the whole time, are one. */
const SAME = 1e-13;

/**
 * @param {TimeLaw} law   from rest to rest
 * @param {number} seconds  0 or more
 * @returns {TimeLaw}  by polynomials of one degree more
 */
export function roundedLaw(law, seconds) {
  if (!(seconds > 0) || law.pieces.length === 0) return law;
  const duration = law.duration + seconds;
  const starts = law.pieces.flatMap(({ start }) => [start, start + seconds]);
  const moments = [...starts, law.duration, duration].sort((a, b) => a - b);
  const ends = moments.filter((t, i) => i === 0 || t - moments[i - 1] > SAME * duration);
  let position = law.from;
  const parts = ends.slice(1).map((end, i) => {
    const [begin, width] = [ends[i], end - ends[i]];
    const middle = begin + width / 2;
    const [now, before] = [polynomialAt(law, middle, begin), polynomialAt(law, middle - seconds, begin - seconds)];
    const coefficients = [position];
    let power = width;
    for (let k = 0; k < Math.max(now.length, before.length); k++) {
      const c = ((now[k] ?? 0) - (before[k] ?? 0)) / (seconds * (k + 1));
      coefficients.push(c);
      position += c * power;
      power *= width;
    }
    return { duration: width, coefficients };
  });
  return timeLaw(law.from, law.to, parts);
}

/** The polynomial that holds at a moment, by the time since another. @param {TimeLaw} law @param {number} t @param {number} since */
function polynomialAt({ duration, pieces, from, to }, t, since) {
  if (t <= 0) return [from];
  if (t >= duration) return [to];
  const { start, coefficients } = pieceAt(pieces, t);
  return shifted(coefficients, since - start);
}
