/** All the postures for a target. */

export const SOLUTIONS = {
  summary(/** @type {number} */ all, /** @type {number} */ inside, /** @type {number} */ lines) {
    const line = lines === 0 ? '' : lines === 1 ? 'a line' : `${lines} lines`;
    if (all === 0) return line || 'none for this pose';
    const points = inside === all ? `${all}, all inside limits` : `${all}, ${inside} inside limits`;
    return line ? `${points}, and ${line}` : points;
  },
  list: 'Solutions of the target',
  columns: {
    number: 'number',
    figure: 'figure',
    name: 'shoulder, elbow, wrist',
    travel: 'travel',
    margin: 'limit margin',
  },
  columnsOther: 'posture',
  travelDetail: 'How far the joint that goes farthest has to go from where the arm stands.',
  marginDetail: 'How far the joint with the least room is from its limit, or how far past it.',
  here: 'here',
  nearest: 'nearest',
  unnamed: 'posture',
  withinOnly: 'Within limits only',
  /** @param {number} hidden */
  hidden: (hidden) =>
    hidden === 1 ? 'One outside the limits is left out.' : `${hidden} outside the limits are left out.`,
  searched: 'Found by search: there may be more.',
  none: 'No posture takes the tool to this pose. The line above says what is in the way.',
  noneButOne: 'The arm meets a part of this pose only. These postures take the tool where that part is met:',
  places: 'These postures bring the tool’s point to the place; how it is turned there follows from them.',
  searching: 'Looking for all postures…',
  stale: 'The list is made when the arm rests.',
  outside: (/** @type {string} */ joint, /** @type {string} */ by) => `${joint} +${by}`,
  unlimited: 'no limits',
  word: {
    front: 'front',
    back: 'back',
    up: 'up',
    down: 'down',
    righty: 'righty',
    lefty: 'lefty',
    'no-flip': 'no flip',
    flip: 'flip',
  },
  ghost: (/** @type {number} */ number, /** @type {string} */ name) => `${number} ${name}`,
  row: (
    /** @type {number} */ number,
    /** @type {string} */ name,
    /** @type {string} */ travel,
    /** @type {string} */ margin,
  ) => `Solution ${number}: ${name}; ${travel}; ${margin}`,
  travelSpoken: (/** @type {string} */ joint, /** @type {string} */ by) => `${joint} goes farthest, ${by}`,
  hereSpoken: 'the arm stands there',
  roomSpoken: (/** @type {string} */ joint, /** @type {string} */ by) => `${joint} is ${by} from its limit`,
  pastSpoken: (/** @type {string} */ joint, /** @type {string} */ by) => `${joint} is ${by} past its limit`,
  went: (/** @type {number} */ number, /** @type {string} */ name) => `The arm goes to solution ${number}, ${name}.`,
  codes: 'Controller codes',
  fanuc: 'FANUC',
  kuka: 'KUKA',
  kukaCode: (/** @type {number} */ status, /** @type {number} */ turn) =>
    `S ${status}, T ${turn} (${status.toString(2).padStart(3, '0')}, ${turn.toString(2).padStart(6, '0')})`,
  noCode: {
    'not-six-axes': 'none: the codes are for arms with six axes',
    prismatic: 'none: the codes are for arms whose joints all turn',
    'no-spherical-wrist': 'none: the last three axes do not meet in a point',
    'no-shoulder': 'none: axes 1 and 2 are parallel',
    'no-elbow': 'none: axes 2 and 3 are not parallel',
  },
  family: {
    wrist: 'The wrist is in line: only the sum of two joints counts, and these postures are a line, not points.',
    shoulder:
      'The wrist is on the first axis: the first joint may turn freely, and these postures are a line, not points.',
    other: 'The arm has more freedom here than the pose takes: these postures are a line, not points.',
  },
  familyMove: (/** @type {string} */ joint) => `${joint} along the line`,
  familyFixed: (/** @type {string} */ joints) => `${joints} move; the tool stays.`,
  familySingle: 'No way along it was found inside the limits.',
  familyGo: 'Move there',
};
