/** What belongs to the robot beside its table: the heads that the page shows from the start. */

export const ROBOT = {
  joint: (/** @type {number} */ i) => `Joint ${i}`,
  turns: 'turns about',
  slides: 'slides along',
  details: (/** @type {string} */ joint) => `Limits, home and link of ${joint}`,
  base: 'Base',
  tool: 'Tool',
  frames: 'Frames and tools',
  active: (
    /** @type {string | undefined} */ user,
    /** @type {string | undefined} */ tool,
    /** @type {boolean} */ isFlange,
  ) => `${user ?? 'world'} · ${tool ?? (isFlange ? 'flange' : 'unlisted tool')}`,
  obstacles: 'Obstacles',
  noObstacles: 'none',
  about: 'About this robot',
  noBase: 'at the origin, upright',
  noTool: 'none; the flange itself',
  noShift: 'none yet',
  turned: 'turned',
  turnedOnly: 'turned on the spot',
  noSource: 'no source given',
  goTo: 'Go to a posture by name',
  fetchingNames: 'Fetching the named postures …',
};
