/**
 * All that is in the picture, kept from one picture to the next: the arm, its floor and light, the frames of base and tool,
 * and the marks about the joint in hand and the target. It knows neither screen nor camera: `onChange` says that another
 * picture is due, and `castsAnew` that the shadow is no longer right.
 *
 * @import { LinkStyle } from './linkPieces.js'
 * @import { GaugeText, Gauge } from './gauge.js'
 * @import { LabelLayer } from './labels.js'
 * @import { Skin } from './skins.js'
 * @import { TargetMark } from './targetMark.js'
 * @import { ArmParts } from './armParts.js'
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Pose } from '../kinematics/pose.js'
 *
 * @typedef {GaugeText & { missing: (metres: number) => string }} SceneText
 */
import { Scene, Vector3 } from 'three';
import { linkFrames } from '../kinematics/forward.js';
import { compose } from '../kinematics/pose.js';
import { createArmModel } from './armModel.js';
import { createFloor, gridSteps } from './floor.js';
import { createGauge } from './gauge.js';
import { createLights } from './lights.js';
import { createTargetMark } from './targetMark.js';
import { createTriad } from './triad.js';

const FADE = 1.8; // where the grid ends, in reaches
const BASE_ARROW = 0.14; // in sizes of the arm
const TOOL_ARROW = 0.09;

/**
 * @param {object} options
 * @param {Skin} options.skin
 * @param {boolean} options.isLow
 * @param {LabelLayer} options.labels
 * @param {SceneText} options.text
 * @param {(change: { castsAnew: boolean }) => void} options.onChange
 * @param {(metres: number) => void} options.onGridStep
 */
