/** The trace of the tool. */

export const TRACE = {
  label: 'Trace of the tool',
  caption: 'Trace',
  none: 'move the arm',
  strokes: (/** @type {number} */ count) => `in ${count} strokes`,
  clear: 'Clear',
  clearTitle: 'Clear the trace and begin it here',
  cleared: 'The trace is cleared; it begins where the tool is.',
};
