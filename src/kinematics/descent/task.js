/**
 * What of a pose an arm with few joints is asked to meet. A task takes the six-row residual and Jacobian of the whole pose
 * and leaves of the orientation only what it asks for; the rest it keeps with the weight `spare`, so that among the
 * postures that meet the task one with little of the rest to go can be preferred.
 *
 * "Upright" is the direction of the arm's first turning axis, the vertical of an arm that stands on the floor.
 *
 *   pose                all of it
 *   position-and-tilt   how the tool leans, all but its turn about the upright: what a 5-joint arm with a roll axis can do
 *   position-and-axis   where the tool's z axis points, all but the turn about it: what a 5-joint arm without one can do
 *   position-and-turn   only the turn about the upright: what a SCARA can do
 *   position-and-pitch  only the angle between the tool's z axis and the upright: what an arm of 4 joints in a plane can do
 *   position            nothing of the orientation
 *
 * @typedef {'pose' | 'position-and-tilt' | 'position-and-axis' | 'position-and-turn' | 'position-and-pitch' | 'position'} TaskName
 */

/** Numbers that a pose and its task need. @type {Readonly<Record<TaskName, number>>} */
export const TASK_ROWS = {
  pose: 6,
  'position-and-tilt': 5,
  'position-and-axis': 5,
  'position-and-turn': 4,
  'position-and-pitch': 4,
  position: 3,
};

/** The rotation vector that the task still has to go, after taskTurn. */
const turn = new Float64Array(3);

/** The direction that the task leaves free, or the only one that it asks for, after taskTurn. */
const axis = new Float64Array(3);

/** @param {TaskName} task whether `axis` is the only direction that counts, rather than the only one that does not */
const keepsAxis = (task) => task === 'position-and-turn' || task === 'position-and-pitch';

/**
 * The shortest rotation vector that takes one direction to another, into `turn`. Exactly opposite ones have many: the one
 * about `spare` is taken, which is across the first.
 * @param {number} a0
 * @param {number} a1
 * @param {number} a2
 * @param {number} b0
 * @param {number} b1
 * @param {number} b2
 * @param {ArrayLike<number>} across  3 numbers
 * @returns {number} its length: the angle between the directions
 */
function writeTilt(a0, a1, a2, b0, b1, b2, across) {
  const x = a1 * b2 - a2 * b1;
  const y = a2 * b0 - a0 * b2;
  const z = a0 * b1 - a1 * b0;
  const sine = Math.sqrt(x * x + y * y + z * z);
  const angle = Math.atan2(sine, a0 * b0 + a1 * b1 + a2 * b2);
  const [u, v, w] = sine === 0 ? [across[0], across[1], across[2]] : [x / sine, y / sine, z / sine];
  turn[0] = angle * u;
  turn[1] = angle * v;
  turn[2] = angle * w;
  return angle;
}

/** A direction across another one. @param {ArrayLike<number>} u @returns {[number, number, number]} */
function anyAcross(u) {
  const [x, y, z] = [u[0], u[1], u[2]];
  const [a, b, c] = Math.abs(x) < 0.6 ? [0, z, -y] : [-z, 0, x];
  const length = Math.hypot(a, b, c);
  return [a / length, b / length, c / length];
}

/** How the tool leans seen from itself, taken to what the goal asks. @param {ArrayLike<number>} T @param {ArrayLike<number>} G @param {ArrayLike<number>} up */
function writeLean(T, G, up) {
  // the goal's upright, seen from the goal, as the tool would carry it
  const x = G[0] * up[0] + G[1] * up[1] + G[2] * up[2];
  const y = G[4] * up[0] + G[5] * up[1] + G[6] * up[2];
  const z = G[8] * up[0] + G[9] * up[1] + G[10] * up[2];
  const a0 = T[0] * x + T[4] * y + T[8] * z;
  const a1 = T[1] * x + T[5] * y + T[9] * z;
  const a2 = T[2] * x + T[6] * y + T[10] * z;
  axis.set(up);
  return writeTilt(a0, a1, a2, up[0], up[1], up[2], anyAcross(up));
}

