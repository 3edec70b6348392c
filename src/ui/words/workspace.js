/** The workspace: what the arm can reach. Numbers come with their units. */

/** @type {Record<'height' | 'manipulability' | 'postures' | 'margin' | 'directions', string>} */
const COLOUR = {
  height: 'Height',
  manipulability: 'Manipulability',
  postures: 'Number of postures',
  margin: 'Room to the limits',
  directions: 'Share of directions',
};

export const WORKSPACE = {
  title: 'Workspace',
  limits: {
    label: 'Joint limits',
    name: { on: 'With limits', off: 'Without' },
    noSlides: 'Slides keep their limits in any case: without them there would be no end to what they reach.',
  },
  name: { volume: 'Volume', section: 'Section', points: 'Points and lines', teach: 'One joint at a time' },
  inScene: 'In the scene',
  hideFromScene: 'Hide',
  hidden: 'The workspace is hidden.',
  sceneLine: {
    label: 'The workspace in the scene',
    volume: 'Workspace: volume',
    section: 'Workspace: section',
    both: 'Workspace: volume and section',
  },
  working: 'At work',
  progress: 'How far it is',
  stage: {
    cloud: 'Places of sampled postures',
    places: 'Places of sampled postures',
    attributes: 'How well the arm works there',
    orientations: 'Orientations of the tool',
    middles: 'Postures for each cube',
    first: 'A first picture',
    curves: 'Where the boundary may be',
    postures: 'Postures in each field',
    sides: 'Which side is reached',
    volume: 'What the section sweeps',
  },
  left: (/** @type {string} */ seconds) => `about ${seconds} s left`,
  cancel: 'Cancel',
  cancelled: 'Cancelled; what there is stays.',
  cancelledNone: 'Cancelled before there was anything.',
  again: 'Go on anew',
  failed: 'The map could not be made.',
  notMapped: {
    'unlimited-slide': (/** @type {number} */ joint) =>
      `Joint ${joint} slides without end, so there is no end to what the arm reaches. Give it limits in the table.`,
    'nothing-moves': () => 'No joint moves the tool point, so it reaches the one place where it is.',
  },
  save: 'Save…',
  more: 'Where chance comes in',
  seed: 'Seed',
  seedLabel: 'Seed of the sampling, a whole number',
  seedNote: 'Postures are sampled. The same seed gives the same map.',
  seedWrong: (/** @type {string} */ most) => `A whole number from 0 to ${most}, please; the last one stays.`,
  set: (/** @type {string} */ label, /** @type {string} */ value) => `${label}: ${value}.`,

  volume: {
    style: { label: 'Drawn as', name: { solid: 'Solid', points: 'Points' } },
    colour: 'Colour',
    colourLabel: 'The volume is coloured by',
    colours: COLOUR,
    detail: 'Cubes',
    detailLabel: 'Edge of a cube',
    opacity: 'Opacity',
    opacityValue: (/** @type {string} */ percent) => `${percent} %`,
    tool: { label: 'Orientation of the tool', name: { any: 'Any', fixed: 'Fixed', cone: 'Cone' } },
    toolCaption: 'Tool',
    angles: ['W', 'P', 'R'],
    angleLabel: (/** @type {string} */ name, /** @type {string} */ unit) => `Orientation ${name}, ${unit}`,
    halfAngle: 'Half angle',
    halfAngleLabel: (/** @type {string} */ unit) => `Half angle of the cone, ${unit}`,
    halfAngleWrong: 'More than 0 and at most half a turn, please; the last one stays.',
    asNow: 'As the tool is now',
    fixedNote: 'Cubes in whose middle the tool can be turned so, by inverse kinematics.',
    coneNote:
      'Cubes in whose middle the tool’s z axis can point somewhere within the cone: 17 directions and four turns about each are tried, so a few that are reached between them may be missing.',
    result: {
      volume: 'Volume',
      area: 'Area',
      cubes: 'Cubes',
      points: 'Points',
      none: 'none',
    },
    range: (/** @type {string} */ from, /** @type {string} */ to) => `${from} to ${to}`,
    cubesIn: (/** @type {string} */ count, /** @type {string} */ edge) => `${count} of ${edge}`,
    none: 'No place is reached so.',
    legend: (/** @type {string} */ name, /** @type {string} */ unit) => (unit ? `${name}, ${unit}` : name),
    legendInWords: (/** @type {string} */ name, /** @type {string[]} */ parts) => `${name}: ${parts.join('; ')}.`,
    part: (/** @type {string} */ from, /** @type {string} */ to, /** @type {string} */ percent) =>
      `${from} to ${to}: ${percent} % of the volume`,
    count: (/** @type {string} */ count, /** @type {string} */ percent) => `${count}: ${percent} % of the volume`,
    legendTable: 'The legend as a list',
    meaning: {
      height: '',
      manipulability:
        'The largest √det(J Jᵀ) of the places that were seen there: what all joints together, each at 1 rad/s or 1 m/s, make of the tool point’s velocities.',
      postures: 'How many postures take the tool point to the middle of the cube.',
      margin: 'Of the posture that is farthest from all limits: 100 % in the middle of all ranges, 0 at a limit.',
      directions: 'Of 54 directions, those that the tool’s z axis was seen to have there.',
    },
    estimate: 'A lower bound: it grows with the number of postures that were looked at.',
    unknownYet: 'Not known yet; drawn in one colour until then.',
    infinitelyMany: (/** @type {number} */ joints) =>
      `Infinitely many wherever it is reached: ${joints} joints move the tool point, and three would do. Drawn in one colour.`,
    proven: 'A cube is counted if its middle is reached, which closed-form inverse kinematics says.',
    estimated:
      'An estimate: this arm has joints to spare, so a cube is counted if a posture was seen to land in it. Cubes at the edge are reached in part and count half; one that is hardly ever hit may be missing.',
    estimatedFew:
      'An estimate: a cube is counted if a posture was seen to land in it. Cubes at the edge are reached in part and count half.',
    flat: 'All places lie in one plane, so there is an area instead of a volume. The section knows it better.',
    noSize: { 1: 'A curve', 2: 'A surface' },
    thin: {
      1: 'What is reached is a curve: it has a length, and neither area nor volume.',
      2: 'What is reached is a surface: it has no volume. Cubes that it passes are drawn.',
    },
    size: (/** @type {string} */ value) => `The volume that is reached is ${value}.`,
    sizeFlat: (/** @type {string} */ value) => `The region that is reached is flat; its area is ${value}.`,
    extent: (/** @type {string[]} */ ranges) => `It extends over ${ranges.join(', ')}.`,
    along: (/** @type {string} */ axis, /** @type {string} */ from, /** @type {string} */ to) =>
      `${axis} from ${from} to ${to}`,
  },
};
