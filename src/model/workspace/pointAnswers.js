/**
 * What the kernel says of points and lines, in the document's units, to be read, copied and saved.
 *
 * @import { RobotDoc } from '../document.js'
 * @import { Held, LineAnswer, PointAnswer, ReachShown } from './asked.js'
 *
 * @typedef {object} PointRow
 * @property {string} name
 * @property {readonly number[]} at          X Y Z
 * @property {'reached' | 'not-found' | 'unreachable'} verdict  not-found: no proof that there is none
 * @property {readonly ReachPosture[]} postures
 * @property {boolean} areAll
 * @property {number} distance               to the nearest place
 * @property {readonly number[]} nearest     that place
 * @property {readonly number[] | null} nearestPosture
 *
 * @typedef {object} ReachPosture
 * @property {readonly number[]} posture
 * @property {{ share: number, joint: number } | null} margin  the room to the nearest limit, as a share of the half range
 *
 * @typedef {object} LineRow
 * @property {boolean} isTravelled
 * @property {number} share
 * @property {readonly number[] | null} start   postures
 * @property {readonly number[] | null} end
 * @property {readonly number[] | null} stopsAt X Y Z
 * @property {'no-start' | 'limit' | 'limit-other' | 'boundary' | 'turn' | null} why  null: it is travelled. limit-other: at a limit, but other
 *   postures go on; boundary: nothing beyond is reached; turn: a joint would have to jump
 * @property {readonly Held[]} held
 */
import { postureFromKernel } from '../compile.js';
import { fromKernel } from '../units.js';

/** @param {RobotDoc} robot @param {ArrayLike<number>} place  m */
export const placeFromKernel = ({ units }, place) => [0, 1, 2].map((i) => fromKernel('length', place[i], units));

/** @param {RobotDoc} robot @param {ArrayLike<number> | null} q */
const postureOf = (robot, q) => q && postureFromKernel(robot, q);

/**
 * @param {RobotDoc} robot
 * @param {{ readonly name: string, readonly at: readonly number[] }} point
 * @param {PointAnswer} answer
 * @returns {PointRow}
 */
export function pointRow(robot, { name, at }, answer) {
  const { isReached, isProven, postures, areAll, distance, nearest, nearestPosture } = answer;
  return {
    name,
    at,
    verdict: isReached ? 'reached' : isProven ? 'unreachable' : 'not-found',
    postures: postures.map(({ q, limitMargin }) => ({
      posture: postureFromKernel(robot, q),
      margin: limitMargin && { share: limitMargin.share, joint: limitMargin.joint },
    })),
    areAll,
    distance: fromKernel('length', distance, robot.units),
    nearest: placeFromKernel(robot, nearest),
    nearestPosture: postureOf(robot, nearestPosture),
  };
}

/** @param {RobotDoc} robot @param {LineAnswer} answer @returns {LineRow} */
export function lineRow(robot, { isTravelled, share, start, end, stop }) {
  const isHeld = stop !== null && stop.held.length > 0;
  const why = isTravelled
    ? null
    : !stop
      ? 'no-start'
      : isHeld
        ? stop.isReachedBeyond
          ? 'limit-other'
          : 'limit'
        : stop.isReachedBeyond
          ? 'turn'
          : 'boundary';
  return {
    isTravelled,
    share,
    start: postureOf(robot, start),
    end: postureOf(robot, end),
    stopsAt: stop && placeFromKernel(robot, stop.place),
    why,
    held: stop?.held ?? [],
  };
}

/**
 * The parts of a line: as far as it can be travelled, and what is missing.
 * @param {number} share
 * @param {readonly number[]} from  m
 * @param {readonly number[]} to
 * @returns {ReachShown['lines'][number][]}
 */
export function lineParts(share, from, to) {
  const stop = from.map((value, i) => value + share * (to[i] - value));
  const way = { points: Float64Array.of(...from, ...stop), kind: /** @type {const} */ ('way') };
  const missing = { points: Float64Array.of(...stop, ...to), kind: /** @type {const} */ ('missing') };
  return share >= 1 ? [way] : share > 0 ? [way, missing] : [missing];
}

/**
 * The list as a table of plain cells, numbers as numbers.
 * @param {readonly PointRow[]} rows
 * @param {readonly string[]} head
 * @param {{ verdict: (row: PointRow) => string, postures: (row: PointRow) => string }} words
 * @returns {(string | number)[][]}
 */
export const pointCells = (rows, head, words) => [
  [...head],
  ...rows.map((row, i) => {
    const [best] = row.postures;
    return [
      row.name || String(i + 1),
      ...row.at,
      words.verdict(row),
      words.postures(row),
      best?.margin ? best.margin.share : '',
      row.verdict === 'reached' ? 0 : row.distance,
      ...row.nearest,
    ];
  }),
];
