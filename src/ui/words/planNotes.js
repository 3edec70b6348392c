/** What a plan assumes, and where it does otherwise than was asked. */

/** @typedef {(text: string) => string} Of */

export const PLAN_NOTES = {
  title: 'Assumed and changed',
  /** @param {number} count */
  count: (count) => (count === 1 ? '1 note' : `${count} notes`),
  joints: (/** @type {number[]} */ numbers) => series('J', numbers),
  steps: (/** @type {number[]} */ numbers) =>
    numbers.length === 1 ? `step ${numbers[0]}` : `steps ${series('', numbers)}`,
  assumed: {
    'joint-rate': (/** @type {string} */ joints, /** @type {string} */ turn, /** @type {string} */ slide) =>
      `No greatest rate is stated for ${joints}: ${turn} is assumed for a joint that turns, ${slide} for one that slides.`,
    'joint-acceleration': (/** @type {string} */ joints, /** @type {string} */ time) =>
      `No greatest acceleration is stated for ${joints}: from rest to the greatest rate in ${time} s is assumed.`,
    'tool-turn': (/** @type {string} */ steps, /** @type {string} */ turn) =>
      `How fast the tool may turn is not said in ${steps}: at most ${turn} is assumed.`,
    'tool-speed': (/** @type {string} */ steps, /** @type {string} */ speed) =>
      `How fast the tool may go is not said in ${steps}: at most ${speed} is assumed.`,
    'tool-acceleration': (/** @type {string} */ steps, /** @type {string} */ acceleration) =>
      `No robot file states an acceleration of the tool: 100 % of it in ${steps} is taken for ${acceleration}.`,
    input: /** @type {Of} */ ((steps) => `The input of ${steps} is taken to come at once.`),
    call: /** @type {Of} */ (
      (steps) => `What ${steps} calls is not among the programs here and is taken to move nothing.`
    ),
  },
  slower: (/** @type {number} */ step, /** @type {string} */ from, /** @type {string} */ to) =>
    `Step ${step} is slower than asked from ${from} % to ${to} % of its way`,
  because: {
    joint: /** @type {Of} */ ((joint) => `, because ${joint} is at its greatest rate, acceleration or jerk.`),
    bend: ', because of how its way bends.',
  },
  instead: {
    trapezoid: (/** @type {string} */ steps, /** @type {string} */ law) =>
      `The ${law} of ${steps} is not kept: without a stop at both ends it goes by constant accelerations.`,
    doubleS: (/** @type {string} */ steps, /** @type {string} */ law) =>
      `The ${law} of ${steps} is not kept: it goes on, without a stop, from or into a move by the S-curve, and with its limited jerk.`,
  },
  stops: (/** @type {number} */ step) => `Step ${step} stops at its end all the same: `,
  why: {
    wait: 'a wait follows.',
    still: 'it, or the step that follows, goes nowhere.',
    short: 'there is no room for a zone.',
    limit: 'in the zone a joint would pass its limit.',
    reach: 'the zone is out of reach.',
    orientation: 'in the zone the tool cannot be so turned.',
    singularity: 'the zone leads through a singularity.',
    start: 'the zone does not begin where the arm stands.',
    law: 'the time law of it, or of the step that follows, goes on only into its own.',
  },
};

/** J1, J2 and J4; a run from one to another is told by its ends. @param {string} sign @param {number[]} numbers */
function series(sign, numbers) {
  /** @type {number[][]} */
  const spans = [];
  for (const number of numbers) {
    const last = spans[spans.length - 1];
    if (last?.[1] === number - 1) last[1] = number;
    else spans.push([number, number]);
  }
  const parts = spans.map(([from, to]) => {
    if (from === to) return `${sign}${from}`;
    return to === from + 1 ? `${sign}${from}, ${sign}${to}` : `${sign}${from}–${sign}${to}`;
  });
  return parts.length < 2 ? parts.join('') : `${parts.slice(0, -1).join(', ')} and ${parts[parts.length - 1]}`;
}
