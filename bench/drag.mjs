/**
 * One frame of a drag: the arm follows the pose under the pointer, and the document takes the posture. Paths go through
 * the whole space of each arm, over limits, singularities and the edge of the reach, since people drag there too.
 *
 * @import { BenchRow } from './run.mjs'
 */
import { tcpPose } from '../src/kinematics/forward.js';
import { createRandom } from '../src/kinematics/random.js';
import { compilePosture, compileRobot } from '../src/model/compile.js';
import { followTo, startFollowing } from '../src/model/aim/follow.js';
import { LIBRARY, newDocument } from '../src/model/library.js';
import { reduce, startState } from '../src/model/session.js';
import { median, quantile } from './measure.mjs';

const ARMS = ['puma560', 'ur5', 'kuka_kr6_r900', 'abb_irb120', 'fanuc_lrmate200id'];
const DRAGS = 12;
const FRAMES = 60;
const METRES = 0.012; // in a frame: 0.7 m in a second

/** @returns {BenchRow[]} */
export function bench() {
  const random = createRandom(560);
  /** @type {number[]} */
  const times = [];
  const names = ARMS.filter((name) => name in LIBRARY);
  for (let turn = -1; turn < DRAGS; turn++) {
    for (const name of names) {
      let state = startState(newDocument(LIBRARY[name]));
      const { doc } = state;
      const chain = compileRobot(doc.robot);
      const goal = tcpPose(chain, compilePosture(doc.robot, doc.posture)).slice();
      const way = [random(), random(), random()].map((value) => 2 * value - 1);
      const length = Math.hypot(...way);
      let following = startFollowing(doc, chain, true);
      for (let frame = 0; frame < FRAMES; frame++) {
        const back = frame >= FRAMES / 2 ? -1 : 1;
        way.forEach((value, i) => (goal[12 + i] += (back * METRES * value) / length));
        const begun = performance.now();
        following = followTo(following, goal);
        state = reduce(state, { type: 'set-posture', posture: following.posture, gesture: 'drag' });
        if (turn >= 0) times.push(performance.now() - begun); // the first turn is for the compiler
      }
    }
  }
  const note = `${names.join(', ')}; ${times.length} frames`;
  return [
    {
      name: 'one frame of a drag: follow and update, rendering aside',
      unit: 'ms',
      median: median(times),
      target: { of: 'median', atMost: 2 },
      note,
    },
    {
      name: 'one frame of a drag: 95 of 100 are quicker than',
      unit: 'ms',
      median: quantile(times, 0.95),
      target: { of: 'median', atMost: 6 },
      note,
    },
  ];
}
