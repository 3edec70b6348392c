/**
 * The Jacobian, what it is made of, and what it says of the arm.
 * @import { EllipsoidKind } from '../../model/numbers/ellipsoid.js'
 * @import { NamedSingularity } from '../../model/numbers/singularityNumbers.js'
 */

/** @type {Record<NamedSingularity, string>} */
const KIND = { wrist: 'wrist', elbow: 'elbow', shoulder: 'shoulder', other: 'unnamed' };

export const JACOBIAN = {
  title: 'Jacobian',
  frame: {
    label: 'Along the axes of',
    name: { world: 'World', base: 'Base', user: 'User', tool: 'Tool' },
    seen: {
      world: () => 'world axes',
      base: () => 'base axes',
      user: (/** @type {string | undefined} */ id) => `the axes of the user frame ${id}`,
      tool: () => 'tool axes',
    },
  },
  about: (/** @type {string} */ axes) => `Joint rates to the twist of the tool point, along ${axes}.`,
  geometry: 'By geometry',
  geometryFoot:
    'Column of a turning joint: z × (p − o) above z, with o on its axis and p the tool point; of a slide: z above 0.',
  numeric: (/** @type {string} */ method, /** @type {string} */ step) => `By ${method} difference, h = ${step} rad`,
  difference: 'Difference',
  largest: (/** @type {string} */ value) => `Largest: ${value}, lengths over L.`,
  rows: ['vx', 'vy', 'vz', 'ωx', 'ωy', 'ωz'],
  joint: (/** @type {number} */ number) => `J${number}`,
  units: (/** @type {string} */ length, /** @type {boolean} */ turns, /** @type {boolean} */ slides) =>
    [
      turns && `v of a turning joint in ${length} per radian, ω in radians per radian`,
      slides && `v of a slide in ${length} per ${length}, ω zero`,
    ]
      .filter(Boolean)
      .join('; ') + '.',
  method: { label: 'Difference', forward: 'Forward', central: 'Central' },
  quotient: {
    label: 'Quotient',
    poses: 'Two poses subtracted',
    kernel: 'As the kernel does',
    posesNote:
      'p(q + h) and p(q) by whole forward kinematics, subtracted and divided: what a book or a first program does.',
    kernelNote:
      'The kernel subtracts nothing that is nearly equal: it takes Rz(h) − 1 as it is, so that no rounding grows as h shrinks.',
  },
  formula: {
    forward: '(p(q + h) − p(q)) / h',
    central: '(p(q + h) − p(q − h)) / 2h',
  },
  step: 'Step h',
  stepSlider: 'Step of the difference, as a power of ten',
  stepField: 'Step of the difference, radians',
  stepValue: (/** @type {string} */ step) => `${step} radians`,
  stepRange: (/** @type {string} */ least, /** @type {string} */ most) =>
    `A step from ${least} to ${most} rad, please; the last one stays.`,
  isDefault: (/** @type {string} */ step) => `${step} is the default`,
  toDefault: (/** @type {string} */ step) => `Default ${step}`,
  defaultWhy: {
    forward: 'Truncation falls like h, rounding grows like 1/h: near 1e−7 their sum is about as small as it gets.',
    central: 'Truncation falls like h², rounding grows like 1/h: near 1e−5 their sum is about as small as it gets.',
  },
  plot: {
    x: 'step h, rad',
    y: 'largest difference',
    slope: { forward: 'forward, slope 1', central: 'central, slope 2' },
    rounding: 'rounding, slope −1',
    default: 'default',
    none: '0',
    caption: 'Difference from the geometry, by step',
    /** @param {string} step @param {string} now @param {string[]} best */
    inWords: (step, now, best) => `At h = ${step} rad the largest difference is ${now}. ${best.join(' ')}`,
    best: (/** @type {string} */ method, /** @type {string} */ step, /** @type {string} */ error) =>
      `${method} is best near h = ${step}: ${error}.`,
    exact: (/** @type {string} */ method) => `${method} is exact here.`,
    table: 'The plot as a table',
    columns: ['h, rad', 'Forward', 'Central'],
  },
  gauge: {
    title: 'Distance to singularity',
    label: 'Joint motion to the nearest singular posture found',
    searching: 'Looking for the nearest singular posture…',
    kind: KIND,
    here: (/** @type {string} */ kinds) => `Singular here: ${kinds} singularity.`,
    away: (/** @type {string} */ kinds, /** @type {string} */ distance) => `${kinds} singularity ${distance} away`,
    close: (/** @type {string} */ kinds, /** @type {string} */ distance) =>
      `Close: ${kinds} singularity ${distance} away`,
    by: (/** @type {string} */ joint, /** @type {string} */ by) => `${joint} moves most on the way, by ${by}.`,
    none: 'No singular posture found within the limits.',
    foot: 'Nearest found, by a search inside the limits: there may be a nearer one. Away: the norm of all joint motion, slides over L.',
    goThere: 'Go there',
    ghost: (/** @type {string} */ kinds) => `${kinds} singularity`,
    went: (/** @type {string} */ kinds) => `At the ${kinds} singularity.`,
    stale: 'Of the posture before; the new one is being looked at.',
  },
  measures: {
    title: 'Singular values',
    part: { label: 'Rows', full: 'All six', linear: 'Velocity', angular: 'Turning' },
    scale: (/** @type {string} */ length) => `L = ${length}`,
    scaleNote: {
      full: 'Metres and radians do not add: velocities are divided by L, and a slide’s rate counts as rate over L. L is half the reach.',
      linear: 'Lengths at the tool point per radian; a slide’s rate counts as rate over L.',
      angular: 'Pure numbers; a slide does not turn the tool.',
    },
    list: 'Singular values, falling',
    manipulability: 'Manipulability w',
    manipulabilityNote: (/** @type {number} */ count) => `Yoshikawa: the product of the ${count} singular values`,
    condition: 'Condition number',
    infinite: '∞',
    rank: 'Rank',
    rankOf: (/** @type {number} */ rank, /** @type {number} */ freedoms) => `${rank} of ${freedoms}`,
    nothing: 'The arm has no motion in these rows.',
    lost: 'Lost here',
    worst: 'Hardest here',
    alsoLost: (/** @type {number} */ count) => ` (one of ${count} lost)`,
    along: (/** @type {string} */ direction) => `moving the tool point along ${direction}`,
    about: (/** @type {string} */ direction) => `turning about ${direction}`,
    mixed: (/** @type {string} */ along, /** @type {string} */ about) => `${along} while ${about}`,
    in: (/** @type {string} */ axes) => `, ${axes}`,
    still: (/** @type {string} */ joints) => `Joint rates that move nothing: ${joints}.`,
    price: (/** @type {string} */ joints) => `The joints that make it, in proportion: ${joints}.`,
  },
  ellipsoid: {
    label: 'Ellipsoid in the scene',
    off: 'None',
    velocity: 'Velocity',
    force: 'Force',
    /** @type {Record<EllipsoidKind, (halves: string, scale: string) => string>} */
    inWords: {
      velocity: (halves, scale) =>
        `Velocities that joint rates of norm 1 rad/s make: ${halves} m/s to either side. Drawn: 1 m/s as ${scale}.`,
      force: (halves, scale) =>
        `Forces that joint torques of norm 1 N·m hold: ${halves} N to either side. Drawn: 1 N as ${scale}.`,
    },
    cut: 'It is longer than drawn.',
  },
  statics: {
    title: 'Static torques',
    about: 'What the joints have to hold when the tool presses with this force and moment; gravity aside. τ = JᵀF.',
    names: ['Fx', 'Fy', 'Fz', 'Mx', 'My', 'Mz'],
    field: (/** @type {string} */ name, /** @type {string} */ axes) =>
      `${name[0] === 'F' ? 'Force' : 'Moment'} along ${name[1]}, ${name[0] === 'F' ? 'newtons' : 'newton metres'}, ${axes}`,
    along: (/** @type {string} */ axes) => `At the tool point, along ${axes}.`,
    list: 'Joint torques and forces',
    torque: 'N·m',
    force: 'N',
  },
  copy: {
    button: 'Copy the numbers of this panel',
    as: (/** @type {string} */ format) => `Copy as ${format}`,
    what: {
      geometric: 'Jacobian by geometry',
      numeric: 'Jacobian by difference',
      measures: 'Singular values',
      statics: 'Static torques',
    },
    chooseFormat: 'As',
    copied: (/** @type {string} */ what, /** @type {string} */ format) => `Copied: ${what}, as ${format}.`,
  },
};
