/**
 * All that is in the picture, kept from one picture to the next: the arm, its floor and light, the frames of base and tool,
 * and the marks about them. It knows neither screen nor camera: `onChange` says that another picture is due, and with
 * `castsAnew` that the shadow is no longer right.
 *
 * @import { Eye } from './eye.js'
 * @import { Excess } from './marks/gauge.js'
 * @import { ArmNow, MarkSet, MarkText, MarkTools } from './marks/marks.js'
 * @import { LabelLayer } from './labels.js'
 * @import { LinkStyle } from './arm/linkPieces.js'
 * @import { Skin } from './skins.js'
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Pose } from '../kinematics/pose.js'
 */
import { LineSegments, Mesh, Scene, Vector3 } from 'three';
import { linkFrames } from '../kinematics/forward.js';
import { compose } from '../kinematics/pose.js';
import { createArmModel } from './arm/armModel.js';
import { disposeOf } from './fatLines.js';
import { createFloor, gridSteps } from './floor.js';
import { homeDirection } from './homeDirection.js';
import { createLights } from './lights.js';
import { createMarks } from './marks/marks.js';
import { createTriad } from './marks/triad.js';

const FADE = 1.8; // where the grid ends, in reaches
const BASE_ARROW = 0.14; // in sizes of the arm
const TOOL_ARROW = 0.09;
const ROOM = 0.16; // about the frames of a row

/**
 * The arm that is built; `posture` has no numbers yet if `isPlaced` is false.
 * @typedef {ArmNow & { styles: readonly LinkStyle[], T_flange_tcp: Pose, isPlaced: boolean }} Shown
 */

/**
 * @param {object} options
 * @param {Skin} options.skin
 * @param {boolean} options.isLow
 * @param {LabelLayer} options.labels
 * @param {MarkText} options.text
 * @param {(change: { castsAnew: boolean }) => void} options.onChange
 * @param {(metres: number) => void} options.onGridStep
 */
