/** What a singularity takes. Directions are told along the axes of the world. */

export const LOST = {
  along: (/** @type {string} */ direction) => `Lost here: moving along ${direction} of the world.`,
  about: (/** @type {string} */ axis) => `Lost here: turning about ${axis} of the world.`,
  both: (/** @type {string} */ direction, /** @type {string} */ axis) =>
    `Lost here: moving along ${direction} and, with it, turning about ${axis} of the world.`,
};
