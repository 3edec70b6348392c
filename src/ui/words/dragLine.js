/** What stands in the way of a drag, and what keys do to a tool that is taken. */

/** The plane of arrow keys, by the axis across it. */
const PLANE = ['YZ', 'XZ', 'XY'];

export const DRAG_LINE = {
  inAxes: { base: 'base', tool: 'tool', world: 'world', user: 'user' },
  limit: (/** @type {string} */ joint) => `${joint} is at its limit.`,
  reach: (/** @type {string} */ by) => `Edge of the reach: ${by} short.`,
  fewReach: (/** @type {string} */ by) => `This arm cannot bring the tool there: ${by} short.`,
  orientation: (/** @type {string} */ by) => `The arm cannot turn the tool this way here: ${by} short.`,
  singularity: (/** @type {string} */ joint) => `Singularity: ${joint} has to turn far first.`,
  part: (/** @type {string} */ by) => `With its few joints the arm keeps the place; the orientation is ${by} off.`,
  taken: {
    /** @param {string} axes @param {number} across */
    move: (axes, across) =>
      `Tool taken. Arrow keys move it along ${PLANE[across][0]} and ${PLANE[across][1]} of the ${axes} axes, two at once in their plane, Page Up and Page Down along ${'XYZ'[across]}. P takes the next plane, R turns it instead, Esc gives it back.`,
    turn: (/** @type {string} */ axes) =>
      `Tool taken. Arrow keys turn it about X and Y of the ${axes} axes, Page Up and Page Down about Z. R moves it instead, Esc gives it back.`,
  },
  takenShort: {
    /** @param {number} across */
    move: (across) =>
      `Arrow keys ${PLANE[across].split('').join(' ')}, Page keys ${'XYZ'[across]} · P next plane · R turns · Esc gives back`,
    turn: () => 'Turning: arrow keys X Y, Page keys Z · R moves · Esc gives back',
  },
  givenBack: 'Tool given back.',
};
