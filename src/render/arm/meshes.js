/**
 * Parts → what Three.js draws. Parts that never move against each other and look alike become one mesh and one set of
 * edges.
 *
 * @import { Part } from './armParts.js'
 */
import { BufferGeometry, Float32BufferAttribute, Matrix4, Vector3 } from 'three';
import { solidOf } from './solid.js';

/**
 * @param {readonly Pick<Part, 'shape' | 'pose'>[]} parts
 * @returns {{ faces: BufferGeometry, edges: BufferGeometry, corners: Vector3[] }}
 *   `corners` are those of the boxes about the single parts: a tighter hull than one box about all
 */
export function geometryOf(parts) {
  /** @type {number[]} */
  const positions = [];
  /** @type {number[]} */
  const normals = [];
  /** @type {number[]} */
  const indices = [];
  /** @type {number[]} */
  const edges = [];
  /** @type {Vector3[]} */
  const corners = [];
  for (const { shape, pose } of parts) {
    const solid = solidOf(shape);
    const first = positions.length / 3;
    for (const index of solid.indices) indices.push(first + index);
    corners.push(...cornersOf(solid.positions, pose));
    transform(solid.positions, pose, 1, positions);
    transform(solid.normals, pose, 0, normals);
    transform(solid.edges, pose, 1, edges);
  }
  const faces = new BufferGeometry();
  faces.setAttribute('position', new Float32BufferAttribute(positions, 3));
  faces.setAttribute('normal', new Float32BufferAttribute(normals, 3));
  faces.setIndex(indices);
  const lines = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(edges, 3));
  return { faces, edges: lines, corners };
}

/**
 * @param {readonly number[]} points  x y z of each
 * @param {ArrayLike<number>} T
 * @param {0 | 1} w  1 for points, 0 for directions
 * @param {number[]} out  appended to
 */
function transform(points, T, w, out) {
  for (let i = 0; i < points.length; i += 3) {
    const x = points[i];
    const y = points[i + 1];
    const z = points[i + 2];
    out.push(
      T[0] * x + T[4] * y + T[8] * z + T[12] * w,
      T[1] * x + T[5] * y + T[9] * z + T[13] * w,
      T[2] * x + T[6] * y + T[10] * z + T[14] * w,
    );
  }
}

/** @param {readonly number[]} points @param {ArrayLike<number>} T */
function cornersOf(points, T) {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i++) {
    least[i % 3] = Math.min(least[i % 3], points[i]);
    most[i % 3] = Math.max(most[i % 3], points[i]);
  }
  const M = new Matrix4().fromArray(T);
  return Array.from({ length: 8 }, (_, i) => {
    const [x, y, z] = [0, 1, 2].map((k) => (i & (1 << k) ? most[k] : least[k]));
    return new Vector3(x, y, z).applyMatrix4(M);
  });
}
