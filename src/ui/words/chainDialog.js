/** The dialog in which a chain of a robot file is chosen, and what it comes to. */

export const CHAIN = {
  title: (/** @type {string} */ name) => `Open ${name}`,
  question: 'Which links of it are the arm?',
  questionParallel: 'Two of its axes are nearly parallel.',
  base: 'Base',
  tip: 'Tip',
  tipChoice: (/** @type {string} */ link, /** @type {number} */ moving) => `${link} (${moving} joints move)`,
  none: 'none with 2 to 6 joints',
  result: 'What it becomes',
  joint: 'Joint',
  name: 'Name',
  one: 'One of many tables that are this same arm, to 1e-8 m.',
  snapped: 'With the axes made parallel.',
  nearly: (/** @type {string} */ axes, /** @type {string} */ degrees) => `Axes ${axes} are ${degrees}° from parallel`,
  axes: (/** @type {number} */ one, /** @type {number} */ other) => `${one} and ${other}`,
  effect: (/** @type {string} */ millimetres) =>
    `treating them as parallel moves the tool by at most ${millimetres} mm (of 100 postures).`,
  keep: 'Keep exact',
  snap: 'Snap',
  snapLabel: 'Nearly parallel axes',
  open: 'Open',
  cancel: 'Cancel',
};
