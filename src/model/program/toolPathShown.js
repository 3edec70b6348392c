/**
 * The path of the tool over a whole program as the scene draws it: points with the speed there, dots that are the same time
 * apart, so that speed is seen without colours, and the arm where the present move begins and ends.
 *
 * @import { Planned } from './planned.js'
 * @import { PlanSeries } from './planSeries.js'
 * @import { AppState } from '../session.js'
 *
 * @typedef {object} ToolPathShown
 * @property {Pick<PlanSeries, 'times' | 'place' | 'speed'>} series
 * @property {number} most       the greatest speed, m/s
 * @property {number} dotEvery   s
 * @property {readonly { time: number, step: number }[]} ends   where moves of the arm end
 */
import { planMomentAt } from '../../motion/planMoment.js';
import { planNow, playbackNow } from './planning.js';
import { memo } from '../memo.js';
import { moveAt, movesInTime } from './player.js';

/** s between dots; the least of them that makes no more than so many dots. */
const DOTS = { every: [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 300], most: 80 };

const shownOf = memo(
  /** @param {PlanSeries} series @param {Planned} planned @returns {ToolPathShown} */
  (series, { plan, steps }) => ({
    series,
    most: series.speed.reduce((most, speed) => Math.max(most, speed), 0),
    dotEvery: DOTS.every.find((every) => plan.duration / every <= DOTS.most) ?? plan.duration,
    ends: movesInTime(plan)
      .filter(({ kind }) => kind !== 'wait')
      .map(({ move, end }) => ({ time: end, step: steps[move] })),
  }),
);

/** @param {AppState} state @returns {ToolPathShown | null}  the same object for as long as it is the same */
export function toolPathShown(state) {
  const planned = planNow(state);
  const series = state.session.planning?.series ?? null;
  if (!planned || !series || !playbackNow(state)?.hasPath) return null;
  return shownOf(series, planned);
}

/** Where in it the arm is, s. @param {AppState} state */
export const toolPathTime = (state) => playbackNow(state)?.time ?? 0;

const ghostsOf = memo(
  /** @param {Planned} planned @param {number} move */
  ({ plan, steps }, move) => {
    const parts = plan.parts.filter((part) => part.move === move);
    const [begin, end] = [parts[0].begin, parts[parts.length - 1].end];
    return { step: steps[move], ends: [begin, end].map((time) => planMomentAt(plan, time).posture) };
  },
);

/**
 * The arm where the present move begins and ends, while that is wanted; nothing of a move that moves nothing.
 * @param {AppState} state
 * @returns {{ step: number, ends: readonly Float64Array[] } | null}  the same object for as long as it is the same
 */
export function moveGhosts(state) {
  const playback = playbackNow(state);
  const planned = playback?.hasGhosts ? planNow(state) : null;
  const move = playback && planned ? moveAt(planned.plan, playback.time) : null;
  return planned && move !== null && planned.moves[move].kind !== 'wait' ? ghostsOf(planned, move) : null;
}
