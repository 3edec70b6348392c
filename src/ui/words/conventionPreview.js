/** What a change of convention would do, in numbers. */

export const PREVIEW = {
  row: (/** @type {number} */ i) => `row ${i}`,
  noRow: 'no row changes',
  base: 'base',
  tool: 'tool',
  toolPose: 'tool pose',
  same: (/** @type {string} */ bound) => `the same to ${bound}`,
  allRows: 'rows',
  kept: 'all numbers stay',
  jump: (/** @type {string} */ distance, /** @type {string} */ angle) => `jumps by ${distance}, turns by ${angle}`,
  none: 'none',
  angles: ['roll', 'pitch', 'yaw'],
  quaternion: 'turned',
  to: '→',
  spokenTo: ' becomes ',
};
