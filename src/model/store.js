/**
 * The one mutable cell in the program.
 * @template State, Action
 * @param {State} initial
 * @param {(state: State, action: Action) => State} reduce  pure; returns the same object when nothing changed
 */
export function createStore(initial, reduce) {
  let state = initial;
  let notifying = false;
  /** @type {Set<() => void>} */
  const subscribers = new Set();

  return {
    get state() {
      return state;
    },

    /**
     * @param {Action} action
     * @throws whatever `reduce` throws at an impossible action; the state is then as it was
     */
    dispatch(action) {
      if (notifying) throw new Error('dispatch() inside a subscriber: derive the value instead.');
      const next = reduce(state, action);
      if (next === state) return;
      state = next;
      notifying = true;
      try {
        subscribers.forEach((notify) => notify());
      } finally {
        notifying = false;
      }
    },

    /** @param {() => void} notify @returns {() => void} unsubscribe */
    subscribe(notify) {
      subscribers.add(notify);
      return () => void subscribers.delete(notify);
    },
  };
}

/**
 * @template State, Action
 * @typedef {{ readonly state: State, dispatch: (action: Action) => void, subscribe: (notify: () => void) => () => void }} Store
 */
