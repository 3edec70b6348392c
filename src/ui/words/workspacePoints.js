/** Points and lines of the workspace, and its teaching view. Numbers come with their units. */

const count = (/** @type {number} */ n, /** @type {string} */ one, /** @type {string} */ many) =>
  n === 1 ? `1 ${one}` : `${n} ${many}`;

export const POINTS = {
  about: 'Whether the tool point can be brought to a place, however the tool is turned there.',
  text: (/** @type {string} */ unit) => `Points, one in a line: x y z in ${unit}, with a name if you like`,
  placeholder: 'A  300 200 400',
  ask: 'Ask',
  tool: 'Tool point',
  open: 'Open CSV…',
  pick: 'Click into the section below, or pick a point in the view.',
  inView: 'Pick in the view',
  picking: {
    label: 'Picking points in the view',
    ground: 'Where a picked point lands',
    name: { section: 'Section', volume: 'Volume' },
    press: {
      section: 'Press on the section’s plane',
      volume: 'Press on a cube: its middle',
      tool: 'Press: as far away as the tool point',
    },
    done: 'Done',
    begun: 'Press in the view where a point is to be. Escape ends it. By keys, type the point instead.',
    left: 'No more picking.',
  },
  drawing: 'Section with the places that were asked for',
  drawingHelp: 'Arrow keys move the cross, with Shift in larger steps; Enter asks for the place there.',
  fault: {
    'too-long': 'That is more text than is read at once (100,000 characters). Nothing was asked.',
    'too-many': 'That is more than 500 points. Nothing was asked.',
    none: 'There is no point in it yet: three numbers in a line, please.',
    'not-three': (/** @type {number} */ line) =>
      `Line ${line} is not three numbers, with one name at most. Nothing was asked; the last answers stay.`,
    'too-far': (/** @type {number} */ line) =>
      `Line ${line} is more than ten kilometres away. Nothing was asked; the last answers stay.`,
  },
  fileFault: 'This file is no text that can be read. Nothing was asked.',
  asking: (/** @type {number} */ done, /** @type {number} */ all) => `${done} of ${all} points`,
  failed: 'This could not be worked out.',
  notMapped: 'This arm has no workspace that could be asked: no joint moves its tool point, or a slide has no limits.',
  head: ['Point', 'x', 'y', 'z', 'Reached', 'Postures', 'Margin'],
  margin: 'Margin',
  marginPercent: (/** @type {string} */ share, /** @type {string} */ joint) => `${share} % (${joint})`,
  noMargin: 'no limits',
  verdict: { reached: 'yes', 'not-found': 'not found', unreachable: 'no' },
  short: (/** @type {string} */ distance) => `${distance} short`,
  postures: (/** @type {number} */ n, /** @type {boolean} */ areAll) => (areAll ? String(n) : `${n} of many`),
  list: 'Points that were asked for',
  summary: (/** @type {number} */ reached, /** @type {number} */ all) => `${reached} of ${all} reached`,
  reached: (/** @type {string} */ name, /** @type {number} */ n, /** @type {boolean} */ areAll) =>
    areAll
      ? `${name} is reached, in ${count(n, 'posture', 'postures')}.`
      : `${name} is reached, in any number of postures; here ${n === 1 ? 'is one' : `are ${n}`}.`,
  unreachable: (/** @type {string} */ name, /** @type {string} */ distance) =>
    `${name} is out of reach: ${distance} are missing.`,
  'not-found': (/** @type {string} */ name, /** @type {string} */ distance) =>
    `No posture was found for ${name}: the nearest that was is ${distance} away. That is no proof.`,
  nearest: (/** @type {string} */ place) => `The nearest place is ${place}.`,
  goNearest: 'Go to the nearest place',
  go: (/** @type {number} */ number) => `Posture ${number}`,
  goLabel: (/** @type {number} */ number, /** @type {string} */ values, /** @type {string} */ margin) =>
    `Move to posture ${number}: ${values}; margin ${margin}`,
  ghost: (/** @type {number} */ number) => `Posture ${number}`,
  went: (/** @type {number} */ number) => `Posture ${number}.`,
  wentNearest: 'At the nearest place.',
  choose: (/** @type {string} */ name) => `Show the answer for ${name}`,
  copy: 'Copy table',
  copied: 'Table copied.',
  notCopied: 'The browser does not allow copying.',
  save: 'Save CSV',
  clear: 'Clear',
  csv: (/** @type {string} */ unit) => [
    'point',
    `x_${unit}`,
    `y_${unit}`,
    `z_${unit}`,
    'reached',
    'postures',
    'margin_share',
    `missing_${unit}`,
    `nearest_x_${unit}`,
    `nearest_y_${unit}`,
    `nearest_z_${unit}`,
  ],
  line: {
    title: 'Straight line',
    from: 'From',
    to: 'to',
    fromLabel: 'The line begins at',
    toLabel: 'The line ends at',
    working: 'Following the line…',
    travelled: 'It can be travelled, all of it in one posture that moves on continuously.',
    stops: (/** @type {string} */ share, /** @type {string} */ place) => `It stops after ${share} %, at ${place}: `,
    why: {
      'no-start': () => 'It cannot be travelled: where it begins is not reached.',
      limit: (/** @type {string} */ held) => `${held}, and no other posture goes on.`,
      'limit-other': (/** @type {string} */ held) =>
        `${held}. What comes next is reached in another posture, which would be a jump.`,
      boundary: () => 'what comes next is out of reach.',
      turn: () => 'what comes next is reached in another posture only, which would be a jump.',
    },
    start: 'Go to where it begins',
    end: 'Go to where it stops',
    done: 'Go to where it ends',
    same: 'Choose two different points.',
  },
};

