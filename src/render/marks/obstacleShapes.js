/**
 * Obstacles of the size 1, to be stretched to their own: faces that a light falls on, and the lines that bound them.
 *
 * @import { BufferGeometry } from 'three'
 * @import { ObstacleDoc } from '../../model/document.js'
 */
import { identity } from '../../kinematics/pose.js';
import { geometryOf } from '../arm/meshes.js';

const ROUND = 64;
const LEVELS = 24;

/** Of a plane: strokes along its border, on the side that is filled, as on a drawing of the ground. */
const STROKES = 16;
const STROKE = 0.04;

/** @param {number} x @param {number} y */
const corner = (x, y) => ({ x, y, radius: 0, sharp: true });

/** A circle as segments. @param {(angle: number) => readonly number[]} at */
const circle = (at) =>
  Array.from({ length: ROUND }, (_, i) =>
    [i, i + 1].flatMap((k) => /** @type {number[]} */ ([...at((2 * Math.PI * k) / ROUND)])),
  ).flat();

/** @param {number} half */
const square = (half) => [corner(half, half), corner(-half, half), corner(-half, -half), corner(half, -half)];

const SHAPES = {
  box: {
    corners: square(0.5),
    profile: [[0, -0.5], [0, 0.5]], // prettier-ignore
  },
  sphere: {
    corners: [{ x: 0, y: 0, radius: 1 }],
    profile: Array.from({ length: LEVELS + 1 }, (_, i) => {
      const angle = Math.PI * (i / LEVELS - 0.5);
      return [1 - Math.cos(angle), Math.sin(angle)];
    }),
  },
  cylinder: {
    corners: [{ x: 0, y: 0, radius: 1 }],
    profile: [[0, -0.5], [0, 0.5]], // prettier-ignore
  },
  plane: {
    corners: square(1),
    profile: [[0, -1e-4], [0, 0]], // prettier-ignore
  },
};

/**
 * @param {ObstacleDoc['kind']} kind
 * @returns {{ faces: BufferGeometry, lines: number[] }}  lines: x y z of each end
 */
export function obstacleShape(kind) {
  const { corners, profile } = SHAPES[kind];
  const shape = { corners, profile: /** @type {[number, number][]} */ (profile) };
  const { faces, edges } = geometryOf([{ shape, pose: identity() }]);
  const bounds = Array.from(edges.getAttribute('position').array);
  edges.dispose();
  if (kind === 'sphere') {
    // round to the eye: each point looks straight outwards
    faces.setAttribute('normal', faces.getAttribute('position').clone());
    return {
      faces,
      lines: [
        ...circle((a) => [Math.cos(a), Math.sin(a), 0]),
        ...circle((a) => [Math.cos(a), 0, Math.sin(a)]),
        ...circle((a) => [0, Math.cos(a), Math.sin(a)]),
      ],
    };
  }
  return { faces, lines: kind === 'plane' ? groundLines() : bounds };
}

/** The border of a plane, and strokes that lean down from it. */
function groundLines() {
  const ends = [
    [1, 1],
    [-1, 1],
    [-1, -1],
    [1, -1],
  ];
  return ends.flatMap(([x, y], i) => {
    const [toX, toY] = ends[(i + 1) % ends.length];
    const border = [x, y, 0, toX, toY, 0];
    const strokes = Array.from({ length: STROKES }, (_, k) => {
      const at = (/** @type {number} */ share) => [x + share * (toX - x), y + share * (toY - y)];
      const [from, to] = [at((k + 0.5) / STROKES), at((k + 0.5) / STROKES - STROKE / 2)];
      return [...from, 0, ...to, -STROKE];
    });
    return [...border, ...strokes.flat()];
  });
}
