/**
 * An angle of the table: an arc about the axis it turns about, from one axis to the other, with a dot where it begins and an
 * arrowhead where it ends; the arms of the angle and the axis are dash-dot, and have their names.
 *
 * @import { Dimension, DimensionOptions } from './measured.js'
 */
import { DoubleSide, BufferAttribute, BufferGeometry, Matrix4, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { within } from './drafting.js';
import { fatLines } from '../fatLines.js';

const RADIUS = /** @type {[number, number]} */ ([48, 96]); // pixels
const HEAD = 13;
const STEPS = 96;
const PITCH = 0.14 / (2 * Math.PI); // more than a turn winds outwards
const MOST = 6 * Math.PI; // a larger angle is drawn as three turns; its label has the number

/** @param {number} angle */
const radiusAt = (angle) => 1 + PITCH * Math.max(0, Math.abs(angle) - 2 * Math.PI);

/** @param {DimensionOptions} options @returns {Dimension} */
export function createAngleDimension({ drafting, skin, size, isVariable }) {
  const axes = { x: drafting.axis('x'), z: drafting.axis('z') };
  const arms = { x: [drafting.axis('x'), drafting.axis('x')], z: [drafting.axis('z'), drafting.axis('z')] };
  const tick = drafting.line(1.75);
  const head = drafting.arrowhead();
  const start = drafting.dot();
  const words = drafting.words();
  const arc = drafting.add(
    fatLines(
      Array.from({ length: 6 * STEPS }, () => 0),
      { color: skin.accent, width: 1.75, order: 40 },
    ),
  );
  const fan = new BufferAttribute(new Float32Array(3 * (STEPS + 2)), 3);
  const sector = drafting.add(
    new Mesh(
      new BufferGeometry()
        .setAttribute('position', fan)
        .setIndex(Array.from({ length: STEPS }, (_, i) => [0, i + 1, i + 2]).flat()),
      new MeshBasicMaterial({
        ...{ color: skin.accent, opacity: 0.13, transparent: true },
        ...{ side: DoubleSide, depthTest: false, depthWrite: false },
      }),
    ),
  );
  sector.renderOrder = 33;
  const placed = new Matrix4();
  let spread = NaN;

  /** The arc and what it encloses, in the plane of x and y, for a radius of one. @param {number} angle */
  function bend(angle) {
    if (angle === spread) return;
    spread = angle;
    const { instanceStart } = arc.geometry.attributes;
    const ends = /** @type {{ data: { array: Float32Array, needsUpdate: boolean } }} */ (
      /** @type {unknown} */ (instanceStart)
    ).data;
    let last = [1, 0];
    fan.setXYZ(0, 0, 0, 0);
    fan.setXYZ(1, 1, 0, 0);
    for (let i = 1; i <= STEPS; i++) {
      const t = (angle * i) / STEPS;
      const next = [radiusAt(t) * Math.cos(t), radiusAt(t) * Math.sin(t)];
      ends.array.set([...last, 0, ...next, 0], 6 * (i - 1));
      fan.setXYZ(i + 1, next[0], next[1], 0);
      last = next;
    }
    ends.needsUpdate = true;
    fan.needsUpdate = true;
  }

  return {
    words,
    face(eye, { from: at, axis, across, shown }) {
      const perPixel = eye.perPixel(at);
      const radius = within(0.1 * size, perPixel, RADIUS);
      const isZero = Math.abs(shown) < 1e-9;
      const angle = Math.max(-MOST, Math.min(MOST, shown));
      const [u, w] = [across[0].way, axis.way];
      const v = new Vector3().crossVectors(w, u);
      const point = (/** @type {number} */ t, /** @type {number} */ share) =>
        at
          .clone()
          .addScaledVector(u, radius * share * Math.cos(t))
          .addScaledVector(v, radius * share * Math.sin(t));

      for (const name of /** @type {const} */ (['x', 'z'])) {
        const isAxis = name === axis.name;
        axes[name].show(isAxis);
        if (isAxis) {
          const ends = [-0.7, 1.3].map((share) => at.clone().addScaledVector(w, share * radius));
          axes[name].lay(ends[0], ends[1], perPixel, axis.number);
        }
        arms[name].forEach((arm, i) => {
          const isUsed = name === across[i].name && !(i === 1 && isZero);
          arm.show(isUsed);
          if (isUsed) arm.lay(at, at.clone().addScaledVector(across[i].way, 1.4 * radius), perPixel, across[i].number);
        });
      }

      for (const mesh of [arc, sector, head.mesh]) mesh.visible = !isZero;
      start.lay(isZero ? point(0, 1) : point(0, 1), (isZero ? 5 : 3) * perPixel);
      tick.line.visible = isVariable && !isZero && axis.constant !== 0 && Math.abs(axis.constant - shown) > 1e-9;
      if (!isZero) {
        const length = Math.min(HEAD * perPixel, 0.6 * radius * Math.abs(angle));
        const tip = point(angle, radiusAt(angle));
        // the chord under the head, so that it lies on the arc
        const back = angle - (Math.sign(angle) * length) / (radius * radiusAt(angle));
        const foot = point(back, radiusAt(back));
        bend(angle);
        placed.makeBasis(u.clone().multiplyScalar(radius), v.clone().multiplyScalar(radius), w).setPosition(at);
        for (const mesh of [arc, sector]) {
          mesh.matrix.copy(placed);
          mesh.matrixWorldNeedsUpdate = true;
        }
        head.lay(tip, tip.clone().sub(foot).normalize(), length);
        if (tick.line.visible) {
          const stop = Math.max(-MOST, Math.min(MOST, axis.constant));
          tick.lay(point(stop, radiusAt(stop) - 0.1), point(stop, radiusAt(stop) + 0.1));
        }
      }
      words.at.copy(point(isZero ? 0 : angle / 2, radiusAt(angle / 2)));
      words.from = at.clone();
    },
  };
}