/**
 * The part of the rotation vector about the upright (swing–twist decomposition).
 * @param {ArrayLike<number>} difference
 * @param {ArrayLike<number>} up
 */
function writeTwist(difference, up) {
  const [x, y, z] = [difference[3], difference[4], difference[5]];
  const angle = Math.sqrt(x * x + y * y + z * z);
  const about = x * up[0] + y * up[1] + z * up[2];
  const twist = angle === 0 ? 0 : 2 * Math.atan2((Math.sin(angle / 2) * about) / angle, Math.cos(angle / 2));
  axis.set(up);
  for (let k = 0; k < 3; k++) turn[k] = twist * up[k];
  return Math.abs(twist);
}

/** The angle to the upright. @param {ArrayLike<number>} T @param {ArrayLike<number>} G @param {ArrayLike<number>} up */
function writePitch(T, G, up) {
  const goal = writeTilt(G[8], G[9], G[10], up[0], up[1], up[2], [0, 0, 0]);
  const across = anyAcross(up);
  const now = writeTilt(T[8], T[9], T[10], up[0], up[1], up[2], across);
  const missing = now - goal;
  for (let k = 0; k < 3; k++) {
    axis[k] = now > 0 ? turn[k] / now : across[k];
    turn[k] = missing * axis[k];
  }
  return Math.abs(missing);
}

/**
 * Radians of the orientation that the task still has to go.
 * @param {TaskName} task
 * @param {ArrayLike<number>} up    the upright, a unit vector
 * @param {ArrayLike<number>} T
 * @param {ArrayLike<number>} goal
 * @param {ArrayLike<number>} difference  poseDifference(T, goal)
 */
export function taskTurn(task, up, T, goal, difference) {
  switch (task) {
    case 'pose':
      return Math.sqrt(difference[3] * difference[3] + difference[4] * difference[4] + difference[5] * difference[5]);
    case 'position':
      return 0;
    case 'position-and-axis':
      axis[0] = T[8];
      axis[1] = T[9];
      axis[2] = T[10];
      return writeTilt(T[8], T[9], T[10], goal[8], goal[9], goal[10], [T[0], T[1], T[2]]);
    case 'position-and-tilt':
      return writeLean(T, goal, up);
    case 'position-and-turn':
      return writeTwist(difference, up);
    case 'position-and-pitch':
      return writePitch(T, goal, up);
    default: {
      /** @type {never} */
      const unknown = task;
      throw new TypeError(`Unknown task: ${unknown}`);
    }
  }
}

/**
 * The orientation rows of a residual, in place: from the whole rotation vector to what the task asks for. To be called
 * after taskTurn of the same posture.
 * @param {TaskName} task
 * @param {number} spare
 * @param {Float64Array} residual
 */
export function shapeResidual(task, spare, residual) {
  if (task === 'pose') return;
  if (task === 'position') {
    for (let k = 3; k < 6; k++) residual[k] *= spare;
    return;
  }
  const about = residual[3] * axis[0] + residual[4] * axis[1] + residual[5] * axis[2];
  for (let k = 0; k < 3; k++) {
    const rest = keepsAxis(task) ? residual[3 + k] - about * axis[k] : about * axis[k];
    residual[3 + k] = turn[k] + spare * rest;
  }
}

/**
 * The orientation rows of a Jacobian, in place, to go with shapeResidual: what the task leaves free counts as `spare`.
 * To be called after taskTurn of the same posture.
 * @param {TaskName} task
 * @param {number} spare
 * @param {Float64Array} J
 */
export function shapeJacobian(task, spare, J) {
  if (task === 'pose') return;
  const alone = keepsAxis(task);
  for (let column = 3; column < J.length; column += 6) {
    if (task === 'position') {
      for (let k = column; k < column + 3; k++) J[k] *= spare;
      continue;
    }
    const about = (1 - spare) * (J[column] * axis[0] + J[column + 1] * axis[1] + J[column + 2] * axis[2]);
    for (let k = 0; k < 3; k++)
      J[column + k] = alone ? spare * J[column + k] + about * axis[k] : J[column + k] - about * axis[k];
  }
}
