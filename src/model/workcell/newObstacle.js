/**
 * An obstacle that is new in the scene: as large as the arm makes sensible, on the floor, in reach of the arm and clear of it
 * where it stands.
 *
 * @import { Doc, ObstacleDoc } from '../document.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { NewObstacle, ObstacleKind } from './obstacles.js'
 * @import { Workcells } from './workcell.js'
 */
import { roundStep } from '../roundStep.js';
import { fromKernel } from '../units.js';
import { sizesOf } from './obstacles.js';

/** Of the arm's reach: how large it is, and how far from the base. */
const SIZE = 0.2;
const FAR = [0.6, 0.8, 1];

/** Directions from the base, the first one ahead of it and a little aside: there the eye is, and something to do for the arm. */
const TURNS = [1, -1, 2, -2, 0, 3, -3, 4, -4, 5, -5, 6].map((twelfth) => (twelfth * Math.PI) / 6);

/** Where a plane lies that would cut the arm at the floor: this far below what it comes to, in reaches. */
const STEPS_DOWN = 20;

/** Lengths of the document keep so many digits: nobody typed more. */
const DIGITS = 3;

/**
 * @param {ObstacleKind} kind
 * @param {Doc} doc
 * @param {Chain} chain
 * @param {Pick<Workcells, 'clearance'>} cells
 * @returns {NewObstacle}
 */
export function newObstacle(kind, doc, chain, cells) {
  const { units } = doc.robot;
  const reach = Number.isFinite(chain.reach) && chain.reach > 0 ? chain.reach : chain.characteristicLength;
  const edge = roundStep(reach * SIZE).step;
  const inUnits = (/** @type {number} */ metres) => Number(fromKernel('length', metres, units).toPrecision(DIGITS));
  const [x, y, z] = chain.base.subarray(12, 15);
  /** @param {number} px @param {number} py @param {number} pz @returns {NewObstacle} */
  const at = (px, py, pz) => {
    const pose = { xyz: [px, py, pz].map(inUnits), rpy: [0, 0, 0] };
    const [whole, half] = [inUnits(edge), inUnits(edge / 2)];
    switch (kind) {
      case 'box':
        return { kind, ...pose, width: whole, depth: whole, height: whole };
      case 'sphere':
        return { kind, ...pose, radius: half };
      case 'cylinder':
        return { kind, ...pose, radius: half, height: whole };
      case 'plane':
        return { kind, ...pose };
    }
  };
  const isFree = (/** @type {NewObstacle} */ obstacle) =>
    isClear(doc, cells, obstacle) && doc.obstacles.every((other) => areApart(other, obstacle));
  const tries =
    kind === 'plane'
      ? Array.from({ length: STEPS_DOWN + 1 }, (_, i) => at(x, y, z - (i * reach) / STEPS_DOWN))
      : FAR.flatMap((far) =>
          TURNS.map((turn) => at(x + far * reach * Math.cos(turn), y + far * reach * Math.sin(turn), z + edge / 2)),
        );
  return tries.find(isFree) ?? tries[0];
}

/** @param {Doc} doc @param {Pick<Workcells, 'clearance'>} cells @param {NewObstacle} obstacle */
function isClear(doc, cells, obstacle) {
  const alone = /** @type {ObstacleDoc} */ ({ ...obstacle, id: 'new' });
  const near = cells.clearance({ ...doc, obstacles: [alone] });
  return near === null || near.obstacle === null || near.distance > 0;
}

/** Whether the spheres around them are apart; planes are in nobody's way. @param {NewObstacle} one @param {NewObstacle} other */
function areApart(one, other) {
  if (one.kind === 'plane' || other.kind === 'plane') return one.kind !== other.kind;
  const around = (/** @type {NewObstacle} */ obstacle) => {
    const { width = 0, depth = 0, height = 0, radius = 0 } = sizesOf(obstacle);
    return radius > 0 ? Math.hypot(radius, height / 2) : Math.hypot(width, depth, height) / 2;
  };
  return Math.hypot(...one.xyz.map((value, k) => value - other.xyz[k])) > around(one) + around(other);
}
