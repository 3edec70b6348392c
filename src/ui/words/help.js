/** The help and what is said about the program; fetched with the dialog. */

/** @typedef {readonly [ways: readonly (readonly string[])[], what: string]} KeyRow */

/** Between the first and the last of a row of keys. */
const UP_TO = 'to';

/** @type {readonly { title: string, keys: readonly KeyRow[] }[]} */
const PLACES = [
  {
    title: 'In the table',
    keys: [
      [[['←'], ['→'], ['↑'], ['↓']], 'To the next cell, as in a spreadsheet'],
      [[['Enter'], ['Tab']], 'Take what was typed, and go on'],
      [[['Esc']], 'Back to what was there before'],
    ],
  },
  {
    title: 'On a joint’s slider',
    keys: [
      [[['←'], ['→']], 'A step; with Shift a coarse one, with Alt or Ctrl a fine one'],
      [[['Page Up'], ['Page Down']], 'Ten steps'],
      [[['Home']], 'To the joint’s home'],
    ],
  },
  {
    title: 'While buttons jog the arm',
    keys: [
      [
        [['1', UP_TO, '6']],
        'The first to the sixth joint or axis, for as long as the key is held; with Shift backwards',
      ],
      [[['Esc'], ['Space']], 'Stop at once'],
    ],
  },
  {
    title: 'In a program',
    keys: [
      [[['↑'], ['↓']], 'To the step above, below; with Shift all from the first to there are chosen'],
      [
        [
          ['Ctrl', 'C'],
          ['Ctrl', 'X'],
          ['Ctrl', 'V'],
        ],
        'Copy or cut the chosen steps, and paste steps after them',
      ],
      [
        [
          ['Alt', '↑'],
          ['Alt', '↓'],
        ],
        'Move the chosen steps',
      ],
      [[['Delete']], 'Delete them'],
    ],
  },
  {
    title: 'On the timeline',
    keys: [
      [[['Space']], 'Play, and pause; Esc pauses anywhere'],
      [[['Page Up'], ['Page Down']], 'To the next step, to the one before'],
    ],
  },
  {
    title: 'In the view',
    keys: [
      [[['←'], ['→'], ['↑'], ['↓']], 'Go round the arm'],
      [[['+'], ['−']], 'Nearer, farther'],
      [[['F']], 'Fit the arm into the view'],
      [
        [['T'], ['Enter']],
        'Take the tool: arrows and Page keys then move it, P in another plane, R turns it, Esc gives it back',
      ],
    ],
  },
];

export const HELP = {
  title: 'Help and about',
  keysTitle: 'Keys',
  control: 'Ctrl',
  shift: 'Shift',
  or: 'or',
  upTo: UP_TO,
  shortcut: {
    undo: 'Undo: everything that changes the robot or moves it; a drag is one step',
    redo: 'Do it again',
    save: 'Save the robot as a file',
    open: 'Open a robot file',
    help: 'This help',
  },
  places: PLACES,
  sections: [
    {
      title: 'Conventions',
      points: [
        'Axes are right-handed and Z points up, in the table, the numbers and the picture alike.',
        'Standard Denavit–Hartenberg: each row is Rz(θ) Tz(d) Tx(a) Rx(α). Modified (Craig): Rx(α) Tx(a) Rz(θ) Tz(d), with a and α of the row before. Converting keeps the robot; reading the numbers otherwise makes another robot.',
        'θ of a revolute joint and d of a prismatic one are constants of the table; the joint value q is added to them. Joint values are never wrapped by a full turn.',
        'FANUC W, P, R and KUKA C, B, A are the same turn: Rz(R) Ry(P) Rx(W). Every triple of angles on the page has its convention beside it.',
        'Controller numbers are the pendant’s: signs, offsets and couplings of the robot’s controller are applied to them. On FANUC, J3 is measured from the horizontal, so J2 moves it.',
        'Poses are of the tool’s point (TCP) in the world, unless another frame is named.',
      ],
    },
    {
      title: 'What is exact, and what is not',
      points: [
        'Forward kinematics is exact to rounding. Right angles in a table are exact.',
        'Inverse kinematics shows a posture as reached only when forward kinematics agrees, within a millionth of a millimetre and a billionth of a radian, and inside the limits.',
        'A list of solutions says whether it is complete. A search can miss one, and says that it was a search.',
        'Drawn links follow the table: they are not the maker’s shapes, and nothing checks for collisions. Masses, gravity and motion under forces are not computed; the static torques of the Jacobian panel are of the force at the tool alone.',
        'The tables of the library are the published ones that each arm names as its source; your arm may have been calibrated to other numbers.',
      ],
    },
    {
      title: 'Before code goes to a controller',
      points: [
        'Controller code was checked against published descriptions of the languages. It was not run on a controller.',
        'Try it at low speed, with a hand on the stop, after looking at every position on the pendant.',
        'KUKA controllers run KRL, not KAREL. On current FANUC controllers the TP program moves the arm, and KAREL calls it.',
      ],
    },
    {
      title: 'About',
      points: [
        'Everything is computed in this browser. Nothing is sent anywhere; your work, the colours, the width of the left panel and the hint you have seen are remembered here. A shared link has the whole model in itself.',
        'The address takes parameters: robot, q, units, panels, view, projection, frames, trace, theme, hint, autosave, quality, clock. ?robot=ur5&panels=view,jog makes a frame for a course page.',
        'Scripts find the page as window.denavit.',
        'Made with Three.js, Bootstrap, Bootstrap Icons, jQuery and math.js. Denavit is free software under the MIT licence.',
      ],
    },
  ],
  version: (/** @type {string} */ version) => `Denavit ${version}`,
};
