/**
 * Work in pieces of some milliseconds, the first at once and then one a frame, so that nothing waits for it.
 *
 * @import { Clock } from '../model/clock.js'
 */

/**
 * @param {Clock} clock
 * @param {Generator<unknown, void>} work
 * @returns {() => void} give it up
 */
export function inSlices(clock, work) {
  let isOn = true;
  function goOn() {
    if (isOn && !work.next().done) clock.onFrame(goOn);
  }
  goOn();
  return () => void (isOn = false);
}
