/**
 * The marks about the arm that come and go: the gauge of the joint in hand, and the target with what is missing to it.
 *
 * @import { Group, Scene, Vector3 } from 'three'
 * @import { ArmParts } from '../arm/armParts.js'
 * @import { Eye } from '../eye.js'
 * @import { Excess, Gauge, GaugeText } from './gauge.js'
 * @import { LabelLayer } from '../labels.js'
 * @import { Skin } from '../skins.js'
 * @import { WantedPose } from './wantedPose.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Pose } from '../../kinematics/pose.js'
 *
 * @typedef {object} ArmNow  the arm that is shown, where it is; its numbers change in place
 * @property {Chain} chain
 * @property {ArmParts} parts
 * @property {Float64Array} posture
 * @property {Float64Array} frames  of linkFrames
 * @property {Pose} T_base_tcp
 *
 * @typedef {object} MarkTools  what marks are made with
 * @property {Scene} scene
 * @property {(link: number) => Group} linkGroup  where a mark hangs that moves with a link
 * @property {Skin} skin
 * @property {LabelLayer} labels
 *
 * @typedef {object} MarkSet  marks that come and go together
 * @property {(arm: ArmNow | null) => void} show  another arm, or the same built anew
 * @property {() => void} follow  after the arm has moved
 * @property {() => void} clear   before the arm is taken apart
 * @property {() => void} build   with any change of what the marks are made of
 * @property {(skin: Skin) => void} setSkin
 * @property {() => Vector3[]} [corners]  what the whole picture has to have in it beside the arm
 * @property {(eye: Eye) => void} [face]  before a picture is taken, for what has its size on the screen
 *
 * @typedef {GaugeText & { missing: (metres: number) => string }} MarkText
 * @typedef {{ T_base_target: Pose, reached: boolean, from: Pose | null }} Target
 */
import { createGauge } from './gauge.js';
import { createWantedPose } from './wantedPose.js';

/** The target's frame: arrows in sizes of the arm; the gap in pixels. */
const TARGET = { arrow: 0.05, gap: 6, order: 30 };

/** @param {MarkTools & { text: MarkText }} options */
export function createMarks({ scene, linkGroup, skin, labels, text }) {
  /** @type {ArmNow | null} */
  let arm = null;
  /** @type {number | null} */
  let held = null;
  /** @type {Excess | null} of the joint that is held */
  let excess = null;
  /** @type {Target | null} */
  let target = null;
  /** @type {Gauge | null} */
  let gauge = null;
  /** @type {WantedPose | null} */
  let targetMark = null;

  function clear() {
    gauge?.dispose();
    targetMark?.dispose();
    gauge = targetMark = null;
  }

  function build() {
    clear();
    if (!arm) return;
    const { chain, parts } = arm;
    const { size } = parts;
    if (held !== null && held < chain.dof) {
      gauge = createGauge({
        index: held,
        excess,
        joint: chain.joints[held],
        seat: parts.joints[held],
        size,
        skin,
        labels,
        text,
      });
      linkGroup(held).add(gauge.group);
    }
    if (target) {
      const { T_base_target, reached } = target;
      targetMark = createWantedPose({ ...TARGET, skin, labels, missing: text.missing });
      // where it is reached, the tool's own letters are there
      targetMark.want(T_base_target, { isMissed: !reached, hasLetters: !reached });
      scene.add(targetMark.group);
    }
    follow();
  }

  function follow() {
    if (!arm) return;
    if (held !== null) gauge?.show(arm.posture[held]);
    targetMark?.measureFrom(target?.from ?? arm.T_base_tcp, arm.parts.size);
  }

  return {
    /** After the arm has moved. */
    follow,
    /** Before the arm is taken apart, and with any change of what the marks are made of. */
    clear,
    build,
    /** @param {ArmNow | null} next */
    show(next) {
      arm = next;
      build();
    },
    /** @param {number | null} index @param {Excess | null} past @returns {boolean} whether that changed anything */
    hold(index, past) {
      if (index === held && past === excess) return false;
      [held, excess] = [index, past];
      build();
      return true;
    },
    /** @param {Target | null} next @returns {boolean} */
    aim(next) {
      if (!next && !target) return false;
      target = next;
      build();
      return true;
    },
    /** @param {Skin} next */
    setSkin(next) {
      skin = next;
      build();
    },
  };
}
