/**
 * The page's clock: the only file that asks the browser for the time and for frames.
 * @import { Clock } from '../model/clock.js'
 */
import { fromMilliseconds, toMilliseconds } from '../model/units.js';

/** @returns {Clock} */
export const createBrowserClock = () => ({
  now: () => fromMilliseconds(performance.now()),
  onFrame: (callback) => void requestAnimationFrame(() => callback()),
  after(seconds, callback) {
    const timer = setTimeout(callback, toMilliseconds(seconds));
    return () => clearTimeout(timer);
  },
});

/** Now, for people: ISO 8601. */
export const today = () => new Date().toISOString();

/** @param {string} text  ISO 8601 */
export const dateOf = (text) => new Date(text);
