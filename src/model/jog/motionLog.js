/**
 * What moved in the last seconds: values of the joints and the speed of the tool, against a time that runs only while
 * something moves. A pause is a gap; what happened at once, with no time between, has no speed.
 *
 * @typedef {object} MotionLog
 * @property {number[]} time  s
 * @property {readonly (readonly (number | null)[])[]} values  of each joint; null: nothing was going on
 * @property {readonly (number | null)[]} speed  m/s
 */

/** Seconds without a change after which nothing moves any more. */
export const REST = 0.4;

/** How wide a pause is drawn, s. */
const GAP = 0.4;

/** @typedef {ReturnType<typeof createMotionLog>} Recording */

/**
 * @param {number} joints
 * @param {number} window  seconds that are kept
 */
export function createMotionLog(joints, window) {
  /** @type {number[]} */
  let time = [];
  /** @type {(number | null)[][]} */
  let values = Array.from({ length: joints }, () => []);
  /** @type {(number | null)[]} */
  let speed = [];
  /** The last change, by the clock. @type {{ at: number, place: readonly number[] } | null} */
  let last = null;
  let isMoving = false;

  /** @param {number} at @param {readonly (number | null)[] | null} q @param {number | null} v */
  function push(at, q, v) {
    time.push(at);
    values.forEach((column, i) => column.push(q ? q[i] : null));
    speed.push(v);
    // in pieces, not one by one: half as much again is kept for a while
    if (at - time[0] < 1.5 * window) return;
    const from = time.findIndex((one) => one >= at - window);
    time = time.slice(from);
    values = values.map((column) => column.slice(from));
    speed = speed.slice(from);
  }
  const end = () => time[time.length - 1] ?? 0;

  return {
    get isMoving() {
      return isMoving;
    },
    /** The last `window` seconds. @returns {MotionLog} */
    get log() {
      const from = time.findIndex((one) => one >= end() - window);
      if (from <= 0) return { time, values, speed };
      return { time: time.slice(from), values: values.map((column) => column.slice(from)), speed: speed.slice(from) };
    },
    /**
     * The arm has moved since the last picture.
     * @param {number} now  by the clock, s
     * @param {readonly number[]} before  values that it left
     * @param {readonly number[]} q
     * @param {readonly number[]} from  where the tool was, m
     * @param {readonly number[]} place  where it is
     */
    move(now, before, q, from, place) {
      if (!isMoving || !last) {
        // From rest, nobody knows when within the picture it began: a step, at one time.
        if (time.length > 0) push(end() + GAP / 2, null, null);
        push(end() + (time.length > 0 ? GAP / 2 : 0), before, null);
        push(end(), q, null);
      } else {
        const seconds = now - last.at;
        const far = Math.hypot(...place.map((x, i) => x - from[i]));
        push(end() + seconds, q, seconds > 0 ? far / seconds : null);
      }
      isMoving = true;
      last = { at: now, place };
    },
    /**
     * The arm has not moved since the last picture.
     * @param {number} now
     * @returns {boolean} whether that has come to a rest, so that no more pictures are wanted
     */
    still(now) {
      if (!isMoving || !last) return true;
      if (now - last.at < REST) return false;
      push(
        end() + REST,
        values.map((column) => column[column.length - 1]),
        0,
      );
      isMoving = false;
      return true;
    },
    /** What moves from here on has nothing to do with what did before. */
    stop() {
      isMoving = false;
      last = null;
    },
  };
}

/**
 * The number now, the least and the greatest.
 * @param {readonly (number | null)[]} column
 */
export function extremes(column) {
  const known = column.filter((value) => value !== null);
  if (known.length === 0) return null;
  return { now: column[column.length - 1], least: Math.min(...known), most: Math.max(...known) };
}

/**
 * As comma-separated values, with a head. Pauses are lines without numbers.
 * @param {MotionLog} log
 * @param {readonly string[]} names  of all columns
 * @param {(metresPerSecond: number) => number} speedOf
 */
export function motionCsv({ time, values, speed }, names, speedOf) {
  const text = (/** @type {number | null} */ value) => (value === null ? '' : String(Number(value.toPrecision(9))));
  const rows = time.map((at, i) =>
    [at - time[0], ...values.map((column) => column[i]), speed[i] === null ? null : speedOf(speed[i])].map(text).join(),
  );
  return [names.map((name) => (name.includes(',') ? `"${name}"` : name)).join(), ...rows, ''].join('\r\n');
}
