/**
 * The two ends of an arm: what the first joint stands on, and the flange with the tool.
 *
 * @import { Vector } from './armPlan.js'
 * @import { Piece } from './joinery.js'
 * @import { Link } from './linkPieces.js'
 * @import { Pose } from '../../kinematics/pose.js'
 */
import { compose, identity, position } from '../../kinematics/pose.js';
import { FLANGE } from './armPlan.js';
import { ORIGIN, X, Z, between, dot, drumAt, facing, link } from './joinery.js';
import { slidePieces } from './slides.js';
import { cone, drum } from './solid.js';

/**
 * In the frame of the first joint's axis.
 * @param {Link} self
 * @param {{ depth: number, plate: number }} base
 * @returns {Piece[]}
 */
export function basePieces({ next, far, radius: r }, { depth, plate }) {
  if (!far || !next) return [];
  const { sense, joinery, at, half } = far;
  const floor = -sense * depth;
  const top = floor + sense * plate;
  const end = at - sense * half;
  const foot = link(drum(1.9 * r, floor, top, 0.06));
  if (joinery !== 'axial') return [foot, ...slidePieces(far, next, top)];
  const column = between(top, end, sense, () => link(cone(1.25 * r, Math.min(1.25 * r, 1.1 * far.radius), top, end)));
  return [foot, ...column, drumAt(far)];
}

/**
 * In the body frame of the last link: the flange and, if the TCP is elsewhere, what reaches from the one to the other.
 * @param {Link} self
 * @param {{ arrival: Vector, isStub: boolean }} way
 * @param {Pose} tool
 * @returns {Piece[]}
 */
export function toolPieces({ body, near, radius: r }, { arrival, isStub }, tool) {
  const tip = position(tool);
  const length = Math.hypot(...tip);
  const sense = arrival[2] < 0 ? -1 : 1;
  /** @type {Piece[]} */
  const pieces = [];
  let front = 0;
  if (Math.abs(arrival[2]) < 0.9) {
    pieces.push({ shape: drum(0.55 * r, -0.85 * r, 0.85 * r), pose: identity(), kind: 'joint' });
  } else {
    // the flange's face is the flange frame, unless the wrist itself is there
    const isRound = near?.joinery === 'axial' || near?.joinery === 'side';
    const behind = near && isRound ? near.sense * (near.at - body.d) + near.half : 0;
    const face = Math.max(0, behind + FLANGE * r, isStub ? 1.6 * r : 0);
    if (isStub) pieces.push(link(drum(0.62 * r, 0, sense * face, 0.02)));
    pieces.push(link(drum(1.22 * r, sense * (face - FLANGE * r), sense * face, 0.12)));
    front = sense * face;
  }
  if (length > 0) {
    /** @type {Vector} */
    const direction = [tip[0] / length, tip[1] / length, tip[2] / length];
    const start = Math.max(0, dot(direction, [0, 0, front]));
    const pose = facing(direction, Math.abs(direction[2]) > 0.7 ? X : Z, ORIGIN);
    const shaft = start + 0.72 * (length - start);
    if (length > start) {
      pieces.push({ shape: drum(0.42 * r, start, shaft, 0.1), pose, kind: 'tool' });
      pieces.push({ shape: cone(0.42 * r, 0.03 * r, shaft, length), pose, kind: 'tool' });
    } else pieces.push({ shape: drum(0.3 * r, 0, length, 0.1), pose, kind: 'tool' });
  }
  return pieces.map((piece) => ({ ...piece, pose: compose(body.T_body_next, piece.pose) }));
}
