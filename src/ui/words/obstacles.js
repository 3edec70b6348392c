/** Obstacles around the arm, and how near it comes to them. */

/** @typedef {'box' | 'sphere' | 'cylinder' | 'plane'} Kind */
/** @typedef {(text: string) => string} Of */

const KINDS = { box: 'Box', sphere: 'Sphere', cylinder: 'Cylinder', plane: 'Plane' };

export const OBSTACLES = {
  kinds: KINDS,
  add: 'Add an obstacle',
  addDetail: {
    box: 'a table, a machine, a cabinet',
    sphere: 'a tank, or room to keep free',
    cylinder: 'a post, a pipe',
    plane: 'a floor or a wall, filled behind it',
  },
  empty: 'No obstacles yet',
  emptyDetail: 'Put in what the arm must not touch. How near it comes is shown as it moves.',
  list: 'Obstacles',
  added: (/** @type {Kind} */ kind, /** @type {string} */ id) =>
    `${KINDS[kind]} ${id} added. It can be dragged in the picture by its handle, or typed.`,
  name: (/** @type {Kind} */ kind, /** @type {string} */ id) => `Name of ${KINDS[kind].toLowerCase()} ${id}`,
  renamed: (/** @type {string} */ id) => `It is called ${id} now.`,
  edit: (/** @type {string} */ id) => `Edit ${id}`,
  editShort: 'Edit',
  doneShort: 'Close',
  remove: (/** @type {string} */ id) => `Remove ${id}`,
  removed: (/** @type {string} */ id) => `${id} removed. Undo brings it back.`,
  duplicate: 'Duplicate',
  duplicated: (/** @type {string} */ id, /** @type {string} */ copy) => `${copy} is a copy of ${id}, beside it.`,
  hide: 'Hide in the picture',
  show: 'Show in the picture',
  hidden: (/** @type {string} */ id) => `${id} is not drawn now; it stands in the way all the same.`,
  shown: (/** @type {string} */ id) => `${id} is drawn again.`,
  notDrawn: 'not drawn',
  touched: 'touched',
  atTool: 'Put at the tool',
  atToolDone: (/** @type {string} */ id) => `The middle of ${id} is where the tool is now.`,
  size: { width: 'Width x', depth: 'Depth y', height: 'Height z', radius: 'Radius' },
  field: (/** @type {string} */ id, /** @type {string} */ what, /** @type {string} */ unit) =>
    `${id}, ${what}, ${unit}`,
  set: (/** @type {string} */ label, /** @type {string} */ value) => `${label}: ${value}.`,
  meaning: {
    box: 'The middle of the box, seen from the world.',
    sphere: 'The middle of the sphere, seen from the world.',
    cylinder: 'The middle of the cylinder, seen from the world; it stands along its own z.',
    plane: 'A point of the plane, seen from the world. It is its own xy; all below it is filled.',
  },
  resetDone: 'It is at the world’s origin, not turned.',

  link: (/** @type {number} */ link) => `link ${link}`,
  between: (/** @type {string} */ one, /** @type {string} */ other) => `${one} to ${other}`,
  toObstacles: 'To obstacles',
  toItself: 'To itself',
  clear: (/** @type {string} */ distance, /** @type {string} */ between) => `${distance}, ${between}`,
  touch: (/** @type {string} */ one, /** @type {string} */ other) => `${one} touches ${other}`,
  inAll: (/** @type {string} */ touches, /** @type {number} */ more) =>
    `In all: ${touches}${more > 0 ? ` and ${more} more` : ''}.`,
  nothingNear: 'There is nothing that the arm could come near to.',
  nowTouches: (/** @type {string} */ what) => `The arm touches: ${what}.`,
  nowClear: 'The arm is clear again.',
  capsules: 'Show the arm as the check sees it',
  approximation:
    'Links are looked at as round bars with round ends, as thick as they are drawn. Knuckles, drums and sleeves about the joints and the flange’s own body are thicker, or farther out, and are not looked at: keep a distance where they matter. Links that one joint alone moves against each other are not held against each other: how far it may go is what its limits say.',
  margin: 'Keep to obstacles',
  marginLabel: (/** @type {string} */ unit) => `What programs are to keep to obstacles, ${unit}`,
  marginDetail: 'in programs, and by ways around',
  marginTitle: 'A program whose arm comes nearer than this is marked, and ways around keep this far off.',
  marginWrong: 'Expected a distance from 0 on.',
};
