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
  from: {
    world: () => 'in world',
    user: (/** @type {string | undefined} */ id) => `in ${id}`,
  },
  fromHeading: 'The numbers are seen from',
  fromUser: 'the active user frame',
  fromNow: (/** @type {string} */ from) => `The target is written ${from}.`,
  copied: { pose: 'the target', matrix: 'the target’s matrix' },
  copyOther: { pose: 'The numbers', matrix: 'The matrix' },

  paste: {
    text: 'A pose as text',
    hint: '450 100 900 180 0 30, a matrix, {X 450, Y 100, …}',
    as: 'What the numbers are',
    lengths: 'Lengths are in',
    angles: 'Angles are in',
    preview: 'The target that comes of it',
    use: 'Use as target',
    cancel: 'Cancel',
    done: 'The pasted pose is the target.',
    found: (/** @type {number} */ count, /** @type {string} */ format) => `${count} numbers${format}.`,
    format: /** @type {Record<string, string>} */ ({
      json: ' in JSON',
      abb: ' as ABB writes them',
      fanuc: ' as FANUC writes them',
      kuka: ' as KUKA writes them',
      ros: ' as ROS writes them',
      ur: ' as Universal Robots writes them',
      named: ' with their names',
    }),
    either: 'Both orders with the rotation first fit; look which one is meant.',
    andForm: (/** @type {string} */ form) => `X Y Z and ${form}`,
    reading: /** @type {Record<string, string>} */ ({
      place: 'X Y Z; the orientation stays',
      rows: 'Matrix, row by row',
      columns: 'Matrix, column by column',
      'rotation-first': 'Rotation row by row, then X Y Z',
    }),
    fault: {
      empty: () => '',
      'too-long': () => 'This text is too long for a pose.',
      word: (/** @type {{ kind: string, word?: string }} */ { word }) =>
        `Expected numbers: 3, 6, 7, 12 or 16 of them; “${word}” is none.`,
      count: (/** @type {{ kind: string, count?: number }} */ { count }) =>
        `Expected 3 numbers (X Y Z), 6 (with three angles), 7 (with a quaternion or an axis and angle), 12 or 16 (a matrix); here ${count === 1 ? 'is 1' : `are ${count}`}.`,
      missing: (/** @type {{ kind: string, names?: string }} */ { names }) =>
        `Expected X Y Z with W P R, with A B C or with a quaternion; here are ${names}.`,
    },
  },
  helper: {
    orientation: 'The place stays; the tool’s z axis points',
    down: 'Straight down',
    atPoint: 'At a point…',
    at: (/** @type {string} */ name) => `At ${name}`,
    turnedAs: 'The place stays; turned as',
    toolNow: 'The tool now',
    base: 'The base',
    placedAs: 'The orientation stays; at the place of',
    point: 'Look at the point X Y Z',
    pointCount: (/** @type {number} */ came) =>
      `A point is three numbers with blanks between them; here ${came === 1 ? 'is 1' : `are ${came}`}.`,
    look: 'Look at it',
    tooNear: 'The target is at that very point: no direction is one to it.',
    done: {
      down: 'The target points straight down.',
      look: (/** @type {string} */ what) => `The target looks at ${what}.`,
      turned: (/** @type {string} */ what) => `The target is turned as ${what}.`,
      placed: (/** @type {string} */ what) => `The target is at the place of ${what}.`,
    },
    thePoint: 'the point',
  },
};
