/**
 * A cube that turns with the view and whose faces can be clicked. It is for the pointer alone: the menu of views beside it
 * says and does the same for everybody.
 *
 * @import { Direction } from './viewMenu.js'
 */
import $ from 'jquery/slim';
import { h } from '../parts/dom.js';
import { TEXT } from '../strings.js';

/** @type {readonly Direction[]} */
const FACES = ['front', 'back', 'left', 'right', 'top', 'bottom'];

/** @param {(face: Direction) => void} look */
export function createViewCube(look) {
  const faces = FACES.map((face) =>
    h('span', { class: 'face', 'data-face': face, title: TEXT.view.direction[face] }, TEXT.view.direction[face]),
  );
  const cube = h('div', { class: 'cube' }, faces);
  $(cube).on('click', '[data-face]', ({ currentTarget }) => look(currentTarget.dataset.face));
  return {
    element: h('div', { class: 'view-cube', 'aria-hidden': 'true' }, cube),
    /** @param {{ azimuth: number, elevation: number }} seen  radians, from what is looked at to the camera */
    turn({ azimuth, elevation }) {
      // the front face looks along −y, where the azimuth is a quarter turn less than nothing
      cube.style.transform = `rotateX(${(-elevation).toFixed(4)}rad) rotateY(${(-azimuth - Math.PI / 2).toFixed(4)}rad)`;
    },
  };
}