export function createScene({ skin, isLow, labels, text, onChange, onGridStep }) {
  const scene = new Scene();
  scene.matrixAutoUpdate = false; // or Three.js takes it, and all in it, to have moved at every picture
  const floor = createFloor({ skin, isLow });
  const lights = createLights({ skin, isLow });
  const arm = createArmModel({ skin, isLow });
  const tools = () => ({ scene, linkGroup: arm.linkGroup, skin, labels });
  const marks = createMarks({ ...tools(), text });
  /** @type {MarkSet[]} */
  const sets = [marks];
  const lower = /** @type {const} */ ({ letters: '', letterCase: 'lower', subscript: '0' });
  const upper = /** @type {const} */ ({ letters: 'strong', letterCase: 'upper' });
  const base = createTriad({ skin, labels, ...lower, width: 2.25, gap: 5, order: 28 }); // frame 0
  const tool = createTriad({ skin, labels, ...upper, width: 2.5, gap: 4, order: 32 });
  const dot = Object.assign(labels.add('dot'), { parent: tool.group }); // the TCP, be its frame shown or not
  scene.add(floor.group, lights.group, arm.group, base.group, tool.group);
  /** @type {Shown | null} */
  let shown = null;
  /** @type {number | null} */
  let lit = null;
  let gridStep = 0;
  const ends = { base: true, tool: true };
  let hasHandle = false; // which has axes and letters of its own
  setVisible(false);

  /** @param {boolean} isVisible */
  function setVisible(isVisible) {
    arm.group.visible = floor.group.visible = dot.visible = isVisible;
    base.setVisible(isVisible && ends.base);
    tool.setVisible(isVisible && ends.tool && !hasHandle);
  }

  /** Everything that follows from where the arm is. @param {Shown} now */
  function move({ chain, posture, frames, T_flange_tcp, T_base_tcp, parts }) {
    linkFrames(chain, posture, frames);
    arm.move(frames, posture);
    compose(frames.subarray(16 * chain.dof), T_flange_tcp, T_base_tcp);
    tool.show(T_base_tcp, TOOL_ARROW * parts.size);
  }

  /** Everything that is in proportion to the arm. @param {Shown} now */
  function settle({ chain, parts: { size, sense, below } }) {
    const T_base = chain.base;
    const [x, y, z] = T_base.subarray(12, 15);
    const reach = Number.isFinite(chain.reach) && chain.reach > 0 ? chain.reach : size;
    const steps = gridSteps(size);
    const hangs = sense * T_base[10] < -0.5;
    const ground = hangs ? chain.shoulder[2] - reach : z - below * Math.abs(T_base[10]);
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
      const isPlaced = shown?.chain.dof === chain.dof && shown.isPlaced; // otherwise the posture was another arm's
      for (const set of sets) set.clear();
      shown = {
        chain,
        styles,
        parts: arm.build(chain, styles),
        posture: isPlaced && shown ? shown.posture : new Float64Array(chain.dof),
        isPlaced,
        frames: new Float64Array(16 * (chain.dof + 1)),
        T_flange_tcp: chain.tool,
        T_base_tcp: new Float64Array(16),
      };
      settle(shown);
      if (isPlaced) move(shown);
      for (const set of sets) set.show(isPlaced ? shown : null);
      setVisible(isPlaced);
      onChange({ castsAnew: true });
    },

    /** @param {ArrayLike<number>} q */
    showPosture(q) {
      if (!shown) throw new TypeError('Expected an arm to be shown before its posture.');
      const { chain, posture, isPlaced } = shown;
      if (q.length !== chain.dof) throw new RangeError(`Expected ${chain.dof} joint values, got ${q.length}.`);
      if (isPlaced && posture.every((value, i) => value === q[i])) return;
      posture.set(q);
      move(shown);
      if (isPlaced) for (const set of sets) set.follow();
      else {
        shown.isPlaced = true;
        for (const set of sets) set.show(shown);
        setVisible(true);
      }
      onChange({ castsAnew: true });
    },

    /** @param {number | null} index  of the joint whose link is to stand out */
    highlightJoint(index) {
      if (index === lit) return;
      lit = index;
      arm.light(index === null ? null : index + 1);
      onChange({ castsAnew: false });
    },

    /** @param {number | null} index  of the joint that is being moved @param {Excess | null} [excess]  where it would have to go */
    holdJoint(index, excess = null) {
      if (marks.hold(index, excess)) onChange({ castsAnew: false });
    },

    /**
     * @param {ArrayLike<number> | null} T_base_target
     * @param {{ reached: boolean, from?: Pose | null }} state  with `reached`, nothing is said to be missing; `from`: what is
     *   missing is so from there, and else from where the tool is
     */
    showTarget(T_base_target, { reached, from = null }) {
      const target = T_base_target && { T_base_target: Float64Array.from(T_base_target), reached, from };
      if (marks.aim(target)) onChange({ castsAnew: false });
    },

    /** Which of the frames at the two ends are drawn. @param {{ base: boolean, tool: boolean }} which */
    showEnds(which) {
      if (which.base === ends.base && which.tool === ends.tool) return;
      Object.assign(ends, which);
      setVisible(shown?.isPlaced ?? false);
      onChange({ castsAnew: false });
    },

    /** Grid and shadow, which a picture may leave out. @param {boolean} isShown */
    showFloor(isShown) {
      floor.group.visible = isShown && arm.group.visible;
    },

    /** @param {boolean} isShown  on the tool, in place of its frame */
    showHandle(isShown) {
      if (isShown === hasHandle) return;
      hasHandle = isShown;
      setVisible(shown?.isPlaced ?? false);
      onChange({ castsAnew: false });
    },

    linkAt: arm.linkAt,

    /**
     * Marks that are fetched when they are first wanted.
     * @template {MarkSet} Set
     * @param {(tools: MarkTools) => Set} create
     * @returns {Set}
     */
    addMarks(create) {
      const set = create(tools());
      sets.push(set);
      if (shown?.isPlaced) set.show(shown);
      onChange({ castsAnew: false });
      return set;
    },

    /** Some marks have changed. @param {boolean} [castsAnew]  with what casts a shadow */
    touch: (castsAnew = false) => onChange({ castsAnew }),

    /** Before a picture is taken. @param {Eye} eye */
    face(eye) {
      for (const set of sets) set.face?.(eye);
    },

    /** Ask for all words again: units or language have changed. */
    rewrite() {
      if (shown) onGridStep(gridStep);
      for (const set of sets) set.build();
      onChange({ castsAnew: false });
    },

    /** @param {Skin} next */
    setSkin(next) {
      skin = next;
      for (const each of [floor, lights, arm, base, tool, ...sets]) each.setSkin(next);
      onChange({ castsAnew: false });
    },

    /** What has to get into the picture, how large the arm is, and from where it is seen best; nothing if there is no arm. */
    extent() {
      if (!shown?.isPlaced) return null;
      const { chain, frames, parts } = shown;
      const around = sets.flatMap((set) => set.corners?.() ?? []);
      const corners = [...arm.corners(), ...base.tips(), ...tool.tips(), ...around];
      return { corners, size: parts.size, home: homeDirection(chain, frames) };
    },

    /** What a camera that goes near a row has to get into the picture: its two frames, and room about them. @param {number} joint */
    extentOfRow(joint) {
      if (!shown?.isPlaced || joint >= shown.chain.dof) return null;
      const { frames, parts } = shown;
      const room = [-ROOM, ROOM].map((share) => share * parts.size);
      const corners = [joint, joint + 1].flatMap((i) =>
        room.flatMap((x) =>
          room.flatMap((y) => room.map((z) => new Vector3(x, y, z).add(new Vector3().fromArray(frames, 16 * i + 12)))),
        ),
      );
      return { corners, size: parts.size };
    },

    /** Let go of all that is in graphics memory; the next picture brings it there again. */
    release() {
      scene.traverse((object) => {
        if (object instanceof Mesh || object instanceof LineSegments) disposeOf(object);
      });
      lights.dispose();
    },

    dispose() {
      for (const set of sets) set.clear();
      for (const each of [base, tool, arm, floor, lights]) each.dispose();
      dot.remove();
    },
  };
}
