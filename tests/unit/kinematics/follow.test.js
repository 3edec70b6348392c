import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { followPose } from '../../../src/kinematics/follow.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { SEED, runs } from '../../helpers/property.js';
import { angleBetween, columnMajor, distanceBetween, oracleForward, rodrigues, times } from './oracle.js';
import { ALL_ARMS, poseOf, publishedArm, withSixJoints } from './publishedArms.js';

/**
 * @import { ChainDescription } from '../../../src/kinematics/chain.js'
 * @import { Followed, FollowOptions } from '../../../src/kinematics/follow.js'
 * @import { Matrix } from './oracle.js'
 */

const SIX = ALL_ARMS.filter(withSixJoints);
const MOST_STEP = 0.35;

/** @param {ChainDescription} description @param {() => number} random */
const anyPosture = ({ joints }, random) =>
  [...joints].map(({ lower = -Infinity, upper = Infinity }) => {
    const [low, high] = [Math.max(lower, -3), Math.min(upper, 3)];
    return low + (high - low) * (0.1 + 0.8 * random());
  });

/** @param {Matrix} pose @param {readonly number[]} by */
const shifted = (pose, by) => pose.map((row, i) => row.map((value, j) => (i < 3 && j === 3 ? value + by[i] : value)));

/** Turned about the place where it is. @param {Matrix} pose @param {readonly number[]} axis @param {number} angle */
function turned(pose, axis, angle) {
  const R = times(
    rodrigues([...axis], angle),
    pose.slice(0, 3).map((row) => row.slice(0, 3)),
  );
  return [...R.map((row, i) => [...row, pose[i][3]]), [0, 0, 0, 1]];
}

/**
 * A drag: the goals one after the other, and what must hold of every answer.
 * @param {ChainDescription} description
 * @param {readonly number[]} q
 * @param {readonly Matrix[]} goals
 * @param {FollowOptions} [options]
 * @returns {Followed[]}
 */
function drag(description, q, goals, options) {
  const chain = createChain(description);
  /** @type {Pick<Followed, 'q' | 'bent'>} */
  let at = { q: Float64Array.from(q), bent: null };
  return goals.map((goal) => {
    const next = followPose(chain, at, columnMajor(goal), options);
    next.q.forEach((value, i) => {
      const { lower = -Infinity, upper = Infinity, type } = description.joints[i];
      expect(value >= lower && value <= upper).toBe(true);
      const unit = type === 'prismatic' ? chain.characteristicLength : 1;
      expect(Math.abs(value - at.q[i]) / unit).toBeLessThanOrEqual((options?.mostStep ?? MOST_STEP) * (1 + 1e-9));
    });
    const { tcp } = oracleForward(description, [...next.q]);
    expect(next.positionError).toBeCloseTo(distanceBetween(tcp, goal), 10);
    if (next.status === 'there' && next.task === 'pose') {
      expect(distanceBetween(tcp, goal)).toBeLessThan(1.1e-9);
      expect(angleBetween(tcp, goal)).toBeLessThan(1.1e-9);
    }
    at = next;
    return next;
  });
}

/** From 0 to 1 and back. @param {number} steps */
const thereAndBack = (steps) =>
  Array.from({ length: 2 * steps }, (_, k) => (k < steps ? k + 1 : 2 * steps - k - 1) / steps);

/** @param {readonly number[]} a @param {ArrayLike<number>} b */
const apart = (a, b) => Math.max(...a.map((value, i) => Math.abs(value - b[i])));

/**
 * The arm is back where it was: as far as the pose tells, which next to a singularity is not to the last digits. The tool then
 * stays where it is all the way between the two; towards another branch it would not.
 * @param {ChainDescription} description @param {readonly number[]} q @param {ArrayLike<number>} back
 */
function expectBack(description, q, back) {
  if (apart(q, back) < 1e-6) return;
  expect(apart(q, back)).toBeLessThan(1e-4);
  const { tcp: goal } = oracleForward(description, [...q]);
  for (const share of [0.25, 0.5, 0.75, 1]) {
    const { tcp } = oracleForward(
      description,
      q.map((value, i) => value + share * (back[i] - value)),
    );
    expect(distanceBetween(tcp, goal)).toBeLessThan(1.1e-9);
    expect(angleBetween(tcp, goal)).toBeLessThan(1.1e-9);
  }
}

