import { expect, test } from 'vitest';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot, postureFromKernel } from '../../../src/model/compile.js';
import { createDerived } from '../../../src/model/derived.js';
import { applyCommand } from '../../../src/model/commands.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';

test('the same arm in millimetres and degrees, centimetres, or metres and radians is the same chain', () => {
  const inDegrees = LIBRARY.scara_cobra600;
  const radians = (/** @type {number} */ degrees) => (degrees * Math.PI) / 180;
  const inRadians = {
    ...inDegrees,
    units: /** @type {const} */ ({ length: 'm', angle: 'rad' }),
    joints: inDegrees.joints.map((joint) => {
      const value = (/** @type {number} */ v) => (joint.type === 'prismatic' ? v / 1000 : radians(v));
      return {
        ...joint,
        theta: radians(joint.theta),
        alpha: radians(joint.alpha),
        a: joint.a / 1000,
        d: joint.d / 1000,
        lower: value(joint.lower ?? 0),
        upper: value(joint.upper ?? 0),
      };
    }),
  };
  const q = [10, -20, 150, 40];
  const qSi = [radians(10), radians(-20), 0.15, radians(40)];
  const one = tcpPose(compileRobot(inDegrees), compilePosture(inDegrees, q));
  const two = tcpPose(compileRobot(inRadians), compilePosture(inRadians, qSi));
  one.forEach((value, i) => expect(value).toBeCloseTo(two[i], 14));
});

test('the nearest number is taken on the way to metres: 671.83 mm is 0.67183 m', () => {
  expect(compileRobot(LIBRARY.puma560).joints[0].d).toBe(0.67183);
});

test('joint values come back from the kernel in document units', () => {
  const robot = LIBRARY.scara_cobra600;
  const q = [12.5, -33, 77, 180];
  postureFromKernel(robot, compilePosture(robot, q)).forEach((value, i) => expect(value).toBeCloseTo(q[i], 12));
});

test('jogging compiles nothing', () => {
  const derived = createDerived();
  const before = newDocument(LIBRARY.puma560);
  const chain = derived.chain(before);
  const tcp = derived.tcp(before);
  const after = applyCommand(before, { type: 'set-joint-value', joint: 1, value: 30 });
  expect(derived.chain(after)).toBe(chain);
  expect(derived.tcp(after)).not.toBe(tcp);
});

test('base and tool are part of the chain', () => {
  const robot = {
    ...LIBRARY.planar2r,
    base: { xyz: [0, 0, 500], rpy: [0, 0, 90] },
    tool: { xyz: [100, 0, 0], rpy: [0, 0, 0] },
  };
  const T = tcpPose(compileRobot(robot), compilePosture(robot, [0, 0]));
  [0, 2.1, 0.5].forEach((value, k) => expect(T[12 + k]).toBeCloseTo(value, 14));
});

test('a continuous joint has no limits, whatever its file says', () => {
  const [first, second] = LIBRARY.planar2r.joints;
  const robot = { ...LIBRARY.planar2r, joints: [{ ...first, type: /** @type {const} */ ('continuous') }, second] };
  const { joints } = compileRobot(robot);
  expect([joints[0].type, joints[0].lower, joints[0].upper]).toEqual(['revolute', -Infinity, Infinity]);
  expect(joints[1].upper).toBeCloseTo(Math.PI, 15);
});
