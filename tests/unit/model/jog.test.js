import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { dexterity } from '../../../src/kinematics/dexterity.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { LIBRARY } from '../../../src/model/library.js';
import { compileRobot } from '../../../src/model/compile.js';
import { beginJog, jogFurther, jogJoint, withoutLimits } from '../../../src/model/jog/jog.js';
import { runs } from '../../helpers/property.js';
import {
  angleBetween,
  columnMajor,
  distanceBetween,
  oracleForward,
  rigid,
  rodrigues,
  times,
} from '../kinematics/oracle.js';
import { ALL_ARMS, publishedArm, withSixJoints } from '../kinematics/publishedArms.js';

/**
 * @import { ChainDescription } from '../../../src/kinematics/chain.js'
 * @import { Matrix } from '../kinematics/oracle.js'
 * @import { JointDoc } from '../../../src/model/document.js'
 */

const SIX = ALL_ARMS.filter(withSixJoints);
const NAMES = ['X', 'Y', 'Z', 'about X', 'about Y', 'about Z'];

/** @param {ChainDescription} description @param {() => number} random */
const anyPosture = ({ joints }, random) =>
  Float64Array.from([...joints], ({ lower = -Infinity, upper = Infinity }) => {
    const [low, high] = [Math.max(lower, -3), Math.min(upper, 3)];
    return low + (high - low) * (0.1 + 0.8 * random());
  });

/** Where the tool has to be: along an axis of the frame, or turned about one through its own point. @param {Matrix} T @param {Matrix} frame @param {number} axis @param {number} amount @returns {Matrix} */
function wanted(T, frame, axis, amount) {
  const direction = [0, 1, 2].map((i) => frame[i][axis % 3]);
  const place = T.slice(0, 3).map((row) => row[3]);
  const R = T.slice(0, 3).map((row) => row.slice(0, 3));
  return axis < 3
    ? rigid(
        R,
        place.map((value, i) => value + amount * direction[i]),
      )
    : rigid(times(rodrigues(direction, amount), R), place);
}

/** @param {Matrix} T @param {() => number} random @returns {Record<string, Matrix>} */
const framesAt = (T, random) => ({
  world: rigid(rodrigues([0, 0, 1], 0), [0, 0, 0]),
  tool: T,
  user: rigid(rodrigues([random() - 0.5, random() - 0.5, random() - 0.5], 3 * random()), [1, 2, 3]),
});

describe.each(SIX)('%s is jogged', (name) => {
  const random = createRandom(560);
  const description = publishedArm(name);
  const chain = createChain(description);

  test.each(NAMES.map((what, axis) => [what, axis]))('%s in every frame, and back', (_, axis) => {
    let steps = 0;
    for (let tries = 0; tries < 3; tries++) {
      const q = anyPosture(description, random);
      const T = oracleForward(description, q).tcp;
      for (const frame of Object.values(framesAt(T, random))) {
        for (const amount of [0.02, -0.02, 0.001]) {
          const press = jogFurther(chain, beginJog(chain, q, columnMajor(frame), Number(axis)), amount);
          const now = oracleForward(description, press.q).tcp;
          // Wherever it came to, it is on the line, and it is as far along as it says.
          const there = wanted(T, frame, Number(axis), press.travelled);
          expect(distanceBetween(now, there)).toBeLessThan(2e-8);
          expect(angleBetween(now, there)).toBeLessThan(2e-7);
          chain.joints.forEach(({ lower, upper }, i) => {
            expect(press.q[i]).toBeGreaterThanOrEqual(lower);
            expect(press.q[i]).toBeLessThanOrEqual(upper);
          });
          if (press.stop) continue;
          expect(press.travelled).toBeCloseTo(amount, 12);
          steps++;
          const back = jogFurther(chain, press, -amount);
          expect(distanceBetween(oracleForward(description, back.q).tcp, T)).toBeLessThan(2e-8);
        }
      }
    }
    expect(steps).toBeGreaterThan(8);
  });
});

const puma = () => compileRobot(LIBRARY.puma560);
const HOME = Float64Array.of(0, Math.PI / 4, -Math.PI, 0, Math.PI / 4, 0);
const WORLD = columnMajor(rigid(rodrigues([0, 0, 1], 0), [0, 0, 0]));

