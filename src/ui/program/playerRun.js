/**
 * Runs a motion program: in each of the page's frames a little of its time, and the arm where it is then. Playing stands
 * outside the history. What stops it is said.
 *
 * @import { Page } from '../page.js'
 * @import { Planned } from '../../model/program/planned.js'
 * @import { Playback } from '../../model/program/player.js'
 */
import { planNow, playbackNow } from '../../model/program/planning.js';
import { after, pause } from '../../model/program/player.js';
import { postureAt } from '../../model/program/planPosture.js';
import { TIMELINE } from '../words/timeline.js';

/** @param {Page} page */
export function createPlayerRun({ store, clock, announce }) {
  let isRunning = false;

  /** The arm goes where the playback says. @param {Playback} next @param {Planned} planned */
  function put(next, planned) {
    const posture = postureAt(store.state.doc.robot, planned.plan, next);
    store.dispatch({ type: 'stand', posture });
    store.dispatch({ type: 'show', change: { playback: { ...next, posture: store.state.doc.posture } } });
  }

  /** @param {string} why  in a sentence */
  function stop(why) {
    const { playback } = store.state.session;
    if (!playback?.isPlaying) return;
    store.dispatch({ type: 'show', change: { playback: pause(playback) } });
    announce(why);
  }

  function run() {
    if (isRunning) return;
    isRunning = true;
    let last = clock.now();
    const goOn = () => {
      const { session, doc, gesture } = store.state;
      const { playback } = session;
      if (!playback?.isPlaying) {
        isRunning = false;
        return;
      }
      clock.onFrame(goOn); // before anything is drawn of what is done here
      const planned = planNow(store.state);
      // somebody else has moved the arm, or is about to
      if (doc.posture !== playback.posture || gesture) return stop(TIMELINE.stopped.moved);
      if (!planned) return stop(TIMELINE.stopped.changed);
      const seconds = clock.now() - last;
      last = clock.now();
      const next = after(playback, seconds, planned.plan.duration);
      put(next, planned);
      if (!next.isPlaying) announce(planned.plan.refused ? TIMELINE.stopped.refused : TIMELINE.stopped.end);
    };
    clock.onFrame(goOn);
  }

  return {
    /**
     * @param {(playback: Playback, planned: Planned) => Playback} change
     * @returns {boolean}  whether there was a plan to play
     */
    act(change) {
      const playback = playbackNow(store.state);
      const planned = planNow(store.state);
      if (!playback || !planned) {
        announce(TIMELINE.notPlanned);
        return false;
      }
      put(change(playback, planned), planned);
      if (store.state.session.playback?.isPlaying) run();
      return true;
    },

    /** What moves no arm: speed, loop, what is drawn. @param {(playback: Playback) => Playback} change */
    set(change) {
      const playback = playbackNow(store.state);
      if (playback) store.dispatch({ type: 'show', change: { playback: change(playback) } });
    },

    stop,
  };
}

/** @typedef {ReturnType<typeof createPlayerRun>} PlayerRun */
