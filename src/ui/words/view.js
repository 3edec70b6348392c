/** The rooms of the page, and the view of the arm. */

export const PANELS = {
  label: 'Panels',
  robot: 'Robot',
  jog: 'Jog',
  aim: 'Aim',
  program: 'Program',
  code: 'Code',
  left: 'Robot and program',
  right: 'Joints and poses',
  view: '3-D view of the arm',
};

export const VIEW = {
  tools: 'View',
  fit: 'Fit the arm into the view',
  describe: (/** @type {string} */ robot, /** @type {string} */ pose) =>
    `${robot} in 3-D. ${pose} Arrow keys orbit, plus and minus zoom, F fits.`,
  grid: (/** @type {string} */ step) => `Grid ${step}`,
};
