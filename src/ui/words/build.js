/** The player that shows how a row of the table makes a frame. */

export const BUILD = {
  title: 'Build it: how a row makes a frame',
  row: 'Row',
  rowOption: (/** @type {number} */ row) => `Row ${row}`,
  back: 'Step back',
  play: 'Play',
  pause: 'Pause',
  forward: 'Step forward',
  close: 'Close “Build it”',
  start: (/** @type {string} */ before, /** @type {string} */ after) =>
    `Four motions take frame ${before} to frame ${after}.`,
  step: (/** @type {number} */ step, /** @type {string} */ motion) => `${step} of 4: ${motion}.`,
  end: (/** @type {string} */ frame) => `That is frame ${frame}.`,
  turn: (/** @type {string} */ amount, /** @type {string} */ axis, /** @type {string} */ symbol) =>
    `turn ${amount} about ${axis} (${symbol})`,
  slide: (/** @type {string} */ amount, /** @type {string} */ axis, /** @type {string} */ symbol) =>
    `slide ${amount} along ${axis} (${symbol})`,
  noTurn: (/** @type {string} */ axis, /** @type {string} */ symbol) => `no turn about ${axis}, since ${symbol} = 0`,
  noSlide: (/** @type {string} */ axis, /** @type {string} */ symbol) => `no slide along ${axis}, since ${symbol} = 0`,
  closed: '“Build it” closed.',
};
