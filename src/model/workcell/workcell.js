/**
 * Document → the arm as capsules among its obstacles, in metres, seen from the world; and how near it comes to them, and to
 * itself, where it stands. A capsule is as thick as the link is drawn, or covers it where it is drawn as a box, and is there
 * also where nothing is drawn. What is drawn about joints, such as knuckles and sleeves, is thicker and stands out from it.
 *
 * @import { Doc, ObstacleDoc, RobotDoc, Units } from '../document.js'
 * @import { Derived } from '../derived.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { ArmBodies } from '../../motion/clearance/armBodies.js'
 * @import { Nearest, NearestLinks, Workcell } from '../../motion/clearance/workcell.js'
 * @import { Obstacle } from '../../motion/clearance/obstacles.js'
 *
 * @typedef {object} Clearance  two bodies and what is between them
 * @property {number} distance  between their surfaces, in document units; below 0 where they overlap
 * @property {number} link      0-based: of the joint that moves it
 * @property {string | null} obstacle  its id, or null:
 * @property {number | null} other     another link
 *
 * @typedef {Clearance & { readonly points: readonly [ofArm: Float64Array, ofOther: Float64Array] }} Near  and where that is, m
 *
 * @typedef {object} Closeness   how the arm stands, for the eye
 * @property {Near | null} around   the nearest obstacle; null: there is none
 * @property {Near | null} itself   the nearest two of its links that could touch; null: there are none
 * @property {readonly Clearance[]} touching
 *
 * @typedef {{ link: number, radius: number, ends: Float64Array }} Capsule  m, seen from the world; x y z of both ends
 *
 * @typedef {object} ShownObstacle
 * @property {string} id
 * @property {ObstacleDoc['kind']} kind
 * @property {Float64Array} T_world_obstacle
 * @property {readonly [number, number, number]} size  m, along its axes; radii, and of a cylinder its height; of a plane 1
 */
import { ENDS, armBodies, writeEnds } from '../../motion/clearance/armBodies.js';
import { nearestPoints } from '../../motion/clearance/nearestPoints.js';
import { byLinks, clearance, createWorkcell, touches } from '../../motion/clearance/workcell.js';
import { compileLinkStyles, compilePose } from '../compile.js';
import { memo } from '../memo.js';
import { fromKernel, toKernel } from '../units.js';
import { sizesOf } from './obstacles.js';

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
  const armOf = memo((/** @type {ArmBodies} */ bodies) => createWorkcell(bodies, []));
  const aroundOf = memo((/** @type {ArmBodies} */ bodies, /** @type {readonly Obstacle[]} */ obstacles) =>
    createWorkcell(bodies, obstacles, { looksAtItself: false }),
  );
  const closenessOf = memo(
    /** @param {Doc['robot']} robot @param {Doc['obstacles']} listed @param {Chain} chain @param {Float64Array} q @returns {Closeness} */
    (robot, listed, chain, q) => {
      const doc = { robot, obstacles: listed };
      const bodies = bodiesOf(robot, chain);
      const obstacles = obstaclesOf(listed, robot.units);
      const name = (/** @type {Nearest} */ near) => named(doc, byLinks(bodies, near));
      const nearIn = (/** @type {Workcell} */ within) => {
        const near = clearance(within, q);
        return near && { ...name(near), points: nearestPoints(within, q, near) };
      };
      const [around, itself] = [nearIn(aroundOf(bodies, obstacles)), nearIn(armOf(bodies))];
      const isTouching = [around, itself].some((near) => near !== null && near.distance <= 0);
      return { around, itself, touching: isTouching ? touches(cell(doc, chain), q).map(name) : [] };
    },
  );
  const capsulesOf = memo(capsules);

  const cell = (/** @type {Pick<Doc, 'robot' | 'obstacles'>} */ { robot, obstacles }, /** @type {Chain} */ chain) =>
    cellOf(bodiesOf(robot, chain), obstaclesOf(obstacles, robot.units));
  return {
    cell: (/** @type {Doc} */ doc) => cell(doc, derived.chain(doc)),
    /** Where the arm stands now; null where there is nothing to come near to. @param {Doc} doc @returns {Clearance | null} */
    clearance(doc) {
      const here = cell(doc, derived.chain(doc));
      const nearest = nearestOf(here, derived.posture(doc));
      return nearest && named(doc, byLinks(here.bodies, nearest));
    },
    /** The same with all that touches, and where; the same object for as long as nothing moves. @param {Doc} doc */
    closeness: (doc) => closenessOf(doc.robot, doc.obstacles, derived.chain(doc), derived.posture(doc)),
    /** The arm as it is looked at, where it stands now. @param {Doc} doc */
    capsules: (doc) => capsulesOf(bodiesOf(doc.robot, derived.chain(doc)), derived.posture(doc)),
    /** Whether any two of its links are held against each other. @param {Doc} doc */
    canTouchItself: (doc) => bodiesOf(doc.robot, derived.chain(doc)).pairs.length > 0,
    /** How thick its links are taken to be, m. @param {Doc} doc */
    radii: (doc) => linkRadii(doc.robot, automaticRadii(derived.chain(doc))),
    /** As the check has them. @param {Doc} doc */
    obstacles: (doc) => obstaclesOf(doc.obstacles, doc.robot.units),
  };
}

/** @typedef {ReturnType<typeof createWorkcells>} Workcells */

/** @param {ArmBodies} bodies @param {Float64Array} q @returns {Capsule[]} */
function capsules(bodies, q) {
  const ends = writeEnds(bodies, q, new Float64Array(ENDS * bodies.stretches.length));
  return bodies.stretches.flatMap(({ link, radius, moves }, i) =>
    moves ? [{ link, radius, ends: ends.subarray(ENDS * i, ENDS * (i + 1)) }] : [],
  );
}

/** What the kernel found, in the document's names and units. @param {Pick<Doc, 'robot' | 'obstacles'>} doc @param {NearestLinks} nearest @returns {Clearance} */
export const named = ({ robot, obstacles }, { distance, link, obstacle, other }) => ({
  ...{ distance: fromKernel('length', distance, robot.units), link, other },
  obstacle: obstacle === null ? null : obstacles[obstacle].id,
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

/** @type {(doc: Doc) => readonly ShownObstacle[]} */
export const shownObstacles = ({ obstacles, robot: { units } }) => shownOf(obstacles, units);

const shownOf = memo(
  /** @param {Doc['obstacles']} obstacles @param {Units} units @returns {ShownObstacle[]} */
  (obstacles, units) =>
    obstacles.map((obstacle) => {
      const { width = 1, depth = 1, height = 1, radius = 1 } = sizesOf(obstacle);
      const sizes = /** @type {const} */ ({
        ...{ box: [width, depth, height], sphere: [radius, radius, radius] },
        ...{ cylinder: [radius, radius, height], plane: [1, 1, 1] },
      })[obstacle.kind];
      const metres = (/** @type {number} */ value) =>
        obstacle.kind === 'plane' ? value : toKernel('length', value, units);
      return {
        ...{ id: obstacle.id, kind: obstacle.kind, T_world_obstacle: compilePose(obstacle, units) },
        size: /** @type {const} */ ([metres(sizes[0]), metres(sizes[1]), metres(sizes[2])]),
      };
    }),
);
