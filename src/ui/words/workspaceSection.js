/** The section of the workspace. Numbers come with their units. */

export const SECTION = {
  cut: {
    label: 'Where it is cut',
    name: { own: 'The arm’s own', angle: 'At an angle', plane: 'A plane' },
  },
  about: {
    meridian: 'The half-plane through the axis of the first joint that turns: how far out, and how high.',
    flat: 'The plane that this arm never leaves.',
    plane: 'What the tool point can reach in this plane.',
  },
  anyAngle: 'At whatever angle that joint stands.',
  oneAngle: 'At this angle of it only.',
  whole: 'The joint has a full turn: the section turned once about the axis is all that is reached.',
  swept: (/** @type {string} */ joint, /** @type {string} */ from, /** @type {string} */ to) =>
    `${joint} turns from ${from} to ${to} only: what is reached is what the section sweeps through that range.`,
  angle: 'Angle',
  angleLabel: (/** @type {string} */ unit) => `Angle of the half-plane, ${unit}`,
  normal: 'Normal x y z',
  normalLabel: 'Normal of the plane, three numbers',
  normalWrong: 'Three numbers that are not all zero, please; the last ones stay.',
  threeNumbers: (/** @type {number} */ came) => `Three numbers, please, not ${came}; the last ones stay.`,
  offset: 'From the origin',
  offsetLabel: (/** @type {string} */ unit) => `Distance of the plane from the origin along its normal, ${unit}`,
  offsetWrong: 'A distance of less than ten kilometres, please; the last one stays.',
  cell: 'Cells',
  cellLabel: (/** @type {string} */ unit) => `Edge of a cell, ${unit}`,
  cellWrong: (/** @type {string} */ least, /** @type {string} */ most) =>
    `From ${least} to ${most}, please, so that there are not too many to keep; the last one stays.`,
  finer: (/** @type {string} */ cell) => `${cell} cells`,
  precise: 'Trace the boundary to 0.05 mm',
  none: 'This arm has no such half-plane: the axis of the first joint that turns does not stand still. Choose a plane instead.',
  onlyFirst: (/** @type {string} */ cell, /** @type {string} */ beside) =>
    `Cells of ${cell} in which a sampled posture lands${beside && `, or up to ${beside} beside the plane`}. What is left out may be reached, too. All that this arm reaches is a surface, which this plane cuts in lines: there is no area to be measured.`,
  noneSeen: 'None of the sampled postures lands in this plane: it seems to be out of reach, which is no proof.',
  noneOwn: 'There is no answer for this arm yet. A plane may be known: choose one.',
  empty: 'No area of the plane is reached; lines or single places in it may be.',
  axes: {
    meridian: ['distance from the axis', 'height along it'],
    flat: ['x', 'y'],
    plane: ['across', 'up'],
  },
  axisUnit: (/** @type {string} */ name, /** @type {string} */ unit) => `${name}, ${unit}`,
  drawing: 'Drawing of the section',
  drawingHelp:
    'Arrow keys move the cross, with Shift in larger steps; plus and minus zoom, 0 shows all of it. So does the wheel, with Ctrl or once the drawing has the focus.',
  zoomIn: 'Zoom in',
  zoomOut: 'Zoom out',
  all: 'Show all of it',
  reading: (/** @type {string} */ u, /** @type {string} */ v, /** @type {boolean} */ isIn) =>
    `${u} · ${v} ${isIn ? 'reached' : 'not reached'}`,
  readingInWords: (/** @type {string} */ u, /** @type {string} */ v, /** @type {boolean} */ isIn) =>
    `${u} across, ${v} up: ${isIn ? 'reached' : 'not reached'}.`,
  pointAt: 'Point at the drawing to read a place',
  coarse: 'A first, rough picture from sampled postures: what is left out may be reached, too',
  result: {
    area: 'Area',
    volume: 'Volume',
    across: 'Across',
    up: 'Up',
    holes: 'Holes',
    boundary: 'Boundary',
    cells: 'Cells',
    range: (/** @type {string} */ from, /** @type {string} */ to) => `${from} to ${to}`,
    noHoles: 'none',
    traced: (/** @type {string} */ points, /** @type {string} */ length) => `${points} points, within ${length}`,
    cellsValue: (/** @type {string} */ columns, /** @type {string} */ rows, /** @type {string} */ size) =>
      `${columns} × ${rows} of ${size}`,
  },
  hole: (/** @type {string} */ area, /** @type {string} */ across, /** @type {string} */ up) =>
    `${area}; across ${across}, up ${up}`,
  holesList: 'Holes and voids',
  proven:
    'Proven: on which side of each line the arm reaches is known from closed-form inverse kinematics, up to rounding.',
  estimated:
    'An estimate: on which side of each line the arm reaches is known from postures that were found. A part that is hardly ever hit may be missing, which the error of the area does not count.',
  gap: (/** @type {string} */ length) => `The longest stretch of boundary that was not found: ${length}.`,
  noVolume: 'Not known for this arm',
  inWords: {
    area: (/** @type {string} */ area, /** @type {string} */ holes) => `The section’s area is ${area}, ${holes}.`,
    holes: (/** @type {number} */ count) =>
      count === 0 ? 'without holes' : count === 1 ? 'with one hole' : `with ${count} holes`,
    extent: (/** @type {string[]} */ ...ranges) => `It extends over ${ranges.join(', and ')}.`,
    along: (/** @type {string} */ name, /** @type {string} */ from, /** @type {string} */ to) =>
      `${name} from ${from} to ${to}`,
    volume: (/** @type {string} */ volume) => `What it sweeps is ${volume}.`,
    proven: 'Proven by inverse kinematics.',
    estimated: 'An estimate, from postures that were found.',
  },
};
