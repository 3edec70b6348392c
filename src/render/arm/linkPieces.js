/**
 * The pieces of one link, in its body frame: from the joint that moves it, along its offset d, its length a, and as far
 * along the next axis as it stands still.
 *
 * @import { Body } from './bodies.js'
 * @import { JointPlan, Vector } from './armPlan.js'
 * @import { Piece } from './joinery.js'
 * @import { Pose } from '../../kinematics/pose.js'
 *
 * @typedef {object} LinkStyle  how the link that a joint moves is drawn; lengths in metres
 * @property {'auto' | 'cylinder' | 'box' | 'none'} kind
 * @property {number} [radius]
 * @property {number} [width]   of a box, across
 * @property {number} [height]  of a box, along its first axis
 * @property {string} [color]   '#rrggbb'
 *
 * @typedef {object} Link
 * @property {Body} body
 * @property {Body} [next]
 * @property {JointPlan} [near]  the joint that moves it
 * @property {JointPlan} [far]
 * @property {number} radius
 */
import { compose, identity } from '../../kinematics/pose.js';
import {
  FORK_CLEAR,
  FORK_ROOT,
  HALF_CORNER,
  HALF_KNUCKLE,
  KNUCKLE,
  TONGUE,
  halfEye,
  hasBeam,
  isFlat,
} from './armPlan.js';
import { ORIGIN, X, Z, between, drumAt, facing, forkPieces, joint, knuckle, link } from './joinery.js';
import { slidePieces, sliderPieces } from './slides.js';
import { bar, beam, cone, drum, stub } from './solid.js';

/**
 * @param {Link} self
 * @param {LinkStyle} [style]
 * @returns {Piece[]}
 */
export function linkPieces(self, style) {
  const own = [...nearPieces(self), ...spanPieces(self), ...farPieces(self)];
  if (!style || style.kind === 'auto') return own;
  const joints = own.filter(({ kind }) => kind !== 'link');
  return style.kind === 'none' ? joints : [...joints, ...plainPieces(self, style)];
}

/** Along the offset d. @param {Link} self @returns {Piece[]} */
function nearPieces({ body, near, far, radius: r }) {
  if (!near) return [];
  if (body.slides) return sliderPieces(near, body);
  const { sense, joinery, at, half } = near;
  if (joinery === 'fork') return [];
  const from = at + sense * half - body.d;
  const end = far?.joinery === 'fork' && !hasBeam(body, r) ? -sense * FORK_CLEAR * far.radius : 0;
  return between(from, end, sense, () => link(drum((joinery === 'side' ? 0.8 : 0.9) * r, from, end, 0.04)));
}

/** Along the length a, with what joins it to the axes at its ends. @param {Link} self @returns {Piece[]} */
function spanPieces({ body, near, far, radius: r }) {
  if (!near) return [];
  const { a, T_body_next } = body;
  const turnsInFork = near.joinery === 'fork';
  const isAcross = far && far.joinery !== 'fork' && (far.joinery !== 'axial' || Math.abs(far.arrival[2]) < 0.9);
  const eye = isAcross ? [knuckle(KNUCKLE * far.radius, halfEye(far.radius, r), T_body_next)] : [];
  // wide enough for a tube of the next joint to leave it sideways
  const across = Math.max(HALF_KNUCKLE * r, far?.joinery === 'axial' ? 1.1 * far.radius : 0);
  if (!hasBeam(body, r)) {
    if (turnsInFork) return [link(beam(a, 0.98 * r, 0.98 * r, TONGUE * r))];
    if (far?.joinery === 'fork') return [];
    if (near.joinery === 'side') return [link(beam(a, KNUCKLE * r, KNUCKLE * r, 2 * across))];
    return Math.abs(a) > 0.05 * r ? [link(beam(a, r, r, TONGUE * r)), ...eye] : eye;
  }
  const forward = Math.sign(a);
  const endsInFork = far?.joinery === 'fork';
  const root = endsInFork ? (FORK_CLEAR + FORK_ROOT / 2) * far.radius : 0;
  const length = forward * Math.max(Math.abs(a) - root, 0.5 * r);
  const thin = far?.radius ?? 0.9 * r;
  if (isFlat(body)) {
    if (endsInFork) return [link(stub(length, KNUCKLE * r, 1.04 * thin, TONGUE * r))];
    return [link(beam(a, KNUCKLE * r, 1.05 * thin, TONGUE * r)), ...(far?.joinery === 'side' ? [] : eye)];
  }
  const alongX = facing([forward, 0, 0], Z, ORIGIN);
  const half = (turnsInFork ? TONGUE / 2 : HALF_CORNER) * r;
  const neck = turnsInFork ? [link(drum(0.62 * r, 0, 1.25 * r, 0.04), alongX)] : [];
  const from = Math.min(turnsInFork ? 1.25 * r : 0, Math.abs(length) / 2);
  return [link(drum(1.1 * r, -half, half)), ...neck, link(cone(r, 0.9 * thin, from, Math.abs(length)), alongX), ...eye];
}

