/**
 * What somebody wants to know of the workspace, and how it is looked at: lengths in metres, angles in radians. It goes with the
 * session and with links: nothing of it is in the file.
 *
 * @typedef {'height' | 'manipulability' | 'postures' | 'margin' | 'directions'} ReachColour
 * @typedef {'coarse' | 'usual' | 'fine'} ReachDetail
 *
 * @typedef {object} WorkspaceView
 * @property {readonly string[]} open   ids of the folds of the panel that are open; what is asked in one that is closed is not worked on
 * @property {boolean} withLimits       of turning joints
 * @property {number} seed              of all sampling
 * @property {boolean} hasVolume        the volume is drawn in the scene
 * @property {'solid' | 'points'} style
 * @property {ReachColour} colour
 * @property {ReachDetail} detail
 * @property {number} opacity           of the solid
 * @property {'any' | 'fixed' | 'cone'} tool  which orientations of the tool count
 * @property {readonly number[]} wpr    the orientation that is meant
 * @property {number} halfAngle         of the cone about its z axis
 * @property {boolean} hasSection       the section is drawn in the scene
 * @property {'own' | 'angle' | 'plane'} cut  own: the one that the arm has by itself; angle: a half-plane at that angle only
 * @property {number} angle
 * @property {readonly number[]} normal  of the plane, of any length but none
 * @property {number} offset            of the plane from the origin, along its normal
 * @property {number | null} cell       of the section; null: as is fit for the arm's size
 * @property {boolean} isPrecise        its boundary is traced to 0.05 mm
 */

/** @type {WorkspaceView} */
export const FIRST_WORKSPACE = {
  open: ['volume'],
  withLimits: true,
  seed: 1,
  hasVolume: true,
  style: 'solid',
  colour: 'height',
  detail: 'coarse',
  opacity: 0.5,
  tool: 'any',
  wpr: [Math.PI, 0, 0],
  halfAngle: Math.PI / 6,
  hasSection: true,
  cut: 'own',
  angle: 0,
  normal: [0, 0, 1],
  offset: 0,
  cell: null,
  isPrecise: true,
};

export const COLOURS = /** @type {const} */ (['height', 'manipulability', 'postures', 'margin', 'directions']);
export const DETAILS = /** @type {const} */ (['coarse', 'usual', 'fine']);
export const STYLES = /** @type {const} */ (['solid', 'points']);
export const TOOLS = /** @type {const} */ (['any', 'fixed', 'cone']);
export const CUTS = /** @type {const} */ (['own', 'angle', 'plane']);

/** What an opacity and a cone may be. */
export const OPACITY = { least: 0.1, most: 1 };
export const WIDEST_CONE = Math.PI;

/** Finer sections than this are refused, m; so are offsets farther away. */
export const CELL = { least: 1e-5, most: 1 };
export const FARTHEST = 1e4;

export const LARGEST_SEED = 1e6;
