/** The path of a program in the scene: its colours say speed, its dots time, its numbers where steps end; and nothing is left behind. */
import { Color, Scene, SRGBColorSpace } from 'three';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { expect, test } from 'vitest';
import { createPathMark } from '../../../src/render/marks/pathMark.js';
import { skinOf } from '../../../src/render/skins.js';
import { fakeLabels } from './fakeLabels.js';

/** @import { ToolPathShown } from '../../../src/model/program/toolPathShown.js' */
/** @import { ArmNow } from '../../../src/render/marks/marks.js' */

const SIZE = 2;
const arm = /** @type {ArmNow} */ (/** @type {unknown} */ ({ parts: { size: SIZE } }));
/** Along x from rest: half of t², so at 1, 2, 3 and 4 s as fast in m/s. */
const times = Float64Array.of(0, 1, 2, 3, 4);
const place = [times.map((t) => (t * t) / 2), times.map(() => 0.5), times.map(() => 1)];
/** @type {ToolPathShown} */
const PATH = {
  series: { times, place, speed: times.slice() },
  most: 4,
  dotEvery: 2,
  ends: [
    { time: 0, step: 0 },
    { time: 2, step: 1 },
    { time: 4, step: 3 },
    { time: 4, step: 5 },
  ],
};

/** Slow is black, fast is white. */
const skin = { ...skinOf('light', () => '#000000'), trace: '#ffffff', traceSlow: '#000000' };

function drawn() {
  const scene = new Scene();
  const labels = fakeLabels();
  const mark = createPathMark({
    ...{ scene, skin, labels, text: {} },
    linkGroup: () => {
      throw new Error('A path stands in the world.');
    },
  });
  mark.want({ path: PATH, time: 0 });
  mark.show(arm);
  const lines = () => {
    /** @type {LineSegments2[]} */
    const all = [];
    scene.traverse((object) => object instanceof LineSegments2 && all.push(object));
    return all;
  };
  return { scene, labels, mark, lines };
}

/** @param {LineSegments2} line @param {string} name @param {number} k */
function vector(line, name, k) {
  const attribute = line.geometry.getAttribute(name);
  return [attribute.getX(k), attribute.getY(k), attribute.getZ(k)];
}

test('it runs through the places, from the colour of rest to that of the greatest speed, evenly to the eye', () => {
  const { lines } = drawn();
  const [hidden, ahead, done] = lines();
  expect(hidden.geometry).toBe(ahead.geometry);
  for (const line of [ahead, done]) {
    for (let k = 0; k < 4; k++) {
      expect(vector(line, 'instanceStart', k)).toEqual(place.map((column) => column[k]));
      expect(vector(line, 'instanceEnd', k)).toEqual(place.map((column) => column[k + 1]));
      const [r] = vector(line, 'instanceColorEnd', k);
      const seen = new Color(r, r, r).getRGB({ r: 0, g: 0, b: 0 }, SRGBColorSpace);
      expect(seen.r).toBeCloseTo((k + 1) / 4, 4);
    }
  }
});

test('it is solid as far as the tool has been, and is not built again for that', () => {
  const { mark, lines } = drawn();
  const before = lines();
  const [, , done] = before;
  expect(done.visible).toBe(false);
  for (const [time, segments] of [
    [2.5, 2],
    [4, 4],
    [1, 1],
  ]) {
    mark.want({ path: PATH, time });
    expect(done.visible).toBe(true);
    expect(done.geometry.instanceCount).toBe(segments);
  }
  expect(lines()).toEqual(before);
});

test('dots are the same time apart, and steps that end at one place share its number', () => {
  const { labels, lines } = drawn();
  const dots = lines()[3];
  expect([0, 1, 2].map((k) => vector(dots, 'instanceStart', k)[0])).toEqual([0, 2, 8]);
  expect([0, 1, 2].map((k) => vector(dots, 'instanceEnd', k)[0])).toEqual([0, 2, 8]); // a dot is as long as it is thick
  expect(dots.geometry.getAttribute('instanceStart').count).toBe(3);
  expect(labels.texts('tick path-step')).toEqual(['1', '2', '4, 6']);
  expect(labels.all.map(({ at }) => at.x)).toEqual([0, 2, 8]);
});

test('nothing is left behind', () => {
  const { scene, labels, mark } = drawn();
  mark.want(null);
  expect([scene.children, labels.all]).toEqual([[], []]);
});
