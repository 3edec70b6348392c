/**
 * The hand in the scene is fetched when it first comes near: a pointer over the view, or the keyboard's focus in it.
 *
 * @import { DragOptions } from './dragTool.js'
 * @import { State } from '../robotView.js'
 */

/**
 * @param {State} state
 * @param {DragOptions} options
 */
export function dragWhenNear(state, options) {
  const { room, stage, onError } = options;
  let isOver = false;
  let isWanted = false;

  async function fetchIt() {
    if (isWanted) return;
    isWanted = true;
    try {
      const { createToolDrag } = await import('./dragTool.js');
      createToolDrag(state, { ...options, isOver });
      forget();
    } catch (error) {
      isWanted = false; // and again when it next comes near
      onError(error);
    }
  }
  function onEnter() {
    isOver = true;
    fetchIt();
  }
  function onLeave() {
    isOver = false;
  }
  function forget() {
    room.removeEventListener('pointerenter', onEnter);
    room.removeEventListener('pointerleave', onLeave);
    stage.canvas.removeEventListener('focus', fetchIt);
  }
  room.addEventListener('pointerenter', onEnter);
  room.addEventListener('pointerleave', onLeave);
  stage.canvas.addEventListener('focus', fetchIt);
}
