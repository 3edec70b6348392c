/**
 * The path of the tool over a whole program: the faster, the brighter, with dots that are the same time apart; solid where the
 * tool has been, dashed where it is still to go, faint where the arm or the floor hides it; the numbers of the steps at the
 * ends of their moves.
 *
 * @import { MarkSet, MarkTools } from './marks.js'
 * @import { Skin } from '../skins.js'
 * @import { ToolPathShown } from '../../model/program/toolPathShown.js'
 *
 * @typedef {{ readonly path: ToolPathShown, readonly time: number } | null} PathWanted
 */
import { Color, Group, SRGBColorSpace } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { indexAt, valueAt } from '../../model/program/planSeries.js';
import { createMarkSet } from './markSet.js';

const WIDTH = { done: 3.5, ahead: 2.25, dot: 6 };
const HIDDEN = 0.3;
const ORDER = 10; // over the arm, below the trace
const DASH = { dashSize: 0.014, gapSize: 0.01 }; // in sizes of the arm
/** More numbers than these would be a cloud. */
const MOST_NUMBERS = 40;
const SAME_PLACE = 1e-4; // in sizes of the arm; likewise
const NEXT_TO_NOTHING = 1e-4;

/**
 * @param {MarkTools} tools
 * @returns {MarkSet & { want: (wanted: PathWanted) => void }}
 */
export function createPathMark(tools) {
  const { scene, labels } = tools;
  return createMarkSet(tools, /** @type {PathWanted} */ (null), ({ parts: { size } }, wanted, skin) => {
    if (!wanted) return null;
    const { path } = wanted;
    const { series } = path;
    const lines = linesOf(series, path.most, skin, size);
    const dots = dotsOf(path, skin, size);
    const group = new Group();
    group.add(...lines.objects, ...dots.objects);
    scene.add(group);
    const numbers = numbersOf(path, size).map(({ at, text }) => {
      const label = Object.assign(labels.add('tick path-step'), { gap: 7, yields: true });
      label.at.fromArray(at);
      label.write(text);
      return label;
    });
    let { time } = wanted;
    return {
      remove() {
        group.removeFromParent();
        for (const each of [...lines.owned, ...dots.owned]) each.dispose();
        for (const label of numbers) label.remove();
      },
      follow: () => lines.setDone(indexAt(series.times, time)),
      take(next) {
        if (next?.path !== path) return false;
        time = next.time;
        return true;
      },
    };
  });
}

/** @param {ToolPathShown['series']} series @param {number} most @param {Skin} skin @param {number} size */
function linesOf({ place, speed }, most, skin, size) {
  const { length } = speed;
  const points = new Float32Array(6 * (length - 1));
  const colours = new Float32Array(6 * (length - 1));
  const paint = painter(skin);
  for (let k = 0; k < length - 1; k++) {
    for (const end of [0, 1]) {
      for (let i = 0; i < 3; i++) points[6 * k + 3 * end + i] = place[i][k + end];
      paint(most > 0 ? speed[k + end] / most : 0, colours, 6 * k + 3 * end);
    }
  }
  const [ahead, done] = [0, 1].map(() => {
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(points);
    geometry.setColors(colours);
    return geometry;
  });
  const style = { vertexColors: true, transparent: true, depthWrite: false };
  const dashed = { dashed: true, dashSize: DASH.dashSize * size, gapSize: DASH.gapSize * size };
  const materials = [
    new LineMaterial({ ...style, ...dashed, linewidth: WIDTH.ahead, opacity: HIDDEN, depthTest: false }),
    new LineMaterial({ ...style, ...dashed, linewidth: WIDTH.ahead }),
    new LineMaterial({ ...style, linewidth: WIDTH.done }),
  ];
  const objects = materials.map((material, i) => {
    const object = new LineSegments2(i < 2 ? ahead : done, material);
    object.renderOrder = ORDER + i;
    object.frustumCulled = false;
    return object;
  });
  objects[0].computeLineDistances();
  return {
    objects,
    owned: [ahead, done, ...materials],
    /** @param {number} segments */
    setDone(segments) {
      done.instanceCount = segments;
      objects[2].visible = segments > 0;
    },
  };
}

/** A dot is a line of next to no length, which has round ends. @param {ToolPathShown} path @param {Skin} skin @param {number} size */
function dotsOf({ series, dotEvery }, skin, size) {
  const { times, place } = series;
  const count = Math.floor(times[times.length - 1] / dotEvery) + 1;
  const at = Float32Array.from({ length: 6 * count }, (_, i) => {
    const time = Math.floor(i / 6) * dotEvery;
    return valueAt(times, place[i % 3], time) + (i % 6 === 5 ? NEXT_TO_NOTHING * size : 0);
  });
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(at);
  const material = new LineMaterial({ color: skin.ink, linewidth: WIDTH.dot, depthWrite: false });
  const dots = new LineSegments2(geometry, material);
  dots.renderOrder = ORDER + 3;
  dots.frustumCulled = false;
  return { objects: [dots], owned: [geometry, material] };
}

/** Writes the colour of a speed, as a share of the greatest; evenly to the eye, as the legend has it. @param {Skin} skin */
function painter({ trace, traceSlow }) {
  const [slow, fast] = [traceSlow, trace].map((text) => {
    const rgb = { r: 0, g: 0, b: 0 };
    new Color(text).getRGB(rgb, SRGBColorSpace);
    return rgb;
  });
  const colour = new Color();
  /** @param {number} share @param {Float32Array} out @param {number} at */
  return (share, out, at) => {
    const mix = (/** @type {'r' | 'g' | 'b'} */ part) => slow[part] + share * (fast[part] - slow[part]);
    colour.setRGB(mix('r'), mix('g'), mix('b'), SRGBColorSpace).toArray(out, at);
  };
}

/** Where moves end, with the numbers of all steps that end there: "1, 10". @param {ToolPathShown} path @param {number} size */
function numbersOf({ series: { times, place }, ends }, size) {
  if (ends.length > MOST_NUMBERS) return [];
  /** @type {{ at: number[], steps: number[] }[]} */
  const places = [];
  for (const { time, step } of ends) {
    const at = place.map((column) => valueAt(times, column, time));
    const same = places.find((one) => Math.hypot(...one.at.map((x, i) => x - at[i])) < SAME_PLACE * size);
    if (same && !same.steps.includes(step)) same.steps.push(step);
    if (!same) places.push({ at, steps: [step] });
  }
  return places.map(({ at, steps }) => ({ at, text: steps.map((step) => String(step + 1)).join(', ') }));
}
