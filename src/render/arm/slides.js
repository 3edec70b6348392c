/**
 * Sliding joints: square where turning joints are round. A ram slides in a sleeve, a carriage on a mast, and the first
 * joint may lift a column out of the base. Under them all runs a rod from the one link to the other, however far apart
 * they are: it shows where a slide goes that has no limits, or has left them.
 *
 * @import { Body } from './bodies.js'
 * @import { JointPlan } from './armPlan.js'
 * @import { Piece } from './joinery.js'
 * @import { Shape } from './solid.js'
 */
import { poseFromRollPitchYaw } from '../../kinematics/orientation.js';
import { identity } from '../../kinematics/pose.js';
import { CARRIAGE, SLEEVE } from './armPlan.js';
import { bar } from './solid.js';

/** A slide's parts stand square to the link that slides. @param {Body} body */
export const squareTo = ({ theta }) => poseFromRollPitchYaw([0, 0, 0], [0, 0, theta]);

/** How far a ram stays in its sleeve, and a mast goes on behind its carriage, in radii. */
const SPARE = 0.4;

/**
 * What the link before carries, seen from the axis.
 * @param {JointPlan} joint
 * @param {Body} body  the link that slides
 * @param {number | null} floor  where on the axis the base's plate ends, if the base carries it
 * @returns {Piece[]}
 */
export function slidePieces({ joinery, radius: r, sense }, body, floor) {
  const pose = squareTo(body);
  const [near, far] = sense > 0 ? [body.low, body.high] : [body.high, body.low];
  if (joinery === 'ram') {
    const isBehind = sense * near > -SPARE * r; // it never comes out on the other side
    const [from, to] = isBehind ? [-sense * SLEEVE * r, sense * 0.35 * r] : [-CARRIAGE * r, CARRIAGE * r];
    return [{ shape: bar(0.95 * r, 0.95 * r, from, to), pose, kind: 'joint' }];
  }
  if (joinery === 'lift') {
    const top = Math.max(sense * near - r, 0.2 * r + sense * (floor ?? 0));
    return [{ shape: bar(1.15 * r, 1.15 * r, floor ?? 0, sense * top), pose, kind: 'joint' }];
  }
  const over = sense * (CARRIAGE + SPARE) * r;
  const foot = floor ?? Math.min(0, sense * near) * sense - over;
  const head = Math.max(0, sense * far) * sense + over;
  /** @param {number} z @param {number} height @returns {Piece} */
  const stop = (z, height) => ({ shape: bar(0.85 * r, 1.0 * r, z, z + height), pose, kind: 'link' });
  return [
    { shape: bar(0.55 * r, 0.75 * r, foot, head), pose, kind: 'link' },
    stop(head, -sense * SPARE * 0.5 * r),
    ...(floor === null ? [stop(foot, sense * SPARE * 0.5 * r)] : []),
  ];
}

/**
 * What the sliding link itself has, seen from its body frame.
 * @param {JointPlan} joint
 * @param {Body} body
 * @returns {Piece[]}
 */
export function sliderPieces({ joinery, radius: r, sense }, { low, high }) {
  if (joinery === 'ram') {
    const back = (SLEEVE + SPARE) * r;
    const [behind, ahead] = sense > 0 ? [-high, -low] : [-low, -high];
    const from = Math.min(0, sense * behind) - back;
    const to = sense * ahead > SPARE * r ? sense * ahead + back : 0;
    return [{ shape: bar(0.62 * r, 0.62 * r, sense * from, sense * to), pose: identity(), kind: 'link' }];
  }
  if (joinery === 'lift') return [];
  return [{ shape: bar(1.0 * r, 1.2 * r, -CARRIAGE * r, CARRIAGE * r), pose: identity(), kind: 'joint' }];
}

/** @param {JointPlan} joint @returns {Shape} of one metre */
export function rodShape({ joinery, radius: r }) {
  const half = (joinery === 'lift' ? 0.8 : 0.36) * r;
  return bar(half, half, 0, 1);
}
