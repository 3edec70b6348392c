import fc from 'fast-check';
import { expect, test } from 'vitest';
import { REST, createMotionLog, extremes, motionCsv } from '../../../src/model/jog/motionLog.js';
import { SEED, runs } from '../../helpers/property.js';

const FRAME = 1 / 60;

/** A tool on a rail: its one joint is its place. */
function rail(window = 20) {
  const recording = createMotionLog(1, window);
  let x = 0;
  let now = 100;
  return {
    recording,
    /** @param {number} by @param {number} [seconds] */
    move(by, seconds = FRAME) {
      now += seconds;
      recording.move(now, [x], [x + by], [x, 0, 0], [x + by, 0, 0]);
      x += by;
    },
    /** @param {number} [seconds] */
    wait(seconds = FRAME) {
      now += seconds;
      return recording.still(now);
    },
  };
}

test('a steady motion has its speed, from the second picture on; at rest it is zero and no more pictures are wanted', () => {
  const { recording, move, wait } = rail();
  expect(wait()).toBe(true);
  for (let i = 0; i < 61; i++) move(0.005);
  expect(wait(REST / 2)).toBe(false);
  expect(recording.isMoving).toBe(true);
  expect(wait(REST)).toBe(true);
  const { time, values, speed } = recording.log;
  expect(values[0][0]).toBe(0);
  expect(values[0][values[0].length - 1]).toBeCloseTo(0.305, 12);
  expect(speed.slice(0, 2)).toEqual([null, null]);
  for (const one of speed.slice(2, -1)) expect(one).toBeCloseTo(0.3, 9);
  expect(speed[speed.length - 1]).toBe(0);
  expect(time[time.length - 1]).toBeCloseTo(1 + REST, 9);
});

test('a pause, however long, is a gap; a step has no speed', () => {
  const { recording, move, wait } = rail();
  move(1);
  wait(1);
  const end = recording.log.time[recording.log.time.length - 1];
  wait(3600);
  move(2);
  const { time, values, speed } = recording.log;
  expect(values[0].slice(-3)).toEqual([null, 1, 3]);
  expect(speed.slice(-3)).toEqual([null, null, null]);
  expect(time[time.length - 1] - end).toBeLessThan(1);
});

test('property: time never goes back, columns are of one length, and no more than the window is told of', () => {
  const step = fc.record({
    by: fc.oneof(fc.constant(0), fc.double({ min: -1, max: 1, noNaN: true })),
    seconds: fc.double({ min: 0.001, max: 0.6, noNaN: true }),
  });
  fc.assert(
    fc.property(fc.array(step, { minLength: 1, maxLength: 300 }), (steps) => {
      const { recording, move, wait } = rail(2);
      for (const { by, seconds } of steps) {
        if (by === 0) wait(seconds);
        else move(by, seconds);
      }
      const { time, values, speed } = recording.log;
      expect(values[0]).toHaveLength(time.length);
      expect(speed).toHaveLength(time.length);
      for (let i = 1; i < time.length; i++) expect(time[i]).toBeGreaterThanOrEqual(time[i - 1]);
      if (time.length > 0) expect(time[time.length - 1] - time[0]).toBeLessThanOrEqual(2);
      for (const one of speed) expect(one === null || (Number.isFinite(one) && one >= 0)).toBe(true);
    }),
    { seed: SEED, numRuns: runs(60) },
  );
});

test('what it was, and as text for a spreadsheet', () => {
  expect(extremes([null, 3, -1, null, 2])).toEqual({ now: 2, least: -1, most: 3 });
  expect(extremes([null])).toBe(null);
  const text = motionCsv(
    { time: [5, 5.5], values: [[1, null]], speed: [null, 0.25] },
    ['t', 'J1 [deg]', 'v'],
    (v) => 1000 * v,
  );
  expect(text).toBe('t,J1 [deg],v\r\n0,1,\r\n0.5,,250\r\n');
});

test('pictures that come late change no speed', () => {
  const { recording, move } = rail();
  const late = [1, 3, 2, 6, 1].map((frames) => frames * FRAME);
  for (const seconds of late) move(0.3 * seconds, seconds);
  for (const one of recording.log.speed.slice(2)) expect(one).toBeCloseTo(0.3, 9);
  const { time } = recording.log;
  expect(time[time.length - 1]).toBeCloseTo(12 * FRAME, 9); // the first one is a step
});