test('a press in many frames of the screen comes to where one step comes to', () => {
  const chain = puma();
  const whole = jogFurther(chain, beginJog(chain, HOME, WORLD, 1), 0.2);
  let press = beginJog(chain, HOME, WORLD, 1);
  for (let k = 0; k < 50; k++) press = jogFurther(chain, press, 0.004);
  expect(press.travelled).toBeCloseTo(0.2, 12);
  press.q.forEach((value, i) => expect(value).toBeCloseTo(whole.q[i], 7));
});

test('it stops at the edge of the reach, at a limit and at a singularity, and says so', () => {
  const chain = puma();
  const out = jogFurther(chain, beginJog(chain, HOME, WORLD, 0), 3);
  expect(out.stop?.why).toMatch(/reach|singularity|limit/);
  expect(out.travelled).toBeGreaterThan(0.1);
  const again = jogFurther(chain, { ...beginJog(chain, out.q, WORLD, 0) }, 0.05);
  expect(again.stop).not.toBeNull();
  expect(again.travelled).toBeLessThan(1e-3);
  const back = jogFurther(chain, beginJog(chain, out.q, WORLD, 0), -0.05);
  expect(back.travelled).toBeCloseTo(-0.05, 9);

  // Its wrist is straight: the tool turns about any axis but one.
  const straight = HOME.with(4, 0);
  const sideways = tcpPose(chain, straight);
  const stuck = jogFurther(chain, beginJog(chain, straight, sideways, 3), 0.1);
  expect(stuck.stop?.why).toBe('singularity');
});

test('a joint that is in the way is named', () => {
  const narrow = { ...LIBRARY.puma560 };
  const joints = narrow.joints.map((joint, i) => (i === 0 ? { ...joint, lower: -5, upper: 5 } : joint));
  const chain = compileRobot({ ...narrow, joints });
  const press = jogFurther(chain, beginJog(chain, HOME, WORLD, 1), 0.5);
  expect(press.stop).toEqual({ why: 'limit', joint: 0 });
  expect(press.q[0]).toBeCloseTo((5 / 180) * Math.PI, 4);
  const free = compileRobot(withoutLimits({ ...narrow, joints }));
  expect(jogFurther(free, beginJog(free, HOME, WORLD, 1), 0.1).stop).toBeNull();
});

test('a held button comes to rest at the limit of a joint that has more room than a turn, and names the joint', () => {
  const chain = puma();
  const most = 0.05; // in a frame
  for (const sign of [1, -1]) {
    const q = HOME.with(5, sign * (266 / 180) * Math.PI - sign * 0.3);
    let press = beginJog(chain, q, tcpPose(chain, q), 5);
    for (let frame = 0; frame < 60 && !press.stop; frame++) {
      const before = press.q;
      press = jogFurther(chain, press, sign * 0.02, most);
      press.q.forEach((value, i) => expect(Math.abs(value - before[i])).toBeLessThanOrEqual(most + 1e-12));
    }
    expect(press.stop).toEqual({ why: 'limit', joint: 5 });
    expect(press.q[5]).toBeCloseTo((sign * 266 * Math.PI) / 180, 4);
    expect(press.travelled).toBeCloseTo(sign * 0.3, 4);
  }
});

test('held through any way, every stop has its true reason, and no joint leaps', () => {
  const random = createRandom(84);
  const most = 0.06;
  for (const id of ['puma560', 'ur5', 'kuka_kr6_r900', 'fanuc_m10ia', 'stanford', 'scara_cobra600']) {
    const chain = compileRobot(LIBRARY[id]);
    const { lower, upper } = chain.packed;
    for (let tries = 0; tries < runs(3); tries++) {
      const q = Float64Array.from(lower, (least, i) => {
        const [low, high] = [Math.max(least, -3), Math.min(upper[i], 3)];
        return low + (high - low) * random();
      });
      let press = beginJog(chain, q, WORLD, Math.floor(6 * random()));
      const rate = (press.isTurn ? 0.03 : 0.01) * (random() < 0.5 ? -1 : 1);
      for (let frame = 0; frame < 200 && !press.stop; frame++) {
        const before = press.q;
        press = jogFurther(chain, press, rate, most);
        press.q.forEach((value, i) => {
          const unit = chain.joints[i].type === 'prismatic' ? chain.characteristicLength : 1;
          expect(Math.abs(value - before[i]) / unit).toBeLessThanOrEqual(most + 1e-12);
        });
      }
      const { stop } = press;
      if (!stop || stop.why === 'freedom') continue;
      // where it stopped, either that joint stands at its limit or the arm is next to a singularity
      if (stop.why === 'limit') {
        const joint = stop.joint ?? -1;
        expect(Math.min(press.q[joint] - lower[joint], upper[joint] - press.q[joint])).toBeLessThan(1e-3);
      } else expect([id, stop.why, dexterity(chain, press.q).isotropy < 0.02]).toEqual([id, stop.why, true]);
    }
  }
});

