/**
 * What the scene shows of the code that is open: the path of the tool, with the numbers of the lines at the ends of their motions. A
 * press on one of them asks for its line.
 *
 * @import { Eye } from './eye.js'
 * @import { Stage } from './stage.js'
 * @import { State } from './robotView.js'
 */
import { Vector3 } from 'three';
import { codePathShown } from '../model/code/codePathShown.js';
import { createPathMark } from './marks/pathMark.js';

/** Pixels about a point, with its number. */
const NEAR = { fine: 22, coarse: 30 };

/** @param {Pick<State, 'store' | 'addView'>} state @param {Stage} stage */
export function createCodeView({ store, addView }, stage) {
  /** @type {Eye | null} */
  let eye = null;
  const path = stage.addMarks((tools) => {
    const set = createPathMark(tools);
    return {
      ...set,
      face(/** @type {Eye} */ next) {
        eye = next;
        set.face?.(next);
      },
    };
  });
  addView(codePathShown, (shown) => {
    path.want(shown && { path: shown.shown, time: 0 });
    stage.touch();
  });

  /** The line of the point that is nearest. @param {{ clientX: number, clientY: number, pointerType?: string }} event */
  function lineAt({ clientX, clientY, pointerType }) {
    const shown = codePathShown(store.state);
    if (!shown || !eye) return null;
    const { left, top } = stage.canvas.getBoundingClientRect();
    const seen = new Vector3();
    let [line, least] = [/** @type {number | null} */ (null), pointerType === 'touch' ? NEAR.coarse : NEAR.fine];
    for (const point of shown.points) {
      eye.project(seen.fromArray(point.at), seen);
      const distance = Math.hypot(seen.x - (clientX - left), seen.y - (clientY - top));
      if (distance < least) [line, least] = [point.line, distance];
    }
    return line;
  }

  // a point that can be pressed says so; the hand on the tool comes first
  stage.canvas.addEventListener('pointermove', (event) => {
    stage.canvas.classList.toggle('is-over-point', event.buttons === 0 && lineAt(event) !== null);
  });
  stage.canvas.addEventListener('click', (event) => {
    const line = lineAt(/** @type {PointerEvent} */ (event));
    if (line !== null)
      store.dispatch({ type: 'show', change: { code: { ...store.state.session.code, asked: { line } } } });
  });
}
