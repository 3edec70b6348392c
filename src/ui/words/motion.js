/** The plot of joint values and of the tool's speed. */

export const MOTION = {
  empty:
    'Nothing has moved since this was opened. Pull a slider, hold a button or drag the tool: the curves run while the arm moves.',
  picture: (/** @type {string} */ seconds) =>
    `Joint values and tool speed over the last ${seconds} s of motion. The table below has the numbers.`,
  table: 'Joints and tool speed: now, least and greatest of what is drawn',
  columns: { name: 'Curve', now: 'now', least: 'least', most: 'greatest' },
  speed: 'Speed',
  speedName: 'Tool speed',
  curve: (/** @type {string} */ name) => `Draw ${name}`,
  pause: 'Pause',
  pauseTitle: 'Record nothing until it is pressed again',
  clear: 'Clear',
  copy: 'Copy as CSV',
  copied: 'The curves are copied as comma-separated values.',
  paused: 'Recording is paused.',
  goesOn: 'Recording goes on.',
  cleared: 'The curves are cleared.',
  axis: (/** @type {string} */ unit) => `Joint values [${unit}]`,
  seconds: 's of motion',
  csvTime: 'time [s]',
  csvColumn: (/** @type {string} */ name, /** @type {string} */ unit) => `${name} [${unit}]`,
  perSecond: (/** @type {string} */ unit) => `${unit}/s`,
};
