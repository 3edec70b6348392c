/**
 * Document → the arm as capsules among its obstacles, in metres, seen from the world; and how near it comes to them, and to
 * itself, where it stands. A capsule is as thick as the link is drawn, or covers it where it is drawn as a box, and is there
 * also where nothing is drawn. What is drawn about joints, such as knuckles and sleeves, is thicker and stands out from it.
 *
 * @import { Doc, ObstacleDoc, RobotDoc, Units } from '../document.js'
 * @import { Derived } from '../derived.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Nearest } from '../../motion/clearance/workcell.js'
 * @import { Obstacle } from '../../motion/clearance/obstacles.js'
 *
 * @typedef {object} Clearance  two bodies and what is between them
 * @property {number} distance  between their surfaces, in document units; below 0 where they overlap
 * @property {number} link      0-based: of the joint that moves it
 * @property {string | null} obstacle  its id, or null:
 * @property {number | null} other     another link
 */
import { armBodies } from '../../motion/clearance/armBodies.js';
import { clearance, createWorkcell } from '../../motion/clearance/workcell.js';
import { compileLinkStyles, compilePose } from '../compile.js';
import { memo } from '../memo.js';
import { fromKernel, toKernel } from '../units.js';

/**
 * @param {Pick<Derived, 'chain' | 'posture'>} derived
 * @param {(chain: Chain) => readonly number[]} automaticRadii  how thick links are drawn where nobody says so, m
 */
export function createWorkcells(derived, automaticRadii) {
  const bodiesOf = memo((/** @type {RobotDoc} */ robot, /** @type {Chain} */ chain) =>
    armBodies(chain, linkRadii(robot, automaticRadii(chain))),
  );
  const obstaclesOf = memo((/** @type {Doc['obstacles']} */ obstacles, /** @type {Units} */ units) =>
    obstacles.map((obstacle) => compileObstacle(obstacle, units)),
  );
  const cellOf = memo(createWorkcell);
  const nearestOf = memo(clearance);

  const cell = (/** @type {Doc} */ { robot, obstacles }, /** @type {Chain} */ chain) =>
    cellOf(bodiesOf(robot, chain), obstaclesOf(obstacles, robot.units));
  return {
    cell: (/** @type {Doc} */ doc) => cell(doc, derived.chain(doc)),
    /** Where the arm stands now; null where there is nothing to come near to. @param {Doc} doc @returns {Clearance | null} */
    clearance(doc) {
      const here = cell(doc, derived.chain(doc));
      const nearest = nearestOf(here, derived.posture(doc));
      return nearest && named(doc, here.bodies.stretches, nearest);
    },
  };
}

/** @param {Doc} doc @param {readonly { link: number }[]} stretches @param {Nearest} nearest @returns {Clearance} */
const named = ({ robot, obstacles }, stretches, { distance, stretch, obstacle, other }) => ({
  distance: fromKernel('length', distance, robot.units),
  link: stretches[stretch].link,
  obstacle: obstacle === null ? null : obstacles[obstacle].id,
  other: other === null ? null : stretches[other].link,
});

/**
 * @param {RobotDoc} robot
 * @param {readonly number[]} automatic
 * @returns {number[]} metres
 */
export const linkRadii = (robot, automatic) =>
  compileLinkStyles(robot).map((style, i) => {
    const { kind, radius = automatic[i], width = 2 * radius, height = 2 * radius } = /** @type {LinkSizes} */ (style);
    return kind === 'box' ? Math.hypot(width, height) / 2 : radius;
  });

/** @typedef {{ kind: string, radius?: number, width?: number, height?: number }} LinkSizes  m */

/**
 * @param {ObstacleDoc} obstacle
 * @param {Units} units
 * @returns {Obstacle}
 */
export function compileObstacle(obstacle, units) {
  const T = compilePose(obstacle, units);
  const metres = (/** @type {number} */ value) => toKernel('length', value, units);
  const centre = T.slice(12, 15);
  switch (obstacle.kind) {
    case 'box':
      return { kind: 'box', T_base_box: T, size: [obstacle.width, obstacle.depth, obstacle.height].map(metres) };
    case 'sphere':
      return { kind: 'sphere', centre, radius: metres(obstacle.radius) };
    case 'cylinder':
      return {
        ...{ kind: 'cylinder', T_base_cylinder: T },
        ...{ radius: metres(obstacle.radius), height: metres(obstacle.height) },
      };
    case 'plane': {
      const normal = T.slice(8, 11);
      return { kind: 'plane', normal, offset: normal.reduce((sum, value, i) => sum + value * centre[i], 0) };
    }
  }
}
