/** Planned motions among obstacles: each move that touches is told, where and when it first does; judged by a planar arm's own trigonometry. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { armBodies } from '../../../src/motion/clearance/armBodies.js';
import { checkPlan } from '../../../src/motion/clearance/checkPlan.js';
import { createWorkcell } from '../../../src/motion/clearance/workcell.js';
import { planMotion } from '../../../src/motion/plan.js';
import { planMomentAt } from '../../../src/motion/planMoment.js';
import { SEED, runs } from '../../helpers/property.js';

/** @import { Move } from '../../../src/motion/moves.js' */

const LONG = 0.5;
const THICK = 0.03;
const BALL = 0.1;
const joint = { type: /** @type {const} */ ('revolute'), theta: 0, d: 0, a: LONG, alpha: 0, lower: -9, upper: 9 };
const chain = createChain({ convention: 'standard', joints: [joint, joint] });
const limits = { rates: Float64Array.of(1, 1), accelerations: Float64Array.of(4, 4) };
const bodies = armBodies(chain, [THICK, THICK]);

/** @param {readonly number[]} posture @param {Partial<Move>} [more] @returns {Move} */
const joints = (posture, more = {}) =>
  /** @type {Move} */ ({
    ...{ kind: 'joint', posture: Float64Array.from(posture), speed: 1, acceleration: 1, ending: { kind: 'fine' } },
    ...more,
  });

/** @param {readonly number[][]} centres */
const among = (centres) =>
  createWorkcell(
    bodies,
    centres.map((centre) => ({ kind: /** @type {const} */ ('sphere'), centre, radius: BALL })),
  );

/** @param {ReturnType<typeof among>} cell @param {ReturnType<typeof planMotion>} plan @param {{ margin?: number }} [options] */
function checked(cell, plan, options) {
  const check = checkPlan(() => cell, plan, options);
  const shares = [];
  for (;;) {
    const turn = check.next();
    if (turn.done) return { found: turn.value, shares };
    shares.push(turn.value);
  }
}

/** Between the ball and the arm's two links, by hand. @param {ArrayLike<number>} q @param {readonly number[]} ball */
function gap(q, [x, y]) {
  const elbow = [LONG * Math.cos(q[0]), LONG * Math.sin(q[0])];
  const tip = [elbow[0] + LONG * Math.cos(q[0] + q[1]), elbow[1] + LONG * Math.sin(q[0] + q[1])];
  const apart = (/** @type {number[]} */ [ax, ay], /** @type {number[]} */ [bx, by]) => {
    const share = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / LONG ** 2;
    const s = Math.min(1, Math.max(0, share));
    return Math.hypot(x - ax - s * (bx - ax), y - ay - s * (by - ay));
  };
  return Math.min(apart([0, 0], elbow), apart(elbow, tip)) - THICK - BALL;
}

/** s between looks of the oracle, and m: the resolution, and what the arm goes in that time. */
const STEP = 5e-4;
const NEAR = 1e-3 + 1.5 * STEP;

const place = fc.double({ min: -1, max: 1, noNaN: true });
const angle = fc.double({ min: -2, max: 2, noNaN: true });

test('a move is told of where it first touches, to a millimetre, and never where it is clear', () => {
  fc.assert(
    fc.property(
      fc.tuple(angle, angle, angle, angle),
      fc.tuple(place, place),
      fc.constantFrom(0, 0.02),
      (q, [x, y], margin) => {
        const start = Float64Array.of(q[0], q[1]);
        fc.pre(gap(start, [x, y]) > margin + 0.002);
        const plan = planMotion(chain, start, [joints([q[2], q[3]])], limits);
        const { found } = checked(among([[x, y, 0]]), plan, { margin });
        let [before, least] = [Infinity, Infinity];
        for (let t = 0; t <= plan.duration; t += STEP) {
          const far = gap(planMomentAt(plan, t).posture, [x, y]);
          least = Math.min(least, far);
          if (found.length > 0 && t < found[0].time) before = Math.min(before, far);
        }
        if (least <= 0) expect(found).toMatchObject([{ move: 0, isTouch: true, near: { obstacle: 0 } }]);
        else if (least > margin + NEAR) expect(found).toEqual([]);
        if (found.length === 0) return;
        const { posture, time, isTouch } = found[0];
        const kept = isTouch ? 0 : margin;
        expect(Math.abs(gap(posture, [x, y]) - kept)).toBeLessThan(NEAR);
        expect(before).toBeGreaterThan(kept - NEAR);
        expect(planMomentAt(plan, time).posture.every((value, j) => Math.abs(value - posture[j]) < 1e-6)).toBe(true);
      },
    ),
    { seed: SEED, numRuns: runs(20) },
  );
});

test('what comes near and then touches, touches; what only comes near is told of with a margin alone', () => {
  const plan = planMotion(chain, Float64Array.of(-0.8, 0), [joints([0.8, 0]), joints([1.5, 0])], limits);
  const touching = checked(among([[0.6, 0, 0]]), plan, { margin: 0.05 });
  expect(touching.found).toMatchObject([{ move: 0, isTouch: true }]);
  expect(touching.shares.at(-1)).toBe(1);
  const high = among([[0.6, 0, THICK + BALL + 0.02]]);
  expect(checked(high, plan).found).toEqual([]);
  expect(checked(high, plan, { margin: 0.01 }).found).toEqual([]);
  expect(checked(high, plan, { margin: 0.05 }).found).toMatchObject([
    { move: 0, isTouch: false, near: { obstacle: 0 } },
  ]);
});

test('a wait is not told of again, and moves that go on into each other are told of by the move they belong to', () => {
  /** @type {Move[]} */
  const moves = [joints([0, 0]), { kind: 'wait', seconds: 1 }, joints([0.8, 0]), joints([1.6, 0])];
  const plan = planMotion(chain, Float64Array.of(-0.8, 0), moves, limits);
  expect(checked(among([[0.6, 0, 0]]), plan).found.map(({ move }) => move)).toEqual([0, 2]);
  const blended = planMotion(
    chain,
    Float64Array.of(-0.8, 0),
    [joints([0.8, 0], { ending: { kind: 'share', share: 0.5 } }), joints([0.8, 1])],
    limits,
  );
  expect(blended.parts[0].notBlended).toBeNull();
  expect(checked(among([[0.6, 0, 0]]), blended).found.map(({ move }) => move)).toEqual([0]);
});

test('a margin is kept to obstacles, not by the arm to itself: how near its links come is how it is built', () => {
  const three = createChain({ convention: 'standard', joints: [joint, joint, joint] });
  const arm = armBodies(three, [THICK, THICK, THICK]);
  // the third link comes back over the first, half a metre above it
  const start = Float64Array.of(0, Math.PI / 2, Math.PI / 2 - 0.1);
  const move = joints([0, Math.PI / 2, Math.PI / 2]);
  const plan = planMotion(three, start, [move], {
    rates: Float64Array.of(1, 1, 1),
    accelerations: Float64Array.of(4, 4, 4),
  });
  expect(checked(createWorkcell(arm, []), plan, { margin: 10 }).found).toEqual([]);
  const folded = planMotion(three, start, [joints([0, 3, 3])], {
    rates: Float64Array.of(1, 1, 1),
    accelerations: Float64Array.of(4, 4, 4),
  });
  expect(checked(createWorkcell(arm, []), folded).found).toMatchObject([{ isTouch: true, near: { obstacle: null } }]);
});
