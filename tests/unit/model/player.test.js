import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  after,
  atSpeed,
  firstPlayback,
  marksOf,
  moveAt,
  pause,
  play,
  scrub,
  toNext,
  toPrevious,
} from '../../../src/model/program/player.js';
import { SEED, runs } from '../../helpers/property.js';

/** @typedef {import('../../../src/motion/plan.js').MotionPart} MotionPart */
/** @typedef {import('../../../src/model/program/player.js').Playback} Playback */
/** @typedef {(playback: Playback) => Playback} Step */

const first = firstPlayback('program_1', [0, 0]);

/** @param {...[number, number]} spans */
const plan = (...spans) =>
  /** @type {import('../../../src/motion/plan.js').MotionPlan} */ ({
    duration: spans.at(-1)?.[1] ?? 0,
    parts: spans.map(([begin, end], move) => /** @type {MotionPart} */ ({ move, begin, end })),
    start: new Float64Array(2),
    refused: null,
  });
const THREE = plan([0, 2], [2, 2.5], [2.5, 6]);

describe('playing', () => {
  test('time runs at the chosen speed, to the end and no further', () => {
    let now = play(atSpeed(first, 2), 6);
    for (let i = 0; i < 10; i++) now = after(now, 0.05, 6);
    expect(now.time).toBeCloseTo(1, 12);
    for (let i = 0; i < 100; i++) now = after(now, 0.05, 6);
    expect(now).toMatchObject({ time: 6, isPlaying: false });
    expect(after(now, 1, 6)).toBe(now);
    expect(play(now, 6)).toMatchObject({ time: 0, isPlaying: true });
  });

  test('a page that was hidden for a minute goes on where it was', () => {
    expect(after(play(first, 6), 60, 6).time).toBe(0.1);
    expect(after(play(first, 6), -1, 6).time).toBe(0);
  });

  test('a loop goes round and keeps what is over', () => {
    const now = after({ ...play(first, 6), time: 5.99, isLoop: true }, 0.05, 6);
    expect(now.isPlaying).toBe(true);
    expect(now.time).toBeCloseTo(0.04, 12);
  });

  test('the speed is 1 to 400 %', () => {
    expect([0.001, 0.01, 1.5, 4, 9].map((speed) => atSpeed(first, speed).speed)).toEqual([0.01, 0.01, 1.5, 4, 4]);
  });

  test('a program that takes no time is not played', () => {
    expect(play(first, 0).isPlaying).toBe(false);
    expect(after({ ...first, isPlaying: true, isLoop: true }, 0.1, 0)).toMatchObject({ time: 0, isPlaying: false });
  });

  test('pausing something that stands is nothing', () => {
    expect(pause(first)).toBe(first);
    expect(pause(play(first, 6)).isPlaying).toBe(false);
  });

  test('whatever is pressed, time stays within the program', () => {
    const marks = [0, 2, 2.5, 6];
    /** @type {(least: number, most: number, step: (value: number) => Step) => fc.Arbitrary<Step>} */
    const by = (min, max, step) => fc.double({ min, max, noNaN: true }).map(step);
    /** @type {readonly Step[]} */
    const presses = [
      (p) => play(p, 6),
      (p) => toNext(p, marks),
      (p) => toPrevious(p, marks),
      (p) => ({ ...p, isLoop: !p.isLoop }),
      pause,
    ];
    const step = fc.oneof(
      by(-1, 10, (seconds) => (p) => after(p, seconds, 6)),
      by(-1e9, 1e9, (time) => (p) => scrub(p, time, 6)),
      by(0.001, 100, (speed) => (p) => atSpeed(p, speed)),
      fc.constantFrom(...presses),
    );
    fc.assert(
      fc.property(fc.array(step, { maxLength: 60 }), (steps) => {
        let now = first;
        for (const one of steps) {
          now = one(now);
          expect(now.time).toBeGreaterThanOrEqual(0);
          expect(now.time).toBeLessThanOrEqual(6);
        }
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });
});

describe('stepping', () => {
  const marks = marksOf(THREE);

  test('goes from mark to mark, both ways, and stands there', () => {
    expect(marks).toEqual([0, 2, 2.5, 6]);
    let now = play(first, 6);
    const there = [];
    for (let i = 0; i < 4; i++) there.push((now = toNext(now, marks)).time);
    for (let i = 0; i < 4; i++) there.push((now = toPrevious(now, marks)).time);
    expect(there).toEqual([2, 2.5, 6, 6, 2.5, 2, 0, 0]);
    expect(now.isPlaying).toBe(false);
    expect(toPrevious({ ...first, time: 2.2 }, marks).time).toBe(2);
  });

  test('moves of no length have one mark together, and a program without moves has one', () => {
    expect(marksOf(plan([0, 0], [0, 2], [2, 2], [2, 3]))).toEqual([0, 2, 3]);
    expect(marksOf(plan())).toEqual([0]);
    expect(toNext(first, [0]).time).toBe(0);
  });

  test('at a mark the move is the one that begins there', () => {
    expect([0, 1.999, 2, 2.4, 2.5, 6].map((time) => moveAt(THREE, time))).toEqual([0, 0, 1, 1, 2, 2]);
    expect(moveAt(plan(), 0)).toBe(null);
  });
});
