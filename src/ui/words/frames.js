/** User frames and tools. */

/** @typedef {'user' | 'tool'} Kind */

/** @type {Record<Kind, string>} */
const ONE = { user: 'User frame', tool: 'Tool' };

export const FRAMES = {
  title: { user: 'User frames', tool: 'Tools' },
  /** What a controller calls them. */
  note: { user: 'UFRAME, BASE_DATA', tool: 'UTOOL, TOOL_DATA' },
  one: ONE,
  none: { user: 'World', tool: 'Flange, no tool' },
  noneDetail: { user: 'the world’s own axes', tool: 'the last frame of the table' },
  own: 'Unlisted tool',
  keepOwn: 'Put into the list',
  keptOwn: (/** @type {string} */ id) => `The tool in use is in the list now, as ${id}.`,
  choose: (/** @type {Kind} */ kind, /** @type {string} */ id) => `Use the ${ONE[kind].toLowerCase()} ${id}`,
  chooseNone: { user: 'Use the world, no user frame', tool: 'Use no tool, the flange itself' },
  chosen: (/** @type {Kind} */ kind, /** @type {string} */ id) => `${ONE[kind]} ${id} is active.`,
  chosenNone: { user: 'No user frame is active.', tool: 'No tool is active; the flange itself is followed.' },
  name: (/** @type {Kind} */ kind, /** @type {string} */ id) => `Name of ${ONE[kind].toLowerCase()} ${id}`,
  renamed: (/** @type {string} */ id) => `It is called ${id} now.`,
  number: (/** @type {string} */ id) => `Number of ${id}`,
  numbered: (/** @type {string} */ id, /** @type {string} */ number) => `${id} has ${number || 'no number'}.`,
  notNumber: 'The number of a frame is a whole number above 0, as 1, or nothing.',
  edit: (/** @type {string} */ id) => `Edit the pose of ${id}`,
  editShort: 'Edit',
  here: 'Put at the tool',
  hereDone: (/** @type {string} */ id) => `${id} is where the tool is now.`,
  remove: (/** @type {string} */ id) => `Remove ${id}`,
  removed: (/** @type {string} */ id) => `${id} removed. Undo brings it back.`,
  removedInUse: (/** @type {string} */ id) => `${id} removed; the flange itself is followed now. Undo brings it back.`,
  removedWithTargets: (/** @type {string} */ id, /** @type {number} */ count) =>
    `${id} removed; ${count === 1 ? 'the target' : `the ${count} targets`} in it ${count === 1 ? 'stays where it is' : 'stay where they are'}, seen from the world. Undo brings it back.`,
  add: { user: 'Add a user frame', tool: 'Add a tool' },
  added: (/** @type {Kind} */ kind, /** @type {string} */ id) => `${ONE[kind]} ${id} added, not active yet.`,
  addedInUse: (/** @type {string} */ id) => `${id} added; it is the tool in use.`,
  from: {
    here: 'At the tool',
    hereDetail: 'where the TCP is now, turned as it is',
    numbers: 'By numbers',
    userDetail: 'at the world’s origin; then type',
    toolDetail: 'at the flange; then type',
    present: 'As the tool in use',
    presentDetail: 'its numbers, to be changed',
    points: 'By three points',
    pointsDetail: 'origin, X axis, Y side, as on a pendant',
  },
  keeps: 'Another tool',
  keepsLabel: 'What stays where it is when another tool is chosen',
  keep: { flange: 'keeps the flange', tcp: 'keeps the TCP' },
  keepNote: {
    flange: 'The joints stay; the TCP goes to the tip of the new tool.',
    tcp: 'The arm moves so that the tip of the new tool is where the old one was.',
  },
  cannotKeep: (/** @type {string} */ id, /** @type {string} */ why) =>
    `${id} is not chosen: the TCP cannot stay. ${why}`,
  noTool: 'No tool',
  keepFlange: 'Keep the flange instead',

  points: 'User frame by three points',
  pointsIntro: 'Bring the TCP to each point and take it there.',
  point: ['Origin', 'On the X axis', 'On the Y side'],
  take: 'Take',
  takeLabel: (/** @type {string} */ point) => `Take the TCP as: ${point}`,
  taken: (/** @type {string} */ point, /** @type {string} */ place) => `${point}: ${place}`,
  notTaken: 'not taken',
  make: 'Make the frame',
  cancel: 'Cancel',
  missing: (/** @type {string} */ point) => `Not taken yet: ${point}.`,
  fault: {
    together: 'Two of the points are the same place. Take them farther apart.',
    inLine: 'The third point is on the X axis, so it does not say where Y is. Take it beside the axis.',
  },
};
