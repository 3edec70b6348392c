/** Named targets. */

export const TARGETS = {
  list: 'Named targets',
  none: 'None yet. A target keeps a pose of the tool with the robot, under a name.',
  keep: 'Keep this target',
  inFrame: (/** @type {string} */ frame) => `Kept in the user frame ${frame}, and moved with it.`,
  givenIn: (/** @type {string} */ frame) => `Given in the user frame ${frame}`,
  kept: (/** @type {string} */ name) => `Kept as ${name}.`,
  name: (/** @type {string} */ name) => `Name of ${name}`,
  aim: (/** @type {string} */ name) => `Aim at ${name}`,
  aimShort: 'Aim',
  aimed: (/** @type {string} */ name) => `The target is ${name}.`,
  set: (/** @type {string} */ name) => `Put ${name} at the present target`,
  setShort: 'Put here',
  setDone: (/** @type {string} */ name) => `${name} is where the target is now.`,
  up: (/** @type {string} */ name) => `Move ${name} up`,
  upShort: 'Up',
  remove: (/** @type {string} */ name) => `Remove ${name}`,
  removed: (/** @type {string} */ name) => `${name} removed. Undo brings it back.`,
};
