/** The handle on the tool, and what stands in its way. */

export const DRAG = {
  handle: 'Handle on the tool',
  bar: 'Dragging the tool',
  axesLabel: 'Axes of the handle',
  axes: { base: 'Base', tool: 'Tool', world: 'World', user: 'User' },
  snap: (/** @type {string} */ length, /** @type {string} */ angle) => `Snap ${length} · ${angle}`,
  snapTitle: 'Move and turn in whole steps; Shift while dragging does the other',
  /** In the scene, on a double arrow and on a ring. */
  nearest: 'as near as found',
  lost: { along: 'no motion this way', about: 'no turn about this' },
};