/** Along the next axis, up to the next joint. @param {Link} self @returns {Piece[]} */
function farPieces({ body, next, near, far, radius: r }) {
  if (!far || !next || !near) return [];
  const { joinery, sense, at, half, radius } = far;
  /** @param {Piece} piece @returns {Piece} */
  const beyond = (piece) => ({ ...piece, pose: compose(body.T_body_next, piece.pose) });
  if (next.slides) return slidePieces(far, next, null).map(beyond);
  if (joinery === 'fork') {
    const passes = hasBeam(body, r) ? ORIGIN : /** @type {Vector} */ ([-body.a, 0, 0]);
    return forkPieces({ ...far, squeeze: near.squeeze }, passes).map(beyond);
  }
  if (joinery === 'side') {
    const collar = joint(drum(0.92 * radius, at - half, at + half));
    const isPlate = hasBeam(body, r) && isFlat(body);
    const behind = (TONGUE / 2) * r + 0.2 * radius;
    const pin = isPlate ? [joint(drum(0.7 * radius, -sense * behind, sense * (TONGUE / 2) * r))] : [];
    return [collar, ...pin].map(beyond);
  }
  const end = at - sense * half;
  const isAcross = Math.abs(far.arrival[2]) < 0.9;
  const wide = isAcross ? radius : 0.9 * radius;
  const start = near.joinery === 'fork' ? Math.min(1.2 * r, sense * end) * sense : 0;
  return [
    ...between(0, start, sense, () => link(drum(0.62 * r, 0, start, 0.02))),
    ...between(start, end, sense, () => link(drum(wide, start, end, 0.04))),
    drumAt(far),
  ].map(beyond);
}

/**
 * A link as bars or tubes of one thickness, straight along d, a and the next d.
 * @param {Link} self
 * @param {LinkStyle} style
 * @returns {Piece[]}
 */
function plainPieces({ body, near, far, radius: r }, { kind, width, height }) {
  const [halfX, halfY] = [width ?? 2 * r, height ?? 2 * r].map((side) => side / 2);
  /** @param {number} from @param {number} to @param {Pose} pose @returns {Piece[]} */
  const along = (from, to, pose) => {
    if (from === to) return [];
    return [link(kind === 'box' ? bar(halfX, halfY, from, to) : drum(r, from, to, 0.04), pose)];
  };
  const lies = near?.joinery === 'axial' ? near.at + near.sense * near.half : 0;
  const starts = body.slides ? 0 : lies - body.d;
  const ends = far?.joinery === 'axial' ? far.at - far.sense * far.half : 0;
  return [
    ...along(starts, 0, identity()),
    ...along(0, body.a, facing(X, [0, 1, 0], ORIGIN)),
    ...along(0, ends, body.T_body_next),
  ];
}
