import { expect, test } from 'vitest';
import { Scene } from 'three';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { createTrace } from '../../../src/model/jog/trace.js';
import { createTraceMark } from '../../../src/render/marks/traceMark.js';
import { skinOf } from '../../../src/render/skins.js';
import { libraryArms } from './arms.js';
import { fakeLabels } from './fakeLabels.js';

/** @import { ArmNow } from '../../../src/render/marks/marks.js' */

const [, chain] = libraryArms[0];

/** @param {Scene} scene @returns {LineSegments2} */
function lineIn(scene) {
  /** @type {LineSegments2[]} */
  const lines = [];
  scene.traverse((object) => object instanceof LineSegments2 && lines.push(object));
  expect(lines).toHaveLength(2); // what is seen and what is hidden, of one geometry
  expect(lines[0].geometry).toBe(lines[1].geometry);
  return lines[0];
}

test('the line is what the trace has, segment for segment, and grows without being built again', () => {
  const q = new Float64Array(chain.dof);
  const trace = createTrace(chain, q, 64);
  const scene = new Scene();
  const labels = fakeLabels();
  const skin = skinOf('light', () => '#A87400');
  const mark = createTraceMark({
    ...{ scene, skin, labels, text: { start: 'start' }, trace: () => trace },
    linkGroup: () => {
      throw new Error('A trace stands in the world.');
    },
  });
  mark.show(/** @type {ArmNow} */ ({}));
  const line = lineIn(scene);
  const { buffer } = { buffer: line.geometry.getAttribute('instanceStart') };
  expect(line.geometry.instanceCount).toBe(0);
  let from = q;
  for (let i = 1; i <= 80; i++) {
    const to = from.slice();
    to[i % chain.dof] += 0.05;
    trace.go(from, to, i % 17 !== 0);
    from = to;
    mark.follow();
    expect(lineIn(scene)).toBe(line);
    expect(line.geometry.instanceCount).toBe(trace.count - 1);
    for (let k = 1; k < trace.count; k++) {
      const [start, end] = ['instanceStart', 'instanceEnd'].map((name) => {
        const attribute = line.geometry.getAttribute(name);
        return [attribute.getX(k - 1), attribute.getY(k - 1), attribute.getZ(k - 1)];
      });
      const point = (/** @type {number} */ at) => [...trace.points.subarray(3 * at, 3 * at + 3)];
      expect(end).toEqual(point(k));
      expect(start).toEqual(point(trace.isStart(k) ? k : k - 1));
    }
  }
  expect(trace.edition).toBeGreaterThan(0); // it was thinned on the way
  expect(line.geometry.getAttribute('instanceStart')).toBe(buffer);
  mark.clear();
  expect(scene.children).toEqual([]);
});
