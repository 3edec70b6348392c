/** Plans asked of another thread: what goes there and what comes back are what they would be here. */
import { expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { planMotion } from '../../../src/motion/plan.js';
import { answerPlanQuestion, planQuestion } from '../../../src/motion/planQuestion.js';
import { arm } from '../kinematics/oracle.js';

/** @import { Move } from '../../../src/motion/moves.js' */

test('a plan comes back from another thread as it would be made here, tools and all', () => {
  const description = arm('puma560');
  const chain = createChain(description);
  const tool = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0.1, 1);
  const long = createChain({ ...description, tool });
  const start = Float64Array.of(0.3, 0.6, -2.6, 0.4, 0.9, 0.2);
  const limits = { rates: new Float64Array(6).fill(3), accelerations: new Float64Array(6).fill(15) };
  const T = tcpPose(long, start);
  const line = (/** @type {number} */ y, /** @type {number} */ z) => {
    const T_base_tcp = T.slice();
    T_base_tcp[13] += y;
    T_base_tcp[14] += z;
    const ending = /** @type {const} */ ({ kind: 'share', share: 0.5 });
    return /** @type {Move} */ ({
      kind: 'linear',
      T_base_tcp,
      speed: 0.2,
      turnSpeed: 1,
      acceleration: 1,
      ending,
      chain: long,
    });
  };
  /** @type {Move[]} */
  const moves = [line(0.1, 0), line(0.1, -0.1), { kind: 'wait', seconds: 0.25 }];
  const here = planMotion(chain, start, moves, limits);
  /** @type {number[]} */
  const words = [];
  const there = answerPlanQuestion(structuredClone(planQuestion(chain, start, moves, limits)), (planned) =>
    words.push(planned),
  );
  expect(structuredClone(there)).toEqual(here);
  expect(there.parts[0].notBlended).toBeNull();
  expect(there.refused).toBeNull();
  expect(words).toEqual([1, 2, 3]);
});
