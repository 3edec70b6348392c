/**
 * Light from the sky and the floor, a key light from front left above that casts the one shadow, and a rim light from
 * behind right.
 *
 * @import { Skin } from './skins.js'
 */
import { Color, DirectionalLight, Group, HemisphereLight, Vector3 } from 'three';

const KEY_FROM = new Vector3(-0.9, -1.5, 3.6).normalize();
const RIM_FROM = new Vector3(2.4, 1.6, 1.2).normalize();

/** @param {{ skin: Skin, isLow: boolean }} options */
export function createLights({ skin, isLow }) {
  const group = new Group();
  const sky = new HemisphereLight();
  const key = new DirectionalLight('#FFFFFF');
  const rim = new DirectionalLight('#DDE8FF');
  key.castShadow = !isLow;
  key.shadow.mapSize.set(2048, 2048);
  key.shadow.radius = 5;
  key.shadow.bias = -0.0006;
  group.add(sky, key, key.target, rim);

  /** @param {Skin} next */
  function setSkin(next) {
    sky.color.set(next.sky);
    sky.groundColor = new Color(next.ground);
    sky.intensity = next.hemisphere;
    key.intensity = next.key;
    rim.intensity = next.rim;
  }
  setSkin(skin);

  return {
    group,
    setSkin,
    /**
     * @param {number} radius  of the space about the middle that the arm can be in
     * @param {Vector3} middle
     */
    reachFor(radius, middle) {
      key.target.position.copy(middle);
      key.position.copy(middle).addScaledVector(KEY_FROM, 2.5 * radius);
      rim.position.copy(middle).addScaledVector(RIM_FROM, radius);
      const { camera } = key.shadow;
      Object.assign(camera, {
        left: -radius,
        right: radius,
        top: radius,
        bottom: -radius,
        near: radius,
        far: 4.5 * radius,
      });
      camera.updateProjectionMatrix();
      key.shadow.normalBias = 0.004 * radius;
    },
    dispose: () => key.dispose(),
  };
}
