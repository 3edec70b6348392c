import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { poseDifference } from '../../../src/kinematics/pose.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { MOST_STEP, followTo, hindranceOf, isOnItsWay, startFollowing } from '../../../src/model/aim/follow.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { SEED, runs } from '../../helpers/property.js';

const six = Object.values(LIBRARY).filter(({ joints }) => joints.length === 6);
const anySix = fc.constantFrom(...six);

/** @param {import('../../../src/model/document.js').Doc} doc */
const chainOf = ({ robot }) => compileRobot(robot);

/** @param {Float64Array} T @param {readonly number[]} by */
function shifted(T, by) {
  const goal = T.slice();
  by.forEach((value, i) => (goal[12 + i] += value));
  return goal;
}

/** @param {import('../../../src/model/aim/follow.js').Following} following @param {Float64Array} goal */
function untilThere(following, goal) {
  let now = followTo(following, goal);
  for (let i = 0; i < 100 && isOnItsWay(now); i++) now = followTo(now, goal);
  return now;
}

const small = fc.double({ min: -0.05, max: 0.05, noNaN: true });

test('what it answers is in the document’s units, and forward kinematics agrees where it says that it is there', () => {
  fc.assert(
    fc.property(anySix, fc.tuple(small, small, small), (robot, by) => {
      const doc = newDocument(robot);
      const chain = chainOf(doc);
      const goal = shifted(tcpPose(chain, compilePosture(robot, doc.posture)), by);
      const now = untilThere(startFollowing(doc, chain, true), goal);
      const q = compilePosture(robot, now.posture);
      const [x, y, z, rx, ry, rz] = poseDifference(tcpPose(chain, q), goal);
      if (now.answer?.status === 'there') expect(Math.hypot(x, y, z, rx, ry, rz)).toBeLessThan(1e-7);
      else expect(hindranceOf(now)?.metres).toBeCloseTo(Math.hypot(x, y, z), 7);
    }),
    { seed: SEED, numRuns: runs(40) },
  );
});

test('a goal where the tool is already moves no joint, and keeps every digit', () => {
  for (const robot of six) {
    const doc = newDocument(robot);
    const chain = chainOf(doc);
    const now = followTo(startFollowing(doc, chain, true), tcpPose(chain, compilePosture(robot, doc.posture)));
    expect(now.posture).toEqual(doc.posture);
  }
});

test('there and back, over the edge of the reach too, the posture returns; no joint goes too fast', () => {
  for (const robot of six.slice(0, 6)) {
    const doc = newDocument(robot);
    const chain = chainOf(doc);
    const begin = tcpPose(chain, compilePosture(robot, doc.posture));
    let now = untilThere(startFollowing(doc, chain, true), begin);
    const far = 1.5 * chain.reach;
    for (const share of [0.05, 0.2, 1, 0.2, 0.05, 0]) {
      for (let i = 0; i < 40; i++) {
        const next = followTo(now, shifted(begin, [share * far, 0, 0]));
        next.q.forEach((value, k) => expect(Math.abs(value - now.q[k])).toBeLessThanOrEqual(MOST_STEP * (1 + 1e-9)));
        now = next;
      }
      if (share === 1) expect(hindranceOf(now)).not.toBeNull();
    }
    if (now.answer?.status === 'there') now.posture.forEach((value, i) => expect(value).toBeCloseTo(doc.posture[i], 5));
  }
});

describe('limits', () => {
  const puma = newDocument(LIBRARY.puma560);
  const robot = { ...puma.robot, joints: puma.robot.joints.with(0, { ...puma.robot.joints[0], lower: -5, upper: 5 }) };
  const sideways = (/** @type {typeof puma} */ doc) =>
    shifted(tcpPose(chainOf(doc), compilePosture(doc.robot, doc.posture)), [0, 0.3, 0]);

  test('stop it, and the joint is named', () => {
    const doc = { ...puma, robot };
    const now = untilThere(startFollowing(doc, chainOf(doc), true), sideways(doc));
    expect(hindranceOf(now)).toMatchObject({ kind: 'limit', joint: 0 });
    expect(now.posture[0]).toBeCloseTo(5, 9);
  });
  test('do not where they are not kept', () => {
    const doc = { ...puma, robot };
    const now = untilThere(startFollowing(doc, chainOf(doc), false), sideways(doc));
    expect(now.posture[0]).toBeGreaterThan(6);
    expect(hindranceOf(now)).toBeNull();
  });
  test('throw no joint back that stands outside them', () => {
    const doc = { ...puma, robot, posture: puma.posture.with(0, 20) };
    const begin = startFollowing(doc, chainOf(doc), true);
    const now = followTo(begin, shifted(tcpPose(begin.chain, begin.q), [0, 0, 0.01]));
    expect(now.posture[0]).toBeCloseTo(20, 6);
  });
});

test('an arm with four joints keeps what it can, and says what it cannot', () => {
  const doc = newDocument(LIBRARY.scara_cobra600);
  const chain = chainOf(doc);
  const T = tcpPose(chain, compilePosture(doc.robot, doc.posture));
  expect(hindranceOf(untilThere(startFollowing(doc, chain, true), shifted(T, [-0.02, 0.01, 0])))).toBeNull();
});
