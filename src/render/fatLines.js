/**
 * Lines of a width in pixels, on top of everything: frames, gauges, the way to a target.
 * @import { ColorRepresentation, Object3D } from 'three'
 */
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

/**
 * @param {readonly number[]} segments  x y z of each end
 * @param {{ color?: ColorRepresentation, colors?: readonly number[], width: number, opacity?: number, dash?: number, order: number }} style
 *   `colors` are r g b of each end, instead of one colour
 */
export function fatLines(segments, { color = '#FFFFFF', colors, width, opacity = 1, dash = 0, order }) {
  const geometry = new LineSegmentsGeometry().setPositions([...segments]);
  if (colors) geometry.setColors([...colors]);
  const material = new LineMaterial({
    color,
    linewidth: width,
    opacity,
    transparent: true,
    depthTest: false,
    depthWrite: false,
    vertexColors: Boolean(colors),
    dashed: dash > 0,
    dashSize: dash,
    gapSize: dash,
  });
  const lines = new LineSegments2(geometry, material);
  if (dash > 0) lines.computeLineDistances();
  lines.renderOrder = order;
  lines.frustumCulled = false;
  return lines;
}

/** A line through points, as the segments that make it. @param {readonly (readonly number[])[]} points */
export const segmentsThrough = (points) => points.slice(1).flatMap((point, i) => [...points[i], ...point]);

/** @param {{ geometry: { dispose: () => void }, material: unknown }} drawn */
export function disposeOf({ geometry, material }) {
  geometry.dispose();
  for (const one of [material].flat()) /** @type {{ dispose: () => void }} */ (one).dispose();
}

/** A line that `spanLine` lays between any two points without building it again. @param {Parameters<typeof fatLines>[1]} style */
export function movableLine(style) {
  const line = fatLines([0, 0, 0, 1, 0, 0], style);
  line.matrixAutoUpdate = false;
  return line;
}

/**
 * @param {Object3D} line
 * @param {ArrayLike<number>} from  in the frame of its parent
 * @param {ArrayLike<number>} to
 */
export function spanLine(line, from, to) {
  const [x, y, z] = [from[0], from[1], from[2]];
  // x runs along it; a line has no use for y and z
  line.matrix.set(to[0] - x, 0, 0, x, to[1] - y, 0, 0, y, to[2] - z, 0, 0, z, 0, 0, 0, 1);
  line.matrixWorldNeedsUpdate = true;
}
