import { expect, test } from 'vitest';
import { createManualClock } from '../../../src/model/clock.js';
import { createStore } from '../../../src/model/store.js';
import { createViews, together } from '../../../src/model/views.js';

const counter = () => createStore(0, (/** @type {number} */ n, /** @type {number} */ by) => n + by);

test('a view draws once a frame, whatever happened in between, and then there is no work at all', () => {
  const clock = createManualClock();
  const store = counter();
  /** @type {number[]} */
  const drawn = [];
  const addView = createViews(store, clock, { onError: (error) => expect.fail(String(error)) });
  addView(
    (n) => n,
    (n) => void drawn.push(n),
  );
  clock.tick();
  for (const by of [1, 2, 3]) store.dispatch(by);
  clock.tick();
  expect(drawn).toEqual([0, 6]);
  expect(clock.idle).toBe(true);
});

test('a view whose value stayed the same is not drawn', () => {
  const clock = createManualClock();
  const store = counter();
  let drawn = 0;
  const addView = createViews(store, clock, { onError: (error) => expect.fail(String(error)) });
  addView(
    (n) => n > 10,
    () => void drawn++,
  );
  clock.tick();
  store.dispatch(1);
  clock.tick();
  expect(drawn).toBe(1);
});

test('a broken view is dropped alone, and reported', () => {
  /** @type {unknown[]} */
  const errors = [];
  let seen = 0;
  const clock = createManualClock();
  const store = counter();
  const addView = createViews(store, clock, { onError: (error) => errors.push(error) });
  addView((n) => n, () => { throw new Error('plot broke'); }); // prettier-ignore
  addView(
    (n) => n,
    () => void seen++,
  );
  for (let i = 0; i < 3; i++) {
    store.dispatch(1);
    clock.tick();
  }
  expect(seen).toBe(3);
  expect(errors.map(String)).toEqual(['Error: plot broke']);
});

test('the order of views does not matter', () => {
  const show = (/** @type {<T>(list: T[]) => T[]} */ order) => {
    const clock = createManualClock();
    const store = counter();
    /** @type {Record<string, number>} */
    const shown = {};
    const addView = createViews(store, clock, { onError: (error) => expect.fail(String(error)), order });
    addView(
      (n) => n,
      (n) => void (shown.plain = n),
    );
    addView(
      (n) => n * 2,
      (n) => void (shown.double = n),
    );
    store.dispatch(4);
    clock.tick();
    return shown;
  };
  expect(show((list) => list)).toEqual(show((list) => list.reverse()));
});

test('several values are one value as long as each is the same', () => {
  const select = together((/** @type {{ a: number, b: string }} */ { a, b }) => [a, b]);
  const first = select({ a: 1, b: 'x' });
  expect(select({ a: 1, b: 'x' })).toBe(first);
  expect(select({ a: 1, b: 'y' })).not.toBe(first);
});

test('a subscriber may not dispatch', () => {
  const store = counter();
  store.subscribe(() => store.dispatch(1));
  expect(() => store.dispatch(1)).toThrow('inside a subscriber');
});
