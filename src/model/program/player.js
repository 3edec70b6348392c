/**
 * The player of a motion program: where in its time it is, and whether time runs. Every function makes another playback of
 * one; none knows a clock, an arm or a screen.
 *
 * @import { MotionPart, MotionPlan } from '../../motion/plan.js'
 *
 * @typedef {object} Playback
 * @property {string} program     the id of the motion program
 * @property {readonly number[]} start  where the arm stood when the program began, in document units
 * @property {readonly number[] | null} posture  where the player has put the arm last: the document's own list; null: nowhere
 * @property {number} time        s, in the program's own time
 * @property {boolean} isOver     that is its end
 * @property {boolean} isPlaying
 * @property {number} speed       share of the program's own: 1 is as planned
 * @property {boolean} isLoop
 * @property {boolean} hasPath    whether the path of the tool is drawn
 * @property {boolean} hasGhosts  whether the arm is drawn where the present move begins and ends
 */

/** Shares of the program's own speed. */
export const SLOWEST = 0.01;
export const FASTEST = 4;

/** s; a page that was hidden goes on where it was. */
export const LONGEST_FRAME = 0.1;

/** s; what is nearer to a mark than this is at it: a millionth of a second is what moves that arrive together may differ by. */
const AT_MARK = 1e-6;

/**
 * @param {string} program
 * @param {readonly number[]} start
 * @param {Playback | null} [before]  whose settings stay
 * @returns {Playback}
 */
export function firstPlayback(program, start, before = null) {
  const { speed = 1, isLoop = false, hasPath = true, hasGhosts = false } = before ?? {};
  return {
    ...{ program, start, posture: null, time: 0, isOver: false, isPlaying: false },
    ...{ speed, isLoop, hasPath, hasGhosts },
  };
}

/** From the beginning if it is at the end. @param {Playback} playback @param {number} duration @returns {Playback} */
export const play = (playback, duration) => ({
  ...at(playback, isAtEnd(playback, duration) ? 0 : playback.time, duration),
  isPlaying: duration > 0,
});

/** @param {Playback} playback @returns {Playback} */
export const pause = (playback) => (playback.isPlaying ? { ...playback, isPlaying: false } : playback);

/** @param {Playback} playback @param {number} time @param {number} duration @returns {Playback} */
export const scrub = (playback, time, duration) => ({
  ...at(playback, Math.min(duration, Math.max(0, time)), duration),
  isPlaying: false,
});

/** @param {Playback} playback @param {number} time @param {number} duration @returns {Playback} */
const at = (playback, time, duration) => ({ ...playback, time, isOver: isAtEnd({ time }, duration) });

/** To where the next move begins, or to the end. @param {Playback} playback @param {readonly number[]} marks @returns {Playback} */
export function toNext(playback, marks) {
  const duration = marks[marks.length - 1] ?? 0;
  return scrub(playback, marks.find((mark) => mark > playback.time + AT_MARK) ?? duration, duration);
}

/** To where this move began, or, from there, the one before. @param {Playback} playback @param {readonly number[]} marks @returns {Playback} */
export function toPrevious(playback, marks) {
  const mark = marks.findLast((one) => one < playback.time - AT_MARK);
  return scrub(playback, mark ?? 0, marks[marks.length - 1] ?? 0);
}

/** @param {Playback} playback @param {number} speed @returns {Playback} */
export const atSpeed = (playback, speed) => ({ ...playback, speed: Math.min(FASTEST, Math.max(SLOWEST, speed)) });

/**
 * After so much of the page's time.
 * @param {Playback} playback
 * @param {number} seconds
 * @param {number} duration
 * @returns {Playback}
 */
export function after(playback, seconds, duration) {
  if (!playback.isPlaying) return playback;
  const time = playback.time + Math.min(LONGEST_FRAME, Math.max(0, seconds)) * playback.speed;
  if (time < duration) return at(playback, time, duration);
  if (playback.isLoop && duration > 0) return at(playback, time % duration, duration);
  return { ...at(playback, duration, duration), isPlaying: false };
}

/** @param {{ readonly time: number }} playback @param {number} duration */
export const isAtEnd = ({ time }, duration) => time >= duration - AT_MARK;

/**
 * The moves over their time: a move that was planned in several parts is one.
 * @param {Pick<MotionPlan, 'parts'>} plan
 */
export function movesInTime({ parts }) {
  /** @type {{ move: number, kind: MotionPart['kind'], begin: number, end: number }[]} */
  const moves = [];
  for (const { move, kind, begin, end } of parts) {
    const last = moves[moves.length - 1];
    if (last?.move === move) last.end = end;
    else moves.push({ move, kind, begin, end });
  }
  return moves;
}

/** The moments at which moves begin, and the end. @param {Pick<MotionPlan, 'parts' | 'duration'>} plan @returns {number[]} */
export function marksOf(plan) {
  /** @type {number[]} */
  const marks = [];
  for (const time of [0, ...movesInTime(plan).map(({ begin }) => begin), plan.duration]) {
    if (marks.length === 0 || time > marks[marks.length - 1] + AT_MARK) marks.push(time);
  }
  return marks;
}

/**
 * The move that is under way at a time; at a mark, the one that begins there.
 * @param {Pick<MotionPlan, 'parts'>} plan
 * @param {number} time
 * @returns {number | null}  null: the plan has none
 */
export function moveAt({ parts }, time) {
  const now = parts.findLast(({ begin }) => begin <= time + AT_MARK) ?? parts[0];
  return now ? now.move : null;
}