describe('a tool that is pulled along', () => {
  test.each(SIX)('%s: 200 mm anywhere and back, and the posture is what it was', (name) => {
    const description = publishedArm(name);
    const random = createRandom(SEED);
    let returned = 0;
    for (let k = 0; k < runs(8); k++) {
      const q = anyPosture(description, random);
      const by = [random() - 0.5, random() - 0.5, random() - 0.5];
      const length = Math.hypot(...by);
      const goals = thereAndBack(12).map((share) =>
        shifted(
          poseOf(name, q),
          by.map((value) => (0.2 * share * value) / length),
        ),
      );
      const answers = drag(description, q, goals);
      if (answers.some(({ status }) => status !== 'there')) continue; // something was in the way: another test
      returned++;
      expectBack(description, q, answers[answers.length - 1].q);
    }
    expect(returned).toBeGreaterThan(0);
  });

  test('close to a singularity, where another branch is near, the arm stays on its own', () => {
    const description = publishedArm('ur5');
    const random = createRandom(20261123);
    const ways = Array.from({ length: 130 }, () => ({
      q: anyPosture(description, random),
      by: [random() - 0.5, random() - 0.5, random() - 0.5],
    }));
    const { q, by } = ways[129]; // of which coming back led 0.19 rad away
    const goals = thereAndBack(12).map((share) =>
      shifted(
        poseOf('ur5', q),
        by.map((value) => (0.2 * share * value) / Math.hypot(...by)),
      ),
    );
    const answers = drag(description, q, goals);
    expect(answers.every(({ status }) => status === 'there')).toBe(true);
    expect(apart(q, answers[answers.length - 1].q)).toBeLessThan(1e-6);
  });

  test('a goal that turns is followed as well', () => {
    const random = createRandom(SEED);
    for (let k = 0; k < runs(20); k++) {
      const description = publishedArm('puma560');
      const q = anyPosture(description, random).map((value, i) => (i === 4 ? 0.8 : value / 2));
      const axis = [0.6, -0.64, 0.48];
      const goals = thereAndBack(10).map((share) => turned(poseOf('puma560', q), axis, 0.4 * share));
      const answers = drag(description, q, goals);
      if (answers.every(({ status }) => status === 'there'))
        expect(apart(q, answers[answers.length - 1].q)).toBeLessThan(1e-6);
    }
  });

  test.each([
    ['planar2r', [0.4, 0.9]],
    ['planar2r', [0.4, -0.9]],
    ['puma560', [0.3, 0.4, 0.5, 0.3, 0.9, 0.2]],
    ['puma560', [0.3, -0.7, -2.9, 0.3, 0.9, 0.2]],
    ['ur5', [0.3, -1.0, 1.2, -1.4, -1.3, 0.2]],
    ['ur5', [0.3, -0.2, -1.2, -0.4, -1.3, 0.2]],
  ])('%s at %j: out of the reach, along the edge, and back with the same elbow', (name, q) => {
    const description = publishedArm(name);
    const pose = poseOf(name, q);
    const [x, y, z] = [0, 1, 2].map((i) => pose[i][3]);
    const length = Math.hypot(x, y, z);
    const out = [x / length, y / length, name === 'planar2r' ? 0 : z / length];
    const aside = [-out[1], out[0], 0];
    const far = 2.5;
    const goals = [];
    for (let k = 1; k <= 20; k++)
      goals.push(
        shifted(
          pose,
          out.map((value) => (value * far * k) / 20),
        ),
      );
    for (let k = 1; k <= 10; k++)
      goals.push(
        shifted(
          pose,
          out.map((value, i) => value * far + (0.6 * aside[i] * k) / 10),
        ),
      );
    for (let k = 9; k >= 0; k--)
      goals.push(
        shifted(
          pose,
          out.map((value, i) => value * far + (0.6 * aside[i] * k) / 10),
        ),
      );
    for (let k = 19; k >= 0; k--)
      goals.push(
        shifted(
          pose,
          out.map((value) => (value * far * k) / 20),
        ),
      );
    for (let k = 0; k < 20; k++) goals.push(pose);
    const answers = drag(description, q, goals);
    expect(answers.map(({ status }) => status)).toContain('reach');
    expect(answers[answers.length - 1].status).toBe('there');
    expect(apart(q, answers[answers.length - 1].q)).toBeLessThan(1e-6);
  });

  test('through the singular wrist no joint goes farther than it may, and the goal is met in the end', () => {
    const name = 'puma560';
    for (const beside of [0, 1e-9, 1e-5, 1e-3, 0.01]) {
      const q = [0.2, 0.3, 0.4, 0.1, 0.35, -0.2];
      const bent = poseOf(name, q);
      // turning about axis 5, which the wrist passes straight, or a little to the side
      const axis = [0, 1, 2].map((i) => bent[i][1]);
      const tilted = axis.map((value, i) => value + beside * bent[i][0]);
      const goals = Array.from({ length: 30 }, (_, k) => turned(bent, tilted, (0.7 * (k + 1)) / 30));
      const last = goals[goals.length - 1];
      for (let k = 0; k < 30; k++) goals.push(last);
      const answers = drag(publishedArm(name), q, goals);
      expect(answers[answers.length - 1].status).toBe('there');
      expect(answers[answers.length - 1].q[4]).toBeGreaterThan(0.3); // by joint 4, on the same branch
    }
  });

  test('a limit in the way is named, and the arm waits beside it', () => {
    const description = publishedArm('puma560');
    const q = [2.6, 0.3, 0.4, 0.3, 0.9, 0.2];
    const pose = poseOf('puma560', q);
    const about = (/** @type {number} */ angle) => {
      const turn = [...rodrigues([0, 0, 1], angle).map((row) => [...row, 0]), [0, 0, 0, 1]];
      return times(turn, pose);
    };
    const answers = drag(
      description,
      q,
      thereAndBack(12).map((share) => about(0.5 * share)),
    );
    const blocked = answers.filter(({ status }) => status === 'limit');
    expect(blocked.length).toBeGreaterThan(3);
    for (const { joint } of blocked) expect(joint).toBe(0);
    expect(apart(q, answers[answers.length - 1].q)).toBeLessThan(1e-6);
  });

  test('a joint with more room than a turn waits at its limit, too, and does not go round to the other', () => {
    const past = 0.1;
    const wide = SIX.filter((name) => {
      const { lower = -Infinity, upper = Infinity } = publishedArm(name).joints[5];
      return upper - lower > 2 * Math.PI && upper < Infinity;
    });
    expect(wide.length).toBeGreaterThan(3);
    /** @type {[string, number][]} */
    const cases = wide.map((name) => [name, SEED]);
    cases.push(['fanuc_lrmate200id', 777001]); // elbow nearly straight: what is nearest to the goal is past the branch's edge
    for (const [name, seed] of cases) {
      const description = publishedArm(name);
      const { upper = Infinity } = description.joints[5];
      const q = anyPosture(description, createRandom(seed)).with(5, upper - 0.02);
      // what the last joint would do on its own
      const axis = oracleForward(description, q).tcp;
      const beyond = q.with(5, upper + past);
      const goals = Array.from({ length: 12 }, () => poseOf(name, beyond));
      const answers = drag(description, q, [...goals, axis, axis, axis]);
      for (const { status, joint } of answers.slice(3, 12)) expect([name, status, joint]).toEqual([name, 'limit', 5]);
      expect(apart(Array.from(answers[3].q), answers[11].q)).toBeLessThan(1e-6);
      expect(apart(q, answers[answers.length - 1].q)).toBeLessThan(1e-6);
    }
  });

  test('a goal far away is approached frame by frame, and met as soon as the joints can', () => {
    const description = publishedArm('ur5');
    const q = [0, -1, 1, -1, -1.3, 0];
    const there = [1.2, -1.3, 1.6, -0.6, -0.8, 1];
    const goal = poseOf('ur5', there);
    const answers = drag(
      description,
      q,
      Array.from({ length: 20 }, () => goal),
    );
    const statuses = answers.map(({ status }) => status);
    expect(statuses[0]).toBe('behind');
    const met = statuses.indexOf('there');
    expect(met).toBeGreaterThanOrEqual(3); // 1.2 rad in steps of 0.35
    expect(statuses.slice(met).every((status) => status === 'there')).toBe(true);
  });

  test.each(ALL_ARMS.filter((name) => !withSixJoints(name)))('%s follows in the task that it can meet', (name) => {
    const description = publishedArm(name);
    const random = createRandom(SEED);
    for (let k = 0; k < runs(5); k++) {
      const q = anyPosture(description, random);
      const to = q.map((value, i) => value + (description.joints[i].type === 'prismatic' ? 0.01 : 0.1) * random());
      const inside = to.every((value, i) => value <= (description.joints[i].upper ?? Infinity));
      const goals = [0.25, 0.5, 0.75, 1, 1, 1].map((share) =>
        poseOf(
          name,
          q.map((value, i) => value + share * (to[i] - value)),
        ),
      );
      const answers = drag(description, q, goals);
      if (inside) expect(['there', 'singularity']).toContain(answers[answers.length - 1].status);
    }
  });

  test('whatever the goals, every answer is true, inside the limits, and no farther than a joint may go', () => {
    fc.assert(
      fc.property(
        fc.constantFrom(...ALL_ARMS),
        fc.nat(1e6),
        fc.array(fc.tuple(...[0, 1, 2, 3].map(() => fc.double({ min: -1, max: 1, noNaN: true }))), {
          minLength: 3,
          maxLength: 6,
        }),
        (name, seed, moves) => {
          const description = publishedArm(name);
          const q = anyPosture(description, createRandom(seed));
          const pose = poseOf(name, q);
          const goals = moves.map(([x, y, z, angle]) => turned(shifted(pose, [x, y, z]), [0.48, 0.6, 0.64], angle));
          drag(description, q, goals);
        },
      ),
      { seed: SEED, numRuns: runs(60) },
    );
  });

  test('wrong calls throw with what was expected', () => {
    const chain = createChain(publishedArm('planar2r'));
    const goal = columnMajor(poseOf('planar2r', [0.1, 0.2]));
    expect(() => followPose(chain, { q: [0] }, goal)).toThrow('Expected 2 joint values, got 1.');
    expect(() => followPose(chain, { q: [0, NaN] }, goal)).toThrow('finite');
    expect(() => followPose(chain, { q: [0, 1] }, goal, { mostStep: 0 })).toThrow('Expected mostStep to be positive');
    expect(() => followPose(chain, { q: [0, 1] }, [1, 2])).toThrow('a pose');
  });
});
