/** Where the tool is to be, and why it is not. */

export const AIM = {
  title: 'Target',
  field: (/** @type {string} */ name, /** @type {string} */ unit) => `Target ${name}, ${unit}`,
  set: (/** @type {string} */ name, /** @type {string} */ value) => `${name}: ${value}`,
  copy: 'Copy the target',
  paste: 'Paste…',
  helpers: 'Helpers',
  move: 'Move there',
  follow: 'Take the tool pose',
  nearest: 'Go as near as found',
  following: 'The fields follow the tool. Type a pose to aim at.',
  toGo: (/** @type {string} */ distance, /** @type {string} */ angle) => `${distance} and ${angle} to go.`,
  reached: (/** @type {string} */ distance, /** @type {string} */ angle) => `Reached: ${distance}, ${angle} off.`,
  subspace: (/** @type {string} */ task) => `Met as far as this arm can: ${task}`,
  asNear: (/** @type {string} */ distance, /** @type {string} */ angle) =>
    `The arm stands ${distance} and ${angle} off, as near as was found.`,
  solutions: 'Solutions',
  solutionsDetail: 'other postures for this pose',
  named: 'Named targets',
  noneNamed: 'none kept yet',
  wentNearest: 'The arm stands at the nearest posture found.',
};

/** Why inverse kinematics did not reach the whole pose. */
export const VERDICT = {
  task: {
    'position-and-tilt': (/** @type {string} */ angle) =>
      `the position and the tilt of the tool. Its turn about the arm’s first axis follows from them and differs by ${angle}.`,
    'position-and-axis': (/** @type {string} */ angle) =>
      `the position and the direction of the tool axis. Its turn about that axis follows from them and differs by ${angle}.`,
    'position-and-turn': (/** @type {string} */ angle) =>
      `the position and the turn about the arm’s first axis. The tilt of the tool is fixed and differs by ${angle}.`,
    'position-and-pitch': (/** @type {string} */ angle) =>
      `the position and the pitch of the tool. The rest of its orientation follows from them and differs by ${angle}.`,
    position: (/** @type {string} */ angle) => `the position. The orientation differs by ${angle}.`,
  },
  beyond: (/** @type {string} */ by) => `Out of reach, by at least ${by}.`,
  distance: (/** @type {string} */ by) =>
    `Out of reach: the tool was found to come no nearer to this place than ${by}.`,
  orientation: 'The tool can be at this place, but no posture turns it this way.',
  outsideLimits: (/** @type {string} */ joint, /** @type {string} */ by) =>
    `Only outside the limits: ${joint} would have to go ${by} past its stop.`,
  notFound: (/** @type {string} */ distance, /** @type {string} */ angle) =>
    `No posture found for this pose. The nearest one found is ${distance} and ${angle} off.`,
  fewJoints: (/** @type {number} */ joints, /** @type {string} */ distance, /** @type {string} */ angle) =>
    `An arm with ${joints} joints cannot take this pose. The nearest posture found is ${distance} and ${angle} off.`,
};