/** @param {readonly string[]} names */
const together = (names) =>
  names.length < 2 ? names.join('') : `${names.slice(0, -1).join(', ')} and ${names[names.length - 1]}`;

export const TEACH = {
  about:
    'Move one joint at a time and see what it does to the tool point: it leaves a trace in the scene and in the section.',
  joint: (/** @type {string} */ name, /** @type {string} */ unit) => `${name}, ${unit}`,
  joints: 'Joints that move the tool point',
  sweep: 'Sweep',
  sweepLabel: (/** @type {string} */ name) => `Draw all that ${name} does from here`,
  swept: (/** @type {string} */ name) => `${name} swept through its range.`,
  clear: 'Clear traces',
  boundary: 'What the boundary is made of',
  boundaryAbout:
    'Go there and see: from these postures the arm cannot push its tool point any farther out of the section.',
  none: 'The section is being worked out, or this arm has none.',
  at: { lower: 'lower', upper: 'upper' },
  held: (/** @type {string} */ joint, /** @type {string} */ bound) => `${joint} at its ${bound} limit`,
  heldAll: together,
  stretched: (/** @type {readonly string[]} */ joints) => `${together(joints)} stretched`,
  folded: (/** @type {readonly string[]} */ joints) => `${together(joints)} folded`,
  axis: (/** @type {readonly string[]} */ joints) => `${together(joints)} as near to the first axis as they come`,
  lined: (/** @type {readonly string[]} */ joints) =>
    joints.length > 1
      ? `singular: the axes of ${together(joints)} in line with the tool point`
      : `singular: ${together(joints)} moves along the boundary`,
  singular: 'singular',
  limitsOnly: (/** @type {readonly string[]} */ joints) => `${together(joints)} moving`,
  with: (/** @type {string} */ a, /** @type {string} */ b) => `${a}; ${b}`,
  go: (/** @type {number} */ number, /** @type {string} */ name) => `Go to critical posture ${number}: ${name}`,
  went: (/** @type {string} */ name) => `There: ${name}.`,
  drawing: 'Section with traces and critical postures',
  drawingWords: (/** @type {number} */ n) => `${n} stretches of boundary, listed below.`,
  summary: (/** @type {number} */ n) => count(n, 'critical posture', 'critical postures'),
};
