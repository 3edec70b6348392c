/**
 * What an arm with fewer than six joints can be asked for when a whole pose is too much: the tasks that its joints are
 * enough for, from the richest to the poorest.
 *
 * @import { Chain } from '../chain.js'
 * @import { TaskName } from './task.js'
 *
 * @typedef {'position' | 'tilt' | 'tool-axis' | 'pitch' | 'turn-about-upright' | 'turn-about-tool-axis' | 'orientation'} TaskPart
 *
 * @typedef {object} LesserTask   what is met of a goal, and what is not up to the arm
 * @property {Exclude<TaskName, 'pose'>} name
 * @property {readonly TaskPart[]} met
 * @property {readonly TaskPart[]} free
 */
import { tcpPose } from '../forward.js';
import { geometricJacobian } from '../jacobian.js';
import { fillRandomPosture } from '../limits.js';
import { leadingJoint } from '../parallelAxes.js';
import { createRandom } from '../random.js';
import { screwsOf } from '../screws.js';
import { TASK_ROWS, shapeJacobian, taskTurn } from './task.js';

/** With this many joints or more an arm is meant to meet whole poses, and half an answer is none. */
const FULL_POSE_JOINTS = 6;

/** @type {readonly LesserTask[]} */
const TASKS = [
  { name: 'position-and-tilt', met: ['position', 'tilt'], free: ['turn-about-upright'] },
  { name: 'position-and-axis', met: ['position', 'tool-axis'], free: ['turn-about-tool-axis'] },
  { name: 'position-and-turn', met: ['position', 'turn-about-upright'], free: ['tilt'] },
  { name: 'position-and-pitch', met: ['position', 'pitch'], free: ['turn-about-upright', 'turn-about-tool-axis'] },
  { name: 'position', met: ['position'], free: ['orientation'] },
];

/** A direction that is left of a column after the others, shorter than this (in radians or arm lengths), is none. */
const NOTHING = 1e-7;

/** Postures at which an arm is tried; one may happen to be singular. */
const TRIALS = 3;

/**
 * The direction of the first turning axis, in root axes; of the first joint if none turns.
 * @param {Chain} chain
 * @returns {[number, number, number]}
 */
export function uprightOf(chain) {
  const { start } = chain.packed;
  const first = Math.max(
    0,
    chain.joints.findIndex(({ type }) => type === 'revolute'),
  );
  const [x, y, z] = screwsOf(chain).axes.subarray(3 * first, 3 * first + 3);
  const [a, b, c] = [0, 1, 2].map((k) => start[k] * x + start[4 + k] * y + start[8 + k] * z);
  const length = Math.hypot(a, b, c);
  return [a / length, b / length, c / length];
}

/**
 * The rank of a 6 · n matrix, by Gram and Schmidt with pivoting.
 * @param {Float64Array} J  overwritten
 */
function rankOf(J) {
  const columns = Array.from({ length: J.length / 6 }, (_, i) => J.subarray(6 * i, 6 * i + 6));
  for (let rank = 0; ; rank++) {
    columns.sort((a, b) => Math.hypot(...b) - Math.hypot(...a));
    const [longest] = columns;
    const length = longest ? Math.hypot(...longest) : 0;
    if (length < NOTHING) return rank;
    const unit = longest.map((value) => value / length);
    for (const column of columns) {
      const along = column.reduce((sum, value, k) => sum + value * unit[k], 0);
      for (let k = 0; k < 6; k++) column[k] -= along * unit[k];
    }
    columns.shift();
  }
}

/**
 * How many independent things of a task the arm can change, at the best of a few postures.
 * @param {Chain} chain
 * @param {TaskName} task
 * @param {readonly number[]} up
 */
function rankFor(chain, task, up) {
  const random = createRandom(1);
  const q = new Float64Array(chain.dof);
  let most = 0;
  for (let trial = 0; trial < TRIALS; trial++) {
    fillRandomPosture(chain.packed, random, chain.characteristicLength, q);
    const J = geometricJacobian(chain, q);
    for (let i = 0; i < J.length; i++) {
      if (i % 6 < 3 && chain.joints[Math.floor(i / 6)].type === 'revolute') J[i] /= chain.characteristicLength;
    }
    const T = tcpPose(chain, q);
    taskTurn(task, up, T, T, new Float64Array(6));
    shapeJacobian(task, 0, J);
    most = Math.max(most, rankOf(J));
  }
  return most;
}

/**
 * @param {Chain} chain
 * @returns {readonly LesserTask[]}
 */
function tasksFor(chain) {
  if (chain.dof >= FULL_POSE_JOINTS) return [];
  const up = uprightOf(chain);
  const rank = (/** @type {TaskName} */ name) => rankFor(chain, name, up);
  const isFlat = leadingJoint(chain) >= 0;
  const canTurn = rank('position-and-turn') > rank('position');
  return TASKS.filter(({ name }) => {
    if (name === 'position') return true;
    // All turning axes upright: how the tool leans is given, and right or wrong whatever the posture. Its turn is the arm's
    // to choose, or follows from the position.
    if (isFlat) return name === (canTurn ? 'position-and-turn' : 'position-and-tilt');
    return rank(name) === TASK_ROWS[name];
  });
}

/** @type {WeakMap<Chain, readonly LesserTask[]>} */
const known = new WeakMap();

/** @param {Chain} chain @returns {readonly LesserTask[]} none for an arm with six joints or more */
export function lesserTasks(chain) {
  let tasks = known.get(chain);
  if (!tasks) {
    tasks = tasksFor(chain);
    known.set(chain, tasks);
  }
  return tasks;
}
