/**
 * What stands around the arm: boxes, spheres, cylinders and planes that a document keeps, in its units, seen from the world.
 * The pose is of the middle of a body; a cylinder stands along its z, and a plane is its own xy, with all below it filled.
 *
 * @import { Doc, ObstacleDoc } from '../document.js'
 *
 * @typedef {ObstacleDoc extends infer One ? One extends ObstacleDoc ? Omit<One, 'id'> : never : never} NewObstacle
 *
 * @typedef {{ type: 'add-obstacle', obstacle: NewObstacle }
 *   | { type: 'rename-obstacle', index: number, id: string }
 *   | { type: 'edit-obstacle', index: number, obstacle: NewObstacle }
 *   | { type: 'remove-obstacle', index: number }} ObstacleCommand
 */
import { poseOnly } from '../frames/frames.js';
import { isSame } from '../program/motionCommands.js';

/** What says how large an obstacle of a kind is. */
export const OBSTACLE_SIZES = Object.freeze({
  box: Object.freeze(/** @type {const} */ (['width', 'depth', 'height'])), // whole edges, along x, y, z
  sphere: Object.freeze(/** @type {const} */ (['radius'])),
  cylinder: Object.freeze(/** @type {const} */ (['radius', 'height'])),
  plane: Object.freeze(/** @type {const} */ ([])),
});

/** @typedef {keyof typeof OBSTACLE_SIZES} ObstacleKind */
/** @typedef {'width' | 'depth' | 'height' | 'radius'} ObstacleSize */

/**
 * The sizes of an obstacle, by name.
 * @param {NewObstacle} obstacle
 * @returns {Partial<Record<ObstacleSize, number>>}
 */
export const sizesOf = (obstacle) => {
  const given = /** @type {Partial<Record<ObstacleSize, number>>} */ (obstacle);
  return Object.fromEntries(OBSTACLE_SIZES[obstacle.kind].map((name) => [name, given[name]]));
};

/**
 * @param {Doc} doc
 * @param {ObstacleCommand} command  that `obstacleRefusal` has nothing against
 * @returns {Doc} the same object when nothing changed
 */
export function applyObstacleCommand(doc, command) {
  const { obstacles } = doc;
  switch (command.type) {
    case 'add-obstacle':
      return { ...doc, obstacles: [...obstacles, made(freeId(doc, command.obstacle.kind), command.obstacle)] };
    case 'rename-obstacle': {
      const old = obstacles[command.index];
      return old.id === command.id
        ? doc
        : { ...doc, obstacles: obstacles.with(command.index, { ...old, id: command.id }) };
    }
    case 'edit-obstacle': {
      const old = obstacles[command.index];
      const next = made(old.id, command.obstacle);
      return isSame(old, next) ? doc : { ...doc, obstacles: obstacles.with(command.index, next) };
    }
    case 'remove-obstacle':
      return { ...doc, obstacles: obstacles.toSpliced(command.index, 1) };
    default: {
      /** @type {never} */
      const unknown = command;
      throw new TypeError(`Unknown command: ${JSON.stringify(unknown)}`);
    }
  }
}

/** What of it an obstacle keeps, and nothing else that came with it. @param {string} id @param {NewObstacle} given */
const made = (id, given) =>
  /** @type {ObstacleDoc} */ ({ kind: given.kind, id, ...poseOnly(given), ...sizesOf(given) });

/** The first of box_1, box_2, … that no obstacle has. @param {Doc} doc @param {ObstacleKind} kind */
function freeId({ obstacles }, kind) {
  const taken = new Set(obstacles.map(({ id }) => id));
  let number = 1;
  while (taken.has(`${kind}_${number}`)) number++;
  return `${kind}_${number}`;
}
