/** The target in other forms, pasted and copied, and the helpers: fetched when they are first asked for. */

export const TARGET = {
  set: (/** @type {string} */ name, /** @type {string} */ value) => `${name}: ${value || 'set'}.`,
  several: (/** @type {string} */ form, /** @type {string} */ names) => `Target, ${form}: ${names}`,
  wrongCount: (
    /** @type {string} */ form,
    /** @type {string} */ names,
    /** @type {number} */ wanted,
    /** @type {number} */ came,
  ) => `${form} is ${wanted} numbers with blanks between them, ${names}; here ${came === 1 ? 'is 1' : `are ${came}`}.`,
  length: {
    quaternion: (/** @type {string} */ length) => `A quaternion has the length 1; this one has ${length}.`,
    axis: (/** @type {string} */ length) => `The axis has the length 1; this one has ${length}.`,
  },
  scale: 'Divide by its length',
  matrix: '4 × 4 matrix',
  matrixTitle: 'Target, 4 × 4 matrix, row by row',
  matrixCount: (/** @type {number} */ came) =>
    `A matrix is 16 numbers, row by row, or 12 without the last row; here ${came === 1 ? 'is 1' : `are ${came}`}.`,
  matrixFault: {
    'bottom-row': () => 'The last row of a pose is 0 0 0 1; this one is another.',
    skew: (/** @type {string} */ by) =>
      `The upper left 3 × 3 is no rotation: its columns are ${by} from square to each other and of length 1.`,
    'left-handed': () => 'The upper left 3 × 3 is a mirror image: its axes are left-handed.',
  },
  nearestRotation: 'Take the nearest rotation',
  form: {
    choose: 'How the target is written',
    now: (/** @type {string} */ form) => `The target is written as ${form}.`,
  },
  copied: { pose: 'the target', matrix: 'the target’s matrix' },
  copyOther: { pose: 'The numbers', matrix: 'The matrix' },
};
