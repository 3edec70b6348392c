/**
 * The pieces by which links meet, in the frame of the joint's axis, and what is needed to place a piece.
 *
 * @import { Shape } from './solid.js'
 * @import { Pose } from '../../kinematics/pose.js'
 * @import { JointPlan, Vector } from './armPlan.js'
 *
 * @typedef {'link' | 'joint' | 'tool'} PartKind
 * @typedef {{ shape: Shape, pose: Pose, kind: PartKind }} Piece
 */
import { identity } from '../../kinematics/pose.js';
import { FORK_CLEAR, FORK_ROOT, TONGUE } from './armPlan.js';
import { beam, drum } from './solid.js';

const CHEEK = 0.42;
const GAP = TONGUE / 2 + 0.1; // from the middle of a fork to a cheek

/** @type {Vector} */
export const X = [1, 0, 0];
/** @type {Vector} */
export const Z = [0, 0, 1];
/** @type {Vector} */
export const ORIGIN = [0, 0, 0];

/** @param {Piece['shape']} shape @param {Pose} [pose] @returns {Piece} */
export const link = (shape, pose = identity()) => ({ shape, pose, kind: 'link' });
/** @param {Piece['shape']} shape @param {Pose} [pose] @returns {Piece} */
export const joint = (shape, pose = identity()) => ({ shape, pose, kind: 'joint' });

/**
 * Nothing at all, where there is no way to go.
 * @param {number} from
 * @param {number} to
 * @param {1 | -1} sense
 * @param {() => Piece} piece
 */
export const between = (from, to, sense, piece) => (sense * (to - from) > 0 ? [piece()] : []);

/**
 * A pose from its z axis, as much of the direction x as is across it, and its origin.
 * @param {Vector} z
 * @param {Vector} x
 * @param {Vector} at
 * @returns {Pose}
 */
export function facing(z, x, at) {
  const along = dot(x, z);
  const across = unit([x[0] - along * z[0], x[1] - along * z[1], x[2] - along * z[2]]);
  const y = [
    z[1] * across[2] - z[2] * across[1],
    z[2] * across[0] - z[0] * across[2],
    z[0] * across[1] - z[1] * across[0],
  ];
  return Float64Array.of(...across, 0, y[0], y[1], y[2], 0, ...z, 0, ...at, 1);
}

/** @param {Vector} u @param {Vector} v */
export const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];

/** @param {Vector} v @returns {Vector} */
function unit(v) {
  const length = Math.hypot(...v);
  return [v[0] / length, v[1] / length, v[2] / length];
}

/**
 * Two cheeks, the root that they spring from, and the pin through both. The link arrives at the root along a line that may
 * pass the axis at some distance: the root reaches over to it.
 * @param {{ radius: number, at: number, arrival: Vector, squeeze: number }} fork
 * @param {Vector} passes  a point of that line
 * @returns {Piece[]}
 */
export function forkPieces({ radius: r, at, arrival, squeeze }, passes) {
  const root = (FORK_CLEAR + (FORK_ROOT / 2) * squeeze) * r;
  const from = unit([-arrival[0], -arrival[1], 0]);
  const middle = (GAP + CHEEK / 2) * r;
  const width = (GAP + CHEEK) * r;
  const inner = (GAP + 0.7 * CHEEK) * r; // the root ends inside the cheeks
  const cheeks = [-1, 1].map((side) => ({
    shape: beam(root, 1.02 * r, 0.86 * r, CHEEK * r),
    pose: facing(Z, from, [0, 0, at + side * middle]),
    kind: /** @type {const} */ ('link'),
  }));
  /** @type {Vector} */
  const aside = [passes[0], passes[1], passes[2] - at];
  const forward = dot(aside, from);
  /** @type {Vector} */
  const over = [aside[0] - forward * from[0], aside[1] - forward * from[1], aside[2]];
  const reach = Math.hypot(...over);
  const rootFrame = facing(from, reach > 0 ? over : Z, [root * from[0], root * from[1], at]);
  const thickness = FORK_ROOT * squeeze * r;
  return [
    ...cheeks,
    { shape: beam(reach, inner, inner, thickness), pose: rootFrame, kind: 'link' },
    { shape: drum(0.62 * r, at - width - 0.14 * r, at + width + 0.14 * r), pose: identity(), kind: 'joint' },
  ];
}

/** A round end about an axis. @param {number} radius @param {number} half @param {Pose} pose @returns {Piece} */
export const knuckle = (radius, half, pose) => ({ shape: drum(radius, -half, half), pose, kind: 'link' });

/** The drum of a turning joint. @param {JointPlan} plan */
export const drumAt = ({ at, half, radius }) => joint(drum(1.14 * radius, at - half, at + half));
