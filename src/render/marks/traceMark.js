/**
 * The line of where the tool has been: solid where it is seen, faint where the arm or the floor hides it. It grows in the
 * graphics memory that it was given at first; while nothing moves it costs nothing.
 *
 * @import { Label } from '../labels.js'
 * @import { ArmNow, MarkSet, MarkTools } from './marks.js'
 * @import { Trace } from '../../model/jog/trace.js'
 */
import { DynamicDrawUsage, Group, InstancedInterleavedBuffer, InterleavedBufferAttribute } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

const WIDTH = 2.5;
const HIDDEN = 0.3;
const ORDER = 14; // over the arm, below all other marks
const PER_SEGMENT = 6;

/**
 * @param {MarkTools & { text: { start: string }, trace: () => Trace | null }} tools  `trace` is asked whenever the arm has moved
 * @returns {MarkSet}
 */
export function createTraceMark({ scene, skin, labels, text, trace }) {
  /** @type {ArmNow | null} */
  let arm = null;
  /** @type {{ trace: Trace, edition: number, points: number, group: Group, geometry: LineSegmentsGeometry, buffer: InstancedInterleavedBuffer, materials: LineMaterial[], start: Label } | null} */
  let drawn = null;

  function clear() {
    if (!drawn) return;
    drawn.group.removeFromParent();
    drawn.geometry.dispose();
    for (const material of drawn.materials) material.dispose();
    drawn.start.remove();
    drawn = null;
  }

  function build() {
    clear();
    const wanted = arm && trace();
    if (!wanted) return;
    const buffer = new InstancedInterleavedBuffer(new Float32Array(PER_SEGMENT * wanted.most), PER_SEGMENT, 1);
    buffer.setUsage(DynamicDrawUsage);
    const geometry = new LineSegmentsGeometry();
    geometry.setAttribute('instanceStart', new InterleavedBufferAttribute(buffer, 3, 0));
    geometry.setAttribute('instanceEnd', new InterleavedBufferAttribute(buffer, 3, 3));
    const group = new Group();
    const materials = [false, true].map((isSeen, i) => {
      const material = new LineMaterial({
        ...{ color: skin.trace, linewidth: WIDTH, transparent: true, depthWrite: false },
        ...(isSeen ? {} : { opacity: HIDDEN, depthTest: false }),
      });
      const lines = new LineSegments2(geometry, material);
      lines.renderOrder = ORDER + i;
      lines.frustumCulled = false;
      group.add(lines);
      return material;
    });
    const start = Object.assign(labels.add('tick trace-start'), { gap: 4, yields: true });
    start.write(text.start);
    scene.add(group);
    drawn = { trace: wanted, edition: wanted.edition, points: 1, group, geometry, buffer, materials, start };
    lay();
  }

  /** Hand on what is new. The last point may have moved, so it is always new. */
  function lay() {
    if (!drawn) return;
    const { trace: line, buffer, geometry, group, start } = drawn;
    const isOther = line.edition !== drawn.edition;
    const from = isOther ? 1 : Math.max(1, drawn.points - 1);
    // A segment ends at each point but the first; where a stroke begins it has no length, and is not drawn.
    for (let i = from; i < line.count; i++) {
      const before = line.isStart(i) ? i : i - 1;
      buffer.array.set(line.points.subarray(3 * before, 3 * before + 3), PER_SEGMENT * (i - 1));
      buffer.array.set(line.points.subarray(3 * i, 3 * i + 3), PER_SEGMENT * (i - 1) + 3);
    }
    if (line.count > from) {
      buffer.addUpdateRange(PER_SEGMENT * (from - 1), PER_SEGMENT * (line.count - from));
      buffer.needsUpdate = true;
    }
    geometry.instanceCount = line.count - 1;
    group.visible = line.count > 1;
    start.visible = group.visible;
    start.at.fromArray(line.points);
    Object.assign(drawn, { points: line.count, edition: line.edition });
  }

  return {
    show(next) {
      arm = next;
      build();
    },
    follow() {
      if (drawn && drawn.trace === trace()) lay();
      else build();
    },
    clear,
    build,
    setSkin(next) {
      skin = next;
      for (const material of drawn?.materials ?? []) material.color.set(next.trace);
    },
  };
}
