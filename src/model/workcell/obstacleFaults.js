/**
 * What can be wrong with the obstacles of a document: one list of facts, for commands, files and whatever else brings
 * obstacles in. Commands may besides ask for a place that is not there.
 *
 * @import { Doc, ObstacleDoc } from '../document.js'
 * @import { Issue } from '../issues.js'
 * @import { NewObstacle, ObstacleCommand, ObstacleKind } from './obstacles.js'
 */
import { ID_PATTERN, LARGEST_NUMBER, MAX_OBSTACLES } from '../documentRules.js';
import { OBSTACLE_SIZES, sizesOf } from './obstacles.js';
import { badChoice, badIndex, issue, shown } from '../refusalParts.js';
import { badPose } from '../robot/robotRefusals.js';

const KINDS = Object.keys(OBSTACLE_SIZES);

/**
 * @param {Doc} doc
 * @param {ObstacleCommand} command
 * @returns {Issue | null}
 */
export function obstacleRefusal({ obstacles }, command) {
  if (command.type === 'add-obstacle')
    return badCount(obstacles.length + 1) ?? badObstacle('obstacles', command.obstacle);
  const { index } = command;
  const path = `obstacles.${index}`;
  const bad = badIndex('obstacle', index, obstacles.length);
  if (bad || command.type === 'remove-obstacle') return bad;
  if (command.type === 'edit-obstacle') return badObstacle(path, command.obstacle);
  return badId(path, command.id) ?? (isTaken(obstacles, index, command.id) ? taken(path, command.id) : null);
}

/**
 * All obstacles of a document.
 * @param {Doc} doc
 * @returns {Generator<Issue>}
 */
export function* obstacleFaults({ obstacles }) {
  const tooMany = badCount(obstacles.length);
  if (tooMany) yield tooMany;
  for (const [i, obstacle] of obstacles.entries()) {
    const path = `obstacles.${i}`;
    const fault = badId(path, obstacle.id) ?? badObstacle(path, obstacle);
    if (fault) yield fault;
    if (isTaken(obstacles.slice(0, i), -1, obstacle.id)) yield taken(path, obstacle.id);
  }
}

/** @param {number} count */
const badCount = (count) =>
  count <= MAX_OBSTACLES
    ? null
    : issue('too-many-obstacles', 'obstacles', `A model keeps at most ${MAX_OBSTACLES} obstacles.`);

/** @param {string} path @param {string} id */
const badId = (path, id) =>
  typeof id === 'string' && ID_PATTERN.test(id)
    ? null
    : issue('id', `${path}.id`, 'A name is a letter or _, then at most 63 letters, digits or _.');

/** @param {readonly ObstacleDoc[]} obstacles @param {number} index @param {string} id */
const isTaken = (obstacles, index, id) => obstacles.some((other, i) => i !== index && other.id === id);

/** @param {string} path @param {string} id */
const taken = (path, id) => issue('id-taken', `${path}.id`, `Another obstacle is called ${shown(id)} already.`);

/** @param {string} path @param {NewObstacle} obstacle @returns {Issue | null} */
function badObstacle(path, obstacle) {
  const kind = /** @type {ObstacleKind} */ (Object(obstacle).kind);
  const bad = badChoice('the kind of an obstacle', `${path}.kind`, kind, KINDS) ?? badPose(path, obstacle);
  if (bad) return bad;
  for (const [name, value] of Object.entries(sizesOf(obstacle))) {
    if (value > 0 && value <= LARGEST_NUMBER) continue;
    return issue(
      'number',
      `${path}.${name}`,
      `The ${name} of a ${kind} is a number above 0, up to 10⁹; got ${shown(value)}.`,
    );
  }
  return null;
}
