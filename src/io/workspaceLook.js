/**
 * What is asked of the workspace, as part of a link: its parameters, never what was found. Written is what differs from how a
 * page begins; whatever stands in a link, only what makes sense is read, and the rest is named.
 *
 * @import { WorkspaceView } from '../model/workspace/workspaceView.js'
 */
import {
  CELL,
  COLOURS,
  CUTS,
  DETAILS,
  FARTHEST,
  FIRST_WORKSPACE,
  LARGEST_SEED,
  OPACITY,
  STYLES,
  TOOLS,
  WIDEST_CONE,
} from '../model/workspace/workspaceView.js';

/** That the workspace is looked at, and which of its folds are open. */
const NAME = 'workspace';

const FOLD = /^[a-z]{1,20}$/;
const MOST_FOLDS = 10;

/** A number as JavaScript writes it. */
const NUMBER = /^-?\d{1,20}(\.\d{1,20})?(e[+-]?\d{1,3})?$/;

/** The largest angle, rad. */
const TURNS = 100;

/** @typedef {(text: string) => unknown} Read  undefined: not understood */

/** @param {readonly string[]} values @returns {Read} */
const one = (values) => (text) => values.find((value) => value === text);

/** @type {Read} */
const yes = (text) => ({ yes: true, no: false })[text];

/** @param {number} least @param {number} most @returns {Read} */
const number = (least, most) => (text) => {
  const value = NUMBER.test(text) ? Number(text) : NaN;
  return value >= least && value <= most ? value : undefined;
};

/** @param {number} limit @returns {Read} */
const three = (limit) => (text) => {
  const parts = text.split(',', 4).map(number(-limit, limit));
  return parts.length === 3 && parts.every((part) => part !== undefined) ? parts : undefined;
};

/** By the view's own names. @type {{ [K in Exclude<keyof WorkspaceView, 'open'>]: Read }} */
const READERS = {
  withLimits: yes,
  seed(text) {
    const value = number(0, LARGEST_SEED)(text);
    return Number.isInteger(value) ? value : undefined;
  },
  hasVolume: yes,
  style: one(STYLES),
  colour: one(COLOURS),
  detail: one(DETAILS),
  opacity: number(OPACITY.least, OPACITY.most),
  tool: one(TOOLS),
  wpr: three(TURNS),
  halfAngle: number(1e-6, WIDEST_CONE),
  hasSection: yes,
  cut: one(CUTS),
  angle: number(-TURNS, TURNS),
  normal(text) {
    const value = three(FARTHEST)(text);
    return Array.isArray(value) && Math.hypot(...value) > 1e-9 ? value : undefined;
  },
  offset: number(-FARTHEST, FARTHEST),
  cell: number(CELL.least, CELL.most),
  isPrecise: yes,
};

/** @param {unknown} value */
const written = (value) => (typeof value === 'boolean' ? (value ? 'yes' : 'no') : String(value));

/** @param {WorkspaceView} view @returns {string[]} fields of an address */
export function writeWorkspaceLook(view) {
  const names = /** @type {(keyof typeof READERS)[]} */ (Object.keys(READERS));
  const others = names.filter((name) => written(view[name]) !== written(FIRST_WORKSPACE[name]));
  return [`${NAME}=${view.open.join()}`, ...others.map((name) => `${NAME}.${name}=${written(view[name])}`)];
}

/**
 * @param {URLSearchParams} given
 * @returns {{ view: WorkspaceView | null, refused: string[] }} null: the link says nothing of it
 */
export function readWorkspaceLook(given) {
  const open = given.get(NAME);
  if (open === null) return { view: null, refused: [] };
  /** @type {string[]} */
  const refused = [];
  /** @type {Record<string, unknown>} */
  const change = {};
  const folds = open === '' ? [] : open.split(',', MOST_FOLDS + 1);
  if (folds.length <= MOST_FOLDS && folds.every((fold) => FOLD.test(fold))) change.open = [...new Set(folds)];
  else refused.push(NAME);
  for (const [name, read] of Object.entries(READERS)) {
    const text = given.get(`${NAME}.${name}`);
    if (text === null) continue;
    const value = read(text);
    if (value === undefined) refused.push(`${NAME}.${name}`);
    else change[name] = value;
  }
  return { view: { ...FIRST_WORKSPACE, ...change }, refused };
}
