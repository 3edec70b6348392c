/**
 * The arm as the check sees it: a capsule for every stretch. All of them where that is wanted; those of links that touch
 * something in any case, in another colour and with rings around them. Seen through the arm, which they mostly hide in.
 *
 * @import { ArmNow, MarkSet, MarkTools } from './marks.js'
 * @import { Capsule } from '../../model/workcell/workcell.js'
 *
 * @typedef {{ readonly capsules: readonly Capsule[], readonly isShown: boolean, readonly touching: ReadonlySet<number> } | null} CapsulesWanted
 *   touching: links
 */
import { Group, Matrix4, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { identity } from '../../kinematics/pose.js';
import { geometryOf } from '../arm/meshes.js';

const TINT = { usual: 0.2, touching: 0.42 };
const WIDTH = { usual: 1.25, touching: 2.5 };
const ORDER = 5; // after the arm and its obstacles, before the marks
const LEVELS = 8; // of a round end
const ROUND = 40;
const RINGS = 4; // around a capsule that touches, and two around any other
const SAME = 1e-6; // m

/** @typedef {{ length: number, radius: number, isTouching: boolean, group: Group, parts: (Mesh | LineSegments2)[] }} Drawn */

/** @param {MarkTools} tools */
export function createCapsuleMarks({ scene, skin }) {
  const root = new Group();
  root.matrixAutoUpdate = false;
  scene.add(root);
  const over = { transparent: true, depthWrite: false, depthTest: false };
  const kinds = {
    usual: { tint: new MeshBasicMaterial(over), line: new LineMaterial({ ...over, linewidth: WIDTH.usual }) },
    touching: { tint: new MeshBasicMaterial(over), line: new LineMaterial({ ...over, linewidth: WIDTH.touching }) },
  };
  /** @type {ArmNow | null} */
  let arm = null;
  /** @type {CapsulesWanted} */
  let wanted = null;
  /** @type {Drawn[]} */
  let drawn = [];

  function paint() {
    for (const kind of /** @type {const} */ (['usual', 'touching'])) {
      const { tint, line } = kinds[kind];
      const colour = kind === 'touching' ? skin.bad : skin.accent;
      tint.color.set(colour);
      line.color.set(colour);
      tint.opacity = TINT[kind];
      line.opacity = kind === 'touching' ? 1 : 0.7;
    }
  }
  paint();

  /** @param {Drawn | undefined} one */
  function remove(one) {
    if (!one) return;
    one.group.removeFromParent();
    for (const { geometry } of one.parts) geometry.dispose();
  }

  function clear() {
    drawn.forEach(remove);
    drawn = [];
  }

  /** @param {number} length @param {number} radius @param {boolean} isTouching @param {number} order */
  function create(length, radius, isTouching, order) {
    const { tint, line } = kinds[isTouching ? 'touching' : 'usual'];
    const { faces, edges } = geometryOf([{ shape: capsuleShape(length, radius), pose: identity() }]);
    edges.dispose();
    const rings = new LineSegmentsGeometry().setPositions(ringsOf(length, radius, isTouching ? RINGS : 2));
    const parts = [new Mesh(faces, tint), new LineSegments2(rings, line)];
    const group = new Group();
    group.matrixAutoUpdate = false;
    parts.forEach((part, i) => {
      part.matrixAutoUpdate = false;
      part.frustumCulled = false;
      part.renderOrder = order + i;
      group.add(part);
    });
    root.add(group);
    return { length, radius, isTouching, group, parts };
  }

  function build() {
    const now = wanted;
    if (!arm || !now) return clear();
    const seen = now.capsules.filter(({ link }) => now.isShown || now.touching.has(link));
    for (const old of drawn.splice(seen.length)) remove(old);
    seen.forEach(({ link, radius, ends }, i) => {
      const axis = [0, 1, 2].map((k) => ends[3 + k] - ends[k]);
      const length = Math.hypot(...axis);
      const isTouching = now.touching.has(link);
      const old = drawn[i];
      const isSame =
        old && Math.abs(old.length - length) < SAME && old.radius === radius && old.isTouching === isTouching;
      if (!isSame) {
        remove(old);
        drawn[i] = create(length, radius, isTouching, ORDER + 2 * i);
      }
      drawn[i].group.matrix.copy(placeOf(ends, axis, length));
      drawn[i].group.matrixWorldNeedsUpdate = true;
    });
  }

  /** @satisfies {MarkSet & Record<string, unknown>} */
  const set = {
    show(/** @type {ArmNow | null} */ next) {
      arm = next;
      build();
    },
    follow() {}, // whoever wants them says where they are
    clear,
    build,
    setSkin(/** @type {typeof skin} */ next) {
      skin = next;
      paint();
    },
    /** @param {CapsulesWanted} next */
    want(next) {
      wanted = next;
      build();
    },
  };
  return set;
}

/** Along z, from its first end. @param {number} length @param {number} radius */
function capsuleShape(length, radius) {
  const cap = Array.from({ length: LEVELS + 1 }, (_, i) => (Math.PI / 2) * (i / LEVELS));
  /** @type {[number, number][]} */
  const profile = [
    ...cap.map((a) => /** @type {[number, number]} */ ([radius * (1 - Math.sin(a)), -radius * Math.cos(a)])),
    ...cap.map((a) => /** @type {[number, number]} */ ([radius * (1 - Math.cos(a)), length + radius * Math.sin(a)])),
  ];
  return { corners: [{ x: 0, y: 0, radius }], profile };
}

/** @param {number} length @param {number} radius @param {number} count */
const ringsOf = (length, radius, count) =>
  Array.from({ length: count }, (_, i) => (length * i) / (count - 1)).flatMap((z) =>
    Array.from({ length: ROUND }, (_, k) =>
      [k, k + 1].flatMap((at) => {
        const angle = (2 * Math.PI * at) / ROUND;
        return [radius * Math.cos(angle), radius * Math.sin(angle), z];
      }),
    ).flat(),
  );

/** @param {Float64Array} ends @param {number[]} axis @param {number} length */
function placeOf(ends, axis, length) {
  const z = new Vector3(...(length > 0 ? axis.map((value) => value / length) : [0, 0, 1]));
  const x = new Vector3(Math.abs(z.x) < 0.9 ? 1 : 0, Math.abs(z.x) < 0.9 ? 0 : 1, 0).cross(z).normalize();
  return new Matrix4().makeBasis(x, new Vector3().crossVectors(z, x), z).setPosition(ends[0], ends[1], ends[2]);
}
