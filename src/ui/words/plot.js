/** Plots as files. */

export const PLOT = {
  save: (/** @type {string} */ kind) => `Save ${kind}`,
  saveTitle: (/** @type {string} */ file) => `Save the plot as ${file}`,
  saved: (/** @type {string} */ file) => `${file} is saved.`,
  errorFile: 'jacobian-error',
  motionFile: 'motion',
};
