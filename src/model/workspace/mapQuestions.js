/**
 * What the worker is asked for what somebody wants to see, with a key: the same key, the same answer. Names, colours and how a
 * map is looked at are no part of it.
 *
 * @import { AppState, Session } from '../session.js'
 * @import { WorkspaceView } from './workspaceView.js'
 * @import { Chain, ChainDescription } from '../../kinematics/chain.js'
 *
 * @typedef {object} Question
 * @property {string} key
 * @property {ChainDescription} chain
 * @property {object} options   of the job
 */
import { along, cross, dot, unit } from '../../kinematics/lines.js';
import { poseFromRollPitchYaw } from '../../kinematics/orientation.js';
import { roundStep } from '../roundStep.js';
import { CELL } from './workspaceView.js';

/** Cubes along twice the arm's reach at first, and so many times as many where they are finer. */
const CUBES = 40;
const FINER = { coarse: 1, usual: 2, fine: 4.5 };

/**
 * Postures for each cube of the box that are looked at. Of its directions there are 54, so to see most of those that there are
 * takes some times as many.
 */
const LOOKS = { usual: 4, directions: 80 };

/** Postures whose places are drawn as points. */
const POINTS = { coarse: 60_000, usual: 150_000, fine: 400_000 };

/** Cells along twice the arm's reach, where nobody says how large they are. */
const CELLS = 400;

/** Cells along twice the arm's reach at most. */
const MOST_CELLS = 10_000;

/** How far lines may be off the boundary, m: in both cases what is drawn is known to a little more. */
const TOLERANCE = { precise: 2e-5, quick: 1e-4 };

/** A normal whose z is larger belongs to a plane that lies rather flat. */
const STEEP = 0.9;

/** @param {Chain} chain @returns {ChainDescription} */
const describe = ({ convention, base, tool, joints }) => ({ convention, base, tool, joints });

/** Twice the reach, m; of an arm without any, a metre. @param {Pick<Chain, 'reach'>} chain */
const widthOf = ({ reach }) => (Number.isFinite(reach) && reach > 0 ? 2 * reach : 1);

/** The edge of a cube, m. @param {Pick<Chain, 'reach'>} chain @param {WorkspaceView['detail']} detail */
export const cubeSize = (chain, detail) => roundStep(roundStep(widthOf(chain) / CUBES).step / FINER[detail]).step;

/** The edge of a section's cell, m. @param {Pick<Chain, 'reach'>} chain @param {Pick<WorkspaceView, 'cell'>} view */
export const cellSize = (chain, { cell }) => Math.max(leastCell(chain), cell ?? roundStep(widthOf(chain) / CELLS).step);

/** The finest cell of a section, m: more of them than this would take too much memory. @param {Pick<Chain, 'reach'>} chain */
export const leastCell = (chain) => Math.max(CELL.least, roundUp(widthOf(chain) / MOST_CELLS));

/** To two digits, upwards. @param {number} value */
function roundUp(value) {
  const step = 10 ** (Math.floor(Math.log10(value)) - 1);
  return Number((Math.ceil(value / step) * step).toPrecision(3));
}

/** Typed arrays are written as lists: the same numbers, the same text. @param {unknown} value */
const keyOf = (value) =>
  JSON.stringify(value, (_, one) => {
    if (one instanceof Float64Array) return Array.from(one);
    return typeof one === 'number' && !Number.isFinite(one) ? String(one) : one; // no limit is another than none said
  });

/** @param {Chain} chain @param {object} options @returns {Question} */
function question(chain, options) {
  const description = describe(chain);
  return { key: keyOf([description, options]), chain: description, options };
}

/**
 * Whether a fold's question is to be worked on: it is open, and somebody sees it, there or in the scene.
 * @param {Session} session
 * @param {string} fold
 * @param {boolean} isInScene
 */
const isWanted = ({ tab, workspace }, fold, isInScene) =>
  workspace !== null && workspace.open.includes(fold) && (isInScene || tab === 'workspace');

/** @param {WorkspaceView} view */
function orientationOf({ tool, wpr, halfAngle }) {
  if (tool === 'any') return { kind: tool };
  const T = poseFromRollPitchYaw([0, 0, 0], wpr);
  return tool === 'fixed' ? { kind: tool, T } : { kind: tool, T, halfAngle };
}

/** A plane is seen with the world's z upwards, or its y if it lies flat. @param {WorkspaceView} view */
function cutOf({ cut, angle, normal, offset }) {
  if (cut === 'own') return undefined;
  if (cut === 'angle') return { kind: 'meridian', angle };
  const n = unit(normal);
  /** @type {[number, number, number]} */
  const up = Math.abs(n[2]) < STEEP ? [0, 0, 1] : [0, 1, 0];
  const v = unit(along(up, -dot(up, n), n));
  return { kind: 'plane', origin: n.map((value) => offset * value), u: cross(v, n), v };
}

/**
 * @param {Pick<AppState, 'session'>} state
 * @param {Chain} chain
 * @returns {{ volume: Question, points: Question | null } | null} points: where places are drawn, too
 */
export function volumeQuestion({ session }, chain) {
  const view = session.workspace;
  if (!view || !isWanted(session, 'volume', view.hasVolume)) return null;
  const { withLimits, seed, detail, style, colour } = view;
  const looks = LOOKS[colour === 'directions' ? 'directions' : 'usual'];
  const volume = question(chain, {
    withLimits,
    seed,
    cell: cubeSize(chain, detail),
    wanted: orientationOf(view),
    looks,
  });
  const points = style === 'points' ? question(chain, { withLimits, seed, count: POINTS[detail] }) : null;
  return { volume, points };
}

/**
 * @param {Pick<AppState, 'session'>} state
 * @param {Chain} chain
 * @returns {Question | null}
 */
export function sectionQuestion({ session }, chain) {
  const view = session.workspace;
  // other folds draw it as well
  const isDrawn =
    isWanted(session, 'section', view?.hasSection ?? false) ||
    ['points', 'teach'].some((fold) => isWanted(session, fold, false));
  if (!view || !isDrawn) return null;
  const { withLimits, seed, isPrecise } = view;
  const tolerance = TOLERANCE[isPrecise ? 'precise' : 'quick'];
  return question(chain, { withLimits, seed, tolerance, cell: cellSize(chain, view), cut: cutOf(view) });
}
