/** What belongs to the robot beside its table: the words of what opens below those heads. */

export const DETAILS = {
  lower: 'Lower limit',
  upper: 'Upper limit',
  home: 'Home',
  velocity: 'Rate limit',
  acceleration: 'Acceleration',
  perSecond: (/** @type {string} */ unit) => `${unit}/s`,
  perSecondSquared: (/** @type {string} */ unit) => `${unit}/s²`,
  spokenPerSecond: (/** @type {string} */ unit) => `${unit} per second`,
  spokenPerSecondSquared: (/** @type {string} */ unit) => `${unit} per second squared`,
  none: 'none',
  endless: 'A continuous joint has no limits.',
  use: (/** @type {string} */ value) => `Now ${value}; take it as`,
  useAs: {
    lower: (/** @type {string} */ value) => `Set the lower limit to ${value}`,
    upper: (/** @type {string} */ value) => `Set the upper limit to ${value}`,
    home: (/** @type {string} */ value) => `Set home to ${value}`,
  },
  field: (/** @type {number} */ joint, /** @type {string} */ name, /** @type {string} */ unit) =>
    `Joint ${joint}, ${name.toLowerCase()}, ${unit}`,
  set: (/** @type {string} */ name, /** @type {string} */ value) => `${name}: ${value}`,

  link: 'Link drawn as',
  linkOf: (/** @type {number} */ joint) => `Link ${joint} drawn as`,
  kind: { auto: 'Automatic', cylinder: 'Cylinder', box: 'Box', none: 'Not drawn' },
  drawn: (/** @type {number} */ joint, /** @type {string} */ kind) => `Link ${joint}: ${kind.toLowerCase()}.`,
  notDrawn: 'The joints at its ends stay in the picture.',
  radius: 'Radius',
  width: 'Width',
  height: 'Height',
  automatic: 'automatic',
  auto: (/** @type {string} */ value) => `auto ${value}`,
  colour: 'Colour',
  swatch: (/** @type {number} */ joint) => `Colour of link ${joint}, by eye`,
  hex: (/** @type {number} */ joint) => `Colour of link ${joint}, as # and six digits`,
  automaticColour: 'Automatic colour',
  coloured: (/** @type {number} */ joint, /** @type {string} */ colour) => `Link ${joint}: colour ${colour}.`,

  pose: {
    base: 'Frame 0, seen from the world.',
    tool: 'The tool’s tip (TCP), seen from the flange, the last frame of the table.',
    user: 'Seen from the world.',
  },
  shift: (/** @type {string} */ what, /** @type {string} */ axis, /** @type {string} */ unit) =>
    `${what}, ${axis}, ${unit}`,
  orientation: 'Orientation',
  orientationAs: (/** @type {string} */ what) => `${what}: orientation written as`,
  notation: {
    rpy: 'URDF rpy',
    wpr: 'FANUC W P R',
    abc: 'KUKA A B C',
    zyz: 'Euler ZYZ',
    quaternion: 'Quaternion',
  },
  /** What stands before each number, and is said of it. */
  angles: {
    rpy: ['roll', 'pitch', 'yaw'],
    wpr: ['W', 'P', 'R'],
    abc: ['A', 'B', 'C'],
    zyz: ['α', 'β', 'γ'],
  },
  meaning: {
    rpy: 'Rz(yaw) · Ry(pitch) · Rx(roll): turns about the fixed axes x, y, z.',
    wpr: 'Rz(R) · Ry(P) · Rx(W): the same numbers as roll, pitch, yaw.',
    abc: 'Rz(A) · Ry(B) · Rx(C): roll, pitch, yaw read backwards.',
    zyz: 'Rz(α) · Ry(β) · Rz(γ): turns about the moving axes z, y, z.',
    quaternion: 'x y z w, of length 1; the scalar stands last.',
  },
  computed: {
    rpy: 'The document keeps roll, pitch, yaw; these numbers are computed from them.',
    quaternion: 'The document keeps a quaternion; these angles are computed from it.',
  },
  quaternion: (/** @type {string} */ what) => `${what}, quaternion x y z w`,
  fourNumbers: (/** @type {number} */ n) =>
    `A quaternion is four numbers with blanks between them, x y z w; here are ${n}.`,
  scale: 'Divide by its length',
  reset: 'Reset to none',
  resetDone: {
    base: 'The base is at the origin, upright.',
    tool: 'There is no tool; the flange itself is followed.',
    user: 'The frame is at the world’s origin.',
  },
  resetNeedless: 'It is none already.',

  info: {
    name: 'Name',
    manufacturer: 'Manufacturer',
    author: 'Author',
    source: 'Source of the numbers',
    licence: 'Licence',
    description: 'Description',
  },
  toSource: 'Open the source',
  newTab: '(in a new tab)',
  libraryHome: 'Home postures of the library are chosen here, away from singularities.',
};
