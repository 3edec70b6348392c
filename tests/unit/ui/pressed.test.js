import { expect, test } from 'vitest';
import { createManualClock } from '../../../src/model/clock.js';
import { createPressGate } from '../../../src/ui/parts/pressed.js';

/** @param {boolean} isButton  what is pressed */
function room(isButton) {
  const host = Object.assign(new EventTarget(), { closest: () => (isButton ? host : null) });
  const [clock, page] = [createManualClock(), new EventTarget()];
  const whenLetGo = createPressGate(host, clock, page);
  let draws = 0;
  const draw = () => void draws++;
  /** @param {EventTarget} on @param {string} type @param {object} [more] */
  const happens = (on, type, more = {}) => void on.dispatchEvent(Object.assign(new Event(type), more));
  return { ...{ host, page, clock, happens }, ask: () => whenLetGo(draw), draws: () => draws };
}

test.each([
  ['a pointer', 'pointerdown', { button: 0 }, 'pointerup'],
  ['a finger that begins to scroll', 'pointerdown', { button: 0 }, 'pointercancel'],
  ['the space bar', 'keydown', { key: ' ' }, 'keyup'],
])('what %s presses stands until it is let go, and is drawn once then', (_, press, more, release) => {
  const { host, page, clock, happens, ask, draws } = room(true);
  happens(host, press, more);
  ask();
  ask();
  clock.tick();
  expect(draws()).toBe(0);
  happens(page, release);
  expect(draws()).toBe(0); // the click comes first
  clock.tick();
  expect(draws()).toBe(1);
  ask();
  expect(draws()).toBe(2);
  clock.tick();
  expect(draws()).toBe(2);
});

test('what is no press of a button holds nothing up', () => {
  for (const [isButton, type, more] of /** @type {const} */ ([
    [false, 'pointerdown', { button: 0 }],
    [true, 'pointerdown', { button: 2 }],
    [true, 'keydown', { key: 'Enter' }],
  ])) {
    const { host, happens, ask, draws } = room(isButton);
    happens(host, type, more);
    ask();
    expect(draws()).toBe(1);
  }
});
