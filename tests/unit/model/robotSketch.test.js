/** The small pictures of the library. */
import { describe, expect, test } from 'vitest';
import { LIBRARY } from '../../../src/model/library.js';
import { sketchRobot } from '../../../src/model/robot/robotSketch.js';

describe.each(Object.entries(LIBRARY))('%s', (_id, robot) => {
  const { line, joints, ground, reach } = sketchRobot(robot);

  test('is drawn inside its square, from base to tool, and fills it one way', () => {
    expect(line).toHaveLength(2 * robot.joints.length + 1);
    for (const [x, y] of [...line, ...joints.map(({ at }) => at)]) {
      for (const value of [x, y]) {
        expect(value).toBeGreaterThanOrEqual(-1e-12);
        expect(value).toBeLessThanOrEqual(1 + 1e-12);
      }
    }
    const [across, up] = [0, 1].map((k) => {
      const values = [...line.map((point) => point[k]), ...(k === 1 && ground !== null ? [ground] : [])];
      return Math.max(...values) - Math.min(...values);
    });
    expect(Math.max(across, up)).toBeCloseTo(1, 12);
    expect(reach).toBeGreaterThan(0);
  });

  test('has each joint once, of its own kind', () => {
    expect(joints.map(({ isSliding }) => isSliding)).toEqual(robot.joints.map(({ type }) => type === 'prismatic'));
  });
});

test('a flat arm is seen from above, its axes end-on, its links at the angles of its home', () => {
  const { line, joints, ground } = sketchRobot(LIBRARY.planar2r);
  expect(ground).toBeNull();
  expect(joints.map(({ axis }) => axis)).toEqual([null, null]);
  const [base, , elbow, , tool] = line;
  expect(Math.atan2(elbow[1] - base[1], elbow[0] - base[0])).toBeCloseTo(Math.PI / 6, 12);
  expect(Math.atan2(tool[1] - elbow[1], tool[0] - elbow[0])).toBeCloseTo(Math.PI / 2, 12);
});

test('an upright arm is seen from the side: the waist stands, the elbow is seen end-on', () => {
  const { joints, ground } = sketchRobot(LIBRARY.anthropomorphic_3r);
  expect(ground).toBeCloseTo(0, 12);
  expect(joints[0].axis).toBeCloseTo(Math.PI / 2, 12);
  expect(joints[2].axis).toBeNull();
});

test('the same arm in the other convention is the same picture', () => {
  const joints = LIBRARY.planar3r.joints.map((joint, i) => ({ ...joint, a: i === 0 ? 0 : 1000 }));
  const modified = sketchRobot({ ...LIBRARY.planar3r, convention: 'modified', joints });
  const standard = sketchRobot({ ...LIBRARY.planar3r, joints: LIBRARY.planar3r.joints.slice(0, 2) });
  expect(modified.line.at(-1)?.[0]).toBeCloseTo(standard.line.at(-1)?.[0] ?? NaN, 12);
  expect(modified.line.at(-1)?.[1]).toBeCloseTo(standard.line.at(-1)?.[1] ?? NaN, 12);
});
