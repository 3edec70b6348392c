/**
 * The gauge of the joint that is being moved: its limits as a dial with a needle, or as a rail with stops, and its value.
 * It hangs in the link before the joint, so that only the pointer and the filled part follow the value.
 *
 * @import { FaceOptions } from './gaugeFace.js'
 * @import { Label, LabelLayer } from '../labels.js'
 *
 * @typedef {object} GaugeText
 * @property {(index: number) => string} jointValue
 * @property {(index: number, which: 'lower' | 'upper') => string} jointLimit
 * @property {(index: number, by: number) => string} jointExcess  by: radians or metres past the limit
 *
 * @typedef {{ joint: number, by: number, bound: 'lower' | 'upper' }} Excess  where a joint would have to go
 */
import { Group, Vector3 } from 'three';
import { dialFace } from './dial.js';
import { disposeOf } from '../fatLines.js';
import { railFace } from './rail.js';

/**
 * @param {FaceOptions & { index: number, excess: Excess | null, labels: LabelLayer, text: GaugeText }} options
 *   `index` is the joint's
 */
export function createGauge({ index, excess, labels, text, ...options }) {
  const { joint, seat } = options;
  const group = new Group();
  group.matrixAutoUpdate = false;
  group.matrix.fromArray(seat.T_link_zero);
  group.matrixWorldNeedsUpdate = true;
  const face = joint.type === 'revolute' ? dialFace(options) : railFace(options);
  group.add(...face.still, ...face.moving);

  /** @param {string} className @param {number} gap @returns {Label & { from: Vector3 }} */
  const addLabel = (className, gap) =>
    Object.assign(labels.add(className), { parent: group, from: new Vector3(), gap, stays: true });
  /** @param {Label & { from: Vector3 }} label @param {number} q */
  function put(label, q) {
    label.at.set(...face.tip(q));
    label.from.set(...face.centre(q));
  }
  const limits = /** @type {const} */ (['lower', 'upper'])
    .filter((which) => face.stops.includes(joint[which]))
    .map((which) => {
      const label = addLabel('tick', 4);
      put(label, face.besideStop(joint[which]));
      label.write(text.jointLimit(index, which));
      return label;
    });
  const value = addLabel('dim', 10);
  const past = excess ? drawExcess(excess) : [];

  /** @param {Excess} wanted */
  function drawExcess({ by, bound }) {
    const limit = joint[bound];
    const end = bound === 'upper' ? limit + by : limit - by;
    const drawn = face.beyond(limit, end);
    group.add(...drawn);
    const label = addLabel('miss', 8);
    put(label, end);
    label.write(text.jointExcess(index, by));
    limits.push(label);
    return drawn;
  }

  return {
    group,
    /** @param {number} q */
    show(q) {
      face.turnTo(q);
      put(value, q);
      value.write(text.jointValue(index));
    },
    dispose() {
      group.removeFromParent();
      [...face.still, ...face.moving, ...past].forEach(disposeOf);
      [...limits, value].forEach((label) => label.remove());
    },
  };
}

/** @typedef {ReturnType<typeof createGauge>} Gauge */
