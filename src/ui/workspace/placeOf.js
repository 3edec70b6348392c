/**
 * The place of the plane that an event in a drawing of it is at.
 *
 * @import { Window } from '../../model/workspace/drawingWindow.js'
 */

/**
 * @param {MouseEvent} event
 * @param {Element} picture
 * @param {{ width: number, height: number }} size  of the drawing, in its own pixels
 * @param {{ x: number, y: number }} middle  where the middle of the window is drawn
 * @param {Window} window
 */
export function placeOf(event, picture, { width, height }, middle, { u, v, scale }) {
  const box = picture.getBoundingClientRect();
  const [px, py] = [
    ((event.clientX - box.left) / box.width) * width,
    ((event.clientY - box.top) / box.height) * height,
  ];
  return { u: u + (px - middle.x) / scale, v: v - (py - middle.y) / scale };
}
