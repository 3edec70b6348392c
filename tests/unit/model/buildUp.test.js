import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  after,
  back,
  buildOf,
  forward,
  isMoving,
  motionAmount,
  motionNow,
  pause,
  play,
  stepped,
} from '../../../src/model/robot/buildUp.js';
import { LIBRARY } from '../../../src/model/library.js';
import { SEED, runs } from '../../helpers/property.js';

const always = () => 1;

/** As long as it takes, in frames of a sixtieth. @param {ReturnType<typeof buildOf>} build @param {(index: number) => number} [amountOf] */
function run(build, amountOf = always) {
  let seconds = 0;
  const stops = new Set([build.at]);
  while (isMoving(build)) {
    build = after(build, 1 / 60, amountOf);
    seconds += 1 / 60;
    if (Number.isInteger(build.at)) stops.add(build.at);
  }
  return { build, seconds, stops: [...stops] };
}

describe('a row that is built up', () => {
  test('is played motion by motion, a second each, and those that move nothing pass quickly', () => {
    const { build, seconds, stops } = run(play(buildOf(2)));
    expect(build).toEqual({ joint: 2, at: 4, goal: 4 });
    expect(stops).toEqual([0, 1, 2, 3, 4]);
    expect(seconds).toBeGreaterThan(3.9);
    expect(seconds).toBeLessThan(4.3);
    expect(run(play(buildOf(2)), () => 0).seconds).toBeLessThan(1.5);
  });

  test('goes one motion forward or back, also out of the middle of one', () => {
    const middle = after(play(buildOf(0)), 0.5, always);
    expect(middle.at).toBe(0.5);
    expect(motionNow(middle)).toBe(0);
    expect(back(middle)).toEqual(buildOf(0));
    expect(pause(middle)).toEqual({ joint: 0, at: 0.5, goal: 0.5 });
    expect(run(forward(pause(middle))).build.at).toBe(2);
    expect(run(forward(buildOf(0))).build.at).toBe(1);
    expect(back(buildOf(0))).toEqual(buildOf(0));
    expect(back({ joint: 0, at: 3, goal: 3 }).at).toBe(2);
  });

  test('begins anew when it is played at its end, and steps where nothing may move', () => {
    expect(play({ joint: 1, at: 4, goal: 4 })).toEqual({ joint: 1, at: 0, goal: 4 });
    expect(stepped(play(buildOf(1))).at).toBe(1);
    expect(stepped({ joint: 1, at: 2.5, goal: 4 }).at).toBe(3);
    expect(stepped(buildOf(1))).toEqual(buildOf(1));
  });

  test('is always somewhere between its two frames, whatever is pressed', () => {
    const press = fc.constantFrom(
      forward,
      back,
      play,
      pause,
      stepped,
      (/** @type {ReturnType<typeof buildOf>} */ build) => after(build, 0.37, always),
    );
    fc.assert(
      fc.property(fc.array(press, { maxLength: 40 }), (presses) => {
        let build = buildOf(3);
        for (const one of presses) {
          build = one(build);
          expect(build.at).toBeGreaterThanOrEqual(0);
          expect(build.at).toBeLessThanOrEqual(build.goal);
          expect(build.goal).toBeLessThanOrEqual(4);
          const index = motionNow(build);
          if (index !== null) expect([0, 1, 2, 3]).toContain(index);
        }
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });

  test('moves by the number of the row, and by the joint value where the joint does', () => {
    const posture = [10, 20, 30, 40, 50, 60];
    expect(motionAmount(LIBRARY.puma560, posture, 1, 0)).toMatchObject({
      field: 'theta',
      amount: 20,
      isVariable: true,
    });
    expect(motionAmount(LIBRARY.puma560, posture, 1, 2)).toMatchObject({
      field: 'a',
      amount: 431.8,
      isVariable: false,
    });
    const slide = LIBRARY.stanford.joints.findIndex(({ type }) => type === 'prismatic');
    const d = motionAmount(LIBRARY.stanford, posture, slide, 1);
    expect(d).toMatchObject({
      field: 'd',
      isVariable: true,
      amount: LIBRARY.stanford.joints[slide].d + posture[slide],
    });
  });
});
