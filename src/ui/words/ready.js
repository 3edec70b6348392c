/** Ready programs. */

export const READY_WORDS = {
  name: {
    'pick-and-place': 'Pick and place',
    'weld-seam': 'Weld seam',
    circle: 'Circle',
    lissajous: 'Lissajous figure',
    corners: 'Sharp and round corners',
    laws: 'The laws of the textbooks',
    points: 'Through points and past them',
  },
  detail: {
    'pick-and-place': 'Down, grip, over, down, release.',
    'weld-seam': 'A slow seam with one rounded bend.',
    circle: 'Two arcs, each past a point on its way.',
    lissajous: '24 short lines, three waves across two.',
    corners: 'The same square twice: stopping at the corners, then rounding them.',
    laws: 'The same move by five laws; compare them in the plots.',
    points: 'Craig’s points 10, 35, 25, 10°: a spline, then LSPB.',
  },
  comments: {
    above: 'above the work',
    grip: 'gripper closed',
    release: 'gripper open',
    arc: 'arc on',
    sharp: 'stops at each corner',
    rounded: 'rounds them',
    laws: {
      trapezoid: 'trapezoid',
      doubleS: 'S-curve',
      cubic: 'cubic',
      quintic: 'quintic',
      timeOptimal: 'time-optimal',
    },
    through: 'cubic spline',
    past: 'LSPB',
  },
  made: (/** @type {string} */ name) => `${name} is made for this arm.`,
  searching: (/** @type {string} */ name) => `${name}: a place within reach is looked for.`,
  notFound: (/** @type {string} */ name) =>
    `${name}: no place was found where this arm can draw it, around its home, the middle of its joints and where it stands. Put the arm where it has room, and try again.`,
};
