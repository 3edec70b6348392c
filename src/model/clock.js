/**
 * Time as a dependency. Only the page's own clock (ui/browserClock.js) asks the browser; everything else is handed one,
 * so that a session can be replayed exactly.
 *
 * @typedef {object} Clock
 * @property {() => number} now                          seconds
 * @property {(callback: () => void) => void} onFrame    once, at the next frame
 * @property {(seconds: number, callback: () => void) => () => void} after  once, later; returns cancel
 *
 * @typedef {Clock & { tick: (seconds?: number) => void, readonly idle: boolean }} ManualClock
 */

/**
 * A clock that moves only when a test says so.
 * @returns {ManualClock}
 */
export function createManualClock() {
  let time = 0;
  /** @type {(() => void)[]} */
  let frames = [];
  /** @type {Set<{ at: number, callback: () => void }>} */
  const timers = new Set();
  return {
    now: () => time,
    onFrame: (callback) => void frames.push(callback),
    after(seconds, callback) {
      const timer = { at: time + seconds, callback };
      timers.add(timer);
      return () => void timers.delete(timer);
    },
    tick(seconds = 1 / 60) {
      time += seconds;
      for (const timer of [...timers].sort((x, y) => x.at - y.at)) {
        if (timer.at <= time && timers.delete(timer)) timer.callback();
      }
      const due = frames;
      frames = [];
      for (const callback of due) callback();
    },
    get idle() {
      return frames.length === 0 && timers.size === 0;
    },
  };
}

/**
 * Call `draw` at most once a frame, and only after something asked for it.
 * @param {Clock} clock
 * @param {() => void} draw
 * @returns {() => void} ask for a frame
 */
export function createFrameLoop(clock, draw) {
  let asked = false;
  return function invalidate() {
    if (asked) return;
    asked = true;
    clock.onFrame(() => {
      asked = false;
      draw();
    });
  };
}
