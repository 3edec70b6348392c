/**
 * A view is a pair: `select` says what it shows (pure), `draw` shows it. Views redraw at most once a frame, only when
 * their selected value is another one, in any order; one that throws is removed and reported, alone.
 *
 * @import { Clock } from './clock.js'
 */
import { createFrameLoop } from './clock.js';

/**
 * @template State
 * @param {{ readonly state: State, subscribe: (notify: () => void) => unknown }} store
 * @param {Clock} clock
 * @param {object} options
 * @param {(error: unknown) => void} options.onError
 * @param {<T>(views: T[]) => T[]} [options.order]  tests shuffle here
 */
export function createViews(store, clock, { onError, order = (views) => views }) {
  /** @type {Set<(state: State) => void>} */
  const views = new Set();
  const invalidate = createFrameLoop(clock, () => {
    for (const view of order([...views])) {
      try {
        view(store.state);
      } catch (error) {
        views.delete(view);
        onError(error);
      }
    }
  });
  store.subscribe(invalidate);

  /**
   * @template Value
   * @param {(state: State) => Value} select
   * @param {(value: Value) => void} draw
   * @returns {() => void} remove
   */
  return function addView(select, draw) {
    /** @type {{ value: Value } | undefined} */
    let shown;
    const view = (/** @type {State} */ state) => {
      const value = select(state);
      if (shown && Object.is(value, shown.value)) return;
      shown = { value };
      draw(value);
    };
    views.add(view);
    invalidate();
    return () => void views.delete(view);
  };
}

/**
 * Several values as one: the same array as long as each of them is the same.
 * @template State
 * @template {readonly unknown[]} Values
 * @param {(state: State) => readonly [...Values]} select
 * @returns {(state: State) => readonly [...Values]}
 */
export function together(select) {
  /** @type {readonly [...Values] | undefined} */
  let last;
  return (state) => {
    const values = select(state);
    if (!last || values.some((value, i) => !Object.is(value, last?.[i]))) last = values;
    return last;
  };
}

/**
 * @template State
 * @typedef {<Value>(select: (state: State) => Value, draw: (value: Value) => void) => () => void} AddView
 */
