/**
 * What of a pose an arm with few joints is asked to meet. A task takes the six-row residual and Jacobian of the whole pose
 * and leaves of the orientation only what it asks for; the rest it keeps with the weight `spare`, so that among the
 * postures that meet the task one with little of the rest to go can be preferred.
 *
 * @typedef {'pose' | 'position-and-axis' | 'position'} TaskName
 */

const axis = new Float64Array(3);

/**
 * The shortest rotation vector that takes the tool's z axis to the goal's, into `out`. Exactly opposite axes have many:
 * the one about the tool's x is taken.
 * @param {ArrayLike<number>} T  the tool
 * @param {ArrayLike<number>} goal
 * @param {Float64Array} out  3 numbers
 * @returns {number} its length: the angle between the axes
 */
function writeTilt(T, goal, out) {
  const x = T[9] * goal[10] - T[10] * goal[9];
  const y = T[10] * goal[8] - T[8] * goal[10];
  const z = T[8] * goal[9] - T[9] * goal[8];
  const sine = Math.sqrt(x * x + y * y + z * z);
  const cosine = T[8] * goal[8] + T[9] * goal[9] + T[10] * goal[10];
  const angle = Math.atan2(sine, cosine);
  if (sine === 0) {
    out[0] = angle * T[0];
    out[1] = angle * T[1];
    out[2] = angle * T[2];
  } else {
    out[0] = (x * angle) / sine;
    out[1] = (y * angle) / sine;
    out[2] = (z * angle) / sine;
  }
  return angle;
}

/**
 * Radians of the orientation that the task still has to go.
 * @param {TaskName} task
 * @param {ArrayLike<number>} T
 * @param {ArrayLike<number>} goal
 * @param {ArrayLike<number>} difference  poseDifference(T, goal)
 */
export function taskTurn(task, T, goal, difference) {
  if (task === 'position') return 0;
  if (task === 'position-and-axis') return writeTilt(T, goal, axis);
  return Math.sqrt(difference[3] * difference[3] + difference[4] * difference[4] + difference[5] * difference[5]);
}

/**
 * The orientation rows of a residual, in place: from the whole rotation vector to what the task asks for.
 * @param {TaskName} task
 * @param {number} spare
 * @param {Float64Array} T
 * @param {Float64Array} goal
 * @param {Float64Array} residual
 */
export function shapeResidual(task, spare, T, goal, residual) {
  if (task === 'position') {
    for (let k = 3; k < 6; k++) residual[k] *= spare;
  } else if (task === 'position-and-axis') {
    const twist = spare * (residual[3] * T[8] + residual[4] * T[9] + residual[5] * T[10]);
    writeTilt(T, goal, axis);
    for (let k = 0; k < 3; k++) residual[3 + k] = axis[k] + twist * T[8 + k];
  }
}

/**
 * The orientation rows of a Jacobian, in place, to go with shapeResidual: turning about the tool's z changes no tilt.
 * @param {TaskName} task
 * @param {number} spare
 * @param {Float64Array} T
 * @param {Float64Array} J
 */
export function shapeJacobian(task, spare, T, J) {
  if (task === 'pose') return;
  for (let column = 3; column < J.length; column += 6) {
    if (task === 'position') {
      for (let k = column; k < column + 3; k++) J[k] *= spare;
    } else {
      const lost = (1 - spare) * (J[column] * T[8] + J[column + 1] * T[9] + J[column + 2] * T[10]);
      for (let k = 0; k < 3; k++) J[column + k] -= lost * T[8 + k];
    }
  }
}
