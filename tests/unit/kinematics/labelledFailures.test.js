/**
 * A thousand goals that cannot be met, labelled by construction (tests/fixtures/kinematics/makeFailures.py): does the kernel
 * know why? The quick run takes every fifth; the deep one all.
 */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { inverseKinematics } from '../../../src/kinematics/inverse.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { SEED, runs } from '../../helpers/property.js';
import { expectHonest } from './honest.js';
import { columnMajor, fromLine, oracleForward } from './oracle.js';
import { ALL_ARMS, fixture, publishedArm } from './publishedArms.js';

/** @import { InverseResult } from '../../../src/kinematics/inverse.js' */
/** @import { Matrix } from './oracle.js' */

/** @typedef {'out-of-reach' | 'orientation' | 'limits' | 'task' | 'either'} Label */
/** @typedef {{ name: string, label: Label, goal: Matrix, numbers: number[] }} Failure */

/** The reason that goes with a label. */
const REASON = { 'out-of-reach': 'distance', orientation: 'orientation', limits: 'limits', task: 'joints' };
/** The statuses that may go with a reason; without a proof it is `stalled`. */
const STATUSES = {
  'out-of-reach': ['unreachable', 'stalled'],
  orientation: ['unreachable', 'stalled'],
  limits: ['outside-limits'],
  task: ['subspace'],
};
const RIGHT = 0.98;

const { arms } = /** @type {{ arms: Record<string, [Label, ...number[]][]> }} */ (fixture('failures.json'));
const everything = Object.entries(arms).flatMap(([name, records]) =>
  records.map(([label, ...values]) => ({
    name,
    label,
    goal: fromLine(values.slice(0, 12)),
    numbers: values.slice(12),
  })),
);

/** Every so manieth of a label. @param {Label} label @returns {Failure[]} */
const sampleOf = (label) => {
  const all = everything.filter((failure) => failure.label === label);
  const step = Math.max(1, Math.floor(all.length / runs(all.length / 5)));
  return all.filter((_, i) => i % step === 0);
};

/** @type {Map<Failure, InverseResult>} */
const asked = new Map();

/** Once each: several tests look at the same answer. @param {Failure} failure */
function ask(failure) {
  const known = asked.get(failure);
  const result = known ?? inverseKinematics(createChain(publishedArm(failure.name)), columnMajor(failure.goal));
  asked.set(failure, result);
  return result;
}

/** @param {Failure} failure */
const answered = (failure) => ({ failure, result: ask(failure) });

test('the fixtures have a thousand, over 6R arms with and without a wrist, and arms of 3, 4 and 5 joints', () => {
  const count = (/** @type {Label} */ label) => everything.filter((failure) => failure.label === label).length;
  const labels = /** @type {const} */ (['out-of-reach', 'orientation', 'limits', 'task']);
  expect(labels.map(count)).toEqual([240, 250, 260, 250]);
  expect(count('either')).toBe(25);
  expect(new Set(everything.map(({ name }) => publishedArm(name).joints.length))).toEqual(new Set([3, 4, 5, 6]));
});

describe('why a goal is not met: right in 98 of 100', () => {
  test.each(/** @type {const} */ (['out-of-reach', 'orientation', 'limits', 'task']))('%s', (label) => {
    const answers = sampleOf(label).map(answered);
    const wrong = answers.filter(
      ({ result }) => result.reason !== REASON[label] || !STATUSES[label].includes(result.status),
    );
    const told = wrong.map(({ failure, result }) => `${failure.name}: ${result.status}, ${result.reason}`);
    const share = 1 - wrong.length / answers.length;
    expect(share, `${wrong.length} wrong of ${answers.length}\n${told.join('\n')}`).toBeGreaterThanOrEqual(RIGHT);
  });
  test('either of two, where two are true: the whole pose only outside the limits, its place inside too', () => {
    for (const failure of sampleOf('either')) expect(['limits', 'joints']).toContain(ask(failure).reason);
  });
});

test.each(/** @type {const} */ (['out-of-reach', 'orientation', 'limits', 'task', 'either']))(
  'what else an answer says of itself is true: %s',
  (label) => {
    for (const failure of sampleOf(label)) expectHonest(publishedArm(failure.name), failure.goal, ask(failure));
  },
);

test('a place that is missed by three tolerances is not called met, however freely the tool may turn there', () => {
  for (const { name, goal, numbers } of sampleOf('out-of-reach')) {
    const options = { positionTolerance: numbers[1] / 3, orientationTolerance: 3.2, restarts: 20 };
    const result = inverseKinematics(createChain(publishedArm(name)), columnMajor(goal), options);
    expect(['converged', 'subspace']).not.toContain(result.status);
  }
});

describe('with the right numbers', () => {
  test('by how much a place is out of reach: no less than without limits, no more than inside them', () => {
    const answers = sampleOf('out-of-reach').map(answered);
    const wrong = answers.filter(({ failure, result: { reason, shortBy = NaN, beyondReach = 0 } }) => {
      const [free, inside] = failure.numbers;
      // as exact as the searches that made them; what is proven of slides takes their limits as they are
      const isTrue = shortBy > free - 1e-7 && beyondReach < inside + 1e-7;
      return reason === 'distance' && !(isTrue && shortBy < inside * 1.02); // other reasons are counted above
    });
    const told = wrong.map(({ failure: { name, numbers }, result }) => `${name}: ${result.shortBy} m, not ${numbers}`);
    expect(told).toEqual([]);
  });
  test('which joint would have to go past its limit, and by how much', () => {
    const answers = sampleOf('limits').map(answered);
    const wrong = answers.filter(({ failure, result }) => {
      const pairs = failure.numbers.map((joint, i, all) => ({ joint, by: all[i + 1] })).filter((_, i) => i % 2 === 0);
      const turning = publishedArm(failure.name).joints.every(({ type }) => type === 'revolute');
      // whether a slide's metre or a joint's radian is the lesser evil is the kernel's to say
      const allowed = turning ? pairs.filter(({ by }) => by < pairs[0].by + 1e-6) : pairs;
      const isIn = ({ joint = -1, by = NaN }) =>
        allowed.some((each) => each.joint === joint && Math.abs(each.by - by) < 1e-6);
      return !isIn(result.limit ?? {});
    });
    const told = wrong.map(({ failure, result }) =>
      JSON.stringify([failure.name, failure.numbers.slice(0, 4), result.limit]),
    );
    const share = 1 - wrong.length / answers.length;
    expect(share, `${wrong.length} wrong of ${answers.length}\n${told.join('\n')}`).toBeGreaterThanOrEqual(RIGHT);
  });
});

describe('never called unreachable', () => {
  test('are poses that a posture outside the limits has, and none inside', () => {
    for (const label of /** @type {const} */ (['limits', 'either'])) {
      for (const failure of sampleOf(label)) expect(ask(failure).status).not.toBe('unreachable');
    }
  });
  test.each(ALL_ARMS)('are poses of postures anywhere, inside the limits and past them: %s', (name) => {
    const description = publishedArm(name);
    const random = createRandom(SEED);
    for (let i = 0; i < runs(10); i++) {
      const past = [0, 0.3, 3][i % 3]; // of the way from limit to limit, on either side
      const q = description.joints.map(({ type, lower, upper }) => {
        const room = past * (type === 'prismatic' ? upper - lower : Math.min(upper - lower, Math.PI));
        return lower - room + (upper - lower + 2 * room) * random();
      });
      const { tcp } = oracleForward(description, q);
      const result = inverseKinematics(createChain(description), columnMajor(tcp));
      expect(result.status).not.toBe('unreachable');
    }
  });
});