test('an arm that stands outside its limits is not taken anywhere', () => {
  const chain = puma();
  const outside = HOME.with(1, 4);
  const press = jogFurther(chain, beginJog(chain, outside, WORLD, 0), 0.01);
  expect(press.stop).toEqual({ why: 'outside', joint: 1 });
  expect(press.q).toEqual(outside);
});

test('a motion for which an arm has no joint is not made, and is not called the edge of its reach', () => {
  const scara = compileRobot(LIBRARY.scara_cobra600);
  const q = Float64Array.of(0.3, 0.8, 0.05, 0.2).subarray(0, scara.dof);
  expect(jogFurther(scara, beginJog(scara, q, WORLD, 3), 0.1)).toMatchObject({ stop: { why: 'freedom' }, q });
  expect(jogFurther(scara, beginJog(scara, q, WORLD, 5), 0.1).stop).toBeNull();
  const planar = compileRobot(LIBRARY.planar2r);
  const bent = Float64Array.of(0.3, 0.8);
  expect(jogFurther(planar, beginJog(planar, bent, WORLD, 2), 0.01).stop).toEqual({ why: 'freedom' });
  expect(jogFurther(planar, beginJog(planar, bent, WORLD, 5), 0.1).stop).toEqual({ why: 'freedom' });
  const along = jogFurther(planar, beginJog(planar, bent, WORLD, 0), -0.01);
  expect(along.stop).toBeNull();
  expect(along.isTilting).toBe(true);
  const straight = beginJog(planar, Float64Array.of(0, 0), WORLD, 0);
  expect(jogFurther(planar, straight, 0.01).stop).toEqual({ why: 'reach' });
  // a wrist's tool goes about on a sphere: next to it is no singularity, however fast its joints would have to be
  const wrist = compileRobot(LIBRARY.spherical_wrist);
  const turned = Float64Array.of(2.51, 0.23, -0.56);
  expect(jogFurther(wrist, beginJog(wrist, turned, WORLD, 0), 0.005, 0.06).stop).toEqual({ why: 'reach' });
});

test('joints that may turn only so far at once bring the tool only so far', () => {
  const chain = puma();
  const press = jogFurther(chain, beginJog(chain, HOME, WORLD, 1), 0.01, 1e-3);
  expect(press.stop).toBeNull();
  expect(press.travelled).toBeGreaterThan(1e-4);
  expect(press.travelled).toBeLessThan(0.002);
  press.q.forEach((value, i) => expect(Math.abs(value - HOME[i])).toBeLessThanOrEqual(1e-3 + 1e-12));
});

test('one joint goes by so much, as far as its limits', () => {
  const joint = /** @type {JointDoc} */ ({ ...LIBRARY.puma560.joints[0], lower: -10, upper: 10 });
  expect(jogJoint(joint, 0.1, 0.2, true)).toEqual({ value: 0.3, isStopped: false });
  expect(jogJoint(joint, 8, 5, true)).toEqual({ value: 10, isStopped: true });
  expect(jogJoint(joint, 8, 5, false)).toEqual({ value: 13, isStopped: false });
  expect(jogJoint(joint, 14, -1, true)).toEqual({ value: 13, isStopped: false });
  expect(jogJoint(joint, 14, 1, true)).toEqual({ value: 14, isStopped: true });
  const endless = { ...joint, type: /** @type {const} */ ('continuous') };
  expect(jogJoint(endless, 1e9 - 1, 5, true)).toEqual({ value: 1e9, isStopped: true });
  expect(jogJoint(joint, -1e9, -5, false)).toEqual({ value: -1e9, isStopped: true });
});
