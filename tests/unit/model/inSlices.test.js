/** Long jobs in slices: none is longer than a page can wait, and what is given up is not heard of again. */
import { expect, test } from 'vitest';
import { inSlices, inSlicesFromNow } from '../../../src/model/inSlices.js';

/** A clock that goes on by a millisecond whenever it is asked, and does what was put off when told to. */
function slowClock() {
  let now = 0;
  /** @type {(() => void)[]} */
  let waiting = [];
  return {
    now: () => (now += 0.001),
    after(/** @type {number} */ _, /** @type {() => void} */ act) {
      waiting.push(act);
      return () => void (waiting = waiting.filter((one) => one !== act));
    },
    turn: () => waiting.splice(0).forEach((act) => act()),
  };
}

function* counting(/** @type {number} */ steps) {
  for (let i = 0; i < steps; i++) yield i / steps;
  return steps;
}

/** @param {typeof inSlices | typeof inSlicesFromNow} begin @param {number} steps */
function begun(begin, steps) {
  const clock = slowClock();
  /** @type {unknown[]} */
  const heard = [];
  const cancel = begin(counting(steps), clock, {
    onDone: (result) => heard.push(result),
    onFault: (error) => heard.push(error),
  });
  return { clock, heard, cancel };
}

test('a short job is done at once where that is wanted, and else when the page has had its turn', () => {
  expect(begun(inSlicesFromNow, 5).heard).toEqual([5]);
  const later = begun(inSlices, 5);
  expect(later.heard).toEqual([]);
  later.clock.turn();
  expect(later.heard).toEqual([5]);
});

test.each([inSlices, inSlicesFromNow])('a long job lets the page have its turns, and can be given up', (begin) => {
  const { clock, heard } = begun(begin, 50);
  for (let turns = 0; turns < 3; turns++) {
    clock.turn();
    expect(heard).toEqual([]);
  }
  for (let turns = 0; turns < 3; turns++) clock.turn();
  expect(heard).toEqual([50]);
  const other = begun(begin, 50);
  other.clock.turn();
  other.cancel();
  for (let turns = 0; turns < 9; turns++) other.clock.turn();
  expect(other.heard).toEqual([]);
});
