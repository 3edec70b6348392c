/**
 * The ellipsoid of velocities or of forces at the tool: a veil, the three ellipses in which its axes lie. Its scale is said
 * in the panel. Where the arm has lost a direction it is a disc or a line, and is drawn as one.
 *
 * @import { MarkSet, MarkTools } from './marks.js'
 * @import { EllipsoidKind } from '../../model/numbers/ellipsoid.js'
 */
import { Group, Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from 'three';
import { ellipsoidAt } from '../../model/numbers/ellipsoid.js';
import { disposeOf, fatLines, segmentsThrough } from '../fatLines.js';
import { createMarkSet } from './markSet.js';

const VEIL = 0.14;
const CORNERS = 64;
const ORDER = 30; // over the arm, below frames and handle

/** A flat ellipsoid still has a normal matrix: nothing is scaled to nothing. Metres. */
const THIN = 1e-6;

/** A circle of radius 1 about each axis in turn. */
const CIRCLES = [0, 1, 2].flatMap((axis) =>
  segmentsThrough(
    Array.from({ length: CORNERS + 1 }, (_, i) => {
      const angle = (2 * Math.PI * i) / CORNERS;
      const point = [0, 0, 0];
      point[(axis + 1) % 3] = Math.cos(angle);
      point[(axis + 2) % 3] = Math.sin(angle);
      return point;
    }),
  ),
);

/**
 * @param {MarkTools} tools
 * @returns {MarkSet & { want: (kind: EllipsoidKind | null) => void }}
 */
export const createEllipsoidMark = ({ scene, ...tools }) =>
  createMarkSet(tools, /** @type {EllipsoidKind | null} */ (null), ({ chain, posture }, wanted, skin) => {
    if (!wanted) return null;
    const group = new Group();
    group.matrixAutoUpdate = false;
    const material = new MeshBasicMaterial({
      ...{ color: skin.accent, transparent: true, opacity: VEIL, depthTest: false, depthWrite: false },
    });
    const veil = new Mesh(new SphereGeometry(1, 48, 24), material);
    veil.renderOrder = ORDER;
    const lines = fatLines(CIRCLES, { color: skin.accent, width: 1.5, opacity: 0.8, order: ORDER + 1 });
    veil.frustumCulled = false;
    group.add(veil, lines);
    scene.add(group);
    return {
      remove() {
        group.removeFromParent();
        disposeOf(veil);
        disposeOf(lines);
      },
      follow() {
        const { center, axes, drawn: halves } = ellipsoidAt(chain, posture, wanted);
        const [x, y, z] = [0, 1, 2].map((k) =>
          new Vector3().fromArray(axes, 3 * k).multiplyScalar(Math.max(THIN, halves[k])),
        );
        group.matrix.makeBasis(x, y, z).setPosition(center[0], center[1], center[2]);
        group.matrixWorldNeedsUpdate = true;
      },
    };
  });
