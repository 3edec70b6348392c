/** What a program touches, and ways around it. */

/** @typedef {(step: number) => string} OfStep */

export const COLLISIONS = {
  section: 'Clearance of the program',
  checking: (/** @type {string} */ percent) => `Looking whether the program keeps clear, ${percent} %`,
  cancel: 'Cancel',
  given: 'Whether the program keeps clear was not looked at to the end.',
  again: 'Look again',
  clear: (/** @type {string} */ margin, /** @type {number} */ count, /** @type {boolean} */ isWhole) =>
    `Keeps ${margin} clear of ${count === 1 ? 'the obstacle' : `${count} obstacles`}, and of itself: ${proven(isWhole)}.`,
  clearOfItself: (/** @type {boolean} */ isWhole) => `The arm does not touch itself: ${proven(isWhole)}.`,
  notClear: 'Not clear in step',
  toStep: /** @type {OfStep} */ ((step) => `To step ${step}, which is not clear`),
  /** Short, at the step. */
  short: {
    touch: (/** @type {string} */ what) => `touches ${what}`,
    near: (/** @type {string} */ what) => `near ${what}`,
  },
  title: {
    touch: (/** @type {string} */ link, /** @type {string} */ what) => `${link} touches ${what}`,
    near: (/** @type {string} */ link, /** @type {string} */ what, /** @type {string} */ margin) =>
      `${link} comes nearer than ${margin} to ${what}`,
  },
  where: (/** @type {string} */ percent, /** @type {string} */ seconds) =>
    `first ${percent} % along its way, at ${seconds} s`,
  sentence: (/** @type {number} */ step, /** @type {string} */ what, /** @type {string} */ where) =>
    `In step ${step} ${what}, ${where}.`,
  show: 'Show where',
  ghost: 'here',
  around: 'Find a way around',
  onlyJoint:
    'A way around can be found for joint moves. The path of this step is what it is: move its ends, or what is in its way.',
  looking: (/** @type {string} */ count, /** @type {string} */ seconds) =>
    `Looking for a way around: ${count} iterations, ${seconds} s`,
  progress: 'Iterations of the search',
  found: (/** @type {number} */ count, /** @type {number} */ step, /** @type {string} */ seconds) =>
    `A way around was found in ${seconds} s: ${count === 1 ? 'one point was' : `${count} points were`} put in before step ${step}. Undo takes ${count === 1 ? 'it' : 'them'} back.`,
  straight: 'The move is clear as it is: nothing had to be put in.',
  notFound: (/** @type {string} */ seconds, /** @type {string} */ count) =>
    `No path found in ${seconds} s (${count} iterations). That does not say that there is none.`,
  tryOn: 'Go on looking',
  stopped: 'The search was cancelled; the program is as it was.',
  start: (/** @type {string} */ link, /** @type {string} */ what) =>
    `There is no way to look for: where the move begins, ${link} is too near to ${what}.`,
  goal: (/** @type {string} */ link, /** @type {string} */ what) =>
    `There is no way to look for: where the move ends, ${link} is too near to ${what}.`,
};

/** @param {boolean} isWhole  whether all of the program can be moved */
const proven = (isWhole) => `proven ${isWhole ? 'all along' : 'up to where the program stops'}, to 1 mm`;