export function createScene({ skin, isLow, labels, text, onChange, onGridStep }) {
  const scene = new Scene();
  const floor = createFloor({ skin, isLow });
  const lights = createLights({ skin, isLow });
  const arm = createArmModel({ skin, isLow });
  const base = createTriad({
    skin,
    labels,
    width: 2.25,
    letters: '',
    letterCase: 'lower',
    subscript: '0',
    gap: 5,
    order: 28,
  });
  const tool = createTriad({ skin, labels, width: 2.5, letters: 'strong', letterCase: 'upper', gap: 4, order: 32 });
  const dot = labels.add('dot');
  dot.parent = tool.group;
  scene.add(floor.group, lights.group, arm.group, base.group, tool.group);

  /** @type {{ chain: Chain, styles: readonly LinkStyle[], parts: ArmParts, T_flange_tcp: Pose, frames: Float64Array } | null} */
  let shown = null;
  /** @type {Float64Array | null} */
  let posture = null;
  const T_base_tcp = new Float64Array(16);
  /** @type {number | null} */
  let lit = null;
  /** @type {number | null} */
  let held = null;
  /** @type {Gauge | null} */
  let gauge = null;
  /** @type {{ T: Float64Array, reached: boolean } | null} */
  let target = null;
  /** @type {TargetMark | null} */
  let targetMark = null;
  let gridStep = 0;

  const isEmpty = () => shown === null || posture === null;
  setVisible();

  function setVisible() {
    arm.group.visible = floor.group.visible = !isEmpty();
    for (const triad of [base, tool]) triad.setVisible(!isEmpty());
    dot.visible = !isEmpty();
  }

  function hangGauge() {
    gauge?.dispose();
    gauge = null;
    if (!shown || !posture || held === null || held >= shown.chain.dof) return;
    const { chain, parts } = shown;
    gauge = createGauge({
      index: held,
      joint: chain.joints[held],
      seat: parts.joints[held],
      size: parts.size,
      skin,
      labels,
      text,
    });
    arm.linkGroup(held).add(gauge.group);
    gauge.show(posture[held]);
  }

  function markTarget() {
    if (!target || !shown || !posture) {
      targetMark?.dispose();
      targetMark = null;
      return;
    }
    if (!targetMark) {
      targetMark = createTargetMark({ skin, labels, missing: text.missing });
      scene.add(targetMark.group);
    }
    targetMark.place(target.T, shown.parts.size);
    targetMark.measure(target.T, T_base_tcp, target.reached);
  }

  /** Everything that follows from where the arm is. */
  function move() {
    if (!shown || !posture) return;
    const { chain, frames, T_flange_tcp, parts } = shown;
    linkFrames(chain, posture, frames);
    arm.move(frames, posture);
    compose(frames.subarray(16 * chain.dof), T_flange_tcp, T_base_tcp);
    tool.show(T_base_tcp, TOOL_ARROW * parts.size);
    if (held !== null && gauge) gauge.show(posture[held]);
    if (target && targetMark) targetMark.measure(target.T, T_base_tcp, target.reached);
  }

  /** Everything that is in proportion to the arm. */
  function settle() {
    if (!shown) return;
    const { chain, parts } = shown;
    const { size } = parts;
    const T_base = chain.base;
    const [x, y, z] = T_base.subarray(12, 15);
    const reach = Number.isFinite(chain.reach) && chain.reach > 0 ? chain.reach : size;
    const steps = gridSteps(size);
    const hangs = parts.sense * T_base[10] < -0.5;
    const ground = hangs ? chain.shoulder[2] - reach : z - parts.below * Math.abs(T_base[10]);
    floor.lay(steps, FADE * reach, [x, y, Math.min(0, ground)]);
    lights.reachFor(Math.max(1.05 * reach, 0.75 * size), new Vector3(...chain.shoulder));
    base.show(T_base, BASE_ARROW * size);
    gridStep = steps.minor;
    onGridStep(gridStep);
  }

  return {
    scene,

    /**
     * @param {Chain} chain
     * @param {readonly LinkStyle[]} styles
     */
    showArm(chain, styles) {
      if (shown?.chain === chain && shown.styles === styles) return;
      if (posture?.length !== chain.dof) posture = null; // of another arm
      gauge?.dispose();
      gauge = null;
      shown = {
        chain,
        styles,
        parts: arm.build(chain, styles),
        T_flange_tcp: chain.tool,
        frames: new Float64Array(16 * (chain.dof + 1)),
      };
      settle();
      move();
      hangGauge();
      markTarget();
      setVisible();
      onChange({ castsAnew: true });
    },

    /** @param {ArrayLike<number>} q */
    showPosture(q) {
      if (!shown) throw new TypeError('Expected an arm to be shown before its posture.');
      if (q.length !== shown.chain.dof) {
        throw new RangeError(`Expected ${shown.chain.dof} joint values, got ${q.length}.`);
      }
      const isFirst = posture === null;
      if (posture?.every((value, i) => value === q[i])) return;
      posture = Float64Array.from(q);
      move();
      if (isFirst) {
        hangGauge();
        markTarget();
        setVisible();
      }
      onChange({ castsAnew: true });
    },

    /** @param {number | null} index  of a joint */
    highlightJoint(index) {
      if (index === lit) return;
      lit = index;
      arm.light(index === null ? null : index + 1);
      onChange({ castsAnew: false });
    },

    /** @param {number | null} index */
    holdJoint(index) {
      if (index === held) return;
      held = index;
      hangGauge();
      onChange({ castsAnew: false });
    },

    /**
     * @param {ArrayLike<number> | null} T_base_target
     * @param {{ reached: boolean }} state
     */
    showTarget(T_base_target, { reached }) {
      if (!T_base_target && !target) return;
      target = T_base_target && { T: Float64Array.from(T_base_target), reached };
      markTarget();
      onChange({ castsAnew: false });
    },

    /** Write the labels again: units or language have changed. */
    rewrite() {
      if (shown) onGridStep(gridStep);
      hangGauge();
      markTarget();
      onChange({ castsAnew: false });
    },

    /** @param {Skin} next */
    setSkin(next) {
      skin = next;
      for (const each of [floor, lights, arm, base, tool, targetMark]) each?.setSkin(skin);
      hangGauge();
      onChange({ castsAnew: false });
    },

    /** What has to get into the picture, and how large the arm is; nothing if there is no arm. */
    extent() {
      if (!shown || isEmpty()) return null;
      return { corners: [...arm.corners(), ...base.tips(), ...tool.tips()], size: shown.parts.size };
    },

    dispose() {
      gauge?.dispose();
      targetMark?.dispose();
      for (const each of [base, tool, arm, floor, lights]) each.dispose();
      dot.remove();
    },
  };
}
