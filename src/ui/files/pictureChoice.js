/**
 * A picture of the scene before it is saved: what is to be in it, and how it looks.
 *
 * @import { Messages } from '../messages.js'
 *
 * @typedef {{ background: boolean, floor: boolean, labels: boolean }} PictureOptions  what is in the picture beside the arm
 * @typedef {(options: PictureOptions) => Promise<Blob>} TakePicture  a PNG of the scene, as it is seen now
 */
import { h } from '../parts/dom.js';
import { SAVE_AS } from '../words/saveAs.js';

const OPTIONS = /** @type {readonly (keyof PictureOptions)[]} */ (['background', 'floor', 'labels']);

/** @param {TakePicture} takePicture @param {Messages} messages */
export function createPictureChoice(takePicture, messages) {
  /** @type {PictureOptions} */
  const options = { background: true, floor: true, labels: true };
  const image = h('img', { alt: SAVE_AS.picture, draggable: 'false' });
  /** @type {Promise<Blob> | null} */
  let taken = null;
  let url = '';
  /** @type {(text: string) => void} */
  let say = () => {};

  async function retake() {
    const mine = takePicture({ ...options });
    taken = mine;
    try {
      const blob = await mine;
      if (taken !== mine) return;
      URL.revokeObjectURL(url);
      url = URL.createObjectURL(blob);
      image.src = url;
      await image.decode();
      say(SAVE_AS.pixels(image.naturalWidth, image.naturalHeight));
    } catch (error) {
      messages.fault(error);
    }
  }

  const boxes = OPTIONS.map((option) => {
    const box = h('input', { type: 'checkbox', checked: true });
    box.addEventListener('change', () => {
      options[option] = box.checked;
      void retake();
    });
    return h('label', {}, box, SAVE_AS[option]);
  });
  return {
    element: h(
      'div',
      { class: 'picture-choice' },
      image,
      h('fieldset', { class: 'picture-options', 'aria-label': SAVE_AS.show }, boxes),
    ),
    /** @param {(text: string) => void} onTaken  hears how large it is */
    take(onTaken) {
      say = onTaken;
      void retake();
    },
    blob: () => taken,
  };
}
