/** The handle at the tool: it can be taken hold of where it was drawn, and not before. */
import { PerspectiveCamera, Scene } from 'three';
import { expect, test } from 'vitest';
import { createHandle } from '../../../src/render/drag/handle.js';
import { eyeOf } from '../../../src/render/eye.js';
import { skinOf } from '../../../src/render/skins.js';
import { fakeLabels } from './fakeLabels.js';

const NOW = {
  T_world_handle: Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.4, 0.2, 0.3, 1),
  ...{ lit: null, isHeld: false, T_world_ghost: null },
};

function eye() {
  const camera = new PerspectiveCamera(24, 4 / 3, 0.1, 50);
  camera.position.set(3, 2, 1);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return eyeOf(camera, 800, 600);
}

test('there is nothing to take hold of until it has been drawn where it is', () => {
  const handle = createHandle({
    ...{ scene: new Scene(), labels: fakeLabels(), skin: skinOf('light', () => '#000000') },
    missing: () => '',
    linkGroup: () => {
      throw new Error('The handle stands in the world.');
    },
  });
  expect(handle.seen).toBeNull();
  handle.face(eye()); // a picture without it
  handle.place(NOW);
  expect(handle.seen).toBeNull();
  handle.face(eye());
  expect(handle.seen?.placed).toMatchObject({ centre: [0.4, 0.2, 0.3], axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]] }); // prettier-ignore
  handle.place(null);
  handle.place(NOW);
  expect(handle.seen).toBeNull();
});
